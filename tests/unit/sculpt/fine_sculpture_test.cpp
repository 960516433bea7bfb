// SPDX-License-Identifier: Apache-2.0
// A sparse sculpture beside one that has every voxel.
#include "field/cell_ranges.h"
#include "property.h"
#include "sculpt/sculpture/fine_reader.h"
#include "sculpt/sculpture/fine_sculpture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace vs::sculpt {
namespace {

// A grid twice as fine as a scene, or as fine along some axes.
field::BrickGrid finestGrid(glm::ivec3 dims, glm::dvec3 perSceneVoxel) {
    field::BrickGrid grid;
    grid.dims = dims;
    grid.perSceneVoxel = perSceneVoxel;
    grid.origin = 0.5 * perSceneVoxel - 0.5;
    return grid;
}

struct Pair {
    Pair(glm::ivec3 dims, Precision precision, glm::dvec3 perSceneVoxel)
        : fine(finestGrid(dims, perSceneVoxel), precision), box{glm::ivec3(0), dims},
          dense(box.volume(), 0.0F) {}

    // Some bricks get values: many are alike.
    void put(std::mt19937& random, FineBricks& before) {
        const glm::ivec3 counts = divideUp(box.hi, kFineBrick);
        const auto below = [&](int n) { return int(random() % unsigned(n)); };
        const glm::ivec3 lo{below(counts.x), below(counts.y), below(counts.z)};
        const glm::ivec3 hi =
            lo + 1 + glm::ivec3(below(counts.x - lo.x), below(counts.y - lo.y), below(counts.z - lo.z));
        const Box3 part = intersect({lo * kFineBrick, hi * kFineBrick}, box);
        std::vector<float> values(part.volume());
        const int kind = below(3);
        for (float& value : values) {
            value = kind == 0 ? 0.0F : kind == 1 ? 1.0F : float(below(256)) / 255.0F;
        }
        const auto texels = texelsOf(values, fine.precision());
        fine.put(part, texels, before);
        write(part, valuesOf(texels, fine.precision()));
    }
    void write(const Box3& part, const std::vector<float>& values) {
        forEachVoxel(part, [&](glm::ivec3 v, std::size_t n) { dense[indexOf(v)] = values[n]; });
    }
    [[nodiscard]] std::size_t indexOf(glm::ivec3 v) const {
        return (std::size_t(v.z) * std::size_t(box.hi.y) + std::size_t(v.y)) * std::size_t(box.hi.x) +
               std::size_t(v.x);
    }
    [[nodiscard]] float at(glm::ivec3 v) const {
        return dense[indexOf(glm::clamp(v, glm::ivec3(0), box.hi - 1))];
    }
    [[nodiscard]] double between(const glm::dvec3& place) const {
        const glm::dvec3 inside = glm::clamp(place, glm::dvec3(0), glm::dvec3(box.hi - 1));
        const glm::ivec3 v(inside);
        const glm::dvec3 f = inside - glm::dvec3(v);
        double sum = 0;
        for (int n = 0; n < 8; ++n) {
            const glm::ivec3 d(n & 1, (n >> 1) & 1, n >> 2);
            const glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(d));
            sum += w.x * w.y * w.z * double(at(v + d));
        }
        return sum;
    }
    [[nodiscard]] std::vector<float> all() const { return valuesOf(fine.texels(box), fine.precision()); }

    FineSculpture fine;
    Box3 box;
    std::vector<float> dense;
};

Pair drawPair(std::mt19937& random) {
    const auto below = [&](int n) { return int(random() % unsigned(n)); };
    const glm::ivec3 dims = 2 * glm::ivec3(10 + below(40), 10 + below(40), 10 + below(40));
    const Precision precision = Precision(below(3));
    return {dims, precision, below(2) == 0 ? glm::dvec3(2) : glm::dvec3(2, 2, 1)};
}

