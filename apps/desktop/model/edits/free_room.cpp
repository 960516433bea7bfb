// SPDX-License-Identifier: Apache-2.0
#include "model/edits/free_room.h"

#include "field/cell_ranges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace vs::desktop {

namespace {

constexpr double kMostZoom = 2;     // nearer, the viewer may stand among what is seen
constexpr double kGap = 0.02;       // of the picture's width, between two parts
constexpr double kMargin = 0.03;    // of the picture, around all of them
constexpr double kOutliers = 0.001; // of what remains: noise in the air about it

render::ViewRays raysFrom(render::Camera camera, const volume::GridGeometry& geometry, glm::ivec2 viewport) {
    camera.zoom = std::min(camera.zoom, kMostZoom);
    return viewRays(camera, geometry, viewport);
}

QRectF seenBy(const render::ViewRays& rays, const std::vector<glm::dvec3>& corners, glm::dvec3 moveMm = {}) {
    glm::dvec2 lo(1e30);
    glm::dvec2 hi(-1e30);
    for (const glm::dvec3& corner : corners) {
        const glm::dvec2 pixel = rays.project(corner + moveMm);
        lo = glm::min(lo, pixel);
        hi = glm::max(hi, pixel);
    }
    return {QPointF(lo.x, lo.y), QPointF(hi.x, hi.y)};
}

// The value below which so large a part of them lies.
double quantile(std::vector<double>& values, double part) {
    const auto nth = values.begin() + std::ptrdiff_t(std::lround(part * double(values.size() - 1)));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
}

} // namespace

FreeRoom::FreeRoom(const render::Camera& camera, const volume::GridGeometry& geometry, glm::ivec2 viewport)
    : camera_(camera), geometry_(&geometry), viewport_(viewport), rays_(raysFrom(camera, geometry, viewport)),
      gap_(kGap * viewport.x) {}

void FreeRoom::take(const std::vector<glm::dvec3>& voxels) {
    if (!voxels.empty()) {
        blocks_.push_back(blockAround(voxels, geometry_->worldFromVoxel, kOutliers));
        taken_.push_back(seenBy(rays_, blocks_.back()));
    }
}

void FreeRoom::take(const std::vector<glm::dvec3>& voxels, const render::Placement& place) {
    if (!voxels.empty()) {
        blocks_.push_back(
            blockAround(voxels, render::worldFromPart(place, *geometry_) * geometry_->worldFromVoxel, 0));
        taken_.push_back(seenBy(rays_, blocks_.back()));
    }
}

FreeRoom::Block FreeRoom::blockAround(const std::vector<glm::dvec3>& voxels, const glm::dmat4& worldFromVoxel,
                                      double outliers) const {
    const std::array<glm::dvec3, 3> axes{glm::normalize(rays_.right), glm::normalize(rays_.up),
                                         rays_.forward};
    glm::dvec3 lo;
    glm::dvec3 hi;
    std::vector<double> places(voxels.size());
    for (int axis = 0; axis < 3; ++axis) {
        std::transform(voxels.begin(), voxels.end(), places.begin(), [&](glm::dvec3 voxel) {
            return glm::dot(glm::dvec3(worldFromVoxel * glm::dvec4(voxel, 1.0)), axes[std::size_t(axis)]);
        });
        double around = 0; // the points are the middles of macrocells
        for (int n = 0; n < 3; ++n) {
            around += 0.5 * field::kCell *
                      std::abs(glm::dot(glm::dvec3(worldFromVoxel[n]), axes[std::size_t(axis)]));
        }
        lo[axis] = quantile(places, outliers) - around;
        hi[axis] = quantile(places, 1 - outliers) + around;
    }
    Block corners;
    for (int n = 0; n < 8; ++n) {
        const glm::dvec3 corner((n & 1) != 0 ? hi.x : lo.x, (n & 2) != 0 ? hi.y : lo.y,
                                (n & 4) != 0 ? hi.z : lo.z);
        corners.push_back(corner.x * axes[0] + corner.y * axes[1] + corner.z * axes[2]);
    }
    return corners;
}

glm::dvec3 FreeRoom::direction(Side side) const {
    const bool isAcross = side == Side::Right || side == Side::Left;
    const glm::dvec3 way = glm::normalize(isAcross ? rays_.right : rays_.up);
    return side == Side::Right || side == Side::Up ? way : -way;
}

