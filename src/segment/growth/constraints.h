// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "field/scene.h"
#include "gl/program.h"

#include <cstdint>
#include <optional>
#include <string>

namespace vs::segment {

// Neighbours across faces, or across faces, edges and corners.
enum class Connectivity { Six, TwentySix };

// The rules of growth: which voxels it may enter, and from where (doc/behaviour.md, "Growth"). Every rule
// given must be kept; all ranges are closed.
struct Constraints {
    Range range; // of intensity, in the volume's unit; float volumes are compared with its ends rounded to
                 // float
    // What child - parent may be, where the child is the voxel entered and the parent the one it is entered
    // from.
    std::optional<Range> difference = {};
    // What the gradient's magnitude may be at the child, in the volume's unit per mm: central differences,
    // beyond the grid the values at its border.
    std::optional<Range> gradient = {};
    // What the difference of the gradient's magnitudes may be, child - parent.
    std::optional<Range> gradientDifference = {};
    // The sculpture that fences growth; null: no fence. Must live on the volume's grid for as long as these
    // constraints are in use.
    const gl::Texture* sculpture = nullptr;
    // Tells one content of the sculpture from another: growth tests refused voxels again when this changes.
    std::uint64_t sculptureVersion = 0;
    // Cut: only voxels with sculpture < 0.5; Probe: only those >= 0.5; Whole: as without a sculpture.
    field::SculptureView view = field::SculptureView::Whole;
    Connectivity connectivity = Connectivity::Six;

    [[nodiscard]] bool hasFence() const {
        return sculpture != nullptr && view != field::SculptureView::Whole;
    }
    bool operator==(const Constraints&) const = default;
};

// Whether everything that `narrow` lets in may be entered under `wide` too.
bool includes(const Constraints& wide, const Constraints& narrow);

// The ends of a range as the shaders compare them: whole numbers for integral volumes (40.5:130 means
// 41:130), halves between two steps for scaled ones, rounded to float, and clipped to the data so that the
// stand-in for non-finite voxels is outside.
glm::vec2 comparableRange(const field::Field& field, const Range& range);

// What the shaders compare differences of two values with; nothing given: all there are.
glm::vec2 comparableDifference(const field::Field& field, const std::optional<Range>& range);

// What turns the values' differences along the voxel axes, across two voxels, into a gradient in world axes:
// its columns, 1 / mm.
glm::mat3 gradientColumns(const field::Field& field);

// Whether a stored value passes `range`: what the shaders do, on the CPU.
bool isInRange(const field::Field& field, const Range& range, double value);

// One shader that includes "segment/shaders/constraints.glsl", compiled for each combination of rules when it
// is first needed.
class ConstrainedProgram {
public:
    explicit ConstrainedProgram(std::string path) : variants_(std::move(path)) {}

    // Ready to run under these constraints, as far as constraints.glsl is concerned: texture 0 (data),
    // texture 1 (sculpture, when fenced).
    gl::Program& prepare(const field::Field& field, const Constraints& constraints,
                         const gl::Defines& more = {});

private:
    gl::ProgramVariants variants_;
};

} // namespace vs::segment
