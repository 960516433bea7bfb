// SPDX-License-Identifier: Apache-2.0
#include "mesh/visible_surface.h"

#include "base/check.h"
#include "mesh/contour.h"

#include <algorithm>
#include <cmath>

namespace vs::mesh {

namespace {

constexpr double kHalf = 32767.5; // in 65535ths

// On the visible side where this is above zero; linear between voxels.
double uncut(const VisibleVolume& visible, std::size_t voxel) {
    if (visible.view == field::SculptureView::Whole) {
        return 1;
    }
    const double cut = (visible.sculpture.empty() ? 0 : visible.sculpture[voxel]) - kHalf;
    return visible.view == field::SculptureView::Cut ? -cut : cut;
}

// Where a quantity that is above zero inside falls below it, if it does so on the way.
double leaves(double inside, double outside) { return outside < 0 ? inside / (inside - outside) : 1; }

template <typename Value>
double crossingAt(const VisibleVolume& visible, const Value* values, std::size_t inside,
                  std::size_t outside) {
    const double in(values[inside]);
    const double out(values[outside]);
    if (!std::isfinite(out)) {
        return 0.5;
    }
    return std::min({leaves(in - visible.range.lo, out - visible.range.lo),
                     leaves(visible.range.hi - in, visible.range.hi - out),
                     leaves(uncut(visible, inside), uncut(visible, outside))});
}

} // namespace

bool VisibleVolume::isVisible(std::size_t voxel) const {
    return volume::visit(*volume,
                         [&](const auto* values) { return range.contains(double(values[voxel])); }) &&
           uncut(*this, voxel) > 0;
}

std::uint16_t packed(float sculpture) {
    return std::uint16_t(std::lround(glm::clamp(sculpture, 0.0F, 1.0F) * 65535.0F));
}

Mesh visibleSurface(const VisibleVolume& visible) {
    const volume::GridGeometry& geometry =
        visible.geometry != nullptr ? *visible.geometry : visible.volume->geometry;
    VS_CHECK(visible.sculpture.empty() || visible.sculpture.size() == geometry.voxelCount());
    return volume::visit(*visible.volume, [&](const auto* values) {
        segment::VoxelSet set = segment::emptySet(geometry.box());
        for (std::size_t i = 0; i < set.inside.size(); ++i) {
            set.inside[i] = visible.isVisible(i) ? 1 : 0;
        }
        return contour(set, geometry, [&](glm::ivec3 inside, glm::ivec3 outside) {
            return crossingAt(visible, values, set.indexOf(inside), set.indexOf(outside));
        });
    });
}

} // namespace vs::mesh