// Moved on until it is seen a gap beyond an edge (a pixel's x, or y for up and down).
FreeRoom::Try FreeRoom::beyond(const Block& part, const Try& from, Side side, double edge) const {
    Try moved = from;
    for (int n = 0; n < 20; ++n) { // nearer corners move farther: a few steps lead there
        moved.seen = seenBy(rays_, part, moved.moveMm);
        const double lacking = side == Side::Right  ? edge + gap_ - moved.seen.left()
                               : side == Side::Left ? moved.seen.right() - (edge - gap_)
                               : side == Side::Down ? edge + gap_ - moved.seen.top()
                                                    : moved.seen.bottom() - (edge - gap_);
        if (lacking < 0.5) {
            break;
        }
        moved.moveMm += lacking * rays_.pixelMm(part.front() + moved.moveMm) * direction(side);
    }
    return moved;
}

bool FreeRoom::isFree(const QRectF& seen) const {
    return std::none_of(taken_.begin(), taken_.end(),
                        [&](const QRectF& other) { return other.intersects(seen); });
}

bool FreeRoom::isInPicture(const Block& part, glm::dvec3 moveMm) const {
    const QRectF seen = seenBy(viewRays(camera_, *geometry_, viewport_), part, moveMm);
    return camera_.zoom <= kMostZoom && QRectF(0, 0, viewport_.x, viewport_.y).contains(seen);
}

// Beyond an edge on one side; and where that is taken, aside of what takes it.
void FreeRoom::tryBeyond(const Block& part, const Try& from, Side side, double edge,
                         std::vector<Try>& tries) const {
    const Try moved = beyond(part, from, side, edge);
    tries.push_back(moved);
    const bool isAcross = side == Side::Right || side == Side::Left;
    for (const QRectF& other : taken_) {
        if (other.intersects(moved.seen)) {
            tries.push_back(beyond(part, moved, isAcross ? Side::Down : Side::Right,
                                   isAcross ? other.bottom() : other.right()));
            tries.push_back(
                beyond(part, moved, isAcross ? Side::Up : Side::Left, isAcross ? other.top() : other.left()));
        }
    }
}

render::Placement FreeRoom::find(const std::vector<glm::dvec3>& voxels) const {
    const Block part = blockAround(voxels, geometry_->worldFromVoxel, 0);
    const Try asCut{{}, seenBy(rays_, part)};
    if (taken_.empty()) {
        return {};
    }
    // Best first: in the picture, to the right, near.
    std::tuple<bool, bool, double> best{true, true, 1e30};
    render::Placement place;
    for (const Side side : {Side::Right, Side::Left, Side::Down, Side::Up}) {
        std::vector<Try> tries;
        for (const QRectF& other : taken_) {
            tryBeyond(part, asCut, side,
                      side == Side::Right  ? other.right()
                      : side == Side::Left ? other.left()
                      : side == Side::Down ? other.bottom()
                                           : other.top(),
                      tries);
        }
        for (const Try& moved : tries) {
            const std::tuple worth{!isInPicture(part, moved.moveMm), side != Side::Right,
                                   glm::length(moved.moveMm)};
            if (worth < best && isFree(moved.seen)) {
                best = worth;
                place.moveMm = moved.moveMm;
            }
        }
    }
    return place;
}

render::Camera FreeRoom::cameraOnAll() const {
    const auto allSeenBy = [&](const render::Camera& camera) {
        const render::ViewRays rays = viewRays(camera, *geometry_, viewport_);
        QRectF all;
        for (const Block& block : blocks_) {
            all = all.united(seenBy(rays, block));
        }
        return all;
    };
    const QRectF picture(0, 0, viewport_.x, viewport_.y);
    render::Camera camera = camera_;
    if (blocks_.empty() || isInPicture(blocks_.back(), {})) {
        return camera;
    }
    camera.zoom = std::min(camera.zoom, kMostZoom);
    for (int n = 0; n < 6; ++n) { // as perspective changes on the way
        const QRectF all = allSeenBy(camera);
        const render::ViewRays rays = viewRays(camera, *geometry_, viewport_);
        const QPointF off = all.center() - picture.center();
        const glm::dvec3 target = geometry_->centreWorld() + camera.panMm.x * glm::normalize(rays.right) +
                                  camera.panMm.y * glm::normalize(rays.up);
        camera.panMm += rays.pixelMm(target) * glm::dvec2(off.x(), -off.y());
        camera.zoom *= std::min({1.0, (1 - 2 * kMargin) * picture.width() / all.width(),
                                 (1 - 2 * kMargin) * picture.height() / all.height()});
    }
    return camera;
}

} // namespace vs::desktop
