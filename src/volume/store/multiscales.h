// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/geometry.h"
#include "volume/store/zarr_array.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vs::volume {

// An image in a store of OME-Zarr 0.4 (ngff.openmicroscopy.org, "multiscales"): the same scan in several
// levels, each coarser than the one before.
struct Multiscales {
    struct Level {
        ZarrArray array;
        GridGeometry geometry; // voxel space of this level to the patient, LPS millimetres
    };

    std::filesystem::path path;
    std::vector<Level> levels; // the finest first
    // Smallest and largest values of the finest level (store_extremes.h), in stores of our own.
    struct Extremes {
        ZarrArray array;
        int side = 0; // voxels along each side of a cell
    };
    std::optional<Extremes> extremes;
    // Which axis of the arrays is the volume's x, y and z; -1: there is none, and there is one voxel along
    // it.
    std::array<int, 3> spatial{-1, -1, -1};
    int channelAxis = -1;
    int timeAxis = -1;
    std::vector<std::string> channelNames; // as far as the store names them
    std::string unit;                      // of the values; only stores of our own say it
    std::vector<std::string> notices;      // what was not said, and what is taken for it

    [[nodiscard]] int channels() const { return countAlong(channelAxis); }
    [[nodiscard]] int times() const { return countAlong(timeAxis); }
    // "0 (512 x 512 x 300), 1 (256 x 256 x 150)".
    [[nodiscard]] std::string levelsText() const;

private:
    [[nodiscard]] int countAlong(int axis) const {
        return axis < 0 ? 1 : int(levels.front().array.shape[std::size_t(axis)]);
    }
};

// The files that describe the arrays of a store, of whose files only .zattrs need be there: names in the
// store.
std::vector<std::string> descriptionFiles(const std::filesystem::path& path);

// The names of its channels as messages list them: ": 0 DAPI, 1 actin".
std::string namesOf(const Multiscales& store);

// The first image of a store. Nothing but its descriptions is read. Throws ReadError.
Multiscales openMultiscales(const std::filesystem::path& path);

// What our own stores say beside what the format has: its only transforms are scale and translation.
struct StoreFacts {
    GridGeometry geometry; // of the finest level
    std::string unit;
    std::string name;
    std::string reducing = "mean"; // how voxels became coarser ones, for people
    // What a label of a label map is called, and its colour (sRGB, 0 to 255, and opacity).
    struct Label {
        std::int64_t value = 0;
        std::string name;
        std::array<std::uint8_t, 4> colour{};
    };
    std::vector<Label> labels = {};
};

// The attributes of a store of `levels`, each half as fine along the axes that `halves` names as the one
// before, for its .zattrs. `extremesSide`: of its cells with extremes, 0 where it has none.
nlohmann::ordered_json multiscalesJson(const StoreFacts& facts, const std::vector<GridGeometry>& levels,
                                       int extremesSide);

} // namespace vs::volume
