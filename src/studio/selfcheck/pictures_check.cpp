// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"
#include "studio/selfcheck/still.h"

#include "gl/context.h"

#include <cmath>
#include <numeric>

namespace vs::studio {

namespace {

constexpr double kSampleStep = 0.5; // between samples, as frames have it
constexpr glm::dvec3 kNoiseSpacing(1, 1.4, 0.8);
constexpr Range kNoiseShown{60, 200}; // of noise from 0 to 200
constexpr render::Projection kBothProjections[] = {render::Projection::Perspective,
                                                   render::Projection::Orthographic};

// What the 8 bits of hardware filters add to errors, in grey levels of a range of values.
double filterLevels() { return gl::Context::isSoftware() ? 0 : 255 * 3.0 / 256; }

template <typename Visit>
void forEachPixel(glm::ivec2 size, const Visit& visit) {
    forEachVoxel({glm::ivec3(0), {size, 1}}, [&](glm::ivec3 v, std::size_t) { visit(glm::ivec2(v)); });
}

// Whether rounding decides if a ray has one sample more or less at an end of its way.
bool isUncertain(const reference::Ray& ray) {
    const auto isAtSample = [](double t) {
        const double part = t / kSampleStep - 0.5;
        return std::abs(part - std::round(part)) < 2e-3;
    };
    return isAtSample(ray.way.lo) || isAtSample(ray.way.hi);
}

// Noise that no part of which hides another.
Still noiseStill(volume::ScalarType type) {
    return Still(makeNoise({22, 19, 25}, type, 0, 200, kNoiseSpacing), kNoiseShown, {}, {56, 48});
}

// Smooth noise: the mean of waves in all directions.
volume::Volume makeSmoothNoise() {
    std::mt19937 random(5);
    const auto part = [&] { return double(random() % 2001) / 1000 - 1; };
    std::vector<glm::dvec4> waves;
    for (int i = 0; i < 8; ++i) {
        const double x = part();
        const double y = part();
        const double z = part();
        waves.emplace_back(0.5 * glm::dvec3(x, y, z), 3 * part());
    }
    return phantom::makePhantom({34, 30, 38}, volume::ScalarType::UInt16,
                                [&](glm::dvec3 p) {
                                    double sum = 0;
                                    for (const glm::dvec4& wave : waves) {
                                        sum += std::sin(glm::dot(glm::dvec3(wave), p) + wave.w);
                                    }
                                    return 20000 * std::clamp(0.5 + sum / 9, 0.0, 1.0);
                                },
                                {1, 1.2, 0.9});
}

// A curve over intensity and shapes over intensity and gradient magnitude, unlit.
std::vector<render::TransferFunction> functionsOfNoise() {
    render::TransferFunction curve;
    curve.points = {{9000, 0, {200, 40, 20}},
                    {12000, 0.12, {220, 140, 60}},
                    {14500, 0.05, {60, 140, 220}},
                    {18000, 0.5, {255, 250, 240}}};
    render::TransferFunction plane;
    plane.kind = render::FunctionKind::TwoD;
    plane.shapes = {
        {render::Trapezoid{{6000, 14000}, {8000, 12000}, {300, 4000}, {1, 1}}, {210, 60, 30}, 0.25},
        {render::Trapezoid{{12000, 20000}, {13000, 19000}, {0, 6000}, {1, 1}}, {230, 230, 90}, 0.4}};
    curve.lighting.amount = 0;
    plane.lighting.amount = 0;
    return {curve, plane};
}

// Where the first sample of a pixel's ray lies, as a part of the way between two: the arithmetic of
// cast_rays.comp for the first sample of a picture.
double startJitter(glm::ivec2 pixel) {
    const glm::vec2 place = glm::vec2(pixel) + 64.0F * glm::vec2(0.5F);
    return double(glm::fract(52.9829189F * glm::fract(glm::dot(place, glm::vec2(0.06711056F, 0.00583715F)))));
}

// The mean difference of two pictures' grey levels.
double meanDifference(const image::Image& a, const image::Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        sum += std::abs(int(a.rgba[i]) - int(b.rgba[i]));
    }
    return sum / double(a.rgba.size());
}

} // namespace

void checkMaximum(Tally& tally) {
    for (const auto type : {volume::ScalarType::UInt8, volume::ScalarType::Float32}) {
        Still still = noiseStill(type);
        for (const auto projection : kBothProjections) {
            still.look({40, 28, 1, {}, projection}, still.size());
            const auto picture = still.picture(render::Mode::Mip);
            tally.about(std::string("grey levels, ") + name(type));
            forEachPixel(still.size(), [&](glm::ivec2 pixel) {
                const auto ray = still.plainRayOf(pixel);
                const double greatest = reference::greatestAlong(still.volume(), ray, kSampleStep);
                const double part = std::max((greatest - kNoiseShown.lo) / kNoiseShown.width(), 0.0);
                if (!isUncertain(ray)) {
                    // Dithering and rounding to 8 bits.
                    tally.compare(picture.pixel(pixel.x, pixel.y)[0], 255 * part, 1.5 + filterLevels());
                }
            });
        }
    }
}

