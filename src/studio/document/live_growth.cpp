// SPDX-License-Identifier: Apache-2.0
#include "studio/document/live_growth.h"

#include "base/check.h"
#include "gl/context.h"
#include "studio/document/operation_log.h"
#include "studio/editing/growth_editor.h"
#include "studio/editing/segment_change.h"

#include <utility>

namespace vs::studio {

bool LiveGrowth::isGrowing() const { return contents_.inHand == InHand::Growth; }
bool LiveGrowth::isScrubbing() const { return contents_.inHand == InHand::Scrub; }

void LiveGrowth::prepare() { editor_.prepare(); }
void LiveGrowth::giveBack() { editor_.giveBack(); }

void LiveGrowth::begin(std::optional<field::SculptureView> sculptureView) {
    VS_CHECK(contents_.inHand == InHand::Nothing);
    Run run;
    run.voxelsBefore = contents_.grownVoxels();
    run.sculptureView = sculptureView.value_or(contents_.view.sculptureView);
    changeOrNothing(contents_, run.records, [&] {
        workUnlocked(contents_, run.records);
        contents_.region.beginLive(run.sculptureView, run.records);
    });
    run.playheadBefore = contents_.region.growth()->playhead();
    run_ = std::move(run);
    contents_.inHand = InHand::Growth;
}

bool LiveGrowth::growFor(double budgetMs, int maxGenerations, std::uint64_t mostVoxels) {
    VS_CHECK(isGrowing());
    ++contents_.version;
    contents_.region.growFor(budgetMs, maxGenerations, mostVoxels);
    return !contents_.region.growth()->isFinished();
}

// When it throws, it still grows: all that needs memory comes before what ends it.
Outcome LiveGrowth::end() {
    VS_CHECK(isGrowing());
    gl::Context::requireDevice();
    contents_.region.endLive(run_.records);
    const int generations = contents_.region.growth()->playhead() - run_.playheadBefore;
    Outcome outcome = describeGrowth(contents_, generations, run_.voxelsBefore);
    const Operation operation = Grow{generations, run_.sculptureView};
    outcome.name = name(operation);
    outcome.milliseconds = run_.timer.milliseconds();
    if (generations > 0) {
        auto entry = log_.prepare(operation, contents_.view, contents_.view);
        Edit edit{shared(operation), {}, {}};
        contents_.history.makeRoom();
        edit.growth = std::move(run_.records);
        contents_.remember(std::move(edit));
        log_.add(std::move(entry));
        contents_.history.settle();
    } else {
        contents_.region.undo(run_.records); // nothing grew: as if it had not begun
        ++contents_.version;                 // slices showed less meanwhile
    }
    run_ = {};
    contents_.inHand = InHand::Nothing;
    return outcome;
}

void LiveGrowth::scrub(int generation) {
    VS_CHECK((contents_.inHand == InHand::Nothing || isScrubbing()) && contents_.region.hasSeeds());
    if (!isScrubbing()) {
        scrubbedFrom_ = contents_.region.growth()->playhead();
        contents_.inHand = InHand::Scrub;
    }
    contents_.region.scrub(generation);
    ++contents_.version;
}

Outcome LiveGrowth::endScrub() {
    VS_CHECK(isScrubbing());
    const Timer timer;
    ShowGeneration shown{contents_.region.growth()->playhead()};
    auto entry = log_.prepare(shown, contents_.view, contents_.view);
    contents_.region.scrub(scrubbedFrom_);
    contents_.inHand = InHand::Nothing;
    Outcome outcome = editor_.run(shown);
    log_.add(std::move(entry));
    contents_.history.settle();
    outcome.name = name(Operation(shown));
    outcome.milliseconds = timer.milliseconds();
    return outcome;
}

void LiveGrowth::dropScrub() {
    VS_CHECK(isScrubbing());
    contents_.region.scrub(scrubbedFrom_);
    contents_.inHand = InHand::Nothing;
    ++contents_.version;
}

} // namespace vs::studio
