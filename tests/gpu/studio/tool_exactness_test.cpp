// SPDX-License-Identifier: Apache-2.0
// Tools on analytic bodies, through the whole chain: pen, rays, surface, mask, radiation, sculpture.
#include "gpu/gl_test.h"
#include "gpu/sculpt/surface_makers.h"
#include "gpu/studio/sculpture_bytes.h"
#include "test_head.h"

#include <cmath>

namespace vs::studio {
namespace {

using ToolExactness = test::GlTest;

// A volume that is 1000 per step inside a body, `depth(world)` being how deep (mm) a place is below its
// surface: the displayed range from kSurface up begins exactly on it.
constexpr double kSurface = 20000;
volume::Volume bodyOf(glm::ivec3 dims, glm::dvec3 spacing, const std::function<double(glm::dvec3)>& depth) {
    return phantom::makePhantom(
        dims, volume::ScalarType::UInt16,
        [=](glm::dvec3 voxel) { return std::clamp(kSurface + 3000 * depth(voxel * spacing), 0.0, 60000.0); },
        spacing);
}

Canvas canvasOf(glm::ivec2 viewport, double azimuth, double elevation, double zoom) {
    Canvas canvas;
    canvas.viewport = viewport;
    canvas.view.range = {kSurface, 65000};
    canvas.view.camera = {azimuth, elevation, zoom, {}, render::Projection::Perspective};
    return canvas;
}

// The sculpture of a document, to be sampled in millimetres.
struct Cut {
    Cut(const Document& document, glm::dvec3 gridSpacing)
        : values(sculpt::valuesOf(test::sculptureBytes(document), sculpt::Precision::Bits16)),
          dims(document.volume().geometry.dims), spacing(gridSpacing) {}

    [[nodiscard]] double at(glm::dvec3 world) const {
        return test::sampleGrid(values, dims, world / spacing);
    }
    // How far from a place that was cut the cut goes on along a unit way, mm.
    [[nodiscard]] double reach(glm::dvec3 from, glm::dvec3 way, double most) const {
        double lo = 0;
        double hi = most;
        for (int n = 0; n < 40; ++n) {
            const double mid = 0.5 * (lo + hi);
            (at(from + mid * way) >= 0.5 ? lo : hi) = mid;
        }
        return lo;
    }

    std::vector<float> values;
    glm::ivec3 dims;
    glm::dvec3 spacing;
};

// A flat slab facing the viewer's side of the grid (towards -y), tilted.
struct Slab {
    glm::dvec3 spacing;
    glm::ivec3 dims;
    glm::dvec3 point;
    glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, -1, 0.3));

    explicit Slab(glm::dvec3 s)
        : spacing(s), dims(glm::ivec3(96.0 / s)), point(0.5 * (glm::dvec3(dims) - 1.0) * s) {}
    [[nodiscard]] volume::Volume volume() const {
        return bodyOf(dims, spacing, [*this](glm::dvec3 p) { return -glm::dot(p - point, normal); });
    }
};

const glm::dvec3 kSpacings[] = {{1, 1, 1}, {1, 1, 3}};

TEST_F(ToolExactness, TheDrillsFloorLiesAtItsDepth) {
    for (const glm::dvec3 spacing : kSpacings) {
        const Slab slab(spacing);
        Document document(slab.volume());
        Drill drill;
        drill.mask = test::ellipseAt(200, 150, 30, 24);
        drill.canvas = canvasOf({400, 300}, 25, 15, 1);
        drill.stroke = {{{180, 150}, 1}, {{222, 155}, 1}};
        ASSERT_GT(document.apply(drill).voxelsTouched, 1000U);
        const Cut cut(document, spacing);
        const auto rays = render::viewRays(drill.canvas->view.camera, document.volume().geometry, {400, 300});
        for (const glm::dvec2 pixel : {glm::dvec2(180, 150), glm::dvec2(200, 145), glm::dvec2(222, 160)}) {
            const auto ray = rays.through(pixel);
            const double t =
                glm::dot(slab.point - ray.origin, slab.normal) / glm::dot(ray.direction, slab.normal);
            const glm::dvec3 surface = ray.origin + t * ray.direction;
            EXPECT_NEAR(cut.reach(surface, ray.direction, 30), 10, 0.15) << spacing.z << " " << pixel.x;
        }
    }
}

