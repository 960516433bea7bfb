// SPDX-License-Identifier: Apache-2.0
// Segments from a label map.
#include "base/progress.h"
#include "segment/edits/label_sets.h"
#include "studio/document/document_change.h"

namespace vs::studio {

namespace {

constexpr std::size_t kMostSegments = 255;

std::string freeName(const SegmentList& segments, const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; segments.find(name) != nullptr; ++number) {
        name = fmt::format("{} ({})", wanted, number);
    }
    return name;
}

std::shared_ptr<const volume::LabelMap> readMap(const LoadLabels& op) {
    std::vector<std::string> notices; // of geometry: requireSameGrid() says what matters
    auto map = std::make_shared<volume::LabelMap>(volume::readLabelMap(op.path, notices));
    if (!op.checksum.empty() && op.checksum != map->checksum) {
        throw Error(
            "{}: is not the label map that was opened (checksum {}, wanted {}); bring that one back, or "
            "take the checksum out to use this one",
            op.path.string(), map->checksum, op.checksum);
    }
    return map;
}

} // namespace

// Returns how many voxels the segments got.
std::size_t Document::Impl::perform(const LoadLabels& op, Region::Records& records) {
    const volume::LabelMap& map = *op.map;
    const auto boxes = segment::labelBoxes(map.labels, volume.geometry.dims);
    const std::uint8_t wasAtWork = segments.atWork;
    bool usesFirst = segments.segments.size() == 1 && !segments.working().isLocked &&
                     !segments.working().isClaimed && !region.hasSeeds();
    std::size_t voxels = 0;
    for (std::size_t n = 1; n < map.values.size(); ++n) {
        reportProgress(double(n) / double(map.values.size()));
        const auto look = map.looks.find(map.values[n]);
        const bool hasLook = look != map.looks.end();
        const std::string wanted = hasLook && !look->second.name.empty()
                                       ? look->second.name
                                       : fmt::format("Label {}", map.values[n]);
        SegmentInfo& info = usesFirst ? segments.segments.front() : segments.add(freeName(segments, wanted));
        if (usesFirst) {
            info.name = wanted;
            usesFirst = false;
        }
        if (hasLook) {
            info.colour = look->second.colour.value_or(info.colour);
        }
        const std::uint8_t label = info.label;
        region.workOn(label, records);
        region.replace(segment::setOf(map.labels, volume.geometry.dims, std::uint8_t(n), boxes[n]), records);
        voxels += std::size_t(region.growth()->voxelCount());
    }
    region.workOn(wasAtWork, records);
    return voxels;
}

Outcome Document::Impl::run(LoadLabels& op, const std::filesystem::path&) {
    if (!op.map) {
        op.map = readMap(op);
    }
    op.checksum = op.map->checksum;
    volume::requireSameGrid(*op.map, volume.geometry, volume.path.empty() ? "the volume" : volume.path);
    const std::size_t labels = op.map->values.size() - 1;
    if (labels == 0) {
        throw Error("{}: holds no label; a label map has voxels other than 0", op.path.string());
    }
    const std::size_t kept =
        segments.segments.size() == 1 && !segments.working().isClaimed && !region.hasSeeds()
            ? 0
            : segments.segments.size();
    if (labels + kept > kMostSegments) {
        throw Error("{}: holds {} labels; beside the {} segments there are there is room for {}",
                    op.path.string(), labels, kept, kMostSegments - kept);
    }
    const std::size_t voxels = change(op);
    return {{},
            0,
            voxels,
            say(labels == 1 ? VS_TEXT("library", "%1 segment, %2 voxels")
                            : VS_TEXT("library", "%1 segments, %2 voxels"),
                labels, voxels)};
}

} // namespace vs::studio
