// SPDX-License-Identifier: Apache-2.0
#include "field/filled_cells.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace vs::field {

namespace {

constexpr int kCellsOfBrick = kFillBrick / kCell; // along a side

// The least and greatest value of what is filled at the corners of a cell of a brick; lo > hi: nothing is.
glm::vec2 rangeOf(const FillCorners& corners, glm::ivec3 cell, const std::vector<float>& values) {
    glm::vec2 range(1e38F, -1e38F);
    constexpr auto side = std::size_t(FillCorners::kSide);
    forEachVoxel({cell * kCell, cell * kCell + kCell + 1}, [&](glm::ivec3 v, std::size_t) {
        const std::size_t i = (std::size_t(v.z) * side + std::size_t(v.y)) * side + std::size_t(v.x);
        if (corners.filled[i] > 0) {
            const std::size_t material = corners.material[i];
            const float value = material >= 1 && material <= values.size() ? values[material - 1] : 0.0F;
            range = {std::min(range.x, value), std::max(range.y, value)};
        }
    });
    return range;
}

} // namespace

void FilledCells::begin(const gl::Texture& scan, std::uint64_t serial) {
    const glm::ivec3 size = scan.size();
    const Box3 all{glm::ivec3(0), size};
    const std::vector<std::byte> bytes = scan.download(all);
    own_.resize(bytes.size() / sizeof(glm::vec2));
    std::memcpy(own_.data(), bytes.data(), bytes.size());
    ranges_ = gl::Texture(size, gl::Format::RG32F, gl::Filter::Nearest, "cell ranges with material");
    ranges_.copyFrom(scan, all, glm::ivec3(0));
    filled_ = gl::Texture(size, gl::Format::R8, gl::Filter::Nearest, "cells with material");
    filled_.clear(all);
    scan_ = &scan;
    scanSerial_ = serial;
    shown_ = std::make_shared<const Fill>();
}

void FilledCells::updateIn(std::uint32_t place, const Fill& fill) {
    const glm::ivec3 size = ranges_.size();
    const glm::ivec3 first = fill.brickAt(place) * kCellsOfBrick;
    const Box3 box = intersect({first, first + kCellsOfBrick}, {glm::ivec3(0), size});
    if (box.isEmpty()) { // beyond the last voxels there are no cells
        return;
    }
    const FillCorners corners = cornersOf(fill, place);
    std::vector<glm::vec2> ranges;
    std::vector<std::uint8_t> isFilled;
    forEachVoxel(box, [&](glm::ivec3 cell, std::size_t) {
        glm::vec2 range =
            own_[(std::size_t(cell.z) * std::size_t(size.y) + std::size_t(cell.y)) * std::size_t(size.x) +
                 std::size_t(cell.x)];
        bool isAny = false;
        if (!corners.isEmpty) {
            const glm::vec2 more = rangeOf(corners, cell - first, values_);
            isAny = more.x <= more.y;
            range = {std::min(range.x, more.x), std::max(range.y, more.y)};
        }
        ranges.push_back(range);
        isFilled.push_back(isAny ? 255 : 0);
    });
    ranges_.upload(box, std::as_bytes(std::span(ranges)));
    filled_.upload(box, std::as_bytes(std::span(isFilled)));
}

void FilledCells::update(const gl::Texture& scan, std::uint64_t serial, const SharedFill& fill,
                         const ShownMaterials& materials) {
    std::vector<float> values;
    std::transform(materials.begin(), materials.end(), std::back_inserter(values),
                   [](const ShownMaterial& m) { return m.value; });
    const bool isNew = scan_ != &scan || scanSerial_ != serial || ranges_.size() != scan.size();
    if (!isNew && shown_ == fill && values == values_) {
        return;
    }
    if (isNew || values != values_) {
        begin(scan, serial);
    }
    values_ = std::move(values);
    for (const std::uint32_t place : placesWithOtherCorners(*shown_, *fill)) {
        updateIn(place, *fill);
    }
    shown_ = fill;
    serial_ = nextSerial();
}

} // namespace vs::field
