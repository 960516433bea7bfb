// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/tool_surface.h"

#include "base/check.h"
#include "sculpt/surface/surface_raster.h"
#include "sculpt/surface/surface_skirt.h"

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

constexpr int kMaxSkirt = 64; // elements
constexpr std::uint32_t kNoCorner = 0xFFFFFFFFU;

// Builds the patches of one sweep.
class SurfaceSweeper : public SurfaceRaster {
public:
    SurfaceSweeper(std::span<const field::SurfacePoint> points, const MaskRaster& mask,
                   const volume::GridGeometry& geometry, const ToolSweep& sweep)
        : SurfaceRaster(points, mask, geometry, sweep),
          outside_(sweep.outsideSteps < 0 ? sweep.radius : sweep.outsideSteps),
          out_(hasOwnDepths() ? 0.0F : float(-outside_), hasOwnDepths() ? 1.0F : float(sweep.depthSteps), 0) {
        // A point farther outside the grid reaches no voxel of it (Footprint::reachVoxels() <= radius + 2).
        const glm::vec3 reach(float(sweep.radius + 3));
        if (sweep.inPieces) {
            out_.sweepInPieces();
        }
        out_.clipTo(-reach, glm::vec3(geometry.dims - 1) + reach);
        const glm::dvec3 sigma = sweep.radius / 3.0 * geometry.stepMm() / geometry.spacing();
        out_.setDensity({SweptPatches::densityFor(sigma.x), SweptPatches::densityFor(sigma.y),
                         SweptPatches::densityFor(sigma.z)});
    }

    SweptPatches run() {
        if (!(hasOwnDepths() || sweep_.depthSteps > 0) || size_.x < 1 || size_.y < 1 || !anyHitUnderMask()) {
            return std::move(out_);
        }
        findDirections();
        addCorners(thinMaskGain());
        findCells();
        if (restores() || sweep_.direction == ToolDirection::Common) {
            addSkirt();
        }
        const int block = blockSize();
        for (int j = -1; j < size_.y; j = j < 0 ? 0 : j + block) {
            for (int i = -1; i < size_.x; i = i < 0 ? 0 : i + block) {
                addBlock({i, j}, {i < 0 ? 1 : block, j < 0 ? 1 : block});
            }
        }
        return std::move(out_);
    }

private:
    enum class Cell : std::uint8_t { Nothing, Whole, Broken };

    // Cells along a side that one sample stands for: a power of two, so that a part of a raster that begins
    // at a multiple of kMaxBlock gives the same samples as the whole.
    [[nodiscard]] int blockSize() const {
        int block = 1;
        while (2 * block <= kMaxBlock && 2 * block * spacing_ <= SweptPatches::kSpacing) {
            block *= 2;
        }
        return block;
    }

    void addCorners(float gain) {
        gain_ = gain;
        out_.reserve(points_.size(), points_.size());
        for (std::size_t n = 0; n < points_.size(); ++n) {
            addCorner(glm::vec3(points_[n].voxel), n, maskAt(n));
        }
    }

    // A corner at a place in voxel space that moves as element `from` does.
    std::uint32_t addCorner(const glm::vec3& place, std::size_t from, float mask) {
        const glm::vec3 inwards = voxelFromSteps_ * directions_[from];
        if (restores()) {
            const float inside = float(sweep_.radius);
            return out_.addCorner(place + inside * inwards, -(inside + sweep_.outwardSteps[from]) * inwards,
                                  gain_ * mask);
        }
        if (hasOwnDepths()) {
            const float outside(outside_);
            return out_.addCorner(place - outside * inwards, (outside + sweep_.depths[from]) * inwards,
                                  gain_ * mask);
        }
        return out_.addCorner(place, inwards, gain_ * mask);
    }

    [[nodiscard]] float cornerMask(int i, int j) const {
        return isHit(i, j) ? out_.corners()[at(i, j)].start.w : 0.0F;
    }

    // Cell (i, j) lies between elements (i, j) and (i + 1, j + 1); cells of the raster's rim have elements on
    // one side.
    Cell& cell(int i, int j) {
        return cells_[std::size_t(j + 1) * std::size_t(size_.x + 1) + std::size_t(i + 1)];
    }
    void findCells() {
        std::vector<std::uint8_t> joinedX(points_.size(), 0); // to the next along x, along y
        std::vector<std::uint8_t> joinedY(points_.size(), 0);
        for (int j = 0; j < size_.y; ++j) {
            for (int i = 0; i < size_.x; ++i) {
                joinedX[at(i, j)] = std::uint8_t(isJoined({i, j}, {i + 1, j}));
                joinedY[at(i, j)] = std::uint8_t(isJoined({i, j}, {i, j + 1}));
            }
        }
        cells_.assign(std::size_t(size_.x + 1) * std::size_t(size_.y + 1), Cell::Nothing);
        for (int j = -1; j < size_.y; ++j) {
            for (int i = -1; i < size_.x; ++i) {
                const bool inner = i >= 0 && j >= 0 && i + 1 < size_.x && j + 1 < size_.y;
                if (inner && (joinedX[at(i, j)] & joinedX[at(i, j + 1)] & joinedY[at(i, j)] &
                              joinedY[at(i + 1, j)]) != 0) {
                    cell(i, j) = Cell::Whole;
                } else if (isHit(i, j) || isHit(i + 1, j) || isHit(i, j + 1) || isHit(i + 1, j + 1)) {
                    cell(i, j) = Cell::Broken;
                }
            }
        }
    }

