// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "field/scene.h"
#include "gl/program.h"

#include <cstdint>

namespace vs::segment {

// Neighbours across faces, or across faces, edges and corners.
enum class Connectivity { Six, TwentySix };

// Which voxels growth may enter.
struct Constraints {
    Range range; // closed, in the volume's unit; float volumes are compared with its ends rounded to float
    // Null: no fence. Must live on the volume's grid for as long as these constraints are in use.
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

// The ends of a range as the shaders compare them: whole numbers for integral volumes (40.5:130 means
// 41:130), rounded to float, and clipped to the data so that the stand-in for non-finite voxels is outside.
glm::vec2 comparableRange(const field::Field& field, const Range& range);

// Whether a stored value passes `range`: what the shaders do, on the CPU.
bool isInRange(const field::Field& field, const Range& range, double value);

// Compiles a shader that includes "segment/shaders/constraints.glsl", with or without the fence.
gl::Program constrainedProgram(const std::string& path, bool hasFence);

// Sets what constraints.glsl reads: texture 0 (data), texture 1 (sculpture, when fenced), uniforms 20 to 23.
void bindConstraints(gl::Program& program, const field::Field& field, const Constraints& constraints);

} // namespace vs::segment
