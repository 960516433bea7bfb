// SPDX-License-Identifier: Apache-2.0
#include "studio/document/live_growth.h"

#include "base/check.h"
#include "studio/document/operation_log.h"
#include "studio/editing/growth_editor.h"
#include "studio/editing/segment_change.h"

#include <utility>

namespace vs::studio {

bool LiveGrowth::isGrowing() const { return contents_.inHand == InHand::Growth; }
bool LiveGrowth::isScrubbing() const { return contents_.inHand == InHand::Scrub; }

void LiveGrowth::begin(std::optional<field::SculptureView> sculptureView) {
    VS_CHECK(contents_.inHand == InHand::Nothing);
    Run run;
    run.voxelsBefore = contents_.grownVoxels();
    run.sculptureView = sculptureView.value_or(contents_.view.sculptureView);
    workUnlocked(contents_, run.records);
    contents_.region.beginLive(run.sculptureView, run.records);
    run_ = std::move(run);
    contents_.inHand = InHand::Growth;
}

bool LiveGrowth::growFor(double budgetMs, int maxGenerations, std::uint64_t mostVoxels) {
    VS_CHECK(isGrowing());
    run_.generations += contents_.region.growFor(budgetMs, maxGenerations, mostVoxels);
    ++contents_.version;
    return !contents_.region.growth()->isFinished();
}

Outcome LiveGrowth::end() {
    VS_CHECK(isGrowing());
    contents_.inHand = InHand::Nothing;
    Run run = std::exchange(run_, {});
    contents_.region.endLive(run.records);
    Outcome outcome = describeGrowth(contents_, run.generations, run.voxelsBefore);
    const Operation operation = Grow{run.generations, run.sculptureView};
    outcome.name = name(operation);
    outcome.milliseconds = run.timer.milliseconds();
    if (run.generations > 0) {
        contents_.remember({shared(operation), {}, std::move(run.records)});
        log_.record(operation, contents_.view);
    } else {
        contents_.region.undo(run.records); // nothing grew: as if it had not begun
    }
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
    contents_.region.scrub(scrubbedFrom_);
    contents_.inHand = InHand::Nothing;
    Outcome outcome = editor_.run(shown);
    log_.record(shown, contents_.view);
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
