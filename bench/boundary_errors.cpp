// SPDX-License-Identifier: Apache-2.0
// Measures how far swept solids are from what was meant, for the comparisons of the thesis, section 3.6, and
// prints the tables of doc/boundary_errors.md. usage: boundary_errors
#include "gl/context.h"
#include "reference/boundary.h"
#include "reference/solids.h"
#include "sculpt/radiation/projection.h"
#include "sculpt/radiation/sweep.h"
#include "sculpt/sculpture/precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

using namespace vs;
using namespace vs::sculpt;

namespace {

const glm::ivec3 kDims(128);
const glm::dvec2 kRadii(16, 10);
const glm::dvec2 kCentre(0.37, 0.41); // of the ellipse: no symmetry with the mask's elements
const Helix kHelix{{64, 64, 30}, {64, 64, 98}, 34, 1.4};
constexpr double kPitch = 1; // one element a voxel
constexpr double kAway = 4;  // from the ends' rims

void heading(const std::string& title, const std::string& first) {
    fmt::print("\n## {}\n\n| {} | rms | max | mean | normals |\n|---|---:|---:|---:|---:|\n", title, first);
}

void row(const std::string& what, const reference::BoundaryErrors& found) {
    fmt::print("| {} | {:.4f} | {:.3f} | {:+.4f} | {:.2f}° |\n", what, found.rms, found.max, found.mean,
               found.normalAngle);
}

void clampToUnit(std::vector<float>& values) {
    for (float& value : values) {
        value = std::clamp(value, 0.0F, 1.0F);
    }
}

std::vector<glm::dvec2> exactOutline() {
    auto outline = reference::ellipse(kRadii);
    for (glm::dvec2& p : outline) {
        p += kCentre;
    }
    return outline;
}

// The helix of an elliptical mask.
class HelixBench {
public:
    HelixBench()
        : path_(helixPath(kHelix)), outline_(exactOutline()),
          curve_(
              [](double t) {
                  return reference::helixAt(kHelix.from, kHelix.to, {1, 0, 0}, kHelix.radius, kHelix.turns,
                                            t);
              },
              reference::SweptCurve::Turning::Least) {}

    std::vector<float> sweep(const MaskRaster& mask, int radius = 3) {
        sweepMask(radiator_, generator_, mask, path_, kDims, fitFootprint(radius));
        auto values = radiator_.download({glm::ivec3(0), kDims});
        clampToUnit(values);
        return values;
    }

    // The same points splatted one by one into a texture of 256 levels, which rounds after each, as blending
    // into it does.
    std::vector<float> blendedInto8Bits(const MaskRaster& mask) {
        std::vector<float> levels(Box3{glm::ivec3(0), kDims}.volume(), 0.0F);
        for (const PathPiece& piece : path_) {
            generator_.generate(sweepPiece(mask, piece), [&](const gl::Buffer& points, std::size_t count) {
                for (const glm::vec4& point : points.read<glm::vec4>(count)) {
                    blend(point, levels);
                }
            });
        }
        for (float& level : levels) {
            level /= 255;
        }
        return levels;
    }

    [[nodiscard]] reference::BoundaryErrors errors(const std::vector<float>& values) const {
        return reference::boundaryErrors(
            values, kDims, glm::dvec3(1), [&](const glm::dvec3& p) -> std::optional<reference::Deviation> {
                const auto place = curve_.locate(p);
                if (place.fromStart < kAway || place.toEnd < kAway) {
                    return std::nullopt;
                }
                const auto off = reference::distanceTo(outline_, place.element);
                return reference::Deviation{off.distance, off.normal.x * place.x + off.normal.y * place.y};
            });
    }

private:
    static void blend(const glm::vec4& point, std::vector<float>& levels) {
        const glm::dvec3 base = glm::floor(glm::dvec3(point));
        std::array<ReferenceWeights, 3> weights;
        for (int axis = 0; axis < 3; ++axis) {
            weights[std::size_t(axis)] = referenceWeights(1, double(point[axis]) - base[axis]);
        }
        const int half = weights[0].halfWidth;
        const glm::ivec3 first = glm::ivec3(base) + 1 - half;
        if (glm::any(glm::lessThan(first, glm::ivec3(0))) ||
            glm::any(glm::greaterThan(first + 2 * half, kDims))) {
            return;
        }
        for (int z = 0; z < 2 * half; ++z) {
            for (int y = 0; y < 2 * half; ++y) {
                const double share = 255.0 * double(point.w) * weights[1].weights[std::size_t(y)] *
                                     weights[2].weights[std::size_t(z)];
                float* line =
                    &levels[(std::size_t(first.z + z) * std::size_t(kDims.y) + std::size_t(first.y + y)) *
                                std::size_t(kDims.x) +
                            std::size_t(first.x)];
                for (int x = 0; x < 2 * half; ++x) {
                    const double sum = double(line[x]) + share * weights[0].weights[std::size_t(x)];
                    line[x] = float(std::min(std::round(sum), 255.0));
                }
            }
        }
    }

