// SPDX-License-Identifier: Apache-2.0
#include "volume/io/inspect.h"
#include "volume/io/read.h"

#include "base/lines.h"

#include <fmt/format.h>

#include <cmath>

namespace vs::volume {
namespace {

[[noreturn]] void refuseLayout(const std::string& text, const std::string& wrong) {
    throw UsageError(
        "raw layout \"{}\": {}; it looks like DIMS:TYPE[:SPACING[:OFFSET]], for example "
        "256x256x108:int16:0.957,0.957,1.5:0 with uint8, int8, uint16, int16, uint32, int32 or float32",
        printable(text), wrong);
}

std::vector<double> splitNumbers(const std::string& layout, const std::string& text, char separator) {
    std::vector<double> numbers;
    for (const std::string& part : split(text, separator)) {
        double value = 0;
        if (!parseNumber(part, value)) {
            refuseLayout(layout, fmt::format("\"{}\" is not a number", printable(part)));
        }
        numbers.push_back(value);
    }
    return numbers;
}

} // namespace

RawLayout parseRawLayout(const std::string& text) {
    const std::vector<std::string> parts = split(text, ':');
    if (parts.size() < 2 || parts.size() > 4) {
        refuseLayout(text, fmt::format("it has {} parts", parts.size()));
    }
    RawLayout layout;
    const auto dims = splitNumbers(text, parts[0], 'x');
    if (dims.size() != 3) {
        refuseLayout(text, "three sizes are needed");
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double size = dims[std::size_t(axis)];
        if (!(size >= 1 && size <= 1e6) || size != std::floor(size)) {
            refuseLayout(text, fmt::format("the size {} makes no sense", size));
        }
        layout.dims[axis] = int(size);
    }
    bool known = false;
    for (int type = 0; type <= int(ScalarType::Float32) && !known; ++type) {
        layout.type = ScalarType(type);
        known = parts[1] == name(layout.type);
    }
    if (!known) {
        refuseLayout(text, fmt::format("the type \"{}\" is unknown", printable(parts[1])));
    }
    if (parts.size() > 2 && !parts[2].empty()) {
        const auto spacing = splitNumbers(text, parts[2], ',');
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double mm = spacing.size() == 3 ? spacing[axis] : spacing.size() == 1 ? spacing[0] : 0.0;
            if (!(mm >= 1e-6 && mm <= 1e4)) {
                refuseLayout(text, "the spacing must be one or three positive numbers of millimetres");
            }
            layout.spacing[int(axis)] = mm;
        }
    }
    if (parts.size() > 3) {
        const auto offset = splitNumbers(text, parts[3], ',');
        if (offset.size() != 1 || !(offset[0] >= 0 && offset[0] < 1e15) ||
            offset[0] != std::floor(offset[0])) {
            refuseLayout(text, "the offset must be a number of bytes");
        }
        layout.offsetBytes = std::size_t(offset[0]);
    }
    return layout;
}

} // namespace vs::volume