    // Pieces of the surface in front go on beyond their silhouettes.
    void addSkirt() {
        SkirtInput input;
        input.size = size_;
        input.isHit = [this](int i, int j) { return isHit(i, j); };
        input.place = [this](int i, int j) { return stepsFromVoxel_ * place(i, j); };
        input.isJoined = [this](glm::ivec2 a, glm::ivec2 b) { return isJoined(a, b); };
        input.direction = meanDirection();
        input.alongX = meanStep({1, 0});
        input.alongY = meanStep({0, 1});
        input.gap = gap_;
        input.coversOthers = !restores(); // what is put back over a hole would close it
        // What is put back must also cover what was cut beside what is seen.
        const double steps = restores() ? 2.0 * sweep_.radius : sweep_.radius;
        input.reach = std::clamp(int(std::ceil(steps / spacing_)), 1, kMaxSkirt);
        const std::vector<SkirtElement> skirt = surfaceSkirt(input);
        if (skirt.empty()) {
            return;
        }
        isCovered_.assign(points_.size() * 4, false);
        std::vector<std::uint32_t> corners(points_.size(), kNoCorner);
        for (int j = 0; j + 1 < size_.y; ++j) {
            for (int i = 0; i + 1 < size_.x; ++i) {
                addSkirtCell({i, j}, skirt, corners);
            }
        }
    }

    // A cell whose corners are all of the skirt, or of the silhouette that it continues.
    void addSkirtCell(glm::ivec2 c, const std::vector<SkirtElement>& skirt,
                      std::vector<std::uint32_t>& corners) {
        std::array<std::uint32_t, 4> cellCorners{};
        std::array<glm::vec3, 4> places{};
        int ofSkirt = 0;
        for (std::size_t n = 0; n < 4; ++n) {
            const glm::ivec2 e(c.x + int(n & 1U), c.y + int(n >> 1U));
            const std::size_t element = at(e.x, e.y);
            if (skirt[element].exists()) {
                ++ofSkirt;
                places[n] = skirt[element].place;
                if (corners[element] == kNoCorner) {
                    const glm::ivec2 from = skirt[element].from;
                    corners[element] =
                        addCorner(voxelFromSteps_ * places[n], at(from.x, from.y), mask_.values[element]);
                }
                cellCorners[n] = corners[element];
            } else if (isHit(e.x, e.y)) {
                places[n] = stepsFromVoxel_ * place(e.x, e.y);
                cellCorners[n] = std::uint32_t(element);
            } else {
                return;
            }
        }
        const auto isFar = [&](std::size_t a, std::size_t b) {
            return glm::distance(places[a], places[b]) > gap_;
        };
        if (ofSkirt == 0 || isFar(0, 1) || isFar(2, 3) || isFar(0, 2) || isFar(1, 3)) {
            return;
        }
        out_.addCell(cellCorners);
        for (std::size_t n = 0; n < 4; ++n) { // these hits need no column of their own in this cell
            if (cellCorners[n] < points_.size()) {
                isCovered_[std::size_t(cellCorners[n]) * 4 + (3 - n)] = true;
            }
        }
    }

    // Cells [first, first + count): as one patch where they are whole, else in quarters, down to single
    // cells.
    void addBlock(glm::ivec2 first, glm::ivec2 count) {
        const glm::ivec2 end = glm::min(first + count, size_); // the rim's last cells are at size - 1
        bool whole = true;
        float sum = 0;
        glm::vec2 moment(0);
        for (int j = first.y; j < end.y; ++j) {
            for (int i = first.x; i < end.x; ++i) {
                whole = whole && cell(i, j) == Cell::Whole;
                // Each element's share at its own place: joining elements must not blur the mask.
                for (int n = 0; n < 4; ++n) {
                    const glm::ivec2 e(i + (n & 1), j + (n >> 1));
                    const float mask = cornerMask(e.x, e.y);
                    sum += mask;
                    moment += mask * glm::vec2(e - first);
                }
            }
        }
        const glm::ivec2 cells = end - first;
        if (!(sum > 0)) {
            return;
        }
        if (cells.x * cells.y == 1) {
            addCell(first);
        } else if (whole) {
            out_.addBlock(cornersOf(first, cells), sum / float(4 * cells.x * cells.y),
                          moment / sum / glm::vec2(cells));
        } else {
            const glm::ivec2 half = (count + 1) / 2;
            for (int n = 0; n < 4; ++n) {
                const glm::ivec2 from = first + glm::ivec2(n & 1, n >> 1) * half;
                const glm::ivec2 to = glm::min(from + half, first + count);
                if (glm::all(glm::lessThan(from, glm::min(to, size_)))) {
                    addBlock(from, to - from);
                }
            }
        }
    }