TEST(FineSculptureTest, HasWhatWasPutAndUndoesIt) {
    test::checkProperty(40, [] {
        std::mt19937 random{std::mt19937::result_type(*test::below(100000))};
        Pair pair = drawPair(random);
        std::vector<FineDelta> deltas;
        std::vector<std::vector<float>> states{pair.all()};
        for (int n = 0; n < 4; ++n) {
            const std::uint64_t version = pair.fine.version();
            FineBricks before;
            pair.put(random, before);
            pair.put(random, before);
            RC_ASSERT(pair.all() == pair.dense);
            std::size_t changed = 0;
            const Box3 box = pair.fine.changedSince(version);
            forEachVoxel(pair.box, [&](glm::ivec3 v, std::size_t i) {
                const bool isOther = pair.dense[i] != states.back()[i];
                changed += isOther ? 1 : 0;
                RC_ASSERT(!isOther || !intersect(box, {v, v + 1}).isEmpty());
            });
            deltas.push_back(pair.fine.since(before));
            RC_ASSERT(deltas.back().changedVoxels == changed);
            states.push_back(pair.all());
        }
        for (std::size_t n = deltas.size(); n-- > 0;) {
            pair.fine.swap(deltas[n]);
            RC_ASSERT(pair.all() == states[n]);
        }
        RC_ASSERT(pair.fine.isEmpty());
        for (std::size_t n = 0; n < deltas.size(); ++n) {
            pair.fine.swap(deltas[n]);
            RC_ASSERT(pair.all() == states[n + 1]);
        }
        const auto held = pair.fine.reader();
        FineDelta cleared = pair.fine.clear();
        RC_ASSERT(pair.fine.isEmpty());
        RC_ASSERT(held(pair.box) == states.back()); // what threads were given stays
        pair.fine.swap(cleared);
        RC_ASSERT(pair.all() == states.back());
    });
}

TEST(FineSculptureTest, SceneAndLevelsHaveWhatLiesThere) {
    test::checkProperty(30, [] {
        std::mt19937 random{std::mt19937::result_type(*test::below(100000))};
        Pair pair = drawPair(random);
        FineBricks before;
        pair.put(random, before);
        pair.put(random, before);
        const field::BrickGrid& grid = pair.fine.grid();
        const glm::ivec3 sceneDims(glm::round(glm::dvec3(grid.dims) / grid.perSceneVoxel));
        const Box3 scene{glm::ivec3(0), sceneDims};
        const auto values = pair.fine.sceneValues(scene);
        forEachVoxel(scene, [&](glm::ivec3 v, std::size_t n) {
            const double wanted = pair.between(glm::dvec3(v) * grid.perSceneVoxel + grid.origin);
            RC_ASSERT(std::abs(double(values[n]) - wanted) < 1e-5);
        });
        // The finest level itself, and one that lies between it and the scene.
        for (const glm::dvec3 scale : {glm::dvec3(1), glm::dvec3(1.25, 1.5, 1)}) {
            field::BrickGrid level = grid;
            level.side = 24;
            level.perSceneVoxel = grid.perSceneVoxel / scale;
            level.origin = (grid.origin + 0.5) / scale - 0.5;
            level.dims = glm::ivec3(glm::ceil(glm::dvec3(grid.dims) / scale));
            const auto overlay = pair.fine.snapshot();
            forEachVoxel({glm::ivec3(0), level.counts()}, [&](glm::ivec3 brick, std::size_t) {
                const auto texels = overlay->texelsOf(level, brick);
                const Box3 box{brick * level.side, brick * level.side + level.texels()};
                const auto found = texels.empty() ? std::vector<float>(box.volume(), 0.0F)
                                                  : valuesOf(texels, pair.fine.precision());
                forEachVoxel(box, [&](glm::ivec3 v, std::size_t n) {
                    const double wanted = pair.between((glm::dvec3(v) - level.origin) / level.perSceneVoxel *
                                                           grid.perSceneVoxel +
                                                       grid.origin);
                    RC_ASSERT(std::abs(double(found[n]) - wanted) < 0.5 / 255 + 1e-4);
                });
            });
        }
    });
}

