// SPDX-License-Identifier: Apache-2.0
// The tint of segments on cut faces: a ball's is the disc that the plane cuts out of it, whether the ball was
// grown before or after the cut.
#include "gpu/gl_test.h"
#include "gpu/studio/test_segments.h"
#include "image/compare.h"
#include "render/ray_caster.h"
#include "render/slice_renderer.h"

#include <cmath>
#include <numbers>

namespace vs::studio {
namespace {

using CutTintTest = test::GlTest;
using test::setOf;
using test::stateOf;

constexpr glm::ivec2 kPicture{300, 300};
const glm::dvec3 kRed(0.9, 0.2, 0.1);
const glm::dvec3 kBlue(0.1, 0.3, 0.9);

enum class Order { GrownThenCut, CutThenGrown };

// A plane across the line of sight, `offsetMm` in front of the ball's centre: what is nearer is cut away.
struct Plane {
    double azimuthDegrees = 0;
    double elevationDegrees = 0;
    double offsetMm = 0;
};

// A ball with a soft edge, on a ground that is seen too. Inside `inner` it is brighter.
struct Ball {
    glm::ivec3 dims{64};
    glm::dvec3 spacing{1};
    double radiusMm = 20.4;
    double innerMm = 0;
    double noise = 0; // of the data, to both sides

    [[nodiscard]] glm::dvec3 centreVoxel() const {
        return glm::dvec3(dims - 1) * 0.5 + glm::dvec3(0.3, -0.2, 0.1);
    }
    [[nodiscard]] volume::Volume volume() const {
        unsigned state = 1;
        return volume::makePhantom(
            dims, volume::ScalarType::UInt8,
            [&, this](glm::dvec3 v) {
                const double r = glm::length((v - centreVoxel()) * spacing);
                const double ground = std::clamp(100 + 20 * (radiusMm - r), 40.0, 130.0);
                state = state * 1664525U + 1013904223U;
                const double speckle = noise * (double(state >> 8) / double(1U << 23) - 1);
                return std::clamp(ground + std::clamp(30 + 20 * (innerMm - r), 0.0, 60.0), 0.0, 255.0) +
                       speckle;
            },
            spacing);
    }
};

View viewOf(const Plane& plane, render::Mode mode) {
    View view;
    view.range = {20, 255};
    view.mode = mode;
    view.camera = {plane.azimuthDegrees, plane.elevationDegrees, 1.6, {}, render::Projection::Orthographic};
    return view;
}

// A document with a ball that is seeded, grown and cut.
struct CutBall {
    CutBall(const Ball& theBall, const Plane& thePlane, Order order)
        : ball(theBall), plane(thePlane), document(ball.volume()) {
        look(render::Mode::Segment);
        if (order == Order::CutThenGrown) {
            document.apply(clip());
        }
        grow();
        if (order == Order::GrownThenCut) {
            document.apply(clip());
        }
    }

    void look(render::Mode mode) { document.look(viewOf(plane, mode)); }

    [[nodiscard]] glm::dvec3 centre() const {
        return glm::dvec3(document.volume().geometry.worldFromVoxel * glm::dvec4(ball.centreVoxel(), 1));
    }
    [[nodiscard]] render::ViewRays rays() const {
        return render::viewRays(viewOf(plane, {}).camera, document.volume().geometry, kPicture);
    }
    [[nodiscard]] glm::dvec3 discCentre() const { return centre() - plane.offsetMm * rays().forward; }
    [[nodiscard]] Clip clip() const {
        Clip op;
        op.planes = {{discCentre(), -rays().forward}};
        return op;
    }

    void seed(const std::string& segment, glm::dvec3 colour, Range range, double beside) {
        UseSegment use{segment};
        use.colour = colour;
        document.apply(use);
        // Behind the face, where both orders can begin.
        const glm::dvec3 place = discCentre() + 4.0 * rays().forward + beside * glm::normalize(rays().right);
        Seed op;
        op.voxels = {glm::ivec3(
            glm::round(glm::dvec3(document.volume().geometry.voxelFromWorld() * glm::dvec4(place, 1))))};
        op.range = range;
        document.apply(op);
        document.apply(Grow{});
    }
    void grow() {
        if (ball.innerMm > 0) {
            seed("Inner", kBlue, {160, 255}, 0);
            seed("Segment 1", kRed, {100, 159}, 0.5 * (ball.innerMm + ball.radiusMm));
        } else {
            seed("Segment 1", kRed, {100, 255}, 0);
        }
    }

