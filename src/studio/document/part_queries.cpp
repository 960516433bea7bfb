// SPDX-License-Identifier: Apache-2.0
#include "studio/document/part_queries.h"

#include "base/check.h"
#include "field/cell_ranges.h"
#include "sculpt/sculpture/precision.h"
#include "studio/editing/contents.h"
#include "studio/editing/display.h"

namespace vs::studio {

std::size_t PartQueries::count() const { return contents_.pasted.sculptures.size(); }

Box3 PartQueries::box(std::size_t part) {
    Box3 box;
    for (const glm::dvec3 middle : cells(part)) {
        const glm::ivec3 cell = glm::ivec3(middle) / field::kCell;
        box = unite(box, {field::kCell * cell, field::kCell * (cell + 1)});
    }
    return intersect(box, contents_.scan.volume.geometry.box());
}

std::vector<glm::dvec3> PartQueries::cells(std::size_t part) {
    const glm::ivec3 dims = contents_.scan.volume.geometry.dims;
    const auto rangesOf = [&](const gl::Texture& texels) {
        gl::Texture cells(field::cellDims(dims), gl::Format::RG32F, gl::Filter::Nearest,
                          "cells of a pasted part");
        field::CellRangeUpdater().update(texels, {glm::ivec3(0), dims}, cells);
        return cells.downloadAll<glm::vec2>();
    };
    const auto& pastes = contents_.pasted.sculptures;
    std::vector<glm::vec2> cut;
    std::vector<glm::vec2> before; // cells that are still the same do not count
    if (part == pastes.size()) {
        cut = contents_.sculpture.cells().downloadAll<glm::vec2>();
        if (!pastes.empty()) {
            before = rangesOf(*pastes.back());
        }
    } else {
        const auto parts = display_.frame(contents_.view, glm::ivec2(1)).pasted;
        if (part >= parts.size()) {
            return {};
        }
        cut = rangesOf(*parts[part].sculpture);
    }
    // More than half, because between two parts that touch both are half there.
    constexpr float kSurely = 0.6F;
    return seenCells(
        [&](std::size_t n) { return cut[n].y >= kSurely && (before.empty() || cut[n] != before[n]); });
}

std::vector<glm::dvec3> PartQueries::remainingCells() {
    const auto cut = contents_.sculpture.cells().downloadAll<glm::vec2>();
    switch (contents_.view.sculptureView) {
    case field::SculptureView::Cut:
        return seenCells([&](std::size_t n) { return cut[n].x < 0.5F; });
    case field::SculptureView::Probe:
        return seenCells([&](std::size_t n) { return cut[n].y >= 0.5F; });
    case field::SculptureView::Whole:
        break;
    }
    return seenCells([](std::size_t) { return true; });
}

// The middles of the macrocells that hold values of the displayed range and for which `isThere` holds.
std::vector<glm::dvec3> PartQueries::seenCells(const std::function<bool(std::size_t)>& isThere) {
    const glm::ivec3 cellDims = field::cellDims(contents_.scan.volume.geometry.dims);
    const auto values = display_.cellRanges().cells.downloadAll<glm::vec2>();
    const Range shown = contents_.view.visibleRange(contents_.scan.volume.range);
    std::vector<glm::dvec3> cells;
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (values[n].y >= shown.lo && values[n].x <= shown.hi && isThere(n)) {
            const int i = int(n);
            const glm::ivec3 cell(i % cellDims.x, i / cellDims.x % cellDims.y, i / cellDims.x / cellDims.y);
            cells.push_back(double(field::kCell) * glm::dvec3(cell) + 0.5 * (field::kCell - 1));
        }
    }
    return cells;
}

std::vector<float> PartQueries::values(std::size_t place, const Box3& box) {
    const auto parts = display_.frame(contents_.view, glm::ivec2(1)).pasted;
    VS_CHECK(place < parts.size());
    return sculpt::valuesOf(parts[place].sculpture->download(box), contents_.sculpture.precision());
}

} // namespace vs::studio
