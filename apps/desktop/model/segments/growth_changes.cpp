// SPDX-License-Identifier: Apache-2.0
// Scrubbing and changes of the rules: what is dragged, shown with the next picture, and one operation when it
// is let go.
#include "field/histogram.h"
#include "model/document/document_host.h"
#include "model/document/view_model.h"
#include "model/edits/editor.h"
#include "model/segments/growth_controller.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_growth.h"

#include <algorithm>
#include <limits>

namespace vs::desktop {

// --- scrubbing

void GrowthController::scrubTo(int generation) {
    if (!canPlay() || host_.facts()->isStrokeOpen()) {
        return;
    }
    if (isPlaying() || rules_) {
        pause();
    }
    showRegion();
    scrubbed_ = generation;
    host_.wake();
}

void GrowthController::showScrubbed() {
    const int generation = *scrubbed_;
    scrubbed_.reset();
    host_.workLong([&] {
        if (generation != status().generation) {
            host_.document()->growing().scrub(generation);
        }
    });
    emit changed();
}

void GrowthController::endScrub() {
    if (scrubbed_) {
        showScrubbed();
    }
    if (host_.facts()->isScrubbing()) {
        editor_.perform([&] { return host_.document()->growing().endScrub(); });
        host_.wake();
    }
    emit changed();
}

std::optional<int> GrowthController::generationBeforeLeak() const {
    const studio::GrowthStatus growth = status();
    const auto isShown = [&](int generation) { return generation < growth.generation; };
    const auto last = std::find_if(growth.leaks.rbegin(), growth.leaks.rend(), isShown);
    return last == growth.leaks.rend() ? std::nullopt : std::optional(*last);
}

void GrowthController::backBeforeLeak() {
    pause();
    if (const auto generation = generationBeforeLeak()) {
        scrubTo(*generation);
        endScrub();
    }
}

// --- the size at which growth from a first stroke stops

void GrowthController::setLimitPercent(int percent) {
    limit_.setPercent(percent);
    emit changed();
}

bool GrowthController::hasStoppedAtLimit() const { return !isPlaying() && limit_.hasStopped(*host_.facts()); }

// Of what is displayed: in range and not cut away.
void GrowthController::limitFirstStroke() {
    double displayed = 0;
    host_.workLong([&] {
        const auto* visible = host_.document()->visibleHistogram(std::numeric_limits<double>::infinity());
        displayed = field::countWithin(*visible, host_.volume()->range, view_.visibleRange());
    });
    // Segments may be of a finer level's voxels than those that were counted.
    const double share = host_.geometry()->voxelMm3() / host_.facts()->segmentVoxelMm3;
    limit_.hold(host_.facts()->segments.atWork, displayed * share);
}

std::uint64_t GrowthController::mostVoxels() const {
    return limit_.mostVoxels(host_.facts()->segments.atWork);
}

void GrowthController::sayLimit() {
    host_.say(tr("Stopped at %1 % of what is displayed: play goes on").arg(limit_.percent()));
}

// --- rules

void GrowthController::setTakesDisplayedRange(bool on) {
    takesDisplayedRange_ = on;
    heldRange_ = {};
    if (!on && host_.document() != nullptr) {
        heldRange_ = range();
    }
    emit changed();
}

namespace {

template <typename T>
void takeOver(std::optional<T>& into, const std::optional<T>& from) {
    if (from) {
        into = from;
    }
}

} // namespace

void GrowthController::changeRules(const studio::SetGrowthRules& rules, bool isHeld) {
    auto* document = host_.document();
    if (document == nullptr || host_.facts()->isStrokeOpen() || host_.isLoading()) {
        return;
    }
    if (!rules_) {
        const Run before = run_;
        const bool hadRunOut = hasRunOut_;
        pause();
        rules_ = Rules{};
        rules_->resumes = before == Run::Forward || before == Run::ToEnd ? before
                          : hadRunOut && isAutoStart_                    ? Run::Forward
                                                                         : Run::None;
        if (host_.facts()->rules.range == Range()) {
            rules_->wanted.range = range(); // none so far: what a stroke would bring
        }
    }
    takesDisplayedRange_ = takesDisplayedRange_ && !rules.range;
    takeOver(rules_->wanted.range, rules.range);
    takeOver(rules_->wanted.difference, rules.difference);
    takeOver(rules_->wanted.gradient, rules.gradient);
    takeOver(rules_->wanted.gradientDifference, rules.gradientDifference);
    takeOver(rules_->wanted.connectivity, rules.connectivity);
    takeOver(rules_->wanted.isLive, rules.isLive);
    rules_->isStale = true;
    if (isHeld) {
        rulesCalm_.stop();
    } else {
        rulesCalm_.start();
    }
    host_.wake();
}

void GrowthController::applyRules() {
    rules_->isStale = false;
    const studio::Operation change = rules_->wanted;
    const bool isFirst = !std::exchange(rules_->isApplied, true);
    view_.flush(); // the view as it is now is part of the log before the change
    editor_.perform([&] {
        auto& document = *host_.document();
        return isFirst ? document.apply(change) : document.replaceLast(change);
    });
    emit changed();
}

void GrowthController::releaseRules() {
    if (rules_) {
        finishRules(true);
    }
}

void GrowthController::finishRules(bool resumes) {
    rulesCalm_.stop();
    if (rules_->isStale) {
        applyRules();
    }
    const Run run = rules_->resumes;
    rules_.reset();
    if (resumes && run != Run::None && canPlay()) {
        start(run);
    }
    host_.wake();
    emit changed();
}

} // namespace vs::desktop
