// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/growth.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace vs::segment {

// What hides a part of the grid from the viewer.
struct Fence {
    const gl::Texture* sculpture = nullptr; // null: nothing is hidden
    const gl::Texture* cells = nullptr;     // RG32F: its smallest and largest value in each macrocell
    field::SculptureView view = field::SculptureView::Whole;
    std::uint64_t version = 0; // of the sculpture
    // Voxels of the sculpture that may differ from what they were at an earlier version.
    std::function<Box3(std::uint64_t)> changedSince = {};
};

// What segments are taken to be in the first voxels behind the cut faces that end them, for pictures alone:
// growth stops at the sculpture, and a membership that was smoothed across that border would be about 0.5
// all over the face. See shaders/continue_segments.comp for what counts; nothing of it is in labels, volumes
// or exports. Internal to this folder: Segmentation has one once there is a fence.
class Continuation {
public:
    explicit Continuation(glm::ivec3 dims);

    // Whether there is a fence to look behind, and a run that knows of one.
    static bool isNeeded(const Growth& growth, const Fence& fence);

    // Whether refresh() would find another fence than the last time.
    [[nodiscard]] bool isStale(const Fence& fence) const;
    // Takes in the fence and the rules of all segments. Returns the bricks to continue again: those that the
    // fence runs through, or did, and of which it, the rules or one of the `changed` bricks close by has
    // changed; with `isAnew` all.
    std::vector<std::uint32_t> refresh(const Growth& growth, const Fence& fence,
                                       const std::vector<std::uint32_t>& changed, bool isAnew);
    // Brings the plane `turned` up to date in some bricks: the voxels that count as the opposite of what they
    // are in the plane `shown`, of which with `alone` one segment counts and no other. `reach` as in
    // Growth::show.
    void run(const Growth& growth, const Fence& fence, const gl::Buffer& shown, const gl::Buffer& turned,
             const gl::Buffer& reach, const std::vector<std::uint32_t>& bricks,
             std::optional<std::uint8_t> alone = {});

private:
    // How the segment with one label goes on; mirrors Rules in shaders/continue_segments.comp (std430).
    struct Rules {
        glm::vec4 voxel{0};
        glm::vec4 pair{0};
        glm::uvec4 run{0};
        bool operator==(const Rules&) const = default;
    };
    static_assert(sizeof(Rules) == 48);

    bool takeRules(const Growth& growth, field::SculptureView view);
    // The bricks for which what hides may have changed.
    std::vector<std::uint32_t> takeFence(const BrickTable& table, const Fence& fence);

    field::SculptureView view_ = field::SculptureView::Whole; // of the fence taken in
    std::uint64_t version_ = 0;
    std::vector<bool> isFenced_; // by brick
    std::vector<Rules> rules_;   // by label
    bool hasGradients_ = false;
    bool takesAway_ = false;
    gl::Buffer rulesOnDevice_;
    gl::Buffer list_;
    gl::Buffer answers_;
    gl::Program findFences_;
    ConstrainedProgram continue_{"segment/shaders/continue_segments.comp"};
};

} // namespace vs::segment
