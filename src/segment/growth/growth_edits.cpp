// SPDX-License-Identifier: Apache-2.0
// What changes segments other than growing: retraction, targeted shrink, edits, and going from one segment to
// another.
#include "base/check.h"
#include "gl/pass.h"
#include "segment/growth/growth.h"
#include "segment/growth/growth_undo.h"
#include "segment/growth/playback.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace vs::segment {

namespace {

constexpr int kAll = std::numeric_limits<int>::max();

} // namespace

// Erases such voxels (RegionPasses::Which) in some bricks, and takes them off the counts.
void Growth::eraseByPlane(const gl::Buffer& plane, bool isInPlane, int last,
                          const std::vector<std::uint32_t>& among, GrowthUndo* undo) {
    const RegionPasses::Which which{last, &plane, isInPlane};
    const auto losing = passes_.holding(seedMap_, owner_, which, among);
    if (losing.empty()) {
        return;
    }
    if (undo != nullptr) {
        undo->save(*this, losing);
    }
    const auto lost = passes_.erase(seedMap_, owner_, which, losing, state_.extent);
    for (std::size_t g = 1; g < lost.size(); ++g) {
        state_.voxels[g - 1] -= lost[g];
    }
    seedMap_.bricks().markChanged(losing);
    frontier_->invalidate();
}

// Live mode: keeps what can be reached from the seeds under the present rules, within what has grown.
void Growth::retract(GrowthUndo* undo) {
    const gl::Pass pass("retract region");
    if (state_.extent == 0) {
        return;
    }
    const gl::TexelBuffer region = seedMap_.makeTexelPlane("region");
    const gl::Buffer reached = seedMap_.makePlane("reached");
    passes_.planeOf(seedMap_, owner_, state_.frozen, *field_, &state_.constraints, rules().forbidden,
                    region.buffer(), seedMap_.bricks().touched());
    std::vector<std::uint32_t> seeds;
    for (const Seed& seed : *state_.seeds) {
        seeds.push_back(seed.voxel);
    }
    frontier_->flood(seedMap_, rules(), seeds, region, reached, kAll);
    eraseByPlane(reached, false, state_.frozen, seedMap_.bricks().touched(), undo);
}

int Growth::absorb(std::span<const glm::ivec3> voxels, int expansions, GrowthUndo* undo) {
    const gl::Pass pass("absorb region");
    const GrowthUndo::Recording recording(undo, *this);
    if (undo != nullptr) {
        undo->keepForbidden(*this);
    }
    truncate(state_.playhead, undo);
    const gl::TexelBuffer region = seedMap_.makeTexelPlane("region");
    const gl::Buffer reached = seedMap_.makePlane("absorbed");
    passes_.planeOf(seedMap_, owner_, 0, *field_, nullptr, nullptr, region.buffer(),
                    seedMap_.bricks().touched());
    Constraints unpaired;
    unpaired.connectivity = state_.constraints.connectivity;
    Frontier::Rules rules = this->rules();
    rules.constraints = &unpaired;
    const int found = frontier_->flood(seedMap_, rules, voxelsInGrid(voxels), region, reached, expansions);
    eraseByPlane(reached, true, 0, seedMap_.bricks().touched(), undo);
    if (!forbidden_) {
        forbidden_ = seedMap_.makePlane("forbidden voxels");
    }
    passes_.join(seedMap_, forbidden_, reached);
    frontier_->invalidate();
    state_.isFinished = false;
    state_.consistentFrom = GrowthState::kNever;
    return found;
}

// Gives the free voxels of a plane in some bricks to the segment, in the playhead's generation.
void Growth::addByPlane(const gl::Buffer& plane, const std::vector<std::uint32_t>& among, GrowthUndo* undo) {
    BrickTable& bricks = seedMap_.bricks();
    const int generation = std::max(1, state_.playhead);
    const auto gaining = passes_.withFree(seedMap_, plane, among);
    if (undo != nullptr) {
        undo->save(*this, gaining);
    }
    state_.voxels.resize(std::size_t(generation));
    state_.voxels.back() += passes_.add(seedMap_, plane, gaining, generation);
    bricks.widen(gaining, generation);
    bricks.upload();
    bricks.markChanged(gaining);
    state_.extent = generation;
    movePlayhead(generation);
}

// What there is now came of an edit: it does not grow.
void Growth::freeze() {
    state_.frozen = state_.extent;
    state_.isFinished = true;
    state_.seeds = std::make_shared<const std::vector<Seed>>();
    frontier_->invalidate();
}

void Growth::replace(const Box3& box, std::span<const std::uint8_t> inside, GrowthUndo* undo) {
    const gl::Pass pass("replace region");
    VS_CHECK_EQ(inside.size(), box.volume());
    const GrowthUndo::Recording recording(undo, *this);
    truncate(state_.playhead, undo);
    gl::Buffer plane = seedMap_.makePlane("edited region");
    seedMap_.uploadPlane(plane, box, inside);
    eraseByPlane(plane, false, 0, seedMap_.bricks().touched(), undo);
    std::vector<std::uint32_t> all(seedMap_.bricks().count());
    std::iota(all.begin(), all.end(), 0U);
    addByPlane(plane, all, undo);
    freeze();
}

