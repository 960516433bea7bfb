// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/scene_view.h"

#include "base/parallel.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace vs::segment {

namespace {

field::BrickGrid gridOfScene(glm::ivec3 dims) {
    field::BrickGrid grid;
    grid.dims = dims;
    return grid;
}

} // namespace

SceneView::SceneView(const field::BrickGrid& grid, glm::ivec3 sceneDims)
    : grid_(grid), sceneDims_(sceneDims),
      edges_(grid, gridOfScene(sceneDims), Box3{glm::ivec3(0), sceneDims}) {}

Box3 SceneView::finestIn(glm::ivec3 v) const { return edges_.finestIn({v, v + 1}); }

glm::ivec3 SceneView::sceneVoxelOf(glm::ivec3 finest) const {
    glm::ivec3 voxel;
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<int>& edges = edges_.along[std::size_t(axis)];
        voxel[axis] = int(std::upper_bound(edges.begin(), edges.end(), finest[axis]) - edges.begin()) - 1;
    }
    return glm::clamp(voxel, glm::ivec3(0), sceneDims_ - 1);
}

// The segments that have at least half of each voxel of a box; 0: none does.
std::vector<std::uint8_t> SceneView::halvesIn(const Box3& box, const BrickTable& table) const {
    std::vector<std::uint8_t> halves(box.volume());
    forEachVoxel(bricksAround(box), [&](glm::ivec3 place, std::size_t) {
        const std::uint32_t number = table.brickOf(place * field::kBrick);
        const auto known = shares_.find(number);
        if (known == shares_.end()) {
            return;
        }
        const Box3 brick = table.box(number);
        const Box3 part = intersect(box, brick);
        for (int z = part.lo.z; z < part.hi.z; ++z) {
            for (int y = part.lo.y; y < part.hi.y; ++y) {
                const glm::ivec3 row(part.lo.x, y, z);
                std::copy_n(known->second.halves.begin() + std::ptrdiff_t(indexIn(brick, row)), part.size().x,
                            halves.begin() + std::ptrdiff_t(indexIn(box, row)));
            }
        }
    });
    return halves;
}

void SceneView::tell(std::uint32_t number, const BrickTable& table, MirroredBrick& brick) const {
    const Box3 box = table.box(number);
    brick.labels.assign(box.volume(), 0);
    brick.generations.resize(box.volume());
    const auto known = shares_.find(number);
    if (known == shares_.end()) {
        return;
    }
    const SceneShares& shares = known->second;
    const Box3 all{glm::ivec3(0), sceneDims_};
    const Box3 wider = intersect(grow(box, 1), all);
    const auto halves = halvesIn(wider, table);
    const glm::ivec3 size = box.size();
    forEachLabelled(shares.labels, [&](std::size_t i) {
        const auto n = int(i);
        const glm::ivec3 voxel = box.lo + glm::ivec3(n % size.x, n / size.x % size.y, n / (size.x * size.y));
        const std::uint8_t label = shares.labels[i];
        bool isShown = shares.halves[i] != 0;
        if (!isShown) { // unless it is thin here, what has half of it nowhere around has no voxel
            isShown = true;
            forEachVoxel(intersect(grow(Box3{voxel, voxel + 1}, 1), all), [&](glm::ivec3 near, std::size_t) {
                isShown = isShown && halves[indexIn(wider, near)] != label;
            });
        }
        if (isShown) {
            brick.labels[i] = label;
            brick.generations[i] = shares.generations[i];
        }
    });
}

// Which generations of the segment at work count now; bricks that hold some that do no more, or do again,
// have changed.
void SceneView::countUpTo(const FineGrowth& finest, Going going, std::set<std::uint32_t>& changed) {
    const GrowthState& state = finest.state();
    if (finest.label() != label_) { // going to another segment forgets what the former one hid
        label_ = finest.label();
        upTo_ = state.playhead;
        return;
    }
    const bool isMoved = state.playhead > upTo_ || (going == Going::Nowhere && state.playhead < upTo_);
    if (isMoved) {
        const int from = std::exchange(upTo_, going == Going::Nowhere ? state.playhead : state.extent);
        for (const std::uint32_t brick : finest.holding(std::min(from, upTo_))) {
            changed.insert(brick);
        }
    }
}

void SceneView::update(FineGrowth& finest, Growth& scene, Going going) {
    const BrickTable& table = scene.seedMap().bricks();
    const Box3 all{glm::ivec3(0), sceneDims_};
    std::map<std::uint32_t, std::vector<Box3>> changed; // in each brick of the scene
    std::set<std::uint32_t> stale;
    const auto forEachBrick = [&](const Box3& voxels, const auto& visit) {
        forEachVoxel(bricksAround(voxels),
                     [&](glm::ivec3 place, std::size_t) { visit(table.brickOf(place * field::kBrick)); });
    };
    const auto since = finest.changed();
    std::set<std::uint32_t> bricksChanged(since.begin(), since.end());
    countUpTo(finest, going, bricksChanged);
    for (const std::uint32_t brick : bricksChanged) {
        const glm::ivec3 lo = finest.placeOfBrick(brick) * field::kBrick;
        const glm::ivec3 hi = glm::min(lo + field::kBrick, grid_.dims);
        const Box3 voxels{sceneVoxelOf(lo), sceneVoxelOf(hi - 1) + 1};
        forEachBrick(voxels, [&](std::uint32_t number) {
            changed[number].push_back(intersect(voxels, table.box(number)));
            shares_[number];
        });
        // Whether voxels beside those are thin may have changed too.
        forEachBrick(intersect(grow(voxels, 1), all), [&](std::uint32_t number) { stale.insert(number); });
    }
    const std::vector<std::pair<std::uint32_t, std::vector<Box3>>> work(changed.begin(), changed.end());
    inParallel(int(work.size()), [&](int n) {
        const auto& [number, boxes] = work[std::size_t(n)];
        ShareCounter counter(finest, edges_, upTo_);
        for (const Box3& box : boxes) {
            counter.count(box, table.box(number), shares_.at(number));
        }
    });
    for (const auto& [number, boxes] : work) {
        const auto& labels = shares_.at(number).labels;
        if (std::all_of(labels.begin(), labels.end(), [](std::uint8_t label) { return label == 0; })) {
            shares_.erase(number);
        }
    }
    std::vector<std::uint32_t> numbers; // of bricks that show something, or did
    std::copy_if(stale.begin(), stale.end(), std::back_inserter(numbers),
                 [&](std::uint32_t brick) { return shares_.contains(brick) || table.isOccupied(brick); });
    std::map<std::uint8_t, GrowthState> others;
    for (const auto& [label, run] : finest.others()) {
        others.emplace(label, run.state);
    }
    GrowthState atWork = finest.state();
    if (const int seeded = finest.lastSeeded(); seeded > 0) { // when, not where: they are of another grid
        atWork.seeds = std::make_shared<const std::vector<segment::Seed>>(1, segment::Seed{0, seeded});
    }
    scene.mirror(finest.label(), atWork, others, numbers,
                 [&](std::uint32_t number, MirroredBrick& brick) { tell(number, table, brick); });
    finest.noteShown();
}

} // namespace vs::segment