TEST_F(ToolExactness, TheLasersFloorLiesAtItsDepthBelowTheSurface) {
    for (const glm::dvec3 spacing : kSpacings) {
        const Slab slab(spacing);
        Document document(slab.volume());
        Laser laser;
        laser.mask = test::ellipseAt(200, 150, 30, 24);
        laser.canvas = canvasOf({400, 300}, 25, 15, 1);
        laser.depthMax = 12;
        laser.stroke = {{{180, 150}, 1}, {{222, 155}, 1}};
        ASSERT_GT(document.apply(laser).voxelsTouched, 1000U);
        const Cut cut(document, spacing);
        const auto rays = render::viewRays(laser.canvas->view.camera, document.volume().geometry, {400, 300});
        for (const glm::dvec2 pixel : {glm::dvec2(180, 150), glm::dvec2(200, 152), glm::dvec2(222, 155)}) {
            const auto ray = rays.through(pixel);
            const double t =
                glm::dot(slab.point - ray.origin, slab.normal) / glm::dot(ray.direction, slab.normal);
            const glm::dvec3 surface = ray.origin + t * ray.direction;
            EXPECT_NEAR(cut.reach(surface, -slab.normal, 30), 12, 0.15) << spacing.z << " " << pixel.x;
            // Half as deep on the way down it is still as wide as the mask, which lies on the surface: its
            // sides run along the normal.
            EXPECT_GT(cut.at(surface - 9.0 * slab.normal), 0.9);
        }
    }
}

TEST_F(ToolExactness, LayersComeOffABall) {
    for (const glm::dvec3 spacing : kSpacings) {
        const double radius = 60;
        const glm::ivec3 dims(glm::ceil(144.0 / spacing));
        const glm::dvec3 centre = 0.5 * (glm::dvec3(dims) - 1.0) * spacing;
        Document document(
            bodyOf(dims, spacing, [=](glm::dvec3 p) { return radius - glm::distance(p, centre); }));
        for (const double layers : {1.0, 4.0, 7.5}) {
            Peel peel;
            peel.mask = test::ellipseAt(215, 140, 60, 60);
            peel.layers = layers;
            peel.canvas = canvasOf({400, 300}, 30, 20, 1);
            ASSERT_GT(document.apply(peel).voxelsTouched, 1000U);
            const Cut cut(document, spacing);
            const auto rays =
                render::viewRays(peel.canvas->view.camera, document.volume().geometry, {400, 300});
            double squared = 0;
            double worst = 0;
            int count = 0;
            int untouched = 0;
            for (int n = 0; n < 2000; ++n) { // evenly over the ball (Vogel's spiral)
                const double z = 1 - (2 * n + 1) / 2000.0;
                const double angle = 2.399963 * n;
                const glm::dvec3 way(std::sqrt(1 - z * z) * std::cos(angle),
                                     std::sqrt(1 - z * z) * std::sin(angle), z);
                const glm::dvec3 surface = centre + radius * way;
                const double inMask = glm::length((rays.project(surface) - glm::dvec2(215, 140)) / 60.0);
                const bool isFront = glm::dot(way, rays.eye - surface) > 0;
                if (isFront && inMask < 0.85) {
                    const double off = cut.reach(surface, -way, 20) - layers;
                    squared += off * off;
                    worst = std::max(worst, std::abs(off));
                    ++count;
                } else if (!isFront || inMask > 1.25) {
                    EXPECT_EQ(cut.at(surface - 2.0 * way), 0) << "outside the mask nothing changes";
                    ++untouched;
                }
            }
            ASSERT_GT(count, 50);
            ASSERT_GT(untouched, 500);
            EXPECT_LT(std::sqrt(squared / count), 0.2)
                << layers << " spacing " << spacing.z << " worst " << worst;
            document.apply(Undo{});
        }
    }
}

TEST_F(ToolExactness, LayersComeOffAHollowBallFromInside) {
    for (const glm::dvec3 spacing : kSpacings) {
        const double radius = 30;
        const glm::ivec3 dims(glm::ceil(108.0 / spacing));
        const glm::dvec3 centre = 0.5 * (glm::dvec3(dims) - 1.0) * spacing;
        Document document(
            bodyOf(dims, spacing, [=](glm::dvec3 p) { return glm::distance(p, centre) - radius; }));
        Peel peel;
        peel.layers = 14;
        peel.canvas = canvasOf({400, 300}, 10, -10, 28); // the eye is inside
        const auto rays = render::viewRays(peel.canvas->view.camera, document.volume().geometry, {400, 300});
        ASSERT_LT(glm::distance(rays.eye, centre), 15);
        peel.mask = test::ellipseAt(200, 150, 130, 110);
        ASSERT_GT(document.apply(peel).voxelsTouched, 1000U);
        const Cut cut(document, spacing);
        double squared = 0;
        double lowest = 1;
        int count = 0;
        for (int y = 80; y <= 220; y += 7) {
            for (int x = 115; x <= 285; x += 7) {
                if (glm::length((glm::dvec2(x, y) - glm::dvec2(200, 150)) / glm::dvec2(130, 110)) > 0.6) {
                    continue;
                }
                const auto ray = rays.through({x, y});
                const glm::dvec3 toCentre = centre - ray.origin; // from inside the ray meets it once
                const double along = glm::dot(toCentre, ray.direction);
                const double t =
                    along + std::sqrt(along * along - glm::dot(toCentre, toCentre) + radius * radius);
                const glm::dvec3 surface = ray.origin + t * ray.direction;
                const glm::dvec3 way = glm::normalize(surface - centre);
                for (double depth = 0; depth <= 14 - 2.5 * spacing.z; depth += 0.5) {
                    lowest = std::min(lowest, cut.at(surface + depth * way));
                }
                const double off = cut.reach(surface, way, 25) - 14;
                squared += off * off;
                ++count;
            }
        }
        ASSERT_GT(count, 200);
        // Slices of 3 steps blur the beginning, 3 steps before the surface, to here.
        EXPECT_GT(lowest, spacing.z > 1 ? 0.8 : 0.9) << "no gaps; spacing " << spacing.z;
        EXPECT_LT(std::sqrt(squared / count), 0.2) << "spacing " << spacing.z;
    }
}

