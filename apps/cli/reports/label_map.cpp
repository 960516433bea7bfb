// SPDX-License-Identifier: Apache-2.0
#include "reports/label_map.h"

#include "reports/progress.h"

#include "base/error.h"
#include "base/log.h"
#include "volume/io/write.h"

#include <algorithm>
#include <utility>

namespace vs::cli {

LabelMap readLabelMap(const std::filesystem::path& path, const volume::GridGeometry* like) {
    std::vector<std::string> notices;
    LabelMap map = [&] {
        const Activity activity("reading " + path.string());
        return volume::readLabelMap(path, notices, like);
    }();
    for (const std::string& notice : notices) {
        logNotice(notice);
    }
    return map;
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
