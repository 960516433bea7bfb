// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/growth.h"

#include "base/progress.h"
#include "base/timer.h"
#include "gl/pass.h"
#include "segment/growth/growth_undo.h"
#include "segment/growth/playback.h"
#include "segment/shaders/bindings.h"

#include <algorithm>
#include <limits>

namespace vs::segment {

namespace {

constexpr int kNever = GrowthState::kNever;

using SeedAnswer = Frontier::SeedAnswer;

} // namespace

Growth::Growth(const field::Field& field, GrowthEngine engine)
    : field_(&field),
      seedMap_(field.geometry.dims, engine == GrowthEngine::Host ? gl::Reach::Shared : gl::Reach::Device),
      frontier_(makeFrontier(engine, seedMap_, field)), kinds_(4, "kinds of segments") {}

Frontier::Rules Growth::rules() const {
    return {field_, &state_.constraints, forbidden_ ? &forbidden_ : nullptr, owner_, state_.frozen};
}

// --- rules

void Growth::setConstraints(const Constraints& constraints, GrowthUndo* undo) {
    const GrowthUndo::Recording recording(undo, *this);
    if (constraints != state_.constraints) {
        truncate(state_.playhead, undo);
        const bool isWider = includes(constraints, state_.constraints);
        state_.constraints = constraints;
        frontier_->invalidate();
        const bool staysConsistent = isWider && state_.consistentFrom <= state_.extent;
        if (!staysConsistent) {
            if (state_.isLive) {
                retract(undo);
            }
            state_.consistentFrom = state_.extent == 0 ? 0 : state_.isLive ? state_.extent : kNever;
        }
        state_.isFinished = false;
        reinstateSeeds(undo);
    }
}

void Growth::setLive(bool isLive, GrowthUndo* undo) {
    const GrowthUndo::Recording recording(undo, *this);
    state_.isLive = isLive;
}

// --- seeds

std::vector<std::uint32_t> Growth::voxelsInGrid(std::span<const glm::ivec3> voxels) const {
    std::vector<std::uint32_t> indices;
    for (const glm::ivec3 v : voxels) {
        if (glm::all(glm::greaterThanEqual(v, glm::ivec3(0))) &&
            glm::all(glm::lessThan(v, field_->geometry.dims))) {
            indices.push_back(seedMap_.indexOf(v));
        }
    }
    return indices;
}

std::vector<SeedAnswer> Growth::testSeeds(const std::vector<std::uint32_t>& voxels) {
    return frontier_->testSeeds(seedMap_, rules(), state_.playhead, voxels);
}

int Growth::enteringGeneration() const { return playback::enteringGeneration(state_); }

SeedCounts Growth::addSeeds(std::span<const glm::ivec3> seeds, GrowthUndo* undo) {
    const gl::Pass pass("add seeds");
    const GrowthUndo::Recording recording(undo, *this);
    std::vector<std::uint32_t> voxels = voxelsInGrid(seeds);
    SeedCounts counts;
    counts.refused = int(seeds.size() - voxels.size());
    const std::size_t offered = voxels.size();
    std::sort(voxels.begin(), voxels.end());
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
    counts.present = int(offered - voxels.size());

    const auto answers = testSeeds(voxels);
    std::vector<std::uint32_t> added;
    std::vector<std::uint32_t> allowedAgain;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (answers[i] == SeedAnswer::Admitted || answers[i] == SeedAnswer::AdmittedAgain) {
            added.push_back(voxels[i]);
            if (answers[i] == SeedAnswer::AdmittedAgain) {
                allowedAgain.push_back(voxels[i]);
            }
        } else {
            ++(answers[i] == SeedAnswer::Present ? counts.present : counts.refused);
        }
    }
    counts.added = int(added.size());
    if (!added.empty()) {
        truncate(state_.playhead, undo);
        if (!allowedAgain.empty()) {
            if (undo != nullptr) {
                undo->held_.allowedAgain = allowedAgain;
            }
            passes_.setBits(seedMap_, forbidden_, allowedAgain, false);
        }
        enterSeeds(added, undo);
        auto remembered = *state_.seeds;
        for (const std::uint32_t voxel : voxels) {
            remembered.push_back({voxel, state_.extent});
        }
        state_.seeds = std::make_shared<const std::vector<Seed>>(std::move(remembered));
    }
    return counts;
}

