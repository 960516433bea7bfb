// SPDX-License-Identifier: Apache-2.0
#include "volume/tiff/tiff_metadata.h"

#include "volume/io/length_units.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace vs::volume {

namespace {

constexpr std::int64_t kMostPages = std::int64_t(1) << 31;

std::int64_t countOf(const std::string& text) {
    return std::clamp<std::int64_t>(std::strtoll(text.c_str(), nullptr, 10), 0, kMostPages);
}

bool isSensible(double spacing) { return std::isfinite(spacing) && spacing > 0; }

TiffMetadata ofImageJ(const std::string& description, glm::dvec2 pixelsPerUnit) {
    TiffMetadata out;
    out.isImageJ = true;
    double slicesApart = 0;
    std::optional<double> unit;
    std::istringstream lines(description);
    for (std::string line; std::getline(lines, line);) {
        const auto equals = line.find('=');
        const std::string key = line.substr(0, equals);
        const std::string value = equals == std::string::npos ? "" : line.substr(equals + 1);
        if (key == "images") {
            out.images = countOf(value);
        } else if (key == "slices") {
            out.slices = countOf(value);
        } else if (key == "channels") {
            out.channels = std::max<std::int64_t>(countOf(value), 1);
        } else if (key == "frames") {
            out.times = std::max<std::int64_t>(countOf(value), 1);
        } else if (key == "spacing") {
            slicesApart = std::abs(std::strtod(value.c_str(), nullptr));
        } else if (key == "unit") {
            unit = millimetresOf(value);
        }
    }
    if (unit && isSensible(pixelsPerUnit.x) && isSensible(pixelsPerUnit.y)) {
        const glm::dvec2 pixel = *unit / pixelsPerUnit;
        out.spacingMm = {pixel, isSensible(slicesApart) ? *unit * slicesApart : 0};
    }
    return out;
}

// An attribute of the first element <Pixels>; nothing where it has none.
std::optional<std::string> ofPixels(const std::string& xml, const std::string& attribute) {
    const auto begin = xml.find("<Pixels");
    const auto end = begin == std::string::npos ? begin : xml.find('>', begin);
    if (end == std::string::npos) {
        return {};
    }
    const std::string element = xml.substr(begin, end - begin);
    const std::string key = " " + attribute + "=";
    const auto at = element.find(key);
    if (at == std::string::npos || at + key.size() >= element.size()) {
        return {};
    }
    const char quote = element[at + key.size()];
    const auto first = at + key.size() + 1;
    const auto last = element.find(quote, first);
    return last == std::string::npos ? std::nullopt : std::optional(element.substr(first, last - first));
}

TiffMetadata ofOme(const std::string& xml) {
    TiffMetadata out;
    out.slices = countOf(ofPixels(xml, "SizeZ").value_or("0"));
    out.channels = std::max<std::int64_t>(countOf(ofPixels(xml, "SizeC").value_or("1")), 1);
    out.times = std::max<std::int64_t>(countOf(ofPixels(xml, "SizeT").value_or("1")), 1);
    const std::string order = ofPixels(xml, "DimensionOrder").value_or("XYCZT");
    std::string sorted = order;
    std::sort(sorted.begin(), sorted.end());
    if (sorted == "CTXYZ" && order.starts_with("XY")) {
        out.order = order.substr(2);
    }
    glm::dvec3 spacing(0);
    for (int axis = 0; axis < 3; ++axis) {
        const std::string name = std::string("PhysicalSize") + "XYZ"[axis];
        const auto size = ofPixels(xml, name);
        const auto unit = millimetresOf(ofPixels(xml, name + "Unit").value_or("um"));
        spacing[axis] = size && unit ? std::strtod(size->c_str(), nullptr) * *unit : 0;
    }
    if (isSensible(spacing.x) && isSensible(spacing.y)) {
        out.spacingMm = {spacing.x, spacing.y, isSensible(spacing.z) ? spacing.z : 0};
    }
    return out;
}

} // namespace

std::int64_t TiffMetadata::pageOf(std::int64_t slice, std::int64_t channel, std::int64_t time) const {
    std::int64_t page = 0;
    std::int64_t step = 1;
    for (const char axis : order) {
        page += step * (axis == 'C' ? channel : axis == 'Z' ? slice : time);
        step *= axis == 'C' ? channels : axis == 'Z' ? slices : times;
    }
    return page;
}

TiffMetadata readTiffMetadata(const std::string& description, glm::dvec2 pixelsPerUnit,
                              bool isPerCentimetre) {
    if (description.starts_with("ImageJ=")) {
        return ofImageJ(description, pixelsPerUnit);
    }
    if (description.find("<OME") != std::string::npos) {
        return ofOme(description);
    }
    TiffMetadata out;
    if (isPerCentimetre && isSensible(pixelsPerUnit.x) && isSensible(pixelsPerUnit.y)) {
        out.spacingMm = {10.0 / pixelsPerUnit, 0};
    }
    return out;
}

} // namespace vs::volume
