// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/scene_view.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vs::segment {

namespace {

std::size_t indexIn(const Box3& box, glm::ivec3 voxel) {
    const glm::ivec3 size = box.size();
    const glm::ivec3 at = voxel - box.lo;
    return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
           std::size_t(at.x);
}

// The finest voxels that one segment has in each voxel of a box of the scene: their generations.
class Shares {
public:
    explicit Shares(const Box3& box) : box_(box), counts_(box.volume()), firsts_(box.volume() + 1) {}

    // Once for each finest voxel; then again, after share(), with its generation.
    void count(std::size_t voxel) { ++counts_[voxel]; }
    void share() {
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            firsts_[i + 1] = firsts_[i] + counts_[i];
            counts_[i] = 0;
        }
        generations_.resize(firsts_.back());
    }
    void add(std::size_t voxel, std::uint32_t generation) {
        generations_[firsts_[voxel] + counts_[voxel]++] = generation;
    }

    [[nodiscard]] std::uint32_t of(std::size_t voxel) const { return counts_[voxel]; }
    // The generation in which there were so many.
    [[nodiscard]] std::uint32_t generationOf(std::size_t voxel, std::uint32_t many) {
        const auto first = generations_.begin() + std::ptrdiff_t(firsts_[voxel]);
        std::nth_element(first, first + std::ptrdiff_t(many) - 1, first + std::ptrdiff_t(counts_[voxel]));
        return first[std::ptrdiff_t(many) - 1];
    }
    [[nodiscard]] const Box3& box() const { return box_; }

private:
    Box3 box_;
    std::vector<std::uint32_t> counts_;
    std::vector<std::size_t> firsts_;
    std::vector<std::uint32_t> generations_;
};

} // namespace

SceneView::SceneView(const field::BrickGrid& grid, glm::ivec3 sceneDims)
    : grid_(grid), sceneDims_(sceneDims) {}

Box3 SceneView::finestIn(const Box3& sceneBox) const {
    const auto edge = [&](glm::ivec3 voxel) {
        return glm::ivec3(glm::ceil((glm::dvec3(voxel) - 0.5) * grid_.perSceneVoxel + grid_.origin - 1e-9));
    };
    return intersect({edge(sceneBox.lo), edge(sceneBox.hi)}, {glm::ivec3(0), grid_.dims});
}

glm::ivec3 SceneView::sceneVoxelOf(glm::ivec3 finest) const {
    const glm::dvec3 place = (glm::dvec3(finest) - grid_.origin) / grid_.perSceneVoxel;
    return glm::clamp(glm::ivec3(glm::floor(place + 0.5 + 1e-9)), glm::ivec3(0), sceneDims_ - 1);
}

void SceneView::seeSlab(const FineGrowth& finest, const Box3& slab, const Box3& sceneBrick,
                        MirroredBrick& brick) const {
    const Box3 around = intersect(grow(slab, 1), {glm::ivec3(0), sceneDims_});
    const Box3 voxels = finestIn(around);
    std::vector<std::pair<const FineCells*, glm::ivec3>> bricks;
    std::set<std::uint8_t> labels;
    forEachVoxel(Box3{voxels.lo / field::kBrick, divideUp(voxels.hi, field::kBrick)},
                 [&](glm::ivec3 place, std::size_t) {
                     const auto known = finest.map().find(finest.brickOf(place * field::kBrick));
                     if (known != finest.map().end()) {
                         bricks.emplace_back(known->second.get(), place * field::kBrick);
                         for (const auto& [label, span] : known->second->spans()) {
                             labels.insert(label);
                         }
                     }
                 });
    const auto halfOf = [&](glm::ivec3 voxel) { return (finestIn(voxel).volume() + 1) / 2; };
    std::vector<std::uint32_t> most(slab.volume());
    for (const std::uint8_t label : labels) {
        Shares shares(around);
        const auto forEach = [&](const auto& tell) {
            for (const auto& [cells, lo] : bricks) {
                cells->forEachGrown([&, cells = cells, lo = lo](std::size_t cell, std::uint32_t generation) {
                    if (cells->label(cell) == label) {
                        const glm::ivec3 voxel = sceneVoxelOf(lo + voxelOfCell(cell));
                        if (glm::all(glm::greaterThanEqual(voxel, around.lo)) &&
                            glm::all(glm::lessThan(voxel, around.hi))) {
                            tell(indexIn(around, voxel), generation);
                        }
                    }
                });
            }
        };
        forEach([&](std::size_t voxel, std::uint32_t) { shares.count(voxel); });
        shares.share();
        forEach([&](std::size_t voxel, std::uint32_t generation) { shares.add(voxel, generation); });
        forEachVoxel(slab, [&](glm::ivec3 voxel, std::size_t i) {
            const std::size_t at = indexIn(around, voxel);
            const std::uint32_t share = shares.of(at);
            if (share <= most[i]) {
                return;
            }
            const auto half = std::uint32_t(halfOf(voxel));
            bool isThin = true; // so far
            if (share < half) {
                forEachVoxel(intersect(grow(Box3{voxel, voxel + 1}, 1), around),
                             [&](glm::ivec3 near, std::size_t) {
                                 isThin = isThin && shares.of(indexIn(around, near)) < halfOf(near);
                             });
            }
            if (share >= half || isThin) {
                most[i] = share;
                const std::size_t to = indexIn(sceneBrick, voxel);
                brick.generations[to] = shares.generationOf(at, std::min(half, share));
                brick.labels[to] = label;
            }
        });
    }
}