double largestDifference(const Document& a, const Document& b) {
    const auto x = sculpt::valuesOf(test::sculptureBytes(a), sculpt::Precision::Bits16);
    const auto y = sculpt::valuesOf(test::sculptureBytes(b), sculpt::Precision::Bits16);
    double worst = 0;
    for (std::size_t n = 0; n < x.size(); ++n) {
        worst = std::max(worst, std::abs(double(x[n]) - y[n]));
    }
    return worst;
}

// The same drilling in a picture of another size.
Drill drillOnPicture(double scale, const sculpt::Stroke& stroke) {
    Drill drill;
    drill.mask = {Shape::Ellipse, {{170 * scale, 126 * scale}, {230 * scale, 174 * scale}}};
    drill.canvas = canvasOf({int(400 * scale), int(300 * scale)}, 25, 15, 1);
    drill.stroke = stroke;
    for (auto& pen : drill.stroke) {
        pen.pixel *= scale;
    }
    return drill;
}

TEST_F(ToolExactness, ThePicturesSizeDoesNotMatter) {
    const Slab slab({1, 1, 1});
    const sculpt::Stroke stroke{{{180, 150}, 1}, {{222, 155}, 1}};
    Document small(slab.volume());
    small.apply(drillOnPicture(1, stroke));
    for (const double scale : {1.7, 3.0}) {
        Document large(slab.volume());
        large.apply(drillOnPicture(scale, stroke));
        EXPECT_LE(largestDifference(small, large), 0.02) << scale;
    }
}

// Orthographic, so that the same solid is drawn: about the picture's middle, twice as near and twice as
// large.
TEST_F(ToolExactness, TheZoomDoesNotMatter) {
    const Slab slab({1, 1, 1});
    const auto drilled = [&](double zoom) {
        Document document(slab.volume());
        Drill drill;
        drill.canvas = canvasOf({400, 300}, 25, 15, zoom);
        drill.canvas->view.camera.projection = render::Projection::Orthographic;
        const glm::dvec2 middle(200, 150);
        drill.mask = {Shape::Ellipse,
                      {middle - zoom * glm::dvec2(20, 15), middle + zoom * glm::dvec2(20, 15)}};
        drill.stroke = {{middle - zoom * glm::dvec2(20, 5), 1}, {middle + zoom * glm::dvec2(15, 5), 1}};
        document.apply(drill);
        return sculpt::valuesOf(test::sculptureBytes(document), sculpt::Precision::Bits16);
    };
    const auto once = drilled(1);
    for (const double zoom : {0.6, 2.5}) {
        const auto other = drilled(zoom);
        double worst = 0;
        for (std::size_t n = 0; n < once.size(); ++n) {
            worst = std::max(worst, std::abs(double(once[n]) - other[n]));
        }
        EXPECT_LE(worst, 0.02) << zoom;
    }
}

TEST_F(ToolExactness, ThePensSpeedDoesNotMatter) {
    const Slab slab({1, 1, 1});
    Document fast(slab.volume());
    fast.apply(drillOnPicture(1, {{{160, 140}, 0.4}, {{240, 160}, 1}}));
    for (const int reports : {7, 60}) {
        sculpt::Stroke stroke;
        for (int n = 0; n <= reports; ++n) {
            const double s = double(n) / reports;
            stroke.push_back(
                {glm::mix(glm::dvec2(160, 140), glm::dvec2(240, 160), s), glm::mix(0.4, 1.0, s)});
        }
        Document slow(slab.volume());
        slow.apply(drillOnPicture(1, stroke));
        EXPECT_LE(largestDifference(fast, slow), 0.02) << reports;
    }
}

} // namespace
} // namespace vs::studio