void Growth::paint(const Box3& box, std::span<const std::uint8_t> inside, bool isToAdd, GrowthUndo* undo) {
    const gl::Pass pass("paint region");
    VS_CHECK_EQ(inside.size(), box.volume());
    const GrowthUndo::Recording recording(undo, *this);
    truncate(state_.playhead, undo);
    gl::Buffer plane = seedMap_.makePlane("painted voxels");
    seedMap_.uploadPlane(plane, box, inside);
    std::vector<std::uint32_t> near;
    for (std::uint32_t brick = 0; brick < seedMap_.bricks().count(); ++brick) {
        if (!intersect(seedMap_.bricks().box(brick), box).isEmpty()) {
            near.push_back(brick);
        }
    }
    if (!isToAdd) {
        eraseByPlane(plane, true, 0, near, undo);
        near.clear();
    }
    addByPlane(plane, near, undo);
    freeze();
}

void Growth::confine(std::span<const std::uint8_t> inside) {
    VS_CHECK_EQ(inside.size(), field_->geometry.voxelCount());
    std::vector<std::uint8_t> outside(inside.size());
    std::transform(inside.begin(), inside.end(), outside.begin(),
                   [](std::uint8_t value) { return value == 0 ? 1 : 0; });
    forbidden_ = seedMap_.makePlane("forbidden voxels");
    seedMap_.uploadPlane(forbidden_, field_->geometry.box(), outside);
    frontier_->invalidate();
    state_.isFinished = false;
}

// --- several segments

void Growth::activate(std::uint8_t label, GrowthUndo* undo) {
    VS_CHECK(label > 0);
    const GrowthUndo::Recording recording(undo, *this);
    if (label != owner_.label) {
        truncate(state_.playhead, undo);
        exchangeRun(label);
    }
}

// Puts the run at work away and takes another's up; nothing is erased. All that needs memory comes first:
// when it throws, nothing has changed.
void Growth::exchangeRun(std::uint8_t label) {
    const auto known = others_.find(label);
    std::vector<GenerationSpan> spans(seedMap_.bricks().count());
    GrowthState fresh;
    gl::Buffer forbidden;
    if (known != others_.end()) {
        std::copy(known->second.spans.begin(), known->second.spans.end(), spans.begin());
        if (!known->second.forbidden.empty()) {
            forbidden = seedMap_.makePlane("forbidden voxels");
            forbidden.write(std::span<const std::uint32_t>(known->second.forbidden));
        }
    }
    std::map<std::uint8_t, Run> putAway;
    Run& now = putAway[owner_.label];
    if (forbidden_) {
        now.forbidden = forbidden_.read<std::uint32_t>(seedMap_.planeBytes() / sizeof(std::uint32_t));
    }
    seedMap_.writeLabels(seedMap_.bricks().touched(), owner_);

    now.state = std::exchange(state_, std::move(known != others_.end() ? known->second.state : fresh));
    now.spans = seedMap_.bricks().exchangeSpans(std::move(spans));
    seedMap_.bricks().upload();
    forbidden_ = std::move(forbidden);
    if (known != others_.end()) {
        others_.erase(known);
    }
    others_.insert(putAway.extract(putAway.begin()));
    owner_ = {label, hasGrownOthers()};
    frontier_->invalidate();
}

bool Growth::hasGrownOthers() const {
    return std::any_of(others_.begin(), others_.end(),
                       [](const auto& run) { return run.second.state.extent > 0; });
}

const GrowthState& Growth::state(std::uint8_t label) const {
    static const GrowthState fresh;
    const auto other = others_.find(label);
    return label == owner_.label ? state_ : other != others_.end() ? other->second.state : fresh;
}

std::uint64_t Growth::voxelCount(std::uint8_t label) const { return playback::shownVoxels(state(label)); }

void Growth::syncLabels() const {
    seedMap_.writeLabels(seedMap_.bricks().changedSince(labelledRevision_), owner_);
    labelledRevision_ = seedMap_.bricks().revision();
}

std::vector<std::uint8_t> Growth::labels() const { return labels(field_->geometry.box()); }

std::vector<std::uint8_t> Growth::labels(const Box3& box) const {
    if (!owner_.hasOthers && state_.playhead == state_.extent) {
        return seedMap_.downloadPlane(seedMap_.grown(), box);
    }
    RegionPasses passes;
    const auto after = [&](int last) {
        const gl::Buffer plane = seedMap_.makePlane("region");
        passes.planeOf(seedMap_, owner_, last, *field_, nullptr, nullptr, plane, seedMap_.bricks().touched());
        return seedMap_.downloadPlane(plane, box);
    };
    auto shown = after(0);
    if (state_.playhead < state_.extent) {
        const auto hidden = after(state_.playhead);
        std::transform(shown.begin(), shown.end(), hidden.begin(), shown.begin(),
                       [](std::uint8_t own, std::uint8_t late) { return own & ~late; });
    }
    return shown;
}

std::vector<std::uint8_t> Growth::labelMap() const {
    syncLabels();
    auto labels = seedMap_.labels().downloadAll<std::uint8_t>();
    if (state_.playhead < state_.extent) {
        const auto shown = this->labels();
        std::transform(labels.begin(), labels.end(), shown.begin(), labels.begin(),
                       [&](std::uint8_t label, std::uint8_t isShown) {
                           return label == owner_.label && isShown == 0 ? std::uint8_t(0) : label;
                       });
    }
    return labels;
}

} // namespace vs::segment
