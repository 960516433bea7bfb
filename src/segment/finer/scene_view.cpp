// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/scene_view.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::segment {

// The generations of one voxel of the scene's finest voxels, by segment.
class SceneView::Gathered {
public:
    using List = std::pair<std::uint8_t, std::vector<std::uint32_t>>;

    void clear() { used_ = 0; }
    // The list of a segment; it stays where it is until the next is asked for.
    List& of(std::uint8_t label) {
        const auto end = lists_.begin() + std::ptrdiff_t(used_);
        auto list =
            std::find_if(lists_.begin(), end, [&](const List& known) { return known.first == label; });
        if (list == end) {
            if (used_ == lists_.size()) {
                lists_.emplace_back();
            }
            list = lists_.begin() + std::ptrdiff_t(used_++);
            list->first = label;
            list->second.clear();
        }
        return *list;
    }
    // The one with the most, of equal ones that with the smallest label; null: none.
    List* most() {
        const auto end = lists_.begin() + std::ptrdiff_t(used_);
        const auto found = std::max_element(lists_.begin(), end, [](const List& a, const List& b) {
            return a.second.size() != b.second.size() ? a.second.size() < b.second.size() : a.first > b.first;
        });
        return found == end || found->second.empty() ? nullptr : &*found;
    }

private:
    std::vector<List> lists_; // kept from voxel to voxel for their memory
    std::size_t used_ = 0;    // so many of them are this voxel's
};

namespace {

std::size_t indexIn(const Box3& box, glm::ivec3 voxel) {
    const glm::ivec3 size = box.size();
    const glm::ivec3 at = voxel - box.lo;
    return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
           std::size_t(at.x);
}

// The cells of finest bricks, of which neighbouring voxels mostly ask for the same one.
class CellReader {
public:
    explicit CellReader(const FineGrowth& growth) : growth_(growth) {}

    // The brick of a voxel; null: nothing has grown in it.
    const FineCells* brickOf(glm::ivec3 voxel) {
        const std::uint32_t number = growth_.brickOf(voxel);
        if (number != number_) {
            number_ = number;
            const auto found = growth_.map().find(number);
            cells_ = found == growth_.map().end() ? nullptr : found->second.get();
        }
        return cells_;
    }

private:
    const FineGrowth& growth_;
    std::uint32_t number_ = ~0U;
    const FineCells* cells_ = nullptr;
};

} // namespace

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

// What some voxels of a brick of the scene have.
void SceneView::share(const FineGrowth& finest, const Box3& sceneVoxels, const Box3& brick,
                      Shares& shares) const {
    shares.labels.resize(brick.volume());
    shares.hasHalf.resize(brick.volume());
    shares.generations.resize(brick.volume());
    CellReader reader(finest);
    Gathered gathered;
    forEachVoxel(sceneVoxels, [&](glm::ivec3 voxel, std::size_t) {
        const Box3 inside = finestIn(voxel);
        gathered.clear();
        // Mostly one brick, seldom as many as eight.
        forEachVoxel(Box3{inside.lo / field::kBrick, (inside.hi - 1) / field::kBrick + 1},
                     [&](glm::ivec3 place, std::size_t) {
                         const glm::ivec3 lo = place * field::kBrick;
                         if (const FineCells* cells = reader.brickOf(lo)) {
                             gather(*cells,
                                    {glm::max(inside.lo - lo, glm::ivec3(0)),
                                     glm::min(inside.hi - lo, glm::ivec3(field::kBrick))},
                                    gathered);
                         }
                     });
        const std::size_t at = indexIn(brick, voxel);
        Gathered::List* const most = gathered.most();
        shares.labels[at] = most == nullptr ? 0 : most->first;
        if (most == nullptr) {
            shares.hasHalf[at] = 0;
            return;
        }
        std::vector<std::uint32_t>& generations = most->second;
        const std::size_t half = (inside.volume() + 1) / 2;
        const std::size_t many = std::min(half, generations.size());
        const auto last = generations.begin() + std::ptrdiff_t(many) - 1;
        std::nth_element(generations.begin(), last, generations.end());
        shares.generations[at] = *last;
        shares.hasHalf[at] = many == half ? 1 : 0;
    });
}

// What counts of some voxels of a brick.
void SceneView::gather(const FineCells& cells, const Box3& inBrick, Gathered& gathered) const {
    const std::size_t tile = cellOf(inBrick.lo) / kTileVoxels;
    if (tile == cellOf(inBrick.hi - 1) / kTileVoxels && cells.isTileEmpty(tile)) {
        return;
    }
    const auto& spans = cells.spans();
    const auto own = spans.find(label_);
    const bool countsAll = own == spans.end() || int(own->second.last) <= upTo_;
    Gathered::List* const only = spans.size() == 1 ? &gathered.of(spans.begin()->first) : nullptr;
    cells.visitGenerations([&](const auto& generationOf) {
        forEachVoxel(inBrick, [&](glm::ivec3 v, std::size_t) {
            const std::size_t cell = cellOf(v);
            const std::uint32_t generation = generationOf(cell);
            if (generation == 0) {
                return;
            }
            const std::uint8_t label = only != nullptr ? only->first : cells.label(cell);
            if (countsAll || label != label_ || int(generation) <= upTo_) {
                (only != nullptr ? *only : gathered.of(label)).second.push_back(generation);
            }
        });
    });
}

bool SceneView::isThinAt(glm::ivec3 sceneVoxel, std::uint8_t label, const BrickTable& table) const {
    bool isThin = true;
    const Box3 around = intersect(grow(Box3{sceneVoxel, sceneVoxel + 1}, 1), {glm::ivec3(0), sceneDims_});
    forEachVoxel(around, [&](glm::ivec3 near, std::size_t) {
        const std::uint32_t number = table.brickOf(near);
        const auto shares = shares_.find(number);
        if (shares != shares_.end()) {
            const std::size_t at = indexIn(table.box(number), near);
            isThin = isThin && !(shares->second.labels[at] == label && shares->second.hasHalf[at] != 0);
        }
    });
    return isThin;
}

void SceneView::tell(std::uint32_t number, const BrickTable& table, MirroredBrick& brick) const {
    const Box3 box = table.box(number);
    brick.generations.assign(box.volume(), 0);
    brick.labels.assign(box.volume(), 0);
    const auto known = shares_.find(number);
    if (known == shares_.end()) {
        return;
    }
    const Shares& shares = known->second;
    forEachVoxel(box, [&](glm::ivec3 voxel, std::size_t i) {
        const std::uint8_t label = shares.labels[i];
        if (label != 0 && (shares.hasHalf[i] != 0 || isThinAt(voxel, label, table))) {
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
        forEachVoxel(Box3{voxels.lo / field::kBrick, divideUp(voxels.hi, field::kBrick)},
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
        for (const Box3& box : boxes) {
            share(finest, box, table.box(number), shares_.at(number));
        }
    });
    for (const auto& [number, boxes] : work) {
        const auto& labels = shares_.at(number).labels;
        if (std::all_of(labels.begin(), labels.end(), [](std::uint8_t label) { return label == 0; })) {
            shares_.erase(number);
        }
    }
    const std::vector<std::uint32_t> numbers(stale.begin(), stale.end());
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
