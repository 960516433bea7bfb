// SPDX-License-Identifier: Apache-2.0
#include "arguments/parse.h"

#include "base/error.h"
#include "volume/io/write.h"

#include <algorithm>
#include <cctype>
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

Range parseRange(const std::string& text, const std::string& what) {
    const auto values = parseNumbers(text, ':', 2, what, "30:254");
    if (values[0] > values[1]) {
        throw UsageError("{} '{}' is empty: its first number is above its second; write {:g}:{:g}", what,
                         text, values[1], values[0]);
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

CLI::Validator between(double lo, double hi) {
    const auto complaint = [lo, hi](const std::string& text) {
        const auto value = number(text);
        return value && *value >= lo && *value <= hi
                   ? std::string()
                   : fmt::format("'{}' is no number from {} to {}", text, lo, hi);
    };
    return CLI::Validator(complaint, fmt::format("FLOAT in [{} - {}]", lo, hi));
}

void checkPictureName(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (extension != ".png") {
        throw UsageError("{}: pictures are written as PNG only; give a name that ends in .png",
                         path.string());
    }
}

void checkGridName(const std::filesystem::path& path) {
    try {
        volume::checkGridName(path);
    } catch (const WriteError& error) {
        throw UsageError("{}", error.what());
    }
}

} // namespace vs::cli
