// SPDX-License-Identifier: Apache-2.0
#include "studio/state/read_labels.h"

#include "base/error.h"

#include <fmt/format.h>

#include <utility>

namespace vs::studio {

namespace {

// The sets take the place of the map's voxels.
void putSets(LoadLabels& labels, volume::LabelMap& map, segment::LabelSets sets) {
    map.labels = {};
    map.values = {0};
    for (const auto& [value, set] : sets) {
        map.values.push_back(value);
    }
    labels.sets = std::make_shared<const segment::LabelSets>(std::move(sets));
}

std::optional<volume::LabelMap> readInBricks(LoadLabels& labels, const LabelGrids& grids) {
    if (!grids.finest || !volume::hasLevels(labels.path)) {
        return {};
    }
    const auto level = volume::openLabelLevel(labels.path, *grids.finest);
    if (!level) {
        return {};
    }
    volume::LabelMap map{labels.path, level->geometry, {}, {}, {}, level->looks};
    putSets(labels, map, segment::labelSets(*level->source, level->level, volume::kMostLabels));
    map.checksum = segment::checksum(*labels.sets);
    return map;
}

volume::LabelMap readWhole(LoadLabels& labels, const LabelGrids& grids, std::vector<std::string>& notices) {
    volume::LabelMap map = volume::readLabelMap(labels.path, notices, &grids.scene);
    const bool isFinest = grids.finest && map.geometry.dims == grids.finest->dims;
    if (isFinest || segment::isOfSets(labels.checksum)) {
        segment::LabelSets sets = segment::labelSets(map.labels, map.values, map.geometry.dims);
        if (segment::isOfSets(labels.checksum)) {
            map.checksum = segment::checksum(sets);
        }
        if (isFinest) {
            putSets(labels, map, std::move(sets));
        }
    }
    return map;
}

} // namespace

void readLabels(LoadLabels& labels, const LabelGrids& grids, std::vector<std::string>& notices) {
    std::optional<volume::LabelMap> map = readInBricks(labels, grids);
    if (!map) {
        map = readWhole(labels, grids, notices);
    }
    const bool isCompared =
        !labels.checksum.empty() && segment::isOfSets(map->checksum) == segment::isOfSets(labels.checksum);
    if (!labels.checksum.empty() && !isCompared) {
        notices.push_back(
            fmt::format("{}: was read whole when its checksum was taken, and in bricks now; that it "
                        "is the same label map is not known",
                        labels.path.string()));
    }
    if (isCompared && labels.checksum != map->checksum) {
        throw Error("{}: is not the label map that was opened (checksum {}, wanted {}); bring that one back, "
                    "or take the checksum out to use this one",
                    labels.path.string(), map->checksum, labels.checksum);
    }
    labels.checksum = map->checksum;
    labels.map = std::make_shared<const volume::LabelMap>(*std::move(map));
}

} // namespace vs::studio
