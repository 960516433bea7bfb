// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "volume/grid/geometry.h"
#include "volume/grid/scan_details.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vs::volume {

enum class ScalarType { UInt8, Int8, UInt16, Int16, UInt32, Int32, Float32 };
inline constexpr std::array kScalarTypes{ScalarType::UInt8,  ScalarType::Int8,   ScalarType::UInt16,
                                         ScalarType::Int16,  ScalarType::UInt32, ScalarType::Int32,
                                         ScalarType::Float32};

// "uint8", "int16", "float32" ...: the names used on the command line, in JSON and in messages.
const char* name(ScalarType type);
std::size_t sizeOf(ScalarType type);

// A scalar volume as it was read: values (rescale slope and intercept already applied) in one block, x
// fastest, with their place in the patient. Never changed after reading. 64-bit inputs are held as Float32.
struct Volume {
    GridGeometry geometry;
    ScalarType type = ScalarType::UInt8;
    std::vector<std::byte> bytes;   // geometry.voxelCount() * sizeOf(type)
    Range range;                    // smallest and largest finite value
    Range usual;                    // without fill values and single extremes: for charts and suggestions
    std::size_t nonFiniteCount = 0; // NaN and infinite voxels; they lie outside every range
    std::string name;               // file or folder name, for titles and messages
    std::filesystem::path path;     // where it came from; empty for volumes made in memory
    std::string unit;               // of the values, as people write it ("HU"); empty where none is known
    ScanDetails details;

    // The value at one voxel; `index` must be inside the grid.
    [[nodiscard]] double at(glm::ivec3 index) const;
};

// Calls `f` with a typed pointer to the volume's values: visit(volume, [&](const auto* values) { ... }).
template <typename F>
decltype(auto) visit(const Volume& volume, F&& f) {
    const void* data = volume.bytes.data();
    switch (volume.type) {
    case ScalarType::UInt8:
        return f(static_cast<const std::uint8_t*>(data));
    case ScalarType::Int8:
        return f(static_cast<const std::int8_t*>(data));
    case ScalarType::UInt16:
        return f(static_cast<const std::uint16_t*>(data));
    case ScalarType::Int16:
        return f(static_cast<const std::int16_t*>(data));
    case ScalarType::UInt32:
        return f(static_cast<const std::uint32_t*>(data));
    case ScalarType::Int32:
        return f(static_cast<const std::int32_t*>(data));
    case ScalarType::Float32:
        break;
    }
    return f(static_cast<const float*>(data));
}

// Values of this size and beyond no scanner measures: they stand for those that were not.
inline constexpr double kNotMeasured = 1e15;

// Fills in range, usual and nonFiniteCount. What is not usual are values of kNotMeasured and beyond, and up
// to a hundred thousandth of the voxels, or one, if they are farther away from all others than a hundred
// times the range of those.
void computeRange(Volume& volume);

// Checksum of geometry and values (FNV-1a, 64 bit, as 16 hex digits): tells a session whether it has its
// volume.
std::string checksum(const Volume& volume);

} // namespace vs::volume
