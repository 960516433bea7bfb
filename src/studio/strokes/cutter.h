// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/rays/picker.h"
#include "sculpt/solids/island_cut.h"
#include "sculpt/solids/solid_cut.h"
#include "sculpt/surface/restore_reach.h"
#include "sculpt/surface/tool_cut.h"

namespace vs::studio {

// What cut strokes need and share, for as long as the document lives.
class Cutter {
public:
    Cutter(const field::Field& field, sculpt::Sculpture& target)
        : tools(field.geometry), solids(field.geometry), sculpture(&target), geometry(&field.geometry) {}

    // The field's voxels lie elsewhere now.
    void follow(const volume::GridGeometry& corrected);
    // The sculpture as it is now, as a texture that stays so: a stroke keeps seeing the surface it began on.
    // Only what has changed since the last one is copied.
    const gl::Texture& snapshot();
    // Voxels that the last snapshot() copied.
    [[nodiscard]] std::size_t copiedVoxels() const { return copiedVoxels_; }
    // The macrocells as they are now, as a copy that stays so: pictures drawn during the stroke may rebuild
    // the shared ones.
    const render::Macrocells& snapshot(const render::Macrocells& macrocells);
    // The scene in which restoring looks for the uncut surface. In volume mode opacity says what is visible,
    // not the displayed range: there everything that was cut away counts.
    [[nodiscard]] static field::Scene restoreScene(const render::Frame& frame);
    // The sculpture's values, x fastest.
    [[nodiscard]] std::vector<float> sculptureAsFloats() const;

    sculpt::ToolCutter tools;
    sculpt::SolidCutter solids;
    sculpt::IslandCutter islands;
    sculpt::RestoreReach restoreReach;
    render::Picker picker;
    sculpt::Sculpture* sculpture;
    const volume::GridGeometry* geometry;

private:
    gl::Texture snapshot_;
    std::uint64_t snapshotVersion_ = 0;
    std::size_t copiedVoxels_ = 0;
    render::Macrocells macrocells_;
};

} // namespace vs::studio
