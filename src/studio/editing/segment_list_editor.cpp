// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/segment_list_editor.h"

#include "base/check.h"
#include "base/progress.h"
#include "segment/edits/label_sets.h"
#include "studio/editing/seen_cells.h"
#include "studio/editing/segment_change.h"
#include "studio/state/read_labels.h"

#include <algorithm>

namespace vs::studio {

namespace {

constexpr std::size_t kMostSegments = 255;

std::string nameInQuotes(const std::string& segment) { return "'" + segment + "'"; }

Phrase said(const std::optional<std::string>& segment) {
    return segment ? say("%1", nameInQuotes(*segment)) : say(VS_TEXT("library", "all"));
}

std::string freeName(const SegmentList& segments, const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; segments.find(name) != nullptr; ++number) {
        name = fmt::format("{} ({})", wanted, number);
    }
    return name;
}

// Labels may have been made before or after it was corrected where voxels lie.
void requireOnGrid(const volume::LabelMap& map, const Contents& contents, bool isFinest) {
    const Scan& scan = contents.scan;
    const std::filesystem::path name = scan.volume.path.empty() ? "the volume" : scan.volume.path;
    try {
        volume::requireSameGrid(map, isFinest ? contents.region.geometry() : scan.volume.geometry, name);
    } catch (const Error&) {
        volume::requireSameGrid(map, isFinest ? scan.levels->levels().front() : scan.inFile, name);
    }
}

} // namespace

void SegmentListEditor::perform(const UseSegment& op, Region::Records& records) {
    SegmentInfo* segment = contents_.segments.find(op.segment);
    if (segment == nullptr && op.takesFirst.value_or(false)) {
        segment = &contents_.segments.segments.front();
        segment->name = op.segment;
        segment->isClaimed = true;
    } else if (segment == nullptr) {
        segment = &contents_.segments.add(op.segment);
    }
    if (op.name && *op.name != op.segment && contents_.segments.find(*op.name) != nullptr) {
        throw Error("there is a segment '{}' already; choose another name", *op.name);
    }
    segment->name = op.name.value_or(segment->name);
    segment->colour = op.colour.value_or(segment->colour);
    segment->opacity = op.opacity.value_or(segment->opacity);
    segment->isVisible = op.isVisible.value_or(segment->isVisible);
    segment->isLocked = op.isLocked.value_or(segment->isLocked);
    segment->treatment = op.treatment.value_or(segment->treatment);
    if (op.goesToWork) {
        contents_.segments.atWork = segment->label;
        contents_.region.workOn(contents_.segments.atWork, records);
    }
}

Outcome SegmentListEditor::run(UseSegment& op) {
    if (contents_.segments.find(op.segment) == nullptr) {
        const bool canTake =
            op.goesToWork && contents_.segments.isUntouched() && contents_.region.isUntouched();
        if (op.takesFirst.value_or(false) && !canTake) {
            throw Error("'{}' cannot take the place of the first segment, which is in use already; leave "
                        "'first' out",
                        op.segment);
        }
        if (canTake) {
            op.takesFirst = op.takesFirst.value_or(!isNumbered(op.segment));
        }
    }
    changeSegments(contents_, *this, op);
    return {{},
            0,
            0,
            op.goesToWork
                ? say(VS_TEXT("library", "at work on %1"), nameInQuotes(contents_.segments.working().name))
                : say(VS_TEXT("library", "%1 changed"), nameInQuotes(op.name.value_or(op.segment)))};
}

void SegmentListEditor::perform(const RemoveSegment& op, Region::Records& records) {
    const SegmentInfo* segment = contents_.segments.find(op.segment);
    if (segment == nullptr) {
        throw Error("there is no segment '{}' to remove", op.segment);
    }
    if (segment->isLocked) {
        throw Error("the segment '{}' is locked; unlock it first", op.segment);
    }
    contents_.region.workOn(segment->label, records);
    contents_.region.clear(records);
    contents_.region.forgetRules(records);
    contents_.segments.remove(segment->label);
    contents_.region.workOn(contents_.segments.atWork, records);
}

Outcome SegmentListEditor::run(RemoveSegment& op) {
    changeSegments(contents_, *this, op);
    return {{}, 0, 0, say("%1", nameInQuotes(op.segment))};
}

void SegmentListEditor::perform(const ShowSegments& op, Region::Records&) {
    if (op.only && contents_.segments.find(*op.only) == nullptr) {
        throw Error("there is no segment '{}' to show", *op.only);
    }
    for (SegmentInfo& segment : contents_.segments.segments) {
        segment.isVisible = !op.only || segment.name == *op.only;
    }
}

Outcome SegmentListEditor::run(ShowSegments& op) {
    changeSegments(contents_, *this, op);
    return {{},
            0,
            0,
            op.only ? say(VS_TEXT("library", "only %1 is shown"), nameInQuotes(*op.only))
                    : say(VS_TEXT("library", "all segments are shown"))};
}

