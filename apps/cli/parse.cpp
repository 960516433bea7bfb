// SPDX-License-Identifier: Apache-2.0
#include "parse.h"

#include "base/error.h"

#include <charconv>
#include <cmath>
#include <optional>

namespace vs::cli {

namespace {

std::optional<double> number(std::string_view text) {
    double value = 0;
    const char* begin = text.data();
    const char* end = begin + text.size();
    if (begin != end && *begin == '+') {
        ++begin;
    }
    const auto result = std::from_chars(begin, end, value);
    if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

} // namespace

std::vector<double> parseNumbers(const std::string& text, char separator, std::size_t count,
                                 const std::string& what, const std::string& example) {
    std::vector<double> values;
    std::size_t start = 0;
    while (start <= text.size()) {
        const std::size_t end = std::min(text.find(separator, start), text.size());
        const auto value = number(std::string_view(text).substr(start, end - start));
        if (!value) {
            throw UsageError("{} '{}' is not understood; write it like {}", what, text, example);
        }
        values.push_back(*value);
        start = end + 1;
    }
    if (values.size() != count) {
        throw UsageError("{} '{}' has {} numbers, {} are wanted; write it like {}", what, text, values.size(),
                         count, example);
    }
    return values;
}

Range parseRange(const std::string& text) {
    const auto values = parseNumbers(text, ':', 2, "range", "30:254");
    if (values[0] > values[1]) {
        throw UsageError("range '{}' is empty: its first number is above its second; write {:g}:{:g}", text,
                         values[1], values[0]);
    }
    return {values[0], values[1]};
}

glm::ivec2 parseSize(const std::string& text) {
    const auto values = parseNumbers(text, 'x', 2, "size", "1230x870");
    for (const double v : values) {
        if (v < 1 || v > 16384 || v != std::floor(v)) {
            throw UsageError(
                "size '{}' is out of bounds; 1 to 16384 pixels each way are allowed, like 1230x870", text);
        }
    }
    return {int(values[0]), int(values[1])};
}

} // namespace vs::cli