void Growth::enterSeeds(std::span<const std::uint32_t> voxels, GrowthUndo* undo) {
    const int generation = enteringGeneration();
    if (undo != nullptr) {
        undo->held_.addedSeeds.assign(voxels.begin(), voxels.end());
    }
    seedMap_.store(voxels, generation);
    std::vector<std::uint32_t> touched;
    for (const std::uint32_t voxel : voxels) {
        seedMap_.bricks().add(seedMap_.voxelAt(voxel), generation);
        touched.push_back(seedMap_.bricks().brickOf(seedMap_.voxelAt(voxel)));
    }
    seedMap_.bricks().upload();
    seedMap_.bricks().markChanged(touched);
    frontier_->add(voxels);
    state_.voxels.resize(std::size_t(generation));
    state_.voxels.back() += voxels.size();
    state_.extent = generation;
    state_.playhead = generation;
    state_.isFinished = false;
}

// Seeds that the rules refused, or that were retracted, enter at the playhead where the present ones let them
// in.
void Growth::reinstateSeeds(GrowthUndo* undo) {
    std::vector<std::uint32_t> voxels;
    for (const Seed& seed : *state_.seeds) {
        voxels.push_back(seed.voxel);
    }
    std::sort(voxels.begin(), voxels.end());
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
    const auto answers = testSeeds(voxels);
    std::vector<std::uint32_t> entering;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (answers[i] == SeedAnswer::Admitted) { // what was absorbed must be seeded anew
            entering.push_back(voxels[i]);
        }
    }
    if (!entering.empty()) {
        enterSeeds(entering, undo);
    }
}

// --- playback

int Growth::advance(int generations, GrowthUndo* undo) {
    return advanceFor(std::numeric_limits<double>::infinity(), generations, undo);
}

int Growth::advanceFor(double budgetMs, int generations, GrowthUndo* undo, std::uint64_t mostVoxels) {
    const GrowthUndo::Recording recording(undo, *this);
    const Timer timer;
    int shown = reveal(generations, mostVoxels);
    // Batches double while they fit into what is left of the time.
    int batch = budgetMs < std::numeric_limits<double>::infinity() ? 1 : frontier_->mostExpansions();
    while (shown < generations && !isFinished() && (shown == 0 || timer.milliseconds() < budgetMs) &&
           (mostVoxels == kAnyNumber || voxelCount() < mostVoxels)) {
        reportProgress();
        const double began = timer.milliseconds();
        shown += compute(std::min(batch, generations - shown));
        shown -= mostVoxels == kAnyNumber ? 0 : cutBack(mostVoxels);
        const double ended = timer.milliseconds();
        if (budgetMs - ended > 2 * (ended - began)) {
            batch = std::min(2 * batch, frontier_->mostExpansions());
        } else {
            batch = std::max(batch / 2, 1);
        }
    }
    return shown;
}

int Growth::reveal(int generations, std::uint64_t mostVoxels) {
    const int before = state_.playhead;
    movePlayhead(playback::revealed(state_, generations, mostVoxels));
    return state_.playhead - before;
}

// Takes back what has just been computed after the first generation by which there are so many voxels, as if
// that had been the last one. Returns how many generations that were.
int Growth::cutBack(std::uint64_t mostVoxels) {
    const int last = playback::firstWith(state_, mostVoxels);
    const int surplus = state_.playhead - last;
    if (surplus > 0) {
        movePlayhead(last);
        truncate(last, nullptr);
    }
    return surplus;
}

int Growth::compute(int generations) {
    const int expansions = std::min(generations, SeedMap::kLongest - state_.extent);
    if (expansions <= 0) {
        state_.isFinished = true;
        return 0;
    }
    const auto grown = expand(expansions);
    const auto tried = int(grown.size());
    const auto added = int(std::find(grown.begin(), grown.end(), 0U) - grown.begin());
    state_.voxels.insert(state_.voxels.end(), grown.begin(), grown.begin() + added);
    state_.extent += added;
    state_.isFinished = added < tried;
    movePlayhead(state_.extent);
    return added;
}

// Voxels grown by each expansion tried. When it throws, nothing has grown.
std::vector<std::uint64_t> Growth::expand(int expansions) {
    BrickTable& bricks = seedMap_.bricks();
    try {
        const std::size_t most = state_.voxels.size() + std::size_t(expansions);
        if (state_.voxels.capacity() < most) {
            state_.voxels.reserve(2 * most);
        }
        auto grown = frontier_->expand(seedMap_, rules(), state_.extent + 1, expansions);
        if (grown.front() > 0) {
            bricks.download();
        }
        return grown;
    } catch (...) {
        bricks.download(); // what the device has written already
        eraseAfter(state_.extent);
        throw;
    }
}

int Growth::takeBack(int generations, GrowthUndo* undo) {
    const int before = state_.playhead;
    setPlayhead(before - std::clamp(generations, 0, before), undo);
    return before - state_.playhead;
}

