// SPDX-License-Identifier: Apache-2.0
#include "studio/document/part_queries.h"

#include "field/cell_ranges.h"
#include "sculpt/sculpture/precision.h"
#include "segment/edits/islands.h"
#include "segment/edits/label_sets.h"
#include "studio/editing/contents.h"
#include "studio/editing/display.h"
#include "studio/editing/seen_cells.h"
#include "studio/editing/shown_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace vs::studio {

namespace {

// Islands of cells are specks that are smaller than this part of the largest one, or of as few cells as a
// single voxel of noise touches where they meet.
constexpr double kSpeck = 1e-3;
constexpr double kVoxelCells = 9;
constexpr double kFew = 0.1; // of the largest one: then a few cells are more than a speck

segment::VoxelSet withoutSpecks(const segment::VoxelSet& cells) {
    const auto connected = segment::Connectivity::TwentySix;
    const auto islands = segment::islands(cells, connected);
    if (islands.size() < 2) {
        return cells;
    }
    const auto asLarge = volume::makeGeometry(cells.box.size(), glm::dvec3(10)); // a millilitre each
    const auto largest = double(islands.front().voxels);
    return segment::dropSmallIslands(
        cells, asLarge, std::max(kSpeck * largest, std::min(kVoxelCells, kFew * largest)), connected);
}

// The world's corners of a box of macrocells: with the half voxel outside the outermost centres.
void addCorners(const Box3& cells, const volume::GridGeometry& geometry, const glm::dmat4& worldFromVoxel,
                std::vector<glm::dvec3>& corners) {
    const glm::dvec3 most = glm::dvec3(geometry.dims) - 0.5;
    const glm::dvec3 lo = glm::max(double(field::kCell) * glm::dvec3(cells.lo), glm::dvec3(0)) -
                          0.5 * glm::dvec3(glm::equal(cells.lo, glm::ivec3(0)));
    const glm::dvec3 hi = glm::min(double(field::kCell) * glm::dvec3(cells.hi), most);
    for (int n = 0; n < 8; ++n) {
        const glm::dvec3 corner((n & 1) != 0 ? hi.x : lo.x, (n & 2) != 0 ? hi.y : lo.y,
                                (n & 4) != 0 ? hi.z : lo.z);
        corners.emplace_back(worldFromVoxel * glm::dvec4(corner, 1.0));
    }
}

} // namespace

std::vector<std::uint8_t> labelsOf(const std::vector<SeenPart>& pulledOut) {
    std::vector<std::uint8_t> labels;
    for (const SeenPart& part : pulledOut) {
        labels.push_back(std::uint8_t(part.at));
    }
    return labels;
}

std::size_t PartQueries::count() const { return contents_.pasted.parts.size(); }

Box3 PartQueries::box(std::size_t part) { return boxAround(cells(part), contents_); }

Box3 PartQueries::nextBox(bool takesTrimmed) { return boxAround(nextCells(takesTrimmed), contents_); }

render::Placement PartQueries::putFor(const render::Placement& drawn, const Box3& box) const {
    return render::broughtTogether(drawn, contents_.view.spread, middleOf(box, contents_),
                                   contents_.scan.volume.geometry);
}

std::vector<SeenPart> PartQueries::seen() const {
    const auto places = shownPlaces(contents_.view, contents_.pasted, contents_.scan.volume.geometry);
    const auto& parts = contents_.pasted.parts;
    std::vector<SeenPart> found;
    for (std::size_t at = 0; at < places.size(); ++at) {
        const bool isPart = at < parts.size();
        if (!isPart || parts[at].isVisible) {
            found.push_back({at, isPart ? parts[at].name : fmt::format("Part {}", at + 1), places[at]});
        }
    }
    return found;
}

std::vector<SeenPart> PartQueries::seenPulledOut() const {
    std::vector<SeenPart> found;
    for (const SegmentInfo& segment : contents_.segments.segments) {
        if (segment.isSeenPulledOut()) {
            found.push_back({segment.label, segment.name,
                             shownPlace(contents_.view, segment, contents_.scan.volume.geometry)});
        }
    }
    return found;
}

std::vector<glm::dvec3> PartQueries::cells(std::size_t part) {
    return seenCellsOfPart(contents_, display_, display_.partAt(part).cells->downloadAll<glm::vec2>());
}

std::vector<glm::dvec3> PartQueries::nextCells(bool takesTrimmed) {
    return seenCellsOfPart(contents_, display_, display_.cellsOfNextPart(takesTrimmed));
}

std::array<Box3, 256> PartQueries::segmentBoxes() {
    std::array<Box3, 256> boxes{};
    if (contents_.region.exists()) {
        const auto found =
            segment::labelBoxes(contents_.region.growth()->labelMap(), contents_.scan.volume.geometry.dims);
        std::copy(found.begin(), found.end(), boxes.begin());
    }
    return boxes;
}

