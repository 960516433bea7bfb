// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/contents.h"

#include <fmt/format.h>

#include <algorithm>

namespace vs::studio {

Contents::Contents(volume::Volume volume, sculpt::Precision precision)
    : scan(std::move(volume)), sculpture(scan.volume.geometry.dims, precision), region(scan.field, sculpture),
      filled(scan.volume.geometry.dims) {
    view.range = scan.shown;
}

void Contents::show(const View& next) {
    if (!(next == view)) {
        sliceChanges += next.differsInSlicesOnly(view) ? 1 : 0;
        ++version;
        view = next;
    }
}

void Contents::remember(Edit edit) {
    if (edit.cut) {
        edit.cutContent = sculpture.contentVersion();
    }
    history.push(std::move(edit));
    ++version;
}

bool Contents::isCutAlongSegments() const {
    const auto clearsCuts = [](const Edit& edit) { return std::holds_alternative<UnCut>(*edit.operation); };
    const auto& done = history.done();
    const auto sinceCleared = std::find_if(done.rbegin(), done.rend(), clearsCuts);
    return sculpture.isLimited() ||
           std::any_of(done.rbegin(), sinceCleared, [](const Edit& edit) { return edit.isLimited; });
}

void Contents::fillIn(std::optional<Canvas>& canvas) const {
    if (!canvas) {
        canvas = Canvas{view, Canvas{}.viewport};
    }
}

std::size_t Contents::grownVoxels() const {
    return region.exists() ? std::size_t(region.growth()->voxelCount()) : 0;
}

std::string Contents::millilitres(std::size_t voxels) const {
    return fmt::format("{:.1f}", double(voxels) * region.geometry().voxelMm3() / 1000);
}

LabelGrids Contents::labelGrids() const {
    return {scan.volume.geometry, region.isFiner() ? std::optional(region.geometry()) : std::nullopt};
}

} // namespace vs::studio
