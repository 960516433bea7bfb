// SPDX-License-Identifier: Apache-2.0
#include "segment/frontier.h"

#include "base/check.h"
#include "base/error.h"
#include "gl/pass.h"

#include <cstddef>
#include <iterator>
#include <limits>

namespace vs::segment {

namespace {

constexpr glm::ivec3 kWordSize(4, 4, 2);
constexpr std::uint32_t kGroupSize = 64;
constexpr std::uint32_t kMaxGroups = 65535;
constexpr int kGroupsPerBrick = 16;

// Mirrors Step in shaders/words.glsl (std430).
struct Step {
    glm::uvec4 parents{0, 1, 1, 0};
    glm::uvec4 candidates{0, 1, 1, 0};
    glm::uvec4 grown{0};
};
static_assert(sizeof(Step) == 48);

} // namespace

Frontier::Frontier(glm::ivec3 dims)
    : dims_(dims), wordDims_((dims + kWordSize - 1) / kWordSize),
      steps_((kMaxSteps + 1) * sizeof(Step), "growth steps"), list_(4, "growth list"),
      collectGrown_("segment/shaders/collect_grown.comp"), pushSeeds_("segment/shaders/push_seeds.comp") {
    const auto bytes = std::size_t(wordDims_.x) * std::size_t(wordDims_.y) * std::size_t(wordDims_.z) *
                       sizeof(std::uint32_t);
    decided_ = gl::Buffer(bytes, "growth decided");
    frontier_ = gl::Buffer(bytes, "growth frontier");
    offers_ = gl::Buffer(bytes, "growth offers");
    parents_ = gl::Buffer(bytes, "growth parent words");
    candidates_ = gl::Buffer(bytes, "growth candidate words");
}

void Frontier::invalidate() {
    isValid_ = false;
    added_.clear();
}

void Frontier::add(std::span<const std::uint32_t> voxels) {
    if (isValid_) { // else all grown voxels are collected anyway
        added_.insert(added_.end(), voxels.begin(), voxels.end());
    }
}

void Frontier::collect(const gl::Texture& seedMap, const BrickTable& bricks) {
    decided_.clear();
    frontier_.clear();
    const std::vector<std::uint32_t> touched = bricks.holding(0, std::numeric_limits<int>::max());
    list_.reserve(touched.size() * sizeof(std::uint32_t));
    list_.write(std::span<const std::uint32_t>(touched));
    list_.bindStorage(7);
    seedMap.bindTexture(0);
    collectGrown_.set(0, dims_).set(1, bricks.brickDims());
    for (std::size_t first = 0; first < touched.size(); first += kMaxGroups) {
        collectGrown_.set(2, int(first));
        const int rows = int(std::min<std::size_t>(kMaxGroups, touched.size() - first));
        collectGrown_.dispatch({kGroupsPerBrick, rows, 1}, gl::Barrier::Indirect);
    }
    isValid_ = true;
}

void Frontier::pushAdded() {
    if (added_.empty()) {
        return;
    }
    list_.reserve(added_.size() * sizeof(std::uint32_t));
    list_.write(std::span<const std::uint32_t>(added_));
    list_.bindStorage(7);
    pushSeeds_.set(0, dims_).set(1, int(added_.size()));
    pushSeeds_.dispatchOverList(added_.size(), gl::Barrier::Indirect);
    added_.clear();
}

std::vector<std::uint64_t> Frontier::expand(gl::Texture& seedMap, BrickTable& bricks,
                                            const field::Field& field, const Constraints& constraints,
                                            int generation, int steps) {
    VS_CHECK(steps >= 1 && steps <= kMaxSteps);
    const gl::Pass pass("expand region");
    std::vector<Step> table(std::size_t(steps) + 1);
    const std::uint32_t carried = isValid_ ? parentCount_ : 0;
    table[0].parents = {std::min((carried + kGroupSize - 1) / kGroupSize, kMaxGroups), 1, 1, carried};
    steps_.write(std::span<const Step>(table));
    const gl::Buffer* storage[] = {&decided_,    &frontier_, &offers_,          &parents_,
                                   &candidates_, &steps_,    &bricks.onDevice()};
    for (unsigned int i = 0; i < std::size(storage); ++i) {
        storage[i]->bindStorage(i);
    }
    if (isValid_) {
        pushAdded();
    } else {
        collect(seedMap, bricks);
    }

    const bool wide = constraints.connectivity == Connectivity::TwentySix;
    gl::Program& spread = spread_[wide ? 1 : 0];
    if (!spread) {
        spread = gl::Program("segment/shaders/spread_frontier.comp",
                             wide ? gl::Defines{{"VS_NEIGHBOURS_26", "1"}} : gl::Defines{});
    }
    gl::Program& commit = commit_[constraints.hasFence() ? 1 : 0];
    if (!commit) {
        commit = constrainedProgram("segment/shaders/commit_offers.comp", constraints.hasFence());
    }
    bindConstraints(commit, field, constraints);
    seedMap.bindImage(0, gl::Access::Write);
    spread.set(1, wordDims_);
    commit.set(1, wordDims_).set(2, bricks.brickDims());
    for (int i = 0; i < steps; ++i) {
        const std::size_t offset = std::size_t(i) * sizeof(Step);
        spread.set(0, i);
        // The second half takes its group count and its words from the first, and the next expansion from the
        // second.
        spread.dispatchIndirect(steps_, offset + offsetof(Step, parents), gl::Barrier::Indirect);
        commit.set(0, i).set(3, generation + i);
        // After the last one the seed map is read as a texture or downloaded.
        commit.dispatchIndirect(steps_, offset + offsetof(Step, candidates),
                                i + 1 < steps ? gl::Barrier::Indirect : gl::Barrier::All);
    }

    table = steps_.read<Step>(table.size());
    parentCount_ = table.back().parents.w;
    std::vector<std::uint64_t> grown(std::size_t(steps), 0);
    for (std::size_t i = 0; i < grown.size(); ++i) {
        grown[i] = table[i].grown.x;
    }
    return grown;
}

} // namespace vs::segment