std::map<std::uint8_t, std::vector<glm::dvec3>>
PartQueries::segmentCells(const std::vector<std::uint8_t>& labels) {
    if (labels.empty() || !contents_.region.exists()) {
        return {};
    }
    const glm::ivec3 dims = contents_.scan.volume.geometry.dims;
    const glm::ivec3 cellDims = field::cellDims(dims);
    const auto cells = std::size_t(cellDims.x) * std::size_t(cellDims.y) * std::size_t(cellDims.z);
    std::array<std::vector<bool>, 256> isThere;
    for (const std::uint8_t label : labels) {
        isThere[label].resize(cells);
    }
    const auto indexOf = [cellDims](glm::ivec3 cell) {
        return (std::size_t(cell.z) * std::size_t(cellDims.y) + std::size_t(cell.y)) *
                   std::size_t(cellDims.x) +
               std::size_t(cell.x);
    };
    const auto labelMap = contents_.region.growth()->labelMap();
    auto voxel = labelMap.begin();
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x, ++voxel) {
                if (!isThere[*voxel].empty()) {
                    const glm::ivec3 cell = glm::min(glm::ivec3(x, y, z) / field::kCell, cellDims - 1);
                    isThere[*voxel][indexOf(cell)] = true;
                }
            }
        }
    }
    std::map<std::uint8_t, std::vector<glm::dvec3>> found;
    for (const std::uint8_t label : labels) {
        for (std::size_t n = 0; n < cells; ++n) {
            if (isThere[label][n]) {
                found[label].push_back(middleOfCell(n, cellDims));
            }
        }
    }
    return found;
}

std::vector<glm::dvec3> PartQueries::remainingCells() {
    const auto cut = contents_.sculpture.cells().downloadAll<glm::vec2>();
    switch (contents_.view.sculptureView) {
    case field::SculptureView::Cut:
        return seenCells(contents_, display_, [&](std::size_t n) { return cut[n].x < 0.5F; });
    case field::SculptureView::Probe:
        return seenCells(contents_, display_, [&](std::size_t n) { return cut[n].y >= 0.5F; });
    case field::SculptureView::Whole:
        break;
    }
    return seenCells(contents_, display_, [](std::size_t) { return true; });
}

std::vector<glm::dvec3> PartQueries::pointsAroundAll() {
    const auto& geometry = contents_.scan.volume.geometry;
    std::vector<glm::dvec3> points;
    for (const Box3& row : rowsSeen()) {
        addCorners(row, geometry, geometry.worldFromVoxel, points);
    }
    for (const SeenPart& part : seen()) {
        if (part.at < count()) {
            addPlaced(cells(part.at), part.place, points);
        }
    }
    const auto pulledOut = seenPulledOut();
    auto cellsOf = segmentCells(labelsOf(pulledOut));
    for (const SeenPart& part : pulledOut) {
        addPlaced(cellsOf[std::uint8_t(part.at)], part.place, points);
    }
    if (points.empty()) {
        addCorners({glm::ivec3(0), field::cellDims(geometry.dims)}, geometry, geometry.worldFromVoxel,
                   points);
    }
    return points;
}

// The corners of cells that are drawn elsewhere.
void PartQueries::addPlaced(const std::vector<glm::dvec3>& cells, const render::Placement& place,
                            std::vector<glm::dvec3>& points) const {
    const auto& geometry = contents_.scan.volume.geometry;
    const glm::dmat4 worldFromVoxel = render::worldFromPart(place, geometry) * geometry.worldFromVoxel;
    for (const glm::dvec3 middle : cells) {
        const glm::ivec3 cell = glm::ivec3(middle) / field::kCell;
        addCorners({cell, cell + 1}, geometry, worldFromVoxel, points);
    }
}

// From the first to the last macrocell of each row in which the picture shows something of what remains.
std::vector<Box3> PartQueries::rowsSeen() {
    const auto frame = display_.frame(contents_.view, glm::ivec2(1));
    const auto distances = frame.macrocells->distances().downloadAll<std::uint32_t>();
    const glm::ivec3 size = frame.macrocells->size();
    segment::VoxelSet cells = segment::emptySet({glm::ivec3(0), size});
    std::transform(distances.begin(), distances.end(), cells.inside.begin(),
                   [](std::uint32_t distance) { return std::uint8_t(distance == 0 ? 1 : 0); });
    cells = withoutSpecks(cells);
    std::vector<Box3> rows;
    const glm::ivec3 dims = cells.box.size();
    for (std::size_t row = 0; row < std::size_t(dims.y) * std::size_t(dims.z); ++row) {
        const auto begin = cells.inside.begin() + std::ptrdiff_t(row * std::size_t(dims.x));
        const auto end = begin + dims.x;
        const auto first = std::find(begin, end, 1);
        if (first != end) {
            const auto last = std::find(std::reverse_iterator(end), std::reverse_iterator(begin), 1).base();
            const glm::ivec3 at = cells.box.lo + glm::ivec3(0, int(row) % dims.y, int(row) / dims.y);
            rows.push_back(
                {at + glm::ivec3(int(first - begin), 0, 0), at + glm::ivec3(int(last - begin), 1, 1)});
        }
    }
    return rows;
}

std::vector<float> PartQueries::values(std::size_t place, const Box3& box) {
    return sculpt::valuesOf(display_.partAt(place).texels->download(box), contents_.sculpture.precision());
}

} // namespace vs::studio
