// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_head.h"
#include "segment/edits/voxel_set.h"
#include "studio/state/region.h"

namespace vs::test {

// Everything that undo must restore.
struct DocumentState {
    std::vector<std::uint32_t> generations;
    std::vector<std::uint8_t> labelMap;
    std::vector<std::byte> sculpture;
    studio::SegmentList segments;

    bool operator==(const DocumentState&) const = default;
};

inline DocumentState stateOf(const studio::Document& document) {
    return {document.region().generations(), document.region().labelMap(), test::sculptureBytes(document),
            document.segments()};
}

// The voxels of a label.
inline segment::VoxelSet setOf(const studio::Document& document, std::uint8_t label) {
    segment::VoxelSet set{document.volume().geometry.box(), document.region().labelMap()};
    for (std::uint8_t& value : set.inside) {
        value = value == label ? 1 : 0;
    }
    return set;
}

inline studio::Seed seedAt(glm::ivec3 voxel, Range range = {80, 120}) {
    studio::Seed op;
    op.voxels = {voxel};
    op.range = range;
    op.canvas = testCanvas();
    return op;
}

// So many generations of brain in the segment at work.
inline void grownBrain(studio::Document& document, int generations) {
    document.apply(brainSeed());
    document.apply(studio::Grow{generations});
}

inline studio::EditSegment editOf(studio::EditSegment::Kind kind, double amount = 0,
                                  const std::string& other = {}) {
    studio::EditSegment op;
    op.kind = kind;
    op.amount = amount;
    op.other = other;
    return op;
}

// The voxels of the 8-bit head whose values are in a range.
inline segment::VoxelSet inRange(const studio::Document& document, const Range& range) {
    segment::VoxelSet set = segment::emptySet(document.volume().geometry.box());
    for (std::size_t i = 0; i < set.inside.size(); ++i) {
        set.inside[i] = range.contains(double(std::uint8_t(document.volume().bytes[i]))) ? 1 : 0;
    }
    return set;
}

using Stroke = decltype(studio::BrushSegment::stroke);

// One of each tool whose stroke can be a brush.
inline std::vector<Stroke> strokes() {
    studio::Drill drill = drillOf(ellipseAt(200, 150, 15, 12), testCanvas());
    studio::Laser laser;
    laser.mask = ellipseAt(190, 140, 12, 12);
    laser.canvas = testCanvas();
    studio::Scissors scissors{ellipseAt(210, 130, 25, 20)};
    scissors.depth = 9;
    scissors.canvas = testCanvas();
    return {somePeel(6), drill, laser, scissors};
}

// What the document says when it refuses an operation; empty: it did not.
inline std::string refusal(studio::Document& document, const studio::Operation& operation) {
    try {
        document.apply(operation);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

} // namespace vs::test