MirroredBrick SceneView::seen(const FineGrowth& finest, const Box3& sceneBrick) const {
    MirroredBrick brick;
    brick.generations.resize(sceneBrick.volume());
    brick.labels.resize(sceneBrick.volume());
    // Slab by slab, each about as thick as a brick of the finest level.
    const int thick = std::max(1, int(std::ceil(field::kBrick / grid_.perSceneVoxel.z)));
    for (int z = sceneBrick.lo.z; z < sceneBrick.hi.z; z += thick) {
        Box3 slab = sceneBrick;
        slab.lo.z = z;
        slab.hi.z = std::min(z + thick, sceneBrick.hi.z);
        seeSlab(finest, slab, sceneBrick, brick);
    }
    return brick;
}

void SceneView::update(FineGrowth& finest, Growth& scene) const {
    const BrickTable& table = scene.seedMap().bricks();
    std::set<std::uint32_t> stale;
    const auto add = [&](std::uint32_t brick) {
        const glm::ivec3 lo = finest.placeOfBrick(brick) * field::kBrick;
        const glm::ivec3 hi = glm::min(lo + field::kBrick, grid_.dims);
        // A voxel depends on those around it.
        const Box3 reached =
            intersect({sceneVoxelOf(lo) - 1, sceneVoxelOf(hi - 1) + 2}, {glm::ivec3(0), sceneDims_});
        forEachVoxel(
            Box3{reached.lo / field::kBrick, divideUp(reached.hi, field::kBrick)},
            [&](glm::ivec3 place, std::size_t) { stale.insert(table.brickOf(place * field::kBrick)); });
    };
    for (const std::uint32_t brick : finest.changed()) {
        add(brick);
    }
    if (finest.label() != scene.activeLabel()) {
        for (const std::uint32_t brick : table.occupied()) { // whose spans are another segment's
            stale.insert(brick);
        }
    }
    const std::vector<std::uint32_t> numbers(stale.begin(), stale.end());
    std::vector<MirroredBrick> bricks(numbers.size());
    inParallel(int(numbers.size()), [&](int n) {
        bricks[std::size_t(n)] = seen(finest, table.box(numbers[std::size_t(n)]));
        bricks[std::size_t(n)].brick = numbers[std::size_t(n)];
    });
    std::map<std::uint8_t, GrowthState> others;
    for (const auto& [label, run] : finest.others()) {
        others.emplace(label, run.state);
    }
    GrowthState atWork = finest.state();
    std::vector<segment::Seed> seeds; // when, not where: they are of another grid
    for (const FineGrowth::Seed& seed : finest.seeds()) {
        seeds.push_back({0, seed.generation});
    }
    atWork.seeds = std::make_shared<const std::vector<segment::Seed>>(std::move(seeds));
    scene.mirror(finest.label(), atWork, others, bricks);
    finest.noteShown();
}

} // namespace vs::segment
