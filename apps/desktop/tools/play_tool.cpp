// SPDX-License-Identifier: Apache-2.0
#include "tools/play_tool.h"

#include "tools/camera_tool.h"

#include "model/studio/studio_controller.h"
#include "studio/document/document_facts.h"

namespace vs::desktop {

namespace {

constexpr int kBeatMs = 16;
constexpr double kLongestBeat =
    0.25; // seconds that pass at most between two pictures: slow devices skip nothing

bool isTravel(const studio::Operation& operation) {
    return studio::about(operation).effect == studio::Effect::Travels;
}

} // namespace

PlayTool::PlayTool(StudioController& studio, CameraTool& camera) : StudioTool(studio), camera_(camera) {
    beat_.setInterval(kBeatMs);
    connect(&beat_, &QTimer::timeout, this, [this] { studio_.host().wake(); });
    connect(&studio_.files(), &DocumentFiles::playable, this, &PlayTool::take);
    connect(&studio_.host(), &DocumentHost::leaving, this, [this] {
        act_.reset();
        steps_.clear();
        operations_.clear();
        stop();
    });
    connect(&studio_.host(), &DocumentHost::changed, this, &PlayTool::noticeHand);
}

QString PlayTool::hint() const {
    return isRunning_ ? tr("Playing. Click, or press Space, to pause; take any tool to go on by hand.")
           : isAtEnd()
               ? tr("All is done. Go on by hand with any tool, or go back to a step.")
               : tr("Paused. Space plays on. Drag to turn the picture; take any tool to go on by hand.");
}

Overlays PlayTool::overlays() const { return act_ ? act_->overlays() : Overlays(); }

void PlayTool::take(const std::vector<studio::Operation>& operations) {
    operations_ = operations;
    steps_ = studio::stepsOf(operations_);
    before_.clear();
    done_ = 0;
    act_.reset();
    target_.reset();
    revision_ = studio_.host().facts()->edits->revision;
    studio_.hand().take(*this);
    play();
}

std::size_t PlayTool::step() const {
    std::size_t step = 0;
    while (step < steps_.size() && done_ >= steps_[step].first + steps_[step].count) {
        ++step;
    }
    return step;
}

bool PlayTool::isWithinStep() const {
    const std::size_t now = step();
    return now < steps_.size() && done_ > steps_[now].first;
}

// --- running

void PlayTool::play() {
    if (!hasSession() || isAtEnd()) {
        return;
    }
    studio_.hand().take(*this);
    end_.reset();
    run();
}

void PlayTool::playStep() {
    play();
    if (isRunning_) {
        const studio::Step& now = steps_[step()];
        end_ = now.first + now.count;
    }
}

void PlayTool::run() {
    isRunning_ = true;
    lastMs_ = Timer::now();
    beat_.start();
    studio_.host().wake();
    emit overlayChanged();
    emit changed();
}

void PlayTool::stop() {
    isRunning_ = false;
    target_.reset();
    beat_.stop();
    emit overlayChanged();
    emit changed();
}

void PlayTool::pause() {
    if (isRunning_) {
        stop();
    }
}

void PlayTool::begin() {
    const studio::Operation& next = operations_[done_];
    before_.resize(done_);
    before_.push_back({studio_.host().facts()->edits->done, studio_.view().shown()});
    act_ = actFor(next, studio_);
    played_ = 0;
    emit changed(); // perhaps another step
}

bool PlayTool::act(const std::function<Act::State()>& work) {
    isActing_ = true;
    const Act::State state = work();
    isActing_ = false;
    return finish(state);
}

// What an act came to: true, it is over and the next can begin.
bool PlayTool::finish(Act::State state) {
    if (state == Act::State::GoesOn) {
        return false;
    }
    act_.reset();
    revision_ = studio_.host().facts()->edits->revision;
    if (state == Act::State::Failed) { // the message says why
        stop();
        return false;
    }
    ++done_;
    studio_.files().takeAsSaved();
    emit studio_.host().changed();
    return true;
}

// Between pictures.
void PlayTool::advance() {
    if (target_) {
        jump();
        return;
    }
    if (!isRunning_ || studio_.host().isAway()) {
        return;
    }
    if (!act_) {
        begin();
    }
    const double now = Timer::now();
    played_ += std::min((now - lastMs_) / 1000, kLongestBeat) * speed_;
    lastMs_ = now;
    if (act([this] { return act_->advance(played_); }) && (isAtEnd() || done_ == end_)) {
        stop();
    }
    emit overlayChanged();
}

// --- going to a step

void PlayTool::goTo(std::size_t step) {
    if (step > steps_.size()) {
        return;
    }
    const std::size_t wanted = step == steps_.size() ? operations_.size() : steps_[step].first;
    studio_.hand().take(*this);
    stop();
    if (act_) {
        act([this] { return act_->complete(); });
    }
    if (wanted < done_) {
        goBack(wanted);
    } else if (wanted > done_) {
        target_ = wanted;
        beat_.start();
        studio_.host().wake();
    }
    emit changed();
}

// One operation at a time, so that the window answers.
void PlayTool::jump() {
    if (!act_) {
        begin();
    }
    if (act([this] { return act_->complete(); }) && done_ == target_) {
        stop();
    }
}

// By undo; the view is not part of the history. A session that itself goes through the history is begun anew.
void PlayTool::goBack(std::size_t operation) {
    const auto first = operations_.begin() + std::ptrdiff_t(operation);
    if (std::any_of(first, operations_.begin() + std::ptrdiff_t(done_), isTravel)) {
        OpenRequest again = studio_.files().source();
        auto session = std::make_shared<studio::Session>(studio_.files().provenance());
        session->operations = operations_;
        again.given = std::move(session);
        again.isPlayed = true;
        studio_.files().open(again);
        return;
    }
    const Before before = before_[operation];
    isActing_ = true;
    bool isDone = true;
    while (isDone && studio_.host().facts()->edits->done > before.edits) {
        isDone = studio_.editor().apply(studio::Undo{});
    }
    isActing_ = false;
    if (!isDone) {
        return;
    }
    studio_.view().showView(before.view);
    done_ = operation;
    revision_ = studio_.host().facts()->edits->revision;
    studio_.files().takeAsSaved();
}

// --- by hand

void PlayTool::press(const Pen& pen) {
    if (isRunning_) {
        pause();
    } else {
        camera_.press(pen);
    }
}

void PlayTool::move(const Pen& pen) {
    if (camera_.isBusy()) {
        camera_.move(pen);
    }
}

void PlayTool::release(const Pen& pen) { camera_.release(pen); }

void PlayTool::clear() { stopHere(); }

// Something else is about to be done.
void PlayTool::finishPending() {
    if (!isActing_) {
        stopHere();
    }
}

// Nothing half-done is left behind; what remains of it is played when it goes on.
void PlayTool::stopHere() {
    stop();
    if (!act_) {
        return;
    }
    isActing_ = true;
    const auto left = act_->stopHere();
    isActing_ = false;
    if (left) {
        operations_[done_] = *left;
        act_.reset();
        revision_ = studio_.host().facts()->edits->revision;
    } else {
        finish(Act::State::Done);
    }
}

void PlayTool::goOnByHand() {
    stopHere();
    steps_.clear();
    operations_.clear();
    if (&studio_.hand().tool() == this) {
        studio_.hand().take(camera_);
    }
    emit changed();
}

// Somebody else has changed the document: it is theirs now.
void PlayTool::noticeHand() {
    if (hasSession() && !isActing_ && !act_ && studio_.host().facts()->edits->revision != revision_) {
        goOnByHand();
    }
}

} // namespace vs::desktop
