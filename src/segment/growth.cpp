// SPDX-License-Identifier: Apache-2.0
#include "segment/growth.h"

#include "base/timer.h"
#include "gl/pass.h"
#include "segment/growth_undo.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace vs::segment {

namespace {

constexpr int kGroupsPerBrick = 16;
constexpr std::size_t kMaxGroups = 65535;

} // namespace

Growth::Growth(const field::Field& field)
    : field_(&field), seedMap_(field.geometry.dims, gl::Format::R32UI, gl::Filter::Nearest, "seed map"),
      bricks_(field.geometry.dims), frontier_(field.geometry.dims), list_(4, "growth voxels"),
      answers_(4, "seed answers"), storeGeneration_("segment/shaders/store_generation.comp"),
      eraseGenerations_("segment/shaders/erase_generations.comp") {}

void Growth::setConstraints(const Constraints& constraints, GrowthUndo* undo) {
    if (undo != nullptr) {
        undo->begin(*this);
    }
    if (constraints != state_.constraints) {
        truncate(state_.playhead, undo);
        state_.constraints = constraints;
        state_.isFinished = false;
        frontier_.invalidate();
    }
    if (undo != nullptr) {
        undo->end(*this);
    }
}

SeedCounts Growth::addSeeds(std::span<const glm::ivec3> seeds, GrowthUndo* undo) {
    const gl::Pass pass("add seeds");
    if (undo != nullptr) {
        undo->begin(*this);
    }
    const glm::ivec3 dims = field_->geometry.dims;
    std::vector<std::uint32_t> voxels;
    SeedCounts counts;
    for (const glm::ivec3 seed : seeds) {
        if (glm::all(glm::greaterThanEqual(seed, glm::ivec3(0))) && glm::all(glm::lessThan(seed, dims))) {
            voxels.push_back((std::uint32_t(seed.z) * std::uint32_t(dims.y) + std::uint32_t(seed.y)) *
                                 std::uint32_t(dims.x) +
                             std::uint32_t(seed.x));
        } else {
            ++counts.refused;
        }
    }
    const std::size_t offered = voxels.size();
    std::sort(voxels.begin(), voxels.end());
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
    counts.present = int(offered - voxels.size());

    gl::Program& test = testSeeds_[state_.constraints.hasFence() ? 1 : 0];
    if (!test) {
        test = constrainedProgram("segment/shaders/test_seeds.comp", state_.constraints.hasFence());
    }
    list_.reserve(voxels.size() * sizeof(std::uint32_t));
    list_.write(std::span<const std::uint32_t>(voxels));
    answers_.reserve(voxels.size() * sizeof(std::uint32_t));
    list_.bindStorage(0);
    answers_.bindStorage(1);
    bindConstraints(test, *field_, state_.constraints);
    seedMap_.bindTexture(2);
    test.set(0, int(voxels.size())).set(1, state_.playhead);
    test.dispatchOverList(voxels.size(), gl::Barrier::Storage);
    const auto answers = answers_.read<std::uint32_t>(voxels.size());
    std::vector<std::uint32_t> added;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (answers[i] == 2) {
            added.push_back(voxels[i]);
        } else {
            ++(answers[i] == 1 ? counts.present : counts.refused);
        }
    }
    counts.added = int(added.size());
    if (!added.empty()) {
        truncate(state_.playhead, undo);
        enterSeeds(added);
    }
    if (undo != nullptr) {
        undo->addedSeeds_ = std::move(added);
        undo->end(*this);
    }
    return counts;
}

void Growth::enterSeeds(std::span<const std::uint32_t> voxels) {
    const int generation = std::max(1, state_.playhead);
    storeGeneration(voxels, generation);
    std::vector<std::uint32_t> touched;
    for (const std::uint32_t voxel : voxels) {
        bricks_.add(voxelAt(voxel), generation);
        touched.push_back(bricks_.brickOf(voxelAt(voxel)));
    }
    bricks_.upload();
    bricks_.markChanged(touched);
    frontier_.add(voxels);
    state_.voxels.resize(std::size_t(generation));
    state_.voxels.back() += voxels.size();
    state_.extent = generation;
    state_.playhead = generation;
    state_.isFinished = false;
}

glm::ivec3 Growth::voxelAt(std::uint32_t index) const {
    const glm::uvec3 dims(field_->geometry.dims);
    return {int(index % dims.x), int(index / dims.x % dims.y), int(index / (dims.x * dims.y))};
}

int Growth::advance(int generations, GrowthUndo* undo) {
    return advanceFor(std::numeric_limits<double>::infinity(), generations, undo);
}

int Growth::advanceFor(double budgetMs, int generations, GrowthUndo* undo) {
    if (undo != nullptr) {
        undo->begin(*this);
    }
    const Timer timer;
    int shown = reveal(generations);
    // Batches double while they fit into what is left of the time.
    int batch = budgetMs < std::numeric_limits<double>::infinity() ? 1 : Frontier::kMaxSteps;
    while (shown < generations && !isFinished() && (shown == 0 || timer.milliseconds() < budgetMs)) {
        const double start = timer.milliseconds();
        shown += compute(std::min(batch, generations - shown));
        const double end = timer.milliseconds();
        if (budgetMs - end > 2 * (end - start)) {
            batch = std::min(2 * batch, Frontier::kMaxSteps);
        } else {
            batch = std::max(batch / 2, 1);
        }
    }
    if (undo != nullptr) {
        undo->end(*this);
    }
    return shown;
}

