// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/inspect.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <vector>

// From values as files store them to those of a Volume. Internal to reading.
namespace vs::volume {

// What stored values stand for: slope * value + intercept. Factors that change nothing leave types alone.
struct Scaling {
    double slope = 1;
    double intercept = 0;

    [[nodiscard]] bool changes() const {
        constexpr double nothing = std::numeric_limits<float>::epsilon();
        return std::abs(slope - 1) > nothing || std::abs(intercept) > nothing;
    }
    [[nodiscard]] float of(double stored) const { return static_cast<float>(slope * stored + intercept); }
};

// Sets volume.type and volume.bytes from values in this machine's byte order; 64-bit values and scaled ones
// become Float32. Returns whether that changed one that is not scaled.
bool takeValues(Volume& volume, StoredType type, std::vector<std::byte>&& bytes, const Scaling& scaling = {});

// Sets the values of one frame of a file that was inspected, with a notice where 64-bit ones were rounded.
// They are read here and by no library: those turn NaN into 0, stop at the first number that they do not
// like, take compressed sizes on trust.
void takeFrame(const std::filesystem::path& path, Inspection& inspection, int frame, ReadResult& result,
               const Scaling& scaling = {});

// Reads a file whose header was inspected and says where the volume lies; `frame` picks a volume of several.
ReadResult readPlaced(const char* format, const std::filesystem::path& path, PlacedInspection&& inspection,
                      std::optional<int> frame, const Scaling& scaling = {});

} // namespace vs::volume