void SegmentListEditor::perform(const PullOut& op, Region::Records&) {
    if (op.segment && contents_.segments.find(*op.segment) == nullptr) {
        throw Error("there is no segment '{}' to pull out", *op.segment);
    }
    std::optional<std::array<glm::dvec3, 256>> middles; // looked for when one is needed
    bool isSome = false;
    for (SegmentInfo& segment : contents_.segments.segments) {
        const bool isOut = segment.pulledOut.has_value();
        const bool isMeant = op.segment ? segment.name == *op.segment
                                        : !isOut && contents_.region.voxelCount(segment.label) > 0;
        if (isMeant) {
            if (!isOut && !middles) {
                middles = this->middles();
            }
            const glm::dvec3 middle = isOut ? segment.pulledOut->middleVoxel : (*middles)[segment.label];
            segment.pulledOut = {op.place, op.isVisible, middle};
            isSome = true;
        }
    }
    if (!isSome) {
        throw Error("there is nothing to pull out: no segment that is not out yet has voxels");
    }
}

std::array<glm::dvec3, 256> SegmentListEditor::middles() const {
    std::array<glm::dvec3, 256> middles{};
    middles.fill(middleOf({}, contents_));
    if (contents_.region.exists()) {
        const auto labels = contents_.region.growth()->labelMap();
        const auto boxes = segment::labelBoxes(labels, contents_.scan.volume.geometry.dims);
        std::transform(boxes.begin(), boxes.end(), middles.begin(),
                       [this](const Box3& box) { return middleOf(box, contents_); });
    }
    return middles;
}

Outcome SegmentListEditor::run(PullOut& op) {
    changeSegments(contents_, *this, op);
    return {{}, 0, 0, said(op.segment)};
}

void SegmentListEditor::perform(const PutBack& op, Region::Records&) {
    bool isSome = false;
    for (SegmentInfo& segment : contents_.segments.segments) {
        if (segment.pulledOut && segment.name == op.segment.value_or(segment.name)) {
            segment.pulledOut.reset();
            isSome = true;
        }
    }
    if (!isSome) {
        throw op.segment ? Error("the segment '{}' is not pulled out", *op.segment)
                         : Error("no segment is pulled out");
    }
}

Outcome SegmentListEditor::run(PutBack& op) {
    changeSegments(contents_, *this, op);
    return {{}, 0, 0, said(op.segment)};
}

// --- from a label map

std::size_t SegmentListEditor::perform(const LoadLabels& op, Region::Records& records) {
    VS_CHECK(op.map); // states of sessions keep it too
    const volume::LabelMap& map = *op.map;
    const auto boxes = op.sets ? std::array<Box3, 256>()
                               : segment::labelBoxes(map.labels, contents_.scan.volume.geometry.dims);
    const std::uint8_t wasAtWork = contents_.segments.atWork;
    bool usesFirst = contents_.segments.segments.size() == 1 && !contents_.segments.working().isLocked &&
                     !contents_.segments.working().isClaimed && !contents_.region.hasSeeds();
    std::size_t voxels = 0;
    for (std::size_t n = 1; n < map.values.size(); ++n) {
        reportProgress(double(n) / double(map.values.size()));
        const std::int64_t value = map.values[n];
        const auto look = map.looks.find(value);
        const bool hasLook = look != map.looks.end();
        const std::string wanted =
            hasLook && !look->second.name.empty() ? look->second.name : fmt::format("Label {}", value);
        SegmentInfo& info = usesFirst ? contents_.segments.segments.front()
                                      : contents_.segments.add(freeName(contents_.segments, wanted));
        if (usesFirst) {
            info.name = wanted;
            usesFirst = false;
        }
        if (hasLook) {
            info.colour = look->second.colour.value_or(info.colour);
        }
        const std::uint8_t label = info.label;
        contents_.region.workOn(label, records);
        if (op.sets) {
            contents_.region.replace(op.sets->at(value), records);
        } else {
            contents_.region.replace(
                segment::setOf(map.labels, contents_.scan.volume.geometry.dims, std::uint8_t(n), boxes[n]),
                records);
        }
        voxels += contents_.region.voxelCount(label);
    }
    contents_.region.workOn(wasAtWork, records);
    return voxels;
}

Outcome SegmentListEditor::run(LoadLabels& op) {
    if (!op.map) {
        std::vector<std::string> notices; // of geometry: requireOnGrid() says what matters
        readLabels(op, contents_.labelGrids(), notices);
    }
    op.checksum = op.map->checksum;
    requireOnGrid(*op.map, contents_, op.sets != nullptr);
    const std::size_t labels = op.map->values.size() - 1;
    if (labels == 0) {
        throw Error("{}: holds no label; a label map has voxels other than 0", op.path.string());
    }
    const std::size_t kept = contents_.segments.segments.size() == 1 &&
                                     !contents_.segments.working().isClaimed && !contents_.region.hasSeeds()
                                 ? 0
                                 : contents_.segments.segments.size();
    if (labels + kept > kMostSegments) {
        throw Error("{}: holds {} labels; beside the {} segments there are there is room for {}",
                    op.path.string(), labels, kept, kMostSegments - kept);
    }
    const std::size_t voxels = changeSegments(contents_, *this, op);
    return {{},
            0,
            voxels,
            say(labels == 1 ? VS_TEXT("library", "%1 segment, %2 voxels")
                            : VS_TEXT("library", "%1 segments, %2 voxels"),
                labels, voxels)};
}

} // namespace vs::studio
