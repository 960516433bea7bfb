// SPDX-License-Identifier: Apache-2.0
#include "label_map.h"

#include "volume_argument.h"

#include "base/error.h"
#include "volume/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace vs::cli {
namespace {

constexpr std::size_t kMostLabels = 255;

// The different values but 0, in their order.
std::vector<std::int64_t> labelValues(const volume::Volume& volume) {
    std::set<std::int64_t> found;
    volume::visit(volume, [&](const auto* values) {
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

std::string sizeText(glm::ivec3 dims) { return fmt::format("{} x {} x {}", dims.x, dims.y, dims.z); }

} // namespace

LabelMap readLabelMap(const std::filesystem::path& path) {
    if (volume::isHeaderless(path)) { // --raw is there for volumes
        throw ReadError("{}: is of no known format; label maps are read from NIfTI, NRRD, MetaImage, VTK and "
                        "DICOM files",
                        path.string());
    }
    VolumeArgument argument;
    argument.path = path.string();
    const volume::Volume volume = loadVolume(argument).volume;
    LabelMap map{path, volume.geometry, {}, labelValues(volume)};
    map.labels.resize(volume.geometry.voxelCount());
    map.values.insert(map.values.begin(), 0);
    volume::visit(volume, [&](const auto* values) {
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

void requireSameGrid(const LabelMap& map, const volume::GridGeometry& geometry,
                     const std::filesystem::path& volume) {
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

std::int64_t nextFreeValue(const LabelMap& map) {
    std::int64_t value = 1;
    while (std::binary_search(map.values.begin() + 1, map.values.end(), value)) {
        ++value;
    }
    return value;
}

void writeLabelMap(const std::filesystem::path& path, const volume::GridGeometry& geometry,
                   std::span<const std::uint8_t> labels, std::span<const std::int64_t> values) {
    const auto fits = [&]<typename T>(T) {
        return std::all_of(values.begin(), values.end(), [](auto value) { return std::in_range<T>(value); });
    };
    const auto write = [&]<typename T>(T) {
        std::vector<T> written(labels.size());
        std::transform(labels.begin(), labels.end(), written.begin(),
                       [&](std::uint8_t label) { return T(values[label]); });
        volume::writeGrid(path, geometry, std::span<const T>(written));
    };
    if (fits(std::uint8_t())) {
        write(std::uint8_t());
    } else if (fits(std::int16_t())) {
        write(std::int16_t());
    } else if (fits(std::uint32_t())) {
        write(std::uint32_t());
    } else {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        throw WriteError("{}: labels from {} to {} cannot be written together; uint8, int16 or uint32 must "
                         "hold them",
                         path.string(), *least, *most);
    }
}

} // namespace vs::cli