int Growth::reveal(int generations) {
    const int kept = std::clamp(state_.extent - state_.playhead, 0, std::max(generations, 0));
    movePlayhead(state_.playhead + kept);
    return kept;
}

int Growth::compute(int generations) {
    const auto grown =
        frontier_.expand(seedMap_, bricks_, *field_, state_.constraints, state_.extent + 1, generations);
    int added = 0;
    while (added < generations && grown[std::size_t(added)] > 0) {
        ++added;
    }
    state_.voxels.insert(state_.voxels.end(), grown.begin(), grown.begin() + added);
    state_.extent += added;
    state_.isFinished = added < generations;
    if (added > 0) {
        bricks_.download();
    }
    movePlayhead(state_.extent);
    return added;
}

int Growth::stepBack(int generations, GrowthUndo* undo) {
    const int before = state_.playhead;
    setPlayhead(before - std::clamp(generations, 0, before), undo);
    return before - state_.playhead;
}

void Growth::setPlayhead(int generation, GrowthUndo* undo) {
    if (undo != nullptr) {
        undo->begin(*this);
    }
    movePlayhead(std::clamp(generation, 0, state_.extent));
    if (undo != nullptr) {
        undo->end(*this);
    }
}

void Growth::movePlayhead(int generation) {
    bricks_.markChanged(
        bricks_.holding(std::min(generation, state_.playhead), std::max(generation, state_.playhead)));
    state_.playhead = generation;
}

void Growth::reset(GrowthUndo* undo) {
    if (undo != nullptr) {
        undo->begin(*this);
    }
    movePlayhead(0);
    truncate(0, undo);
    if (undo != nullptr) {
        undo->end(*this);
    }
}

void Growth::truncate(int last, GrowthUndo* undo) {
    if (last >= state_.extent) {
        return;
    }
    if (undo != nullptr) {
        undo->save(*this, last);
    }
    eraseAfter(last);
    state_.extent = last;
    state_.voxels.resize(std::size_t(last));
    state_.isFinished = false;
}

void Growth::eraseAfter(int last) {
    const gl::Pass pass("erase generations");
    const auto bricks = bricks_.holding(last, std::numeric_limits<int>::max());
    list_.reserve(bricks.size() * sizeof(std::uint32_t));
    list_.write(std::span<const std::uint32_t>(bricks));
    list_.bindStorage(0);
    seedMap_.bindImage(0, gl::Access::ReadWrite);
    eraseGenerations_.set(0, bricks_.brickDims()).set(1, last);
    for (std::size_t first = 0; first < bricks.size(); first += kMaxGroups) {
        eraseGenerations_.set(2, int(first));
        const int rows = int(std::min(kMaxGroups, bricks.size() - first));
        // Read next by whatever comes: downloads, scans, the smoothing.
        eraseGenerations_.dispatch({kGroupsPerBrick, rows, 1}, gl::Barrier::All);
    }
    bricks_.truncate(last);
    bricks_.upload();
    frontier_.invalidate();
}

void Growth::storeGeneration(std::span<const std::uint32_t> voxels, int generation) {
    list_.reserve(voxels.size() * sizeof(std::uint32_t));
    list_.write(voxels);
    list_.bindStorage(0);
    seedMap_.bindImage(0, gl::Access::Write);
    storeGeneration_.set(0, int(voxels.size())).set(1, generation);
    storeGeneration_.dispatchOverList(voxels.size(), gl::Barrier::All);
}

std::uint64_t Growth::voxelCount() const {
    return std::accumulate(state_.voxels.begin(), state_.voxels.begin() + state_.playhead, std::uint64_t(0));
}

Box3 Growth::touchedBox() const {
    Box3 box;
    for (const std::uint32_t brick : bricks_.holding(0, std::numeric_limits<int>::max())) {
        box = unite(box, bricks_.box(brick));
    }
    return box;
}

std::vector<std::uint32_t> Growth::generations(bool upToPlayhead) const {
    auto values = seedMap_.downloadAll<std::uint32_t>();
    if (upToPlayhead) {
        std::replace_if(
            values.begin(), values.end(), [&](std::uint32_t g) { return g > std::uint32_t(state_.playhead); },
            0U);
    }
    return values;
}

std::vector<std::uint8_t> Growth::labels() const {
    const glm::ivec3 dims = field_->geometry.dims;
    const std::size_t slice = std::size_t(dims.x) * std::size_t(dims.y);
    std::vector<std::uint8_t> labels(slice * std::size_t(dims.z), 0);
    // Slice by slice over what was touched, so that no second copy of the whole seed map is made.
    const Box3 box = touchedBox();
    for (int z = box.lo.z; z < box.hi.z; ++z) {
        const auto bytes = seedMap_.download({{0, 0, z}, {dims.x, dims.y, z + 1}});
        const auto* values = reinterpret_cast<const std::uint32_t*>(bytes.data());
        std::transform(
            values, values + slice, labels.begin() + std::ptrdiff_t(slice * std::size_t(z)),
            [&](std::uint32_t g) { return g != 0 && g <= std::uint32_t(state_.playhead) ? 1 : 0; });
    }
    return labels;
}

} // namespace vs::segment
