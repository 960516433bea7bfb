// SPDX-License-Identifier: Apache-2.0
// Where growth at the finest level begins.
#include "segment/finer/fine_growth.h"
#include "segment/finer/fine_recording.h"
#include "segment/growth/playback.h"
#include "volume/grid/visit_type.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace vs::segment {

namespace {

using SeedAnswer = Frontier::SeedAnswer;

bool isBefore(glm::ivec3 a, glm::ivec3 b) { return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x); }

void makeUnique(std::vector<glm::ivec3>& voxels) {
    std::sort(voxels.begin(), voxels.end(), isBefore);
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
}

} // namespace

SeedAnswer FineGrowth::answer(glm::ivec3 voxel, const FineRules& rules) const {
    const std::uint32_t brick = brickOf(voxel);
    const std::size_t cell = cellOf(voxel & (field::kBrick - 1));
    const auto cells = map_.find(brick);
    const std::uint32_t generation = cells == map_.end() ? 0 : cells->second->generation(cell);
    const bool isOwn = generation != 0 && cells->second->label(cell) == label_;
    if (generation != 0 && !(isOwn && int(generation) > run_.state.playhead)) {
        return isOwn ? SeedAnswer::Present : SeedAnswer::Refused;
    }
    if (!admitsByValue(voxel, rules)) {
        return SeedAnswer::Refused;
    }
    if (rules.constraints->hasFence()) {
        const bool isCut = (*rules.fence)({voxel, voxel + 1}).front() >= 0.5F;
        if (isCut != (rules.constraints->view == field::SculptureView::Probe)) {
            return SeedAnswer::Refused;
        }
    }
    const auto forbidden = rules.forbidden->find(brick);
    return forbidden != rules.forbidden->end() && has(*forbidden->second, cell) ? SeedAnswer::AdmittedAgain
                                                                                : SeedAnswer::Admitted;
}

SeedCounts FineGrowth::addSeeds(std::span<const glm::ivec3> seeds, FineUndo* undo) {
    const Recording recording(undo, *this);
    std::vector<glm::ivec3> voxels;
    std::copy_if(seeds.begin(), seeds.end(), std::back_inserter(voxels),
                 [&](glm::ivec3 v) { return glm::all(glm::lessThan(glm::uvec3(v), glm::uvec3(dims()))); });
    SeedCounts counts;
    counts.refused = int(seeds.size() - voxels.size());
    const std::size_t offered = voxels.size();
    makeUnique(voxels);
    counts.present = int(offered - voxels.size());
    std::vector<glm::ivec3> added;
    auto forbidden = std::make_shared<ForbiddenBits>(*run_.forbidden);
    for (const glm::ivec3 voxel : voxels) {
        const SeedAnswer answer = this->answer(voxel, rules());
        if (answer == SeedAnswer::AdmittedAgain) {
            auto& bits = (*forbidden)[brickOf(voxel)];
            auto fewer = std::make_shared<CellBits>(*bits);
            const std::size_t cell = cellOf(voxel & (field::kBrick - 1));
            (*fewer)[cell / 64] &= ~(std::uint64_t(1) << cell % 64);
            bits = std::move(fewer);
        }
        if (answer == SeedAnswer::Admitted || answer == SeedAnswer::AdmittedAgain) {
            added.push_back(voxel);
        } else {
            ++(answer == SeedAnswer::Present ? counts.present : counts.refused);
        }
    }
    counts.added = int(added.size());
    if (!added.empty()) {
        truncate(run_.state.playhead);
        run_.forbidden = std::move(forbidden);
        enterSeeds(added);
        auto remembered = *run_.seeds;
        for (const glm::ivec3 voxel : voxels) {
            remembered.push_back({voxel, run_.state.extent});
        }
        run_.seeds = std::make_shared<const std::vector<Seed>>(std::move(remembered));
    }
    return counts;
}

void FineGrowth::enterSeeds(const std::vector<glm::ivec3>& voxels) {
    const int generation = playback::enteringGeneration(run_.state);
    std::map<std::uint32_t, std::vector<std::size_t>> byBrick;
    for (const glm::ivec3 voxel : voxels) {
        byBrick[brickOf(voxel)].push_back(cellOf(voxel & (field::kBrick - 1)));
    }
    for (const auto& [brick, cells] : byBrick) {
        const auto known = map_.find(brick);
        OpenCells open = known == map_.end() ? OpenCells() : known->second->opened();
        for (const std::size_t cell : cells) {
            open.set(cell, std::uint32_t(generation), label_);
        }
        replaceCells(brick, open);
    }
    if (isValid_) {
        added_.insert(added_.end(), voxels.begin(), voxels.end());
    }
    run_.state.voxels.resize(std::size_t(generation));
    run_.state.voxels.back() += voxels.size();
    run_.state.extent = generation;
    run_.state.playhead = generation;
    run_.state.isFinished = false;
}

void FineGrowth::reinstateSeeds() {
    std::vector<glm::ivec3> voxels;
    for (const Seed& seed : *run_.seeds) {
        voxels.push_back(seed.voxel);
    }
    makeUnique(voxels);
    const FineRules rules = this->rules();
    std::erase_if(voxels, [&](glm::ivec3 v) { return answer(v, rules) != SeedAnswer::Admitted; });
    if (!voxels.empty()) {
        enterSeeds(voxels);
    }
}

std::vector<glm::ivec3> FineGrowth::nearestAdmitted(const std::vector<glm::dvec3>& places,
                                                    const Constraints& constraints) const {
    const FineFence fence = constraints.hasFence() ? fenceNow_() : FineFence();
    const bool keepsCutPart = constraints.view == field::SculptureView::Probe;
    const glm::dmat3 millimetres(values_->field().geometry.worldFromVoxel);
    std::vector<glm::ivec3> found;
    volume::visitType(values_->type(), [&](const auto* none) {
        const HostRules rules(none, glm::ivec3(4), values_->field(), constraints);
        for (const glm::dvec3& place : places) {
            const glm::ivec3 cell(glm::floor(place));
            const Box3 around{cell - 1, cell + 3};
            const auto values = values_->read(around);
            const auto here = rules.of(reinterpret_cast<decltype(none)>(values.data()));
            double nearest = std::numeric_limits<double>::infinity();
            glm::ivec3 best{0};
            forEachVoxel(Box3{cell, cell + 2}, [&](glm::ivec3 voxel, std::size_t) {
                const double apart = glm::length(millimetres * (glm::dvec3(voxel) - place));
                const bool isInside = glm::all(glm::lessThan(glm::uvec3(voxel), glm::uvec3(dims())));
                if (apart < nearest && isInside && here.admits(voxel - around.lo) &&
                    (!constraints.hasFence() ||
                     (fence(Box3{voxel, voxel + 1}).front() >= 0.5F) == keepsCutPart)) {
                    nearest = apart;
                    best = voxel;
                }
            });
            if (nearest < std::numeric_limits<double>::infinity()) {
                found.push_back(best);
            }
        }
    });
    return found;
}

} // namespace vs::segment