    Radiator radiator_;
    PointGenerator generator_;
    std::vector<PathPiece> path_;
    std::vector<glm::dvec2> outline_;
    reference::SweptCurve curve_;
};

MaskRaster maskWith(const MaskFilter& filter) {
    return rasterize(ellipseOutline(kCentre, kRadii), kPitch, filter);
}

void measureFilters(HelixBench& bench) {
    heading("Sampling and reconstruction (figures 3.14, 3.15)", "filter");
    for (const Sampling sampling : {Sampling::None, Sampling::PolygonSmooth}) {
        row(kMaskSamplings[std::size_t(sampling)],
            bench.errors(bench.sweep(maskWith({sampling, Reconstruction::BSpline, 40, 1}))));
    }
    for (const Sampling sampling : {Sampling::Uniform, Sampling::Jittered}) {
        for (std::size_t n = 0; n < kReconstructions.size(); ++n) {
            const auto kind = Reconstruction(n);
            row(fmt::format("{}, {} {}", kMaskSamplings[std::size_t(sampling)], kReconstructions[n],
                            naturalWidth(kind)),
                bench.errors(bench.sweep(maskWith({sampling, kind, naturalWidth(kind), 1}))));
        }
    }
}

void measureWidths(HelixBench& bench) {
    heading("Width of the B-spline (figure 3.16)", "sub-samples");
    for (const int width : {10, 20, 40, 50, 100}) {
        row(std::to_string(width),
            bench.errors(bench.sweep(maskWith({Sampling::Jittered, Reconstruction::BSpline, width, 1}))));
    }
}

void measureSubdivision(HelixBench& bench) {
    heading("Subdivision of an outline of 24 points on the ellipse (figure 3.14 c to e)", "scheme and level");
    Outline drawn;
    for (int n = 0; n < 24; ++n) {
        const double angle = 2 * 3.14159265358979 * n / 24;
        drawn.push_back(kCentre + kRadii * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    const MaskFilter box{Sampling::Uniform, Reconstruction::Box, 10, 1};
    const MaskFilter spline{Sampling::Jittered, Reconstruction::BSpline, 40, 1};
    for (const auto& [name, filter] : {std::pair{"uniform, box 10", box}, {"jittered, bspline 40", spline}}) {
        row(fmt::format("none; {}", name), bench.errors(bench.sweep(rasterize(drawn, kPitch, filter))));
        for (std::size_t scheme = 0; scheme < kSubdivisions.size(); ++scheme) {
            for (const int level : {1, 2, 3}) {
                const Outline finer = subdivide(drawn, Subdivision(scheme), level);
                row(fmt::format("{} {}; {}", kSubdivisions[scheme], level, name),
                    bench.errors(bench.sweep(rasterize(finer, kPitch, filter))));
            }
        }
    }
}

void measurePrecision(HelixBench& bench) {
    heading("Precision (figure 3.18)", "bits");
    const MaskRaster mask = maskWith({});
    row("8, blended splat by splat", bench.errors(bench.blendedInto8Bits(mask)));
    for (std::size_t n = 0; n < kPrecisions.size(); ++n) {
        auto values = bench.sweep(mask);
        roundTo(Precision(n), values);
        row(fmt::format("{}, the result rounded", kPrecisions[n]), bench.errors(values));
    }
}

void measureRadii(HelixBench& bench) {
    heading("Radius of the radiation (figure 3.13)", "radius");
    for (const int radius : {2, 3, 4}) {
        row(fmt::format("{}, mask jittered, bspline 40", radius),
            bench.errors(bench.sweep(maskWith({}), radius)));
    }
    for (const int radius : {2, 3, 4}) {
        row(fmt::format("{}, mask unfiltered", radius),
            bench.errors(bench.sweep(maskWith({Sampling::None, Reconstruction::Box, 10, 1}), radius)));
    }
}

// Two pipes that meet, the first askew to the grid.
class PipeJoint {
public:
    PipeJoint()
        : ends_{{{22, 34, 50}, {74, 62, 71}, {74, 116, 71}}},
          first_([&](double t) { return glm::mix(ends_[0], ends_[1], t); },
                 reference::SweptCurve::Turning::Least),
          second_([&](double t) { return glm::mix(ends_[1], ends_[2], t); },
                  reference::SweptCurve::Turning::Least),
          outline_(exactOutline()) {}

    std::vector<float> radiated(double pitch) {
        std::vector<float> all(Box3{glm::ivec3(0), kDims}.volume(), 0.0F);
        for (const auto& path : paths()) {
            sweepMask(radiator_, generator_, mask(pitch), path, kDims, fitFootprint(3));
            unite(all, radiator_.download({glm::ivec3(0), kDims}));
        }
        clampToUnit(all);
        return all;
    }
    std::vector<float> projected(double pitch) {
        std::vector<float> all(Box3{glm::ivec3(0), kDims}.volume(), 0.0F);
        for (const auto& path : paths()) {
            unite(all, projectSweep(mask(pitch), path, kDims));
        }
        return all;
    }

    // Only what belongs to the first pipe and is farther from the second than anything reaches; of it the
    // wall or the ends, away from the rims between them.
    [[nodiscard]] reference::BoundaryErrors errors(const std::vector<float>& values, bool ofEnds) const {
        return reference::boundaryErrors(
            values, kDims, glm::dvec3(1), [&](const glm::dvec3& p) -> std::optional<reference::Deviation> {
                const auto place = first_.locate(p);
                const auto off = reference::distanceTo(outline_, place.element);
                if (distanceToSecond(p) < kAway) {
                    return std::nullopt;
                }
                const double toEnd = std::min(place.fromStart, place.toEnd);
                if (!ofEnds && toEnd > kAway) {
                    return reference::Deviation{off.distance,
                                                off.normal.x * place.x + off.normal.y * place.y};
                }
                if (ofEnds && off.distance < -kAway && toEnd < kAway) {
                    const glm::dvec3 along = glm::cross(place.x, place.y);
                    return reference::Deviation{-toEnd, place.fromStart < place.toEnd ? -along : along};
                }
                return std::nullopt;
            });
    }

private:
    [[nodiscard]] double distanceToSecond(const glm::dvec3& p) const {
        const auto place = second_.locate(p);
        return std::max(
            {reference::distanceTo(outline_, place.element).distance, -place.fromStart, -place.toEnd});
    }
    [[nodiscard]] std::array<std::vector<PathPiece>, 2> paths() const {
        return {polylinePath(std::span(ends_).subspan(0, 2)), polylinePath(std::span(ends_).subspan(1, 2))};
    }
    static MaskRaster mask(double pitch) { return rasterize(ellipseOutline(kCentre, kRadii), pitch); }
    static void unite(std::vector<float>& all, const std::vector<float>& one) {
        std::transform(all.begin(), all.end(), one.begin(), all.begin(),
                       [](float a, float b) { return std::max(a, b); });
    }

    std::array<glm::dvec3, 3> ends_;
    Radiator radiator_;
    PointGenerator generator_;
    reference::SweptCurve first_;
    reference::SweptCurve second_;
    std::vector<glm::dvec2> outline_;
};

void measureMethods() {
    heading("Projection and radiation on a joint of two pipes (figure 3.19)", "method, part, mask pitch");
    PipeJoint joint;
    for (const double pitch : {1.0, 0.5}) {
        const auto projected = joint.projected(pitch);
        const auto radiated = joint.radiated(pitch);
        for (const bool ofEnds : {false, true}) {
            const auto* part = ofEnds ? "ends" : "wall";
            row(fmt::format("projection, {}, {}", part, pitch), joint.errors(projected, ofEnds));
            row(fmt::format("radiation, {}, {}", part, pitch), joint.errors(radiated, ofEnds));
        }
    }
}

} // namespace

int main() {
    try {
        const gl::Context context = gl::Context::createHeadless();
        HelixBench bench;
        measureFilters(bench);
        measureWidths(bench);
        measureSubdivision(bench);
        measurePrecision(bench);
        measureRadii(bench);
        measureMethods();
        context.requireNoErrors();
    } catch (const std::exception& error) {
        fmt::print(stderr, "boundary_errors: {}\n", error.what());
        return 1;
    }
    return 0;
}