    void addCell(glm::ivec2 c) {
        if (cell(c.x, c.y) == Cell::Whole) {
            out_.addCell(cornersOf(c, {1, 1}));
        } else if (cell(c.x, c.y) == Cell::Broken) {
            addQuarters(c);
        }
    }

    // The corners of cells [c, c + cells).
    [[nodiscard]] std::array<std::uint32_t, 4> cornersOf(glm::ivec2 c, glm::ivec2 cells) const {
        const glm::ivec2 d = c + cells;
        return {std::uint32_t(at(c.x, c.y)), std::uint32_t(at(d.x, c.y)), std::uint32_t(at(c.x, d.y)),
                std::uint32_t(at(d.x, d.y))};
    }

    // Whether all four cells around an element are broken: then its quarters of them are one patch.
    [[nodiscard]] bool isBrokenAround(glm::ivec2 e) {
        return cell(e.x - 1, e.y - 1) == Cell::Broken && cell(e.x, e.y - 1) == Cell::Broken &&
               cell(e.x - 1, e.y) == Cell::Broken && cell(e.x, e.y) == Cell::Broken;
    }

    // Whether the skirt covers one of the four cells around an element.
    [[nodiscard]] bool isCovered(glm::ivec2 e, int corner) const {
        return !isCovered_.empty() && isCovered_[at(e.x, e.y) * 4 + std::size_t(corner)];
    }

    void addQuarters(glm::ivec2 c) {
        for (int n = 0; n < 4; ++n) {
            const glm::ivec2 side(n & 1, n >> 1);
            const glm::ivec2 e = c + side;
            if (!(cornerMask(e.x, e.y) > 0) || isCovered(e, 3 - n)) { // at the rim: e may lie beyond it
                continue;
            }
            const bool allFour = isBrokenAround(e) && !isCovered(e, 0) && !isCovered(e, 1) &&
                                 !isCovered(e, 2) && !isCovered(e, 3);
            if (allFour && n != 3) { // the four together are the first of the cells' business
                continue;
            }
            auto u = tangent(e, {1, 0});
            auto v = tangent(e, {0, 1});
            const glm::vec3 direction = directions_[at(e.x, e.y)];
            if (!u && v) {
                u = voxelFromSteps_ * glm::cross(direction, inSteps(*v));
            } else if (u && !v) {
                v = voxelFromSteps_ * glm::cross(direction, inSteps(*u));
            } else if (!u) { // alone: nothing tells how large it is
                continue;
            }
            const glm::vec3 alongU = (allFour ? 1.0F : side.x == 0 ? 0.5F : -0.5F) * *u;
            const glm::vec3 alongV = (allFour ? 1.0F : side.y == 0 ? 0.5F : -0.5F) * *v;
            const glm::vec3 first = place(e.x, e.y) - (allFour ? 0.5F * (*u + *v) : glm::vec3(0));
            std::array<std::uint32_t, 4> corners{};
            for (std::size_t k = 0; k < 4; ++k) {
                const glm::vec3 start = first + float(k & 1U) * alongU + float(k >> 1U) * alongV;
                corners[k] = addCorner(start, at(e.x, e.y), mask_.values[at(e.x, e.y)]);
            }
            out_.addCell(corners);
        }
    }
    double outside_;
    std::vector<Cell> cells_;
    float gain_ = 1;
    std::vector<bool> isCovered_; // four cells around each element: the skirt covers it there; empty: nowhere
    SweptPatches out_;
};

} // namespace

std::vector<glm::vec3> toolDirections(std::span<const field::SurfacePoint> points, const MaskRaster& mask,
                                      const volume::GridGeometry& geometry, const ToolSweep& sweep) {
    VS_CHECK_EQ(points.size(), mask.values.size());
    SurfaceRaster raster(points, mask, geometry, sweep);
    raster.findDirections();
    return raster.takeDirections();
}

SweptPatches sweepSurface(std::span<const field::SurfacePoint> points, const MaskRaster& mask,
                          const volume::GridGeometry& geometry, const ToolSweep& sweep) {
    VS_CHECK_EQ(points.size(), mask.values.size());
    return SurfaceSweeper(points, mask, geometry, sweep).run();
}

} // namespace vs::sculpt
