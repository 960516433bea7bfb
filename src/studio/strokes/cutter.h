// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/detail.h"
#include "field/fill/fill_texture.h"
#include "render/rays/picker.h"
#include "sculpt/sculpture/fill_target.h"
#include "sculpt/solids/island_cut.h"
#include "sculpt/solids/solid_cut.h"
#include "sculpt/surface/restore_reach.h"
#include "sculpt/surface/tool_cut.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vs::studio {

// What cut strokes need and share, for as long as the document lives.
class Cutter {
public:
    // `filled` is what tools fill; null: nothing can be filled.
    Cutter(const field::Field& field, sculpt::Sculpture& target, field::SharedFill* filled = nullptr)
        : tools(field.geometry), solids(field.geometry), sculpture(&target), fill(filled),
          scene(&field.geometry), geometry(&field.geometry) {}

    // What strokes change that are made from now on.
    struct Aim {
        enum class At {
            All,    // the scan's sculpture and, when they cut, what is filled
            Scan,   // the sculpture alone
            Fill,   // they fill with a material
            Filled, // they take away what is filled, and nothing else
        };
        At at = At::All;
        std::uint8_t material = 0;
    };
    Aim aim;

    // What it takes to work on a finer sculpture, made before anything is changed, for the device may have no
    // room for it.
    struct Finer {
        std::unique_ptr<Cutter> rough;
        sculpt::FineWindow window;
    };
    [[nodiscard]] Finer makeFiner(const field::Field& field) const;
    // Tools work on the sculpture's finer one from now on, which it must have, on surfaces that lie in the
    // finest of these levels.
    void refine(Finer finer, field::Detail& detail);
    // Works on the scene's sculpture all the same, for strokes in hand that have no time for the finest
    // level; null where there is none.
    [[nodiscard]] Cutter* rough() { return rough_.get(); }
    // Whether it works on the finer sculpture.
    [[nodiscard]] bool cutsFiner() const { return detail_ != nullptr; }
    // The field's voxels lie elsewhere now.
    void follow(const volume::GridGeometry& corrected);
    // What a stroke cuts into. What was there before goes into the backup and, of the finer sculpture, into
    // `originals`.
    std::unique_ptr<sculpt::CutTarget> target(sculpt::BrickBackup& backup, sculpt::FineBricks& originals,
                                              sculpt::Combine how);
    // Whether strokes that cut now take away what is filled.
    [[nodiscard]] bool cutsFill() const {
        return fill != nullptr && detail_ == nullptr && aim.at == Aim::At::All && !(*fill)->isEmpty();
    }
    // What is filled now, on the device, and stays so there until this is called again.
    const field::FillTexture& keptFill() {
        keptFill_.show(*fill);
        return keptFill_;
    }
    // The surface under places of a frame's picture, in the voxel space that tools work in.
    std::vector<field::SurfacePoint> pick(const render::Frame& frame, std::span<const glm::vec2> pixels);
    // RestoreReach::measure() of points that pick() gave, with depths and the reach in the tools' steps.
    std::vector<float> reachOf(const render::Frame& frame, std::span<const field::SurfacePoint> points,
                               std::span<const glm::vec3> directions, std::span<const float> depths,
                               int radius);
    // Operations count steps of the scene, tools those of the grid that they work on: so many in one.
    [[nodiscard]] double toolSteps() const { return toolSteps_; }
    // A place in the scene's voxel space in that which tools work in.
    [[nodiscard]] glm::dvec3 toolPlace(const glm::dvec3& sceneVoxel) const;
    // Surfaces stay for pick() what they are now, also where tools cut; until they are let go.
    void keepSurfaces();
    void letSurfacesGo() { kept_.reset(); }
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
    field::SharedFill* fill;
    const volume::GridGeometry* scene;    // the grid that operations speak of
    const volume::GridGeometry* geometry; // the grid that tools work on

private:
    [[nodiscard]] glm::dvec3 scenePlace(const glm::dvec3& toolVoxel) const;

    std::unique_ptr<Cutter> rough_;
    volume::GridGeometry finest_;
    double toolSteps_ = 1;
    field::Detail* detail_ = nullptr;          // null: tools work on the scene's grid
    std::optional<sculpt::FineWindow> window_; // onto the finer sculpture
    std::optional<sculpt::FillWindow> fillWindow_;
    field::FillTexture keptFill_;
    std::shared_ptr<const field::BrickOverlay> kept_;
    std::uint64_t keptVersion_ = 0; // of the finer sculpture
    gl::Texture snapshot_;
    std::uint64_t snapshotVersion_ = 0;
    std::size_t copiedVoxels_ = 0;
    render::Macrocells macrocells_;
};

} // namespace vs::studio
