// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture.h"

#include "field/cell_ranges.h"
#include "gl/pass.h"

#include <algorithm>

namespace vs::sculpt {

Sculpture::Sculpture(glm::ivec3 dims)
    : texels_(dims, gl::Format::R16F, gl::Filter::Linear, "sculpture"),
      cells_(field::cellDims(dims), gl::Format::RG32F, gl::Filter::Nearest, "sculpture cells"),
      combine_("sculpt/shaders/combine_sculpture.comp"), changed_(sizeof(std::uint32_t), "changed voxels") {}

Box3 Sculpture::combine(const Radiator& radiation, Combine how) {
    changed_.clear();
    const Box3 box = radiation.resultBox();
    if (box.isEmpty() || (how == Combine::Restore && isEmpty())) {
        return {};
    }
    {
        const gl::Pass pass("combine sculpture");
        radiation.bindResultTiles(0);
        changed_.bindStorage(1);
        radiation.energy().bindImage(0, gl::Access::Read);
        texels_.bindImage(1, gl::Access::ReadWrite);
        combine_.set(0, radiation.tileDims())
            .set(1, radiation.originVoxel())
            .set(2, dims())
            .set(3, how == Combine::Restore ? 1 : 0);
        combine_.dispatchIndirect(radiation.tileArguments(), 0, gl::Barrier::Texture);
    }
    // A cut only adds: what was not empty stays so.
    const bool staysNonEmpty = how == Combine::Cut && isEmpty_ == false;
    refresh(box);
    if (staysNonEmpty) {
        isEmpty_ = false;
    }
    return box;
}

std::uint64_t Sculpture::changedVoxels() const { return changed_.readValue<std::uint32_t>(); }

void Sculpture::clear() {
    texels_.clear();
    cells_.clear();
    everTouched_ = {};
    isEmpty_ = true;
    noteChange({glm::ivec3(0), dims()});
}

void Sculpture::noteChange(const Box3& box) {
    constexpr std::size_t remembered = 64;
    ++version_;
    changes_.push_back(box);
    if (changes_.size() > remembered) {
        changes_.pop_front();
    }
}

Box3 Sculpture::changedSince(std::uint64_t version) const {
    const std::uint64_t count = version_ - version;
    if (count > changes_.size()) {
        return {glm::ivec3(0), dims()};
    }
    Box3 all;
    for (auto change = changes_.end() - std::ptrdiff_t(count); change != changes_.end(); ++change) {
        all = unite(all, *change);
    }
    return all;
}

void Sculpture::upload(const Box3& box, std::span<const std::byte> texels) {
    texels_.upload(box, texels);
    refresh(box);
}

void Sculpture::swap(BrickDelta& delta) {
    delta.swap(texels_);
    refresh(delta.box());
}

void Sculpture::refresh(const Box3& box) {
    if (!box.isEmpty()) {
        updater_.update(texels_, box, cells_);
        everTouched_ = unite(everTouched_, box);
        isEmpty_.reset();
        noteChange(box);
    }
}

bool Sculpture::isEmpty() const {
    if (!isEmpty_) {
        // The cells know: a voxel is a corner of some cell, and only where something was written can there be
        // anything.
        const Box3 cells =
            intersect({(everTouched_.lo - 1) / field::kCell, everTouched_.hi / field::kCell + 1},
                      {glm::ivec3(0), cells_.size()});
        const auto bytes = cells_.download(cells);
        const auto* ranges = reinterpret_cast<const glm::vec2*>(bytes.data());
        isEmpty_ = std::none_of(ranges, ranges + cells.volume(), [](glm::vec2 range) { return range.y > 0; });
    }
    return *isEmpty_;
}

} // namespace vs::sculpt
