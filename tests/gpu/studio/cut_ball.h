// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/studio/test_segments.h"
#include "render/rays/ray_caster.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace vs::test {

inline constexpr glm::ivec2 kPicture{300, 300};
inline const glm::dvec3 kRed(0.9, 0.2, 0.1);
inline const glm::dvec3 kBlue(0.1, 0.3, 0.9);

enum class Order { GrownThenCut, CutThenGrown };

// A plane across the line of sight, `offsetMm` in front of the ball's centre: what is nearer is cut away. In
// probe view the other side is, and seen.
struct Plane {
    double azimuthDegrees = 0;
    double elevationDegrees = 0;
    double offsetMm = 0;
    bool isProbed = false;
};

// A ball with a soft edge, on a ground that is seen too. Inside `inner` it is brighter.
struct Ball {
    glm::ivec3 dims{64};
    glm::dvec3 spacing{1};
    double radiusMm = 20.4;
    double innerMm = 0;

    [[nodiscard]] glm::dvec3 centreVoxel() const {
        return glm::dvec3(dims - 1) * 0.5 + glm::dvec3(0.3, -0.2, 0.1);
    }
    [[nodiscard]] volume::Volume volume() const {
        return phantom::makePhantom(
            dims, volume::ScalarType::UInt8,
            [&, this](glm::dvec3 v) {
                const double r = glm::length((v - centreVoxel()) * spacing);
                const double ground = std::clamp(100 + 20 * (radiusMm - r), 40.0, 130.0);
                return ground + std::clamp(30 + 20 * (innerMm - r), 0.0, 60.0);
            },
            spacing);
    }
};

inline studio::View viewOf(const Plane& plane, render::Mode mode) {
    studio::View view;
    view.range = {20, 255};
    view.mode = mode;
    view.sculptureView = plane.isProbed ? field::SculptureView::Probe : field::SculptureView::Cut;
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

    void look(render::Mode mode) { document.showView(viewOf(plane, mode)); }

    [[nodiscard]] glm::dvec3 centre() const {
        return glm::dvec3(document.volume().geometry.worldFromVoxel * glm::dvec4(ball.centreVoxel(), 1));
    }
    [[nodiscard]] render::ViewRays rays() const {
        return render::viewRays(viewOf(plane, {}).camera, document.volume().geometry, kPicture);
    }
    [[nodiscard]] glm::dvec3 discCentre() const { return centre() - plane.offsetMm * rays().forward; }
    [[nodiscard]] studio::Clip clip() const {
        studio::Clip op;
        op.planes = {{discCentre(), plane.isProbed ? rays().forward : -rays().forward}};
        return op;
    }

    void seed(const std::string& segment, glm::dvec3 colour, Range range, double fromCentre) {
        studio::UseSegment use{segment};
        use.colour = colour;
        document.apply(use);
        // Behind the face, where both orders can begin.
        const double behind = 3;
        const double away = behind - plane.offsetMm; // from the ball's centre, along the line of sight
        const double across = std::sqrt(std::max(0.0, fromCentre * fromCentre - away * away));
        const glm::dvec3 place =
            discCentre() + behind * rays().forward + across * glm::normalize(rays().right);
        studio::Seed op;
        op.voxels = {glm::ivec3(
            glm::round(glm::dvec3(document.volume().geometry.voxelFromWorld() * glm::dvec4(place, 1))))};
        op.range = range;
        document.apply(op);
        if (ball.innerMm > 0) { // by faces alone a segment does not reach all that the other one leaves it
            studio::SetGrowthRules rules;
            rules.connectivity = 26;
            document.apply(rules);
        }
        document.apply(studio::Grow{});
    }
    void grow() {
        if (ball.innerMm > 0) {
            seed("Segment 2", kBlue, {160, 255}, 0);
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
    // With other looks of all segments meanwhile.
    template <typename Change>
    auto with(const Change& change, const std::function<image::Image()>& draw) {
        const auto before = document.segments().segments;
        for (const auto& segment : before) {
            studio::UseSegment use{segment.name};
            use.goesToWork = false;
            change(use);
            document.apply(use);
        }
        auto result = draw();
        for (const auto& segment : before) {
            studio::UseSegment use{segment.name};
            use.colour = segment.colour;
            use.isVisible = segment.isVisible;
            use.goesToWork = false;
            document.apply(use);
        }
        return result;
    }
    image::Image in(glm::dvec3 colour) {
        return with([&](studio::UseSegment& use) { use.colour = colour; }, [this] { return picture(); });
    }
    image::Image without() {
        return with([](studio::UseSegment& use) { use.isVisible = false; }, [this] { return picture(); });
    }

    Ball ball;
    Plane plane;
    studio::Document document;
};

inline double apart(const image::Image& a, const image::Image& b, int x, int y) {
    double most = 0;
    for (int c = 0; c < 3; ++c) {
        most = std::max(most, std::abs(double(a.pixel(x, y)[c]) - double(b.pixel(x, y)[c])));
    }
    return most;
}

// How far, in voxels, the tinted part of a picture reaches beyond a disc around the face's centre, or stays
// behind it.
struct Misfit {
    double beyond = 0;
    double behind = 0;
};
using IsTinted = std::function<bool(int x, int y)>;
inline Misfit misfit(const CutBall& cut, const IsTinted& isTinted, double sphereMm) {
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
            const bool is = isTinted(x, y);
            if (is == (fromRim <= 0)) {
                continue;
            }
            double voxels = 1e9;
            for (int i = 0; i < 720; ++i) {
                const double angle = i * std::numbers::pi / 360;
                const glm::dvec3 rim = radius * (std::cos(angle) * right + std::sin(angle) * up);
                voxels = std::min(voxels, glm::length(voxelFromWorld * (place - rim)));
            }
            double& off = is ? result.beyond : result.behind;
            off = std::max(off, voxels);
        }
    }
    return result;
}

} // namespace vs::test
