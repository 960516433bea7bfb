// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"
#include "studio/selfcheck/still.h"

#include "gl/context.h"
#include "reference/trilinear.h"

#include <cmath>

namespace vs::studio {

namespace {

constexpr glm::dvec3 kSphereCentre(47.3, 46.1, 48.2);
constexpr double kSphereRadius =
    40; // so large that values between voxels are those of a sphere to 0.007 voxel
constexpr glm::ivec2 kSurfacePicture(56, 44);

// 100 on a sphere, and more inside by the distance from it: in voxels of 1 mm.
volume::Volume makeRoundRamp() {
    return phantom::makePhantom({96, 94, 97}, volume::ScalarType::Float32, [](glm::dvec3 p) {
        return 100 + kSphereRadius - glm::length(p - kSphereCentre);
    });
}

glm::ivec2 pixelOfIndex(std::size_t i) { return {int(i) % kSurfacePicture.x, int(i) / kSurfacePicture.x}; }

// How much farther off hits are where the texture filter knows places between voxels to 8 bits only.
double filterError() { return gl::Context::isSoftware() ? 0 : 0.008; }

// Where a ray passes a sphere: how far from its centre, and along the ray where it enters.
struct Passage {
    double miss = 0;
    double entry = 0; // mm; meaningful for rays that meet it
};
Passage passageOf(const render::ViewRays::Ray& ray, double radius) {
    const double along = glm::dot(kSphereCentre - ray.origin, ray.direction);
    const double miss = glm::length(kSphereCentre - ray.origin - along * ray.direction);
    return {miss, along - std::sqrt(std::max(radius * radius - miss * miss, 0.0))};
}

// Points that were met on a sphere: which rays meet it, how far they lie from it and from their rays, which
// way they face and how far from the eye they are.
void compareSphere(Tally& tally, const Still& still, const std::vector<field::SurfacePoint>& points,
                   const std::string& what) {
    tally.about(what + ": rays");
    tally.compare(double(points.size()), kSurfacePicture.x * kSurfacePicture.y);
    int hits = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto ray = still.rayOf(pixelOfIndex(i));
        const Passage passage = passageOf(ray, kSphereRadius);
        const bool isHit = points[i].voxel.w > 0.5F;
        if (std::abs(passage.miss - kSphereRadius) > 0.05) {
            tally.about(what + ": hits");
            tally.compare(isHit ? 1 : 0, passage.miss < kSphereRadius ? 1 : 0);
        }
        if (!isHit) {
            continue;
        }
        ++hits;
        const glm::dvec3 found(points[i].voxel);
        const glm::dvec3 fromEye = found - ray.origin;
        tally.about(what + ": distance from the sphere, voxels");
        tally.compare(glm::length(found - kSphereCentre), kSphereRadius, 0.01 + filterError());
        tally.about(what + ": distance from the ray, voxels");
        tally.compare(glm::length(fromEye - glm::dot(fromEye, ray.direction) * ray.direction), 0, 1e-3);
        tally.about(what + ": distance from the eye, mm");
        tally.compare(double(points[i].normal.w), glm::length(fromEye), 2e-3);
        tally.about(what + ": cosine of the normal's error");
        tally.compare(glm::dot(glm::dvec3(points[i].normal), glm::normalize(found - kSphereCentre)), 1, 2e-3);
    }
    tally.about(what + ": hits");
    tally.require(hits > 500);
}

// Each pixel of a surface picture shows something where its ray meets the sphere, and black elsewhere.
void compareSpherePicture(Tally& tally, const Still& still, const image::Image& picture) {
    tally.about("pixels that show a surface");
    for (int y = 0; y < kSurfacePicture.y; ++y) {
        for (int x = 0; x < kSurfacePicture.x; ++x) {
            const double miss = passageOf(still.rayOf({x, y}), kSphereRadius).miss;
            if (std::abs(miss - kSphereRadius) > 0.05) {
                const auto* pixel = picture.pixel(x, y);
                tally.compare(pixel[0] + pixel[1] + pixel[2] > 0 ? 1 : 0, miss < kSphereRadius ? 1 : 0);
            }
        }
    }
}

} // namespace

void checkSurfaces(Tally& tally) {
    Still still(makeRoundRamp(), {100, 1000}, {}, kSurfacePicture);
    for (const auto projection : {render::Projection::Perspective, render::Projection::Orthographic}) {
        still.look({25, 15, 1, {}, projection}, kSurfacePicture);
        compareSphere(tally, still, still.pick(render::Mode::Surface), "picked surface");
        compareSpherePicture(tally, still, still.picture(render::Mode::Surface));
    }
}

void checkCutFaces(Tally& tally) {
    constexpr double cutAt = 50.3; // voxel y; what lies behind is cut away
    Still still(makeRoundRamp(), {100, 1000}, {180, 10, 1, {}, render::Projection::Perspective},
                kSurfacePicture);
    still.sculpt([](glm::dvec3 p) { return std::clamp(0.5 + (p.y - cutAt) / 8, 0.0, 1.0); });
    const auto points = still.pick(render::Mode::Surface);
    int onFace = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto ray = still.rayOf(pixelOfIndex(i));
        const glm::dvec3 place = ray.origin + (cutAt - ray.origin.y) / ray.direction.y * ray.direction;
        const double depth = kSphereRadius - glm::length(place - kSphereCentre);
        if (depth > 0.2) {
            ++onFace;
            tally.about("places on a cut's face, voxels");
            tally.compare(glm::length(glm::dvec3(points[i].voxel) - place), 0, 0.02 + 2 * filterError());
            tally.about("normals of a cut's face");
            tally.compare(double(points[i].normal.y), 1, 1e-3);
        } else if (depth < -0.2 && points[i].voxel.w > 0.5F) {
            tally.about("places beside a cut's face");
            tally.require(double(points[i].voxel.y) < cutAt);
        }
    }
    tally.about("rays that meet a cut's face");
    tally.require(onFace > 300);
}

void checkSegmentSurfaces(Tally& tally) {
    // A haze whose gradient must not be taken for the segment's.
    Still still(
        phantom::makePhantom({96, 94, 97}, volume::ScalarType::UInt8, [](glm::dvec3 p) { return p.x; }),
        {200, 255}, {40, -20, 1, {}, render::Projection::Perspective}, kSurfacePicture);
    still.segment([](glm::dvec3 p) {
        return std::clamp(0.5 + (kSphereRadius - glm::length(p - kSphereCentre)) / 12, 0.0, 1.0);
    });
    compareSphere(tally, still, still.pick(render::Mode::Segment), "picked segment");
    compareSpherePicture(tally, still, still.picture(render::Mode::Segment));
}

void checkBrightest(Tally& tally) {
    Still still(makeNoise({22, 19, 25}, volume::ScalarType::Float32, 0, 200, {1, 1.4, 0.8}), {0, 200},
                {40, 28, 1, {}, render::Projection::Perspective}, kSurfacePicture);
    const auto points = still.pick(render::Mode::Mip, render::Picker::Meets::Brightest);
    tally.about("greatest values along rays");
    int met = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto ray = still.plainRayOf(pixelOfIndex(i));
        // A ray that only touches the box may have one sample more or less.
        if (points[i].voxel.w > 0.5F && ray.way.hi - ray.way.lo > 1) {
            ++met;
            const double value = reference::trilinearAt(still.volume(), glm::dvec3(points[i].voxel));
            tally.compare(value, reference::greatestAlong(still.volume(), ray, 0.5), 1 + 400 * filterError());
        }
    }
    tally.require(met > 500);
}

} // namespace vs::studio