TEST(FineSculptureTest, CellsHoldAllThatLiesInThem) {
    test::checkProperty(30, [] {
        std::mt19937 random{std::mt19937::result_type(*test::below(100000))};
        Pair pair = drawPair(random);
        FineBricks before;
        pair.put(random, before);
        const field::BrickGrid& grid = pair.fine.grid();
        const glm::ivec3 sceneDims(glm::round(glm::dvec3(grid.dims) / grid.perSceneVoxel));
        const Box3 cells{glm::ivec3(0), field::cellDims(sceneDims)};
        const auto ranges = pair.fine.cellRanges(cells);
        forEachVoxel(pair.box, [&](glm::ivec3 v, std::size_t n) {
            const glm::dvec3 place = (glm::dvec3(v) - grid.origin) / grid.perSceneVoxel;
            const glm::ivec3 cell =
                glm::clamp(glm::ivec3(glm::floor(place / double(field::kCell))), glm::ivec3(0), cells.hi - 1);
            const glm::vec2 range =
                ranges[(std::size_t(cell.z) * std::size_t(cells.hi.y) + std::size_t(cell.y)) *
                           std::size_t(cells.hi.x) +
                       std::size_t(cell.x)];
            RC_ASSERT((pair.dense[n] >= range.x && pair.dense[n] <= range.y));
        });
    });
}

// Where the scene was cut, the finest level is; elsewhere it is what it was.
TEST(FineSculptureTest, RisesWhereTheSceneRose) {
    test::checkProperty(20, [] {
        std::mt19937 random{std::mt19937::result_type(*test::below(100000))};
        Pair pair = drawPair(random);
        FineBricks before;
        pair.put(random, before);
        const auto was = pair.all();
        const field::BrickGrid& grid = pair.fine.grid();
        const glm::ivec3 sceneDims(glm::round(glm::dvec3(grid.dims) / grid.perSceneVoxel));
        const Box3 scene{glm::ivec3(0), sceneDims};
        const auto low = pair.fine.sceneValues(scene);
        auto high = low;
        const int from = int(random() % unsigned(sceneDims.x));
        forEachVoxel(scene, [&](glm::ivec3 v, std::size_t n) { high[n] = v.x >= from ? 1.0F : low[n]; });
        FineBricks originals;
        pair.fine.raise(scene, low, high, originals);
        FineDelta delta = pair.fine.since(originals);
        const auto is = pair.all();
        forEachVoxel(pair.box, [&](glm::ivec3 v, std::size_t n) {
            const double x = (v.x - grid.origin.x) / grid.perSceneVoxel.x;
            RC_ASSERT(is[n] >= was[n]);
            RC_ASSERT((x < from || is[n] > 0.995F));
            RC_ASSERT((x > from - 1 || is[n] == was[n]));
        });
        pair.fine.swap(delta);
        RC_ASSERT(pair.all() == was);
    });
}

// As far as limits let it, which say nothing of most bricks, and the same whatever boxes they are asked for.
TEST(FineSculptureTest, RisesNoHigherThanLimitsLetIt) {
    test::checkProperty(20, [] {
        std::mt19937 random{std::mt19937::result_type(*test::below(100000))};
        const Pair pair = drawPair(random);
        Pair free = pair;
        Pair limited = pair;
        const int spared = int(random() % unsigned(pair.box.hi.y));
        const auto membershipAt = [&](glm::ivec3 v) { return v.y < spared ? 0 : (v.x * 7 + v.z * 13) % 256; };
        Limits limits;
        limits.takesOnly = *test::below(3) == 0;
        limits.finest = std::make_shared<const Limits::InBox>([&](const Box3& box) {
            std::vector<std::byte> bytes(box.hi.y <= spared ? 0 : 2 * box.volume());
            forEachVoxel(box, [&](glm::ivec3 v, std::size_t n) {
                if (!bytes.empty()) {
                    bytes[2 * n] = std::byte(membershipAt(v));
                }
            });
            return bytes;
        });
        const field::BrickGrid& grid = pair.fine.grid();
        const glm::ivec3 sceneDims(glm::round(glm::dvec3(grid.dims) / grid.perSceneVoxel));
        const Box3 scene{glm::ivec3(0), sceneDims};
        const std::vector<float> low(scene.volume(), 0.0F);
        const std::vector<float> high(scene.volume(), 1.0F);
        FineBricks originals;
        free.fine.raise(scene, low, high, originals);
        originals.clear();
        limited.fine.raise(scene, low, high, originals, limits);
        const auto unlimited = free.all();
        const auto is = limited.all();
        forEachVoxel(pair.box, [&](glm::ivec3 v, std::size_t n) {
            const float most = limits.takesOnly ? 0.0F : 1.0F - float(membershipAt(v)) / 255;
            RC_ASSERT(std::abs(is[n] - std::min(unlimited[n], most)) < 0.003F);
        });
    });
}

} // namespace
} // namespace vs::sculpt
