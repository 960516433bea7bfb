// SPDX-License-Identifier: Apache-2.0
// Several segments, their looks and their edits.
#include "base/progress.h"
#include "segment/edits/islands.h"
#include "segment/edits/margins.h"
#include "segment/edits/set_algebra.h"
#include "segment/edits/smoothing.h"
#include "segment/membership/segmentation.h"
#include "studio/document/document_change.h"

#include <algorithm>

namespace vs::studio {

namespace {

using Kind = EditSegment::Kind;

std::string inQuotes(const std::string& segment) { return "'" + segment + "'"; }

bool needsVoxel(Kind kind) { return kind == Kind::KeepIsland || kind == Kind::DropIsland; }
bool needsOther(Kind kind) {
    return kind == Kind::Unite || kind == Kind::Subtract || kind == Kind::Intersect;
}

segment::VoxelSet edited(const EditSegment& op, const segment::VoxelSet& set, const segment::VoxelSet& other,
                         const volume::GridGeometry& geometry, segment::Connectivity connectivity) {
    switch (op.kind) {
    case Kind::KeepIsland:
        return segment::keepIsland(set, *op.voxel, connectivity);
    case Kind::DropIsland:
        return segment::dropIsland(set, *op.voxel, connectivity);
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

constexpr double kSliceMs = 100; // between asking whether to go on

// A segment's smooth membership on the whole grid: 0.5 at its surface.
std::vector<float> smoothMembership(const field::Field& field, const segment::VoxelSet& set) {
    segment::Growth growth(field);
    growth.replace(set.box, set.inside);
    segment::Segmentation segmentation(field.geometry);
    do {
        segmentation.update(growth, segment::Smoothing::Smooth, segment::allOpaque(), kSliceMs);
        reportProgress();
    } while (segmentation.isBehind());
    return segmentation.values();
}

} // namespace

// --- the list

void Document::Impl::perform(const UseSegment& op, Region::Records& records) {
    SegmentInfo* segment = segments.find(op.segment);
    if (segment == nullptr && op.takesFirst.value_or(false)) {
        segment = &segments.segments.front();
        segment->name = op.segment;
        segment->isClaimed = true;
    } else if (segment == nullptr) {
        segment = &segments.add(op.segment);
    }
    if (op.name && *op.name != op.segment && segments.find(*op.name) != nullptr) {
        throw Error("there is a segment '{}' already; choose another name", *op.name);
    }
    segment->name = op.name.value_or(segment->name);
    segment->colour = op.colour.value_or(segment->colour);
    segment->opacity = op.opacity.value_or(segment->opacity);
    segment->isVisible = op.isVisible.value_or(segment->isVisible);
    segment->isLocked = op.isLocked.value_or(segment->isLocked);
    if (op.goesToWork) {
        segments.atWork = segment->label;
        region.workOn(segments.atWork, records);
    }
}

Outcome Document::Impl::run(UseSegment& op, const std::filesystem::path&) {
    if (segments.find(op.segment) == nullptr) {
        const bool canTake = op.goesToWork && segments.isUntouched() && region.isUntouched();
        if (op.takesFirst.value_or(false) && !canTake) {
            throw Error("'{}' cannot take the place of the first segment, which is in use already; leave "
                        "'first' out",
                        op.segment);
        }
        if (canTake) {
            op.takesFirst = op.takesFirst.value_or(!isNumbered(op.segment));
        }
    }
    change(op);
    return {{},
            0,
            0,
            op.goesToWork ? say(VS_TEXT("library", "at work on %1"), inQuotes(segments.working().name))
                          : say(VS_TEXT("library", "%1 changed"), inQuotes(op.name.value_or(op.segment)))};
}

void Document::Impl::perform(const RemoveSegment& op, Region::Records& records) {
    const SegmentInfo* segment = segments.find(op.segment);
    if (segment == nullptr) {
        throw Error("there is no segment '{}' to remove", op.segment);
    }
    if (segment->isLocked) {
        throw Error("the segment '{}' is locked; unlock it first", op.segment);
    }
    region.workOn(segment->label, records);
    region.clear(records);
    region.forgetRules(records);
    segments.remove(segment->label);
    region.workOn(segments.atWork, records);
}

Outcome Document::Impl::run(RemoveSegment& op, const std::filesystem::path&) {
    change(op);
    return {{}, 0, 0, say("%1", inQuotes(op.segment))};
}

std::function<bool(glm::ivec3)> Document::Impl::lockedVoxels() const {
    std::array<bool, 256> isLocked{};
    for (const SegmentInfo& segment : segments.segments) {
        isLocked[segment.label] = segment.isLocked;
    }
    const bool any = std::find(isLocked.begin(), isLocked.end(), true) != isLocked.end();
    if (!any || !region.exists()) {
        return {};
    }
    return [isLocked, labels = region.growth()->labelMap(), dims = volume.geometry.dims](glm::ivec3 voxel) {
        const glm::ivec3 lo = glm::max(voxel - 1, 0);
        const glm::ivec3 hi = glm::min(voxel + 1, dims - 1);
        for (int z = lo.z; z <= hi.z; ++z) {
            for (int y = lo.y; y <= hi.y; ++y) {
                for (int x = lo.x; x <= hi.x; ++x) {
                    const auto i =
                        (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x) +
                        std::size_t(x);
                    if (isLocked[labels[i]]) {
                        return true;
                    }
                }
            }
        }
        return false;
    };
}

// --- edits

void Document::Impl::perform(const EditSegment& op, Region::Records& records) {
    workUnlocked(records);
    segment::VoxelSet other;
    if (needsOther(op.kind)) {
        const SegmentInfo* info = segments.find(op.other);
        if (info == nullptr || info->label == segments.atWork) {
            throw Error("'{}' is no other segment; name one", op.other);
        }
        if (op.kind == Kind::Unite && info->isLocked) {
            throw Error("the segment '{}' is locked; unlock it first", op.other);
        }
        other = region.voxels(info->label, records);
        if (op.kind == Kind::Unite) {
            region.workOn(info->label, records);
            region.clear(records);
            region.workOn(segments.atWork, records);
        }
    }
    const segment::VoxelSet set = region.voxels(segments.atWork, records);
    region.replace(edited(op, set, other, volume.geometry, region.rules().connectivity), records);
}

Outcome Document::Impl::run(EditSegment& op, const std::filesystem::path&) {
    if (!region.exists() || region.growth()->voxelCount(segments.atWork) == 0) {
        if (op.kind != Kind::Unite) {
            throw Error("the segment '{}' is empty; there is nothing to edit", segments.working().name);
        }
    }
    if (needsVoxel(op.kind) && !op.voxel) {
        if (!op.pixel) {
            throw Error("'{}' needs a pixel on the island, or one of its voxels", name(op));
        }
        settle(op.canvas);
        const glm::vec2 pixel(*op.pixel);
        const auto points = cutter.picker.pickPoints(frame(op.canvas->view, op.canvas->viewport),
                                                     std::span(&pixel, 1), render::Picker::Meets::Segment);
        if (points.front().voxel.w < 0.5F) {
            throw Error("nothing lies under pixel {:g}, {:g}; point at an island", pixel.x, pixel.y);
        }
        op.voxel = glm::ivec3(glm::round(glm::vec3(points.front().voxel)));
    }
    const std::size_t before = region.exists() ? region.growth()->voxelCount(segments.atWork) : 0;
    change(op);
    const std::size_t now = grownVoxels();
    return {{},
            0,
            now > before ? now - before : before - now,
            say(VS_TEXT("library", "%1 voxels, %2 ml; %3 before"), now, millilitres(now), before)};
}

// What a stroke would cut: the sculpture is left as it was.
segment::VoxelSet Document::Impl::brushed(const BrushSegment& op) {
    const std::uint64_t content = sculpture.contentVersion();
    std::visit([&](const auto& drawn) { beginStroke(drawn); }, op.stroke);
    sculpt::BrickDelta delta;
    try {
        stroke->replay();
        delta = stroke->finish();
    } catch (...) {
        discardStroke();
        throw;
    }
    stroke.reset();
    if (delta.isEmpty()) {
        return {};
    }
    segment::VoxelSet set = segment::emptySet(delta.box());
    std::vector<std::vector<float>> after;
    for (const Box3& brick : delta.bricks()) {
        after.push_back(sculpture.values(brick));
    }
    sculpture.swap(delta);
    sculpture.contentIsAsAt(content);
    const Range seen = std::visit(
        [&](const auto& drawn) { return drawn.canvas->view.visibleRange(volume.range); }, op.stroke);
    for (std::size_t n = 0; n < delta.bricks().size(); ++n) {
        const segment::VoxelSet brick{delta.bricks()[n], {}};
        const auto before = sculpture.values(brick.box);
        for (std::size_t i = 0; i < before.size(); ++i) {
            const glm::ivec3 voxel = brick.voxelAt(i);
            const bool isCut = before[i] < 0.5F && after[n][i] >= 0.5F;
            if (isCut && (!op.isToAdd || seen.contains(volume.at(voxel)))) {
                set.inside[set.indexOf(voxel)] = 1;
            }
        }
    }
    return set;
}

void Document::Impl::perform(const BrushSegment& op, Region::Records& records) {
    workUnlocked(records);
    const segment::VoxelSet brush = brushed(op);
    const segment::VoxelSet set = region.voxels(segments.atWork, records);
    region.replace(op.isToAdd ? segment::unite(set, brush) : segment::subtract(set, brush), records);
}

Outcome Document::Impl::run(BrushSegment& op, const std::filesystem::path&) {
    std::visit([&](auto& drawn) { settle(drawn.canvas); }, op.stroke);
    const std::size_t before = grownVoxels();
    change(op);
    const std::size_t now = grownVoxels();
    return {{},
            0,
            now > before ? now - before : before - now,
            now == before
                ? say(VS_TEXT("library", "nothing changed: the stroke does not reach the segment's surface"))
                : describeChange(before, now)};
}

Outcome Document::Impl::run(CutSegment& op, const std::filesystem::path&) {
    Region::Records records;
    const segment::VoxelSet set = region.voxels(segments.atWork, records);
    region.undo(records);
    if (set.count() == 0) {
        throw Error("the segment '{}' is empty; there is nothing to cut by", segments.working().name);
    }
    const auto inside = smoothMembership(field, segment::changeMargin(set, volume.geometry, op.marginMm));
    reportProgress();
    const Box3 box = volume.geometry.box();
    std::vector<float> values = sculpture.values(box);
    reportProgress();
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = std::max(values[i], op.keeps ? 1 - inside[i] : inside[i]);
    }
    const auto texels = sculpt::texelsOf(values, sculpture.precision());
    reportProgress(); // from here on it is done to the end
    sculpt::BrickBackup backup(sculpture.texels());
    backup.protect(box);
    sculpture.upload(box, texels);
    if (const auto isLocked = lockedVoxels()) {
        const Box3 spared = backup.spare(isLocked);
        if (!spared.isEmpty()) {
            sculpture.refresh(spared);
        }
    }
    sculpt::BrickDelta delta = backup.finish();
    const std::size_t changed = delta.changedVoxels();
    if (!delta.isEmpty()) {
        remember(op, std::move(delta), {});
    }
    return {{}, 0, changed, say(VS_TEXT("library", "%1 voxels changed"), changed)};
}

} // namespace vs::studio