    image::Image picture() {
        render::RayCaster caster;
        caster.render(document.frame(kPicture));
        return caster.readPicture();
    }
    // With all segments of one colour, or hidden.
    image::Image pictureIn(std::optional<glm::dvec3> colour) {
        const auto before = document.segments();
        for (const auto& segment : before.segments) {
            UseSegment use{segment.name};
            use.colour = colour;
            use.isVisible = colour.has_value();
            use.goesToWork = false;
            document.apply(use);
        }
        auto result = picture();
        for (const auto& segment : before.segments) {
            UseSegment use{segment.name};
            use.colour = segment.colour;
            use.isVisible = segment.isVisible;
            use.goesToWork = false;
            document.apply(use);
        }
        return result;
    }

    Ball ball;
    Plane plane;
    Document document;
};

double apart(const image::Image& a, const image::Image& b, int x, int y) {
    double most = 0;
    for (int c = 0; c < 3; ++c) {
        most = std::max(most, std::abs(double(a.pixel(x, y)[c]) - double(b.pixel(x, y)[c])));
    }
    return most;
}

// How far, in voxels, the part of the picture that looks like `here` and not like `elsewhere` reaches beyond
// a disc of a radius around the place, or stays behind it.
struct Misfit {
    double beyond = 0;
    double behind = 0;
    int pixels = 0; // inside the disc by half a voxel or more that do not look like `here`
};
Misfit misfit(CutBall& cut, const image::Image& seen, const image::Image& here, const image::Image& elsewhere,
              double sphereMm) {
    const auto rays = cut.rays();
    const glm::dvec3 centre = cut.discCentre();
    const double radius = std::sqrt(sphereMm * sphereMm - cut.plane.offsetMm * cut.plane.offsetMm);
    const glm::dmat3 voxelFromWorld(cut.document.volume().geometry.voxelFromWorld());
    const glm::dvec3 right = glm::normalize(rays.right);
    const glm::dvec3 up = glm::normalize(rays.up);
    Misfit result;
    for (int y = 0; y < kPicture.y; ++y) {
        for (int x = 0; x < kPicture.x; ++x) {
            const auto ray = rays.through({x + 0.5, y + 0.5});
            const glm::dvec3 place =
                ray.origin + ray.direction * glm::dot(centre - ray.origin, ray.direction) - centre;
            const double fromRim = glm::length(place) - radius;
            const bool isHere = apart(seen, here, x, y) <= apart(seen, elsewhere, x, y);
            if (isHere == (fromRim <= 0) || apart(here, elsewhere, x, y) < 12) {
                continue;
            }
            double voxels = 1e9;
            for (int i = 0; i < 720; ++i) {
                const double angle = i * std::numbers::pi / 360;
                const glm::dvec3 rim = radius * (std::cos(angle) * right + std::sin(angle) * up);
                voxels = std::min(voxels, glm::length(voxelFromWorld * (place - rim)));
            }
            (isHere ? result.beyond : result.behind) =
                std::max(isHere ? result.beyond : result.behind, voxels);
            result.pixels += !isHere && voxels > 0.5 ? 1 : 0;
        }
    }
    return result;
}

const Plane kPlanes[] = {{0, 0, 0.4},    {0, 0, 9},      {33, 21, -0.3}, {33, 21, 10},   {33, 21, -10},
                         {45, 35.26, 0}, {45, 35.26, 8}, {-70, 58, -8},  {12, 80, 12.5}, {160, -30, 6}};

void expectDisc(const Ball& ball, const Plane& plane, Order order, double tolerance) {
    const std::string what =
        fmt::format("azimuth {} elevation {} offset {} {}", plane.azimuthDegrees, plane.elevationDegrees,
                    plane.offsetMm, order == Order::CutThenGrown ? "cut, then grown" : "grown, then cut");
    CutBall cut(ball, plane, order);
    const auto before = stateOf(cut.document);
    const auto seen = cut.picture();
    const auto without = cut.pictureIn({});
    const auto all = misfit(cut, seen, cut.pictureIn(kRed), without, ball.radiusMm);
    fmt::print("{}: beyond {:.2f} behind {:.2f}, {} pixels\n", what, all.beyond, all.behind, all.pixels);
    EXPECT_LT(all.beyond, tolerance) << what;
    EXPECT_LT(all.behind, tolerance) << what;
    EXPECT_TRUE(stateOf(cut.document) == before) << "pictures change nothing: " << what;
}

TEST_F(CutTintTest, IsTheDiscThatThePlaneCutsOutOfABall) {
    for (const Plane& plane : kPlanes) {
        for (const Order order : {Order::GrownThenCut, Order::CutThenGrown}) {
            expectDisc({}, plane, order, 0.5);
        }
    }
}

TEST_F(CutTintTest, IsADiscAcrossThickSlicesToo) {
    Ball ball;
    ball.dims = {64, 64, 22};
    ball.spacing = {1, 1, 3};
    for (const Plane& plane : kPlanes) {
        for (const Order order : {Order::GrownThenCut, Order::CutThenGrown}) {
            expectDisc(ball, plane, order, 0.5);
        }
    }
}

} // namespace
} // namespace vs::studio
