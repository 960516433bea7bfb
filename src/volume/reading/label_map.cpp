// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/label_map.h"

#include "base/error.h"
#include "volume/reading/label_looks.h"
#include "volume/reading/read_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace vs::volume {
namespace {

// The different values but 0, in their order.
std::vector<std::int64_t> labelValues(const Volume& volume) {
    std::set<std::int64_t> found;
    visit(volume, [&](const auto* values) {
        double last = 0;
        for (std::size_t i = 0; i < volume.geometry.voxelCount(); ++i) {
            const auto value = double(values[i]);
            if (value == last) {
                continue;
            }
            if (!(std::abs(value) < 1e15) || value != std::floor(value)) {
                throw ReadError("{}: holds the value {:g}; a label map holds whole numbers only",
                                volume.path.string(), value);
            }
            last = value;
            if (value != 0 && found.insert(std::int64_t(value)).second && found.size() > kMostLabels) {
                throw ReadError("{}: holds more than {} different values; a label map has at most so many",
                                volume.path.string(), kMostLabels);
            }
        }
    });
    return {found.begin(), found.end()};
}

std::optional<int> levelLike(const StoreBricks& store, const GridGeometry& like) {
    const auto& levels = store.levels();
    const auto found = std::find_if(levels.begin(), levels.end(),
                                    [&](const GridGeometry& level) { return level.dims == like.dims; });
    return found == levels.end() ? std::nullopt : std::optional(int(found - levels.begin()));
}

std::string sizeText(glm::ivec3 dims) { return fmt::format("{} x {} x {}", dims.x, dims.y, dims.z); }

} // namespace

LabelMap readLabelMap(const std::filesystem::path& path, std::vector<std::string>& notices,
                      const GridGeometry* like) {
    if (isHeaderless(path)) { // --raw is there for volumes
        throw ReadError("{}: is of no known format; label maps are read from NIfTI, NRRD, MetaImage, VTK and "
                        "DICOM files",
                        path.string());
    }
    ReadOptions options;
    if (like != nullptr && hasLevels(path)) {
        const auto level = levelLike(StoreBricks(path, ReadOptions()), *like);
        options.level = level && *level > 0 ? level : std::nullopt;
    }
    ReadResult read = readVolume(path, options);
    const Volume& volume = read.volume;
    notices.insert(notices.end(), read.notices.begin(), read.notices.end());
    LabelMap map{path, volume.geometry, {}, labelValues(volume), checksum(volume), labelLooksOf(path)};
    map.labels.resize(volume.geometry.voxelCount());
    map.values.insert(map.values.begin(), 0);
    visit(volume, [&](const auto* values) {
        std::int64_t last = 0;
        std::uint8_t label = 0;
        for (std::size_t i = 0; i < map.labels.size(); ++i) {
            if (const auto value = std::int64_t(values[i]); value != last) {
                const auto place = std::lower_bound(map.values.begin() + 1, map.values.end(), value);
                label = std::uint8_t(value == 0 ? 0 : place - map.values.begin());
                last = value;
            }
            map.labels[i] = label;
        }
    });
    return map;
}

std::optional<LabelLevel> openLabelLevel(const std::filesystem::path& path, const GridGeometry& like) {
    auto store = std::make_shared<const StoreBricks>(path, ReadOptions());
    const std::optional<int> level = levelLike(*store, like);
    if (!level) {
        return {};
    }
    const GridGeometry geometry = store->levels()[std::size_t(*level)];
    return LabelLevel{std::move(store), *level, geometry, labelLooksOf(path)};
}

void requireSameGrid(const LabelMap& map, const GridGeometry& geometry, const std::filesystem::path& volume) {
    if (map.geometry.dims != geometry.dims) {
        throw Error("{}: has {} voxels and {} has {}; labels must lie on the volume's grid",
                    map.path.string(), sizeText(map.geometry.dims), volume.string(), sizeText(geometry.dims));
    }
    double apart = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec4 voxel(side * (geometry.dims - 1), 1);
        const glm::dvec4 offset = (map.geometry.worldFromVoxel - geometry.worldFromVoxel) * voxel;
        apart = std::max(apart, glm::length(glm::dvec3(offset)));
    }
    if (!(apart <= 0.1 * geometry.stepMm())) {
        throw Error("{}: its voxels lie up to {:.3g} mm from those of {}; spacing, origin and direction of "
                    "labels must be the volume's",
                    map.path.string(), apart, volume.string());
    }
}

} // namespace vs::volume
