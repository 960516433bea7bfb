// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/segment_shape_editor.h"

#include "segment/edits/fine_islands.h"
#include "segment/edits/fine_shapes.h"
#include "segment/edits/islands.h"
#include "segment/edits/margins.h"
#include "segment/edits/set_algebra.h"
#include "segment/edits/smoothing.h"
#include "studio/editing/segment_change.h"
#include "studio/operations/trail.h"

namespace vs::studio {

namespace {

using Kind = EditSegment::Kind;

bool needsVoxel(Kind kind) { return kind == Kind::KeepIsland || kind == Kind::DropIsland; }
bool needsOther(Kind kind) {
    return kind == Kind::Unite || kind == Kind::Subtract || kind == Kind::Intersect;
}

// The voxel of the finest level at a place in the scene's voxel space.
glm::ivec3 finestAt(const glm::dvec3& place, const field::BrickGrid& grid) {
    return glm::ivec3(glm::round(place * grid.perSceneVoxel + grid.origin));
}

// What an edit makes of a set of voxels of a grid. `onIsland`: the voxel that islands are named by, and of a
// level that is finer than the scene's how far from it they may lie.
template <typename Set, typename... Reach>
Set edited(const EditSegment& op, const Set& set, const Set& other, const volume::GridGeometry& geometry,
           segment::Connectivity connectivity, glm::ivec3 onIsland, Reach... reach) {
    switch (op.kind) {
    case Kind::KeepIsland:
        return segment::keepIsland(set, onIsland, connectivity, reach...);
    case Kind::DropIsland:
        return segment::dropIsland(set, onIsland, connectivity, reach...);
    case Kind::KeepLargest:
        return segment::keepLargestIsland(set, connectivity);
    case Kind::DropSmall:
        return segment::dropSmallIslands(set, geometry, op.amount, connectivity);
    case Kind::FillHoles:
        return op.amount > 0 ? segment::fillHoles(set, geometry, op.amount)
                             : segment::fillHoles(set, geometry);
    case Kind::Margin:
        return segment::changeMargin(set, geometry, op.amount);
    case Kind::Open:
        return segment::opening(set, geometry, op.amount);
    case Kind::Close:
        return segment::closing(set, geometry, op.amount);
    case Kind::Smooth:
        return segment::smooth(set, geometry, op.amount);
    case Kind::Hollow:
        return segment::hollow(set, geometry, op.amount);
    case Kind::Unite:
        return segment::unite(set, other);
    case Kind::Subtract:
        return segment::subtract(set, segment::changeMargin(other, geometry, op.amount));
    case Kind::Intersect:
        return segment::intersect(set, segment::changeMargin(other, geometry, op.amount));
    }
    throw Error("an edit of a segment that is not known");
}

} // namespace

// --- edits

template <typename Take>
auto SegmentShapeEditor::takeOther(const EditSegment& op, Region::Records& records, Take take) {
    const std::uint8_t atWork = contents_.segments.atWork;
    const SegmentInfo* other = contents_.segments.find(op.other);
    if (other == nullptr || other->label == atWork) {
        throw Error("'{}' is no other segment; name one", op.other);
    }
    if (op.kind == Kind::Unite && other->isLocked) {
        throw Error("the segment '{}' is locked; unlock it first", op.other);
    }
    auto set = take(other->label);
    if (op.kind == Kind::Unite) {
        contents_.region.workOn(other->label, records);
        contents_.region.clear(records);
        contents_.region.workOn(atWork, records);
    }
    return set;
}

void SegmentShapeEditor::perform(const EditSegment& op, Region::Records& records) {
    workUnlocked(contents_, records);
    if (contents_.region.isFiner()) {
        performFinest(op, records);
        return;
    }
    const auto take = [&](std::uint8_t label) { return contents_.region.voxels(label, records); };
    const segment::VoxelSet other = needsOther(op.kind) ? takeOther(op, records, take) : segment::VoxelSet();
    const segment::VoxelSet set = take(contents_.segments.atWork);
    contents_.region.replace(edited(op, set, other, contents_.scan.volume.geometry,
                                    contents_.region.rules().connectivity, op.voxel.value_or(glm::ivec3(0))),
                             records);
}

void SegmentShapeEditor::performFinest(const EditSegment& op, Region::Records& records) {
    const auto take = [&](std::uint8_t label) { return contents_.region.finestVoxels(label); };
    const field::BrickGrid& grid = contents_.region.finestGrid();
    const segment::FineSet other =
        needsOther(op.kind) ? takeOther(op, records, take) : segment::FineSet(grid.dims);
    const segment::FineSet set = take(contents_.segments.atWork);
    const glm::ivec3 place = op.finest.value_or(finestAt(op.voxel.value_or(glm::ivec3(0)), grid));
    const glm::ivec3 reach(glm::ceil(double(segment::kIslandReach) * grid.perSceneVoxel));
    contents_.region.replace(edited(op, set, other, contents_.region.geometry(),
                                    contents_.region.rules().connectivity, place, reach),
                             records);
}

Outcome SegmentShapeEditor::run(EditSegment& op) {
    const std::size_t before = contents_.region.voxelCount(contents_.segments.atWork);
    if (before == 0) {
        if (op.kind != Kind::Unite) {
            throw Error("the segment '{}' is empty; there is nothing to edit",
                        contents_.segments.working().name);
        }
    }
    if (needsVoxel(op.kind) && !op.voxel && !(contents_.region.isFiner() && op.finest)) {
        if (!op.pixel) {
            throw Error("'{}' needs a pixel on the island, or one of its voxels", name(op));
        }
        contents_.fillIn(op.canvas);
        const glm::vec2 pixel(*op.pixel);
        const auto points = cutter_.picker.pickPoints(display_.frame(op.canvas->view, op.canvas->viewport),
                                                      std::span(&pixel, 1), render::Picker::Meets::Segment);
        if (points.front().voxel.w < 0.5F) {
            throw Error("nothing lies under pixel {:g}, {:g}; point at an island", pixel.x, pixel.y);
        }
        op.voxel = glm::ivec3(glm::round(glm::vec3(points.front().voxel)));
        if (contents_.region.isFiner()) {
            op.finest = finestAt(points.front().voxel, contents_.region.finestGrid());
        }
    }
    changeSegments(contents_, *this, op);
    const std::size_t now = contents_.grownVoxels();
    return {{},
            0,
            now > before ? now - before : before - now,
            say(VS_TEXT("library", "%1 voxels, %2 ml; %3 before"), now, contents_.millilitres(now), before)};
}

void SegmentShapeEditor::perform(const BrushSegment& op, Region::Records& records) {
    workUnlocked(contents_, records);
    if (contents_.region.isFiner()) {
        contents_.region.paint(cuts_.wouldCutFinest(op), op.isToAdd, records);
        return;
    }
    const segment::VoxelSet brush = cuts_.wouldCut(op);
    const segment::VoxelSet set = contents_.region.voxels(contents_.segments.atWork, records);
    contents_.region.replace(op.isToAdd ? segment::unite(set, brush) : segment::subtract(set, brush),
                             records);
}

Outcome SegmentShapeEditor::run(BrushSegment& op) {
    std::visit([&](auto& drawn) { contents_.fillIn(drawn.canvas); }, op.stroke);
    const std::size_t before = contents_.grownVoxels();
    changeSegments(contents_, *this, op);
    const std::size_t now = contents_.grownVoxels();
    return {{},
            0,
            now > before ? now - before : before - now,
            now == before
                ? say(VS_TEXT("library", "nothing changed: the stroke does not reach the segment's surface"))
                : describeChange(before, now)};
}

void SegmentShapeEditor::perform(const PaintSegment& op, Region::Records& records) {
    workUnlocked(contents_, records);
    if (contents_.region.isFiner()) {
        contents_.region.paint(finestUnder(op), op.isToAdd, records);
    } else {
        contents_.region.paint(voxelsAlong(op.trail, contents_.scan.volume, op.range), op.isToAdd, records);
    }
}

namespace {

segment::VoxelSet voxelsOf(const field::Fill& fill, int material) {
    segment::VoxelSet set = segment::emptySet(fill.filledWithin({glm::ivec3(0), fill.dims()}));
    forEachVoxel(set.box, [&](glm::ivec3 v, std::size_t n) {
        const field::Fill::Voxel there = fill.at(v);
        set.inside[n] = there.filled >= 0.5F && there.material == material ? 1 : 0;
    });
    return set.tight();
}

} // namespace

void SegmentShapeEditor::perform(const SegmentFill& op, Region::Records& records) {
    workUnlocked(contents_, records);
    contents_.region.paint(voxelsOf(*contents_.filled.fill, op.material), true, records);
}

Outcome SegmentShapeEditor::run(SegmentFill& op) {
    if (contents_.filled.fill->voxels(std::uint8_t(op.material)) == 0) {
        throw Error("material: nothing is filled with number {} that a segment could have", op.material);
    }
    if (contents_.region.isFiner()) {
        throw Error("segments grow at a finer level than material lies at: none can be made of it");
    }
    const std::size_t before = contents_.grownVoxels();
    changeSegments(contents_, *this, op);
    const std::size_t now = contents_.grownVoxels();
    return {{}, 0, now - before, describeChange(before, now)};
}

segment::FineSet SegmentShapeEditor::finestUnder(const PaintSegment& op) {
    segment::FineSet set = finestAlong(op.trail, contents_.region.finestGrid(), contents_.region.geometry());
    return op.range ? contents_.region.finestInRange(set, *op.range) : set;
}

Outcome SegmentShapeEditor::run(PaintSegment& op) {
    const bool isAnyUnder = contents_.region.isFiner()
                                ? voxelsAlong(op.trail, contents_.scan.volume.geometry).count() > 0
                                : voxelsAlong(op.trail, contents_.scan.volume, op.range).count() > 0;
    if (!isAnyUnder) {
        return {{}, 0, 0, say(VS_TEXT("library", "nothing changed: no voxel lies under the brush"))};
    }
    const std::size_t before = contents_.grownVoxels();
    changeSegments(contents_, *this, op);
    const std::size_t now = contents_.grownVoxels();
    const std::size_t changed = now > before ? now - before : before - now;
    return {{},
            0,
            changed,
            changed == 0 ? say(VS_TEXT("library",
                                       "nothing changed: no voxel under the brush could be added or removed"))
                         : describeChange(before, now)};
}

} // namespace vs::studio