void Growth::setPlayhead(int generation, GrowthUndo* undo) {
    const GrowthUndo::Recording recording(undo, *this);
    movePlayhead(std::clamp(generation, 0, state_.extent));
}

void Growth::movePlayhead(int generation) {
    BrickTable& bricks = seedMap_.bricks();
    bricks.markChanged(
        bricks.holding(std::min(generation, state_.playhead), std::max(generation, state_.playhead)));
    state_.playhead = generation;
}

// --- erasing

void Growth::truncate(int last, GrowthUndo* undo) {
    if (last >= state_.extent) {
        return;
    }
    auto seeds = *state_.seeds;
    std::erase_if(seeds, [&](const Seed& seed) { return seed.generation > last; });
    auto stay = std::make_shared<const std::vector<Seed>>(std::move(seeds));
    if (undo != nullptr) {
        undo->save(*this, passes_.holding(seedMap_, owner_, {last, nullptr, true},
                                          seedMap_.bricks().holding(last, kNever)));
    }
    eraseAfter(last);
    state_.extent = last;
    state_.frozen = std::min(state_.frozen, last);
    state_.voxels.resize(std::size_t(last));
    state_.isFinished = false;
    if (last == 0) {
        state_.consistentFrom = 0;
    } else if (last < state_.consistentFrom) {
        state_.consistentFrom = kNever; // what stays may have been reached by what went
    }
    state_.seeds = std::move(stay);
}

void Growth::eraseAfter(int last) {
    const gl::Pass pass("erase generations");
    BrickTable& bricks = seedMap_.bricks();
    passes_.erase(seedMap_, owner_, {last, nullptr, true}, bricks.holding(last, kNever), 0);
    bricks.truncate(last);
    bricks.upload();
    frontier_->invalidate();
}

void Growth::reset(GrowthUndo* undo) {
    const GrowthUndo::Recording recording(undo, *this);
    if (undo != nullptr) {
        undo->keepForbidden(*this);
    }
    movePlayhead(0);
    truncate(0, undo);
    state_.seeds = std::make_shared<const std::vector<Seed>>();
    state_.consistentFrom = 0;
    forbidden_ = {};
    frontier_->invalidate();
}

// --- asking

std::uint64_t Growth::voxelCount() const { return playback::shownVoxels(state_); }

Box3 Growth::touchedBox() const {
    Box3 box;
    for (const std::uint32_t brick : seedMap_.bricks().touched()) {
        box = unite(box, seedMap_.bricks().box(brick));
    }
    return box;
}

void Growth::show(const gl::Buffer& plane, const gl::Buffer& reach, const std::vector<std::uint32_t>& bricks,
                  std::span<const std::uint32_t> kinds, std::uint32_t wanted,
                  const gl::Buffer* owners) const {
    gl::Defines defines = seedMap_.widthDefines();
    if (owners != nullptr) {
        defines.emplace_back("VS_OWNERS", "1");
        owners->bindStorage(kOwnersStorage);
    }
    if (owner_.hasOthers) {
        defines.emplace_back("VS_OTHERS", "1");
    }
    if (state_.playhead < state_.extent) {
        defines.emplace_back("VS_HIDES", "1");
    }
    gl::Program& show = show_.with(defines);
    kinds_.reserve(kinds.size_bytes());
    kinds_.write(kinds);
    seedMap_.bind(show);
    seedMap_.bindOwner(show, owner_);
    kinds_.bindStorage(kKindsStorage);
    plane.bindStorage(kShownBitsStorage);
    reach.bindStorage(kReachStorage);
    show.set("playhead", std::uint32_t(state_.playhead)).set("wanted", wanted);
    seedMap_.dispatchOverBricks(show, bricks, gl::Barrier::All); // labels are images when growth goes on
}

std::vector<std::uint32_t> Growth::generations(bool upToPlayhead) const {
    const glm::ivec3 dims = field_->geometry.dims;
    auto values = seedMap_.downloadGenerations({glm::ivec3(0), dims});
    const auto last = std::uint32_t(upToPlayhead ? state_.playhead : state_.extent);
    std::replace_if(
        values.begin(), values.end(), [&](std::uint32_t g) { return g > last; }, 0U);
    if (owner_.hasOthers) {
        syncLabels();
        const auto labels = seedMap_.labels().downloadAll<std::uint8_t>();
        std::transform(values.begin(), values.end(), labels.begin(), values.begin(),
                       [&](std::uint32_t g, std::uint8_t label) { return label == owner_.label ? g : 0; });
    }
    return values;
}

} // namespace vs::segment
