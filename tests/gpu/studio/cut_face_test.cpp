// SPDX-License-Identifier: Apache-2.0
// Cut faces have no specks: one ray a pixel shows what many show.
#include "gpu/gl_test.h"
#include "gpu/sculpt/surface_makers.h"
#include "gpu/studio/sculpture_bytes.h"
#include "render/rays/picker.h"
#include "render/rays/ray_caster.h"
#include "test_head.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vs::studio {
namespace {

using CutFaceTest = test::GlTest;

constexpr glm::ivec2 kSize{240, 200};

// A solid ball with a texture as coarse as tissue, and a scan's noise.
volume::Volume texturedBall() {
    return phantom::makePhantom({72, 72, 72}, volume::ScalarType::UInt8, [](glm::dvec3 p) {
        const double r = glm::length(p - glm::dvec3(35.5));
        const double texture = 140 + 50 * std::sin(0.35 * p.x + 0.1 * p.z) * std::cos(0.3 * p.y);
        const double noise =
            8 * (glm::fract(std::sin(glm::dot(p, glm::dvec3(12.9898, 78.233, 37.719))) * 43758.5453) - 0.5);
        return (texture + noise) * std::clamp(0.5 + (30 - r) / 2, 0.0, 1.0);
    });
}

// With a range from 110 up the face has pockets, whose rims are met beside it.
View viewFrom(double azimuth, double elevation, render::Mode mode = render::Mode::Surface, double lo = 50) {
    View view = test::testCanvas({lo, 255}).view;
    view.camera = {azimuth, elevation, 1.1, {}, render::Projection::Perspective};
    view.mode = mode;
    return view;
}

image::Image pictureOf(Document& document, int samples) {
    render::Frame frame = document.frame(kSize);
    frame.samples = samples;
    render::RayCaster caster;
    caster.render(frame);
    return caster.readPicture();
}

// Which pixels show a cut face, and nothing else two pixels around.
std::vector<bool> pixelsWithinFaces(Document& document) {
    const auto values = sculpt::valuesOf(test::sculptureBytes(document), sculpt::Precision::Bits16);
    std::vector<glm::vec2> pixels;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            pixels.emplace_back(x + 0.5F, y + 0.5F);
        }
    }
    render::Picker picker;
    const auto points = picker.pickPoints(document.frame(kSize), pixels);
    const auto isOnFace = [&](int x, int y) {
        const auto& point = points[std::size_t(y * kSize.x + x)];
        return point.voxel.w > 0.5F &&
               std::abs(test::sampleGrid(values, document.volume().geometry.dims, glm::dvec3(point.voxel)) -
                        0.5F) < 0.02F;
    };
    std::vector<bool> within(points.size(), false);
    for (int y = 2; y < kSize.y - 2; ++y) {
        for (int x = 2; x < kSize.x - 2; ++x) {
            bool isWithin = true;
            for (int n = 0; n < 25 && isWithin; ++n) {
                isWithin = isOnFace(x + n % 5 - 2, y + n / 5 - 2);
            }
            within[std::size_t(y * kSize.x + x)] = isWithin;
        }
    }
    return within;
}

// How far a pixel's green is from the median of its 3 x 3 neighbours.
int speck(const image::Image& picture, int x, int y) {
    std::array<int, 9> values{};
    for (int n = 0; n < 9; ++n) {
        values[std::size_t(n)] = picture.pixel(x + n % 3 - 1, y + n / 3 - 1)[1];
    }
    std::nth_element(values.begin(), values.begin() + 4, values.end());
    return std::abs(picture.pixel(x, y)[1] - values[4]);
}

void expectNoSpecks(Document& document, const View& view, const std::string& what) {
    document.showView(view);
    const auto within = pixelsWithinFaces(document);
    const auto one = pictureOf(document, 1);
    const auto many = pictureOf(document, 64);
    int texture = 0;
    for (int i = 0; i < kSize.x * kSize.y; ++i) {
        texture = within[std::size_t(i)] ? std::max(texture, speck(many, i % kSize.x, i / kSize.x)) : texture;
    }
    // Many samples take up to a third off the texture; two pixels are dithered, up and down.
    constexpr int dither = 4;
    int faces = 0;
    int specks = 0;
    for (int i = 0; i < kSize.x * kSize.y; ++i) {
        if (within[std::size_t(i)]) {
            ++faces;
            const int x = i % kSize.x;
            const int y = i / kSize.x;
            specks += speck(one, x, y) > texture + texture / 2 + dither ? 1 : 0;
        }
    }
    EXPECT_EQ(specks, 0) << what << ", of " << faces << " pixels, texture " << texture;
    EXPECT_GT(faces, 300) << what << ": the face must be seen";
}

// From straight in front of a face to almost along it.
TEST_F(CutFaceTest, PlanesShowTheirTextureAndNothingElse) {
    for (const glm::dvec3 normal :
         {glm::dvec3(0, -1, 0), glm::dvec3(0.31, -0.83, 0.47), glm::dvec3(-0.6, -0.7, 0.2)}) {
        Document document(texturedBall());
        Clip clip;
        clip.planes = {{glm::dvec3(document.volume().geometry.centreWorld()) + 4.3 * glm::normalize(normal),
                        glm::normalize(normal)}};
        document.apply(clip);
        for (const double azimuth : {0.0, 30.0}) {
            for (const double lo : {50.0, 110.0}) {
                expectNoSpecks(
                    document, viewFrom(azimuth, 10, render::Mode::Surface, lo),
                    fmt::format("a plane facing {:.1f}, from {}, above {}", normal.x, azimuth, lo));
            }
        }
    }
}

TEST_F(CutFaceTest, HolesShowTheirTextureAndNothingElse) {
    for (const double radius : {24.0, 70.0}) {
        Document document(texturedBall());
        Drill drill = test::drillOf(test::ellipseAt(200, 150, radius, radius), test::testCanvas());
        drill.canvas->view = viewFrom(0, 10);
        drill.depthMax = 18;
        document.apply(drill);
        for (const double azimuth : {0.0, radius / 4}) { // into a wide one aslant
            for (const double lo : {50.0, 110.0}) {
                expectNoSpecks(document, viewFrom(azimuth, 10, render::Mode::Surface, lo),
                               fmt::format("a hole of {} pixels, from {}, above {}", radius, azimuth, lo));
            }
        }
    }
}

TEST_F(CutFaceTest, PeeledFacesShowTheirTextureAndNothingElse) {
    Document document(texturedBall());
    Peel peel = test::somePeel(7);
    peel.canvas->view = viewFrom(0, 10);
    document.apply(peel);
    Seed seed;
    seed.voxels = {{35, 35, 35}};
    seed.range = Range{50, 255};
    seed.canvas = test::testCanvas();
    seed.canvas->view = viewFrom(0, 10);
    document.apply(seed);
    document.apply(Grow{});
    for (const render::Mode mode : {render::Mode::Surface, render::Mode::Segment}) {
        for (const auto sampling : {field::Sampling::Trilinear, field::Sampling::Tricubic}) {
            View view = viewFrom(10, 30, mode);
            view.sampling = sampling;
            expectNoSpecks(document, view, fmt::format("peeled, {}", render::name(mode)));
        }
    }
}

} // namespace
} // namespace vs::studio