void checkXRay(Tally& tally) {
    for (const auto type : {volume::ScalarType::UInt8, volume::ScalarType::Float32}) {
        Still still = noiseStill(type);
        for (const auto projection : kBothProjections) {
            still.look({40, 28, 1, {}, projection}, still.size());
            still.frame().xrayGain = 1.5;
            const auto picture = still.picture(render::Mode::XRay);
            const auto& geometry = still.volume().geometry;
            const double perStep = 1.5 * geometry.stepMm() / geometry.diagonalMm();
            tally.about(std::string("grey levels, ") + name(type));
            forEachPixel(still.size(), [&](glm::ivec2 pixel) {
                const auto ray = still.plainRayOf(pixel);
                const double sum =
                    reference::integralAlong(still.volume(), ray, kNoiseShown, kSampleStep, 0.5);
                if (!isUncertain(ray)) {
                    tally.compare(picture.pixel(pixel.x, pixel.y)[0], 255 * std::min(perStep * sum, 1.0),
                                  1.5 + filterLevels());
                }
            });
        }
    }
}

void checkCompositing(Tally& tally) {
    for (const auto& function : functionsOfNoise()) {
        Still still(makeSmoothNoise(), {0, 20000}, {30, 25, 1, {}, render::Projection::Perspective},
                    {48, 40});
        still.classify(function);
        const auto picture = still.picture(render::Mode::Volume);
        const render::FunctionSampler sampler(function);
        const auto colourOf = [&](double value, double gradient) { return sampler.at(value, gradient); };
        const std::string kind = namesOf(function.kind)[std::size_t(function.kind)];
        double sum = 0;
        double seen = 0;
        forEachPixel(still.size(), [&](glm::ivec2 pixel) {
            const glm::dvec3 light(reference::compositeAlong(still.volume(), still.plainRayOf(pixel),
                                                             colourOf, kSampleStep, startJitter(pixel)));
            const glm::dvec3 expected = 255.0 * render::displayFromLinear(light);
            tally.about("grey levels, " + kind + " function");
            for (int c = 0; c < 3; ++c) {
                const double found = picture.pixel(pixel.x, pixel.y)[c];
                tally.compare(found, expected[c], 3 + filterLevels());
                sum += std::abs(found - expected[c]) / (3 * still.size().x * still.size().y);
                seen += expected[c] / (3 * still.size().x * still.size().y);
            }
        });
        tally.about("mean of grey levels, " + kind + " function");
        tally.compare(sum, 0, 1);
        tally.require(seen > 20);
    }
}

void checkSkipping(Tally& tally) {
    // Bubbles in a ramp: much is empty, and some of it is close to what is not.
    const auto bubbles = [](glm::dvec3 p) {
        const glm::dvec3 c = glm::mod(p, glm::dvec3(23.0)) - 11.0;
        return glm::length(c) < 4 ? 60 + 2 * p.z : 0.3 * p.x;
    };
    Still still(phantom::makePhantom({60, 50, 56}, volume::ScalarType::UInt8, bubbles, {1, 1.3, 0.8}),
                {60, 200}, {40, 30, 1.2, {}, render::Projection::Perspective}, {96, 72});
    render::TransferFunction function;
    function.points = {{55, 0, {200, 90, 40}}, {90, 0.3, {240, 200, 120}}, {170, 0.6, {255, 255, 255}}};
    for (const render::Mode mode :
         {render::Mode::Surface, render::Mode::Mip, render::Mode::XRay, render::Mode::Volume}) {
        if (mode == render::Mode::Volume) {
            still.classify(function);
        }
        const auto fast = still.picture(mode);
        const auto marched = still.marchedPicture(mode);
        const std::string which = render::name(mode);
        if (mode == render::Mode::Mip || mode == render::Mode::XRay) {
            tally.about("grey levels against marching everywhere, " + which);
            for (std::size_t i = 0; i < fast.rgba.size(); ++i) {
                tally.compare(fast.rgba[i], marched.rgba[i], 1);
            }
        }
        // After a skip samples fall elsewhere: rays that graze a surface may meet it a little later.
        tally.about("mean of grey levels against marching everywhere, " + which);
        tally.compare(meanDifference(fast, marched), 0, mode == render::Mode::Surface ? 0.35 : 0.05);
        if (mode == render::Mode::Mip) {
            still.frame().scene.sampling = field::Sampling::Tricubic;
            const auto smooth = still.picture(mode);
            tally.about("mean of grey levels against marching everywhere, tricubic");
            tally.compare(meanDifference(smooth, still.marchedPicture(mode)), 0, 0.05);
            tally.require(meanDifference(smooth, fast) > 0);
            still.frame().scene.sampling = field::Sampling::Trilinear;
        }
        tally.require(std::accumulate(fast.rgba.begin(), fast.rgba.end(), 0.0) > 65 * 96 * 72);
    }
}

void checkParts(Tally& tally) {
    Still still = noiseStill(volume::ScalarType::UInt8);
    still.look({40, 28, 1, {}, render::Projection::Perspective}, still.size());
    const auto wholeMip = still.picture(render::Mode::Mip);
    const auto wholeXRay = still.picture(render::Mode::XRay);
    still.sculpt([](glm::dvec3 p) { return std::clamp(0.5 + (p.x - 0.4 * p.y - 7.3) / 4, 0.0, 1.0); });
    tally.about("what a cut changes in a picture");
    tally.require(meanDifference(still.picture(render::Mode::Mip), wholeMip) > 5);
    still.pasteInPlace();
    // Every place of the volume is seen on one side of the cut and on no other.
    for (const auto& [mode, whole] :
         {std::pair(render::Mode::Mip, wholeMip), std::pair(render::Mode::XRay, wholeXRay)}) {
        const auto joined = still.picture(mode);
        tally.about(std::string("grey levels of what was cut and pasted, ") + render::name(mode));
        tally.compare(double(joined.rgba.size()), double(whole.rgba.size()));
        for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
            tally.compare(joined.rgba[i], whole.rgba[i], 1);
        }
    }
}

} // namespace vs::studio
