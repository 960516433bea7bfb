// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/picker.h"
#include "sculpt/layered_cut.h"
#include "sculpt/tool_cut.h"
#include "studio/operation.h"

namespace vs::studio {

// What cut strokes need and share, for as long as the document lives.
class Cutter {
public:
    Cutter(const field::Field& field, sculpt::Sculpture& target)
        : tools(field.geometry), sculpture(&target), geometry(&field.geometry) {}

    // The sculpture as it is now, as a texture that stays so: a stroke keeps seeing the surface it began on.
    // Only what has changed since the last one is copied.
    const gl::Texture& snapshot();
    // Voxels that the last snapshot() copied.
    [[nodiscard]] std::size_t copiedVoxels() const { return copiedVoxels_; }
    // The macrocells as they are now, likewise: pictures drawn during the stroke may rebuild the shared ones.
    const render::Macrocells& snapshot(const render::Macrocells& macrocells);
    // The sculpture's values, x fastest.
    [[nodiscard]] std::vector<float> sculptureAsFloats() const;

    sculpt::ToolCutter tools;
    sculpt::Sculpture* sculpture;
    const volume::GridGeometry* geometry;

private:
    gl::Texture snapshot_;
    std::uint64_t snapshotVersion_ = 0;
    std::size_t copiedVoxels_ = 0;
    render::Macrocells macrocells_;
};

// One stroke of the peel or the drill, from pen-down to pen-up. Whatever is drawn is in the sculpture at
// once; finish() gives the delta that undoes it, discard() puts everything back. Surfaces are those seen at
// pen-down (SPEC 7): going slower, or over the same place again, cuts no deeper.
class CutStroke {
public:
    // `frame` is what the pen was drawn on; `operation` is a Peel or a Drill with its canvas set.
    CutStroke(Cutter& cutter, render::Picker& picker, const render::Frame& frame, const Peel& operation);
    CutStroke(Cutter& cutter, render::Picker& picker, const render::Frame& frame, const Drill& operation);

    // Peels down to this many layers in all; fewer than before puts layers back.
    void peelTo(double layers);
    // The pen has come here: stamps along the way from where it was, as deep as the pressure says.
    void drillAt(const sculpt::PenPoint& pen);
    // One stamp at full pressure where the mask was drawn.
    void stampWhereDrawn();

    // The operation as it has become: with the layers, or the pen points, so far.
    [[nodiscard]] const Operation& operation() const { return operation_; }
    // The sculpture's version at pen-down.
    [[nodiscard]] std::uint64_t sculptureVersion() const { return sculptureVersion_; }
    sculpt::BrickDelta finish() { return backup_.finish(); }
    void discard();

private:
    void prepare(const Sketch& sketch);
    std::vector<glm::vec2> elementPixels(glm::dvec2 centre) const;
    void stamp(glm::dvec2 centre, double pressure);

    Cutter* cutter_;
    render::Picker* picker_;
    render::Frame frame_;
    Operation operation_;
    std::uint64_t sculptureVersion_;
    sculpt::BrickBackup backup_;
    sculpt::MaskRaster mask_; // centred on the origin, in pixels
    glm::dvec2 drawnAt_{0};
    glm::dvec2 extent_{0};
    std::optional<sculpt::LayeredCut> peel_; // nothing: the sketch is empty
};

} // namespace vs::studio
