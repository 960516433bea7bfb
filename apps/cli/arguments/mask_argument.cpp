// SPDX-License-Identifier: Apache-2.0
#include "arguments/mask_argument.h"

#include "reports/label_map.h"

#include "base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <span>

namespace vs::cli {
namespace {

std::int64_t parseLabel(const std::string& part, const std::string& text, const std::string& option) {
    std::int64_t label = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), label);
    if (error != std::errc() || end != part.data() + part.size() || label == 0) {
        throw UsageError("{} {}: '{}' is no label; write whole numbers other than 0 behind the file, "
                         "like labels.nii.gz:4,5",
                         option, text, part);
    }
    return label;
}

} // namespace

MaskArgument parseMask(const std::string& text, const std::string& option) {
    std::error_code ignored; // reading will tell what is wrong
    const auto colon = text.rfind(':');
    if (colon == std::string::npos || std::filesystem::exists(text, ignored)) {
        return {text, {}};
    }
    MaskArgument argument{text.substr(0, colon), {}};
    for (std::size_t from = colon + 1; from <= text.size();) {
        const std::size_t to = std::min(text.find(',', from), text.size());
        argument.labels.push_back(parseLabel(text.substr(from, to - from), text, option));
        from = to + 1;
    }
    return argument;
}

std::vector<std::uint8_t> readMask(const MaskArgument& argument, const volume::Volume& volume) {
    LabelMap map = readLabelMap(argument.path);
    requireSameGrid(map, volume.geometry, volume.path);
    std::array<std::uint8_t, 256> isInside{};
    std::fill(isInside.begin() + 1, isInside.end(), std::uint8_t(argument.labels.empty() ? 1 : 0));
    const std::span held(map.values.begin() + 1, map.values.end());
    for (const std::int64_t label : argument.labels) {
        const auto place = std::find(held.begin(), held.end(), label);
        if (place == held.end()) {
            throw Error("{}: no voxel has the label {}; there are {}", argument.path.string(), label,
                        held.empty() ? "none" : fmt::format("{}", fmt::join(held, ", ")));
        }
        isInside[std::size_t(place - held.begin()) + 1] = 1;
    }
    for (std::uint8_t& label : map.labels) {
        label = isInside[label];
    }
    return std::move(map.labels);
}

} // namespace vs::cli
