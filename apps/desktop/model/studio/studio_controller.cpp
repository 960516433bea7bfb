// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"

#include "model/hand/tool.h"
#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "model/segments/segment_measurer.h"
#include "model/slices/slice_controller.h"
#include "render/slices/slice_windows.h"
#include "studio/document/document_facts.h"
#include "studio/document/surface_queries.h"

#include <utility>

namespace vs::desktop {

namespace {
constexpr double kPictureSliceMs = 8;
constexpr int kCalmPollMs = 40; // until the picture may refine
studio::MemoryBudgets budgetsOf(const Preferences& preferences) {
    return {std::size_t(preferences.deviceMegabytes) << 20U, std::size_t(preferences.hostMegabytes) << 20U,
            false};
}

} // namespace

StudioController::StudioController()
    : picture_(std::make_unique<PictureLoop>(host_.gl().device().isSoftware,
                                             [this](const auto& work) { host_.runLong(work); })) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &StudioController::tick);
    connectParts();
    growth_ = std::make_unique<GrowthController>(host_, view_, editor_);
    segments_ = std::make_unique<SegmentController>(host_, view_, editor_, *growth_, notices_);
    measurer_ = std::make_unique<SegmentMeasurer>(host_, *segments_, *growth_);
    slices_ = std::make_unique<SliceController>(host_, view_);
    files_ = std::make_unique<DocumentFiles>(
        DocumentFiles::Model{host_, notices_, view_, camera_, hand_, editor_, *growth_, *segments_});
    connect(growth_.get(), &GrowthController::changed, &host_, &DocumentHost::tellSoon);
    connect(slices_.get(), &SliceController::crosshairMoved, &hand_, &Hand::overlayChanged);
    connect(&host_, &DocumentHost::leaving, this, &StudioController::letGo);
    connect(&editor_, &Editor::voxelsMoved, &camera_, &CameraMotion::fitAfterCorrection);
    camera_.setTurntable(preferences_.turntable);
    growth_->setLimitPercent(preferences_.firstStrokePercent);
    files_->preferMemory(budgetsOf(preferences_));
}

StudioController::~StudioController() {
    host_.gl().makeCurrent();
    segments_->stop();
    host_.replace(nullptr); // before the ray caster: its frames point into it
    files_.reset();
    slices_.reset();
    picture_.reset();
}

void StudioController::connectParts() {
    connect(&host_, &DocumentHost::woken, this, [this] {
        picture_->interact();
        schedule(0);
    });
    connect(&host_, &DocumentHost::workWaits, this, [this] { schedule(0); });
    connect(&host_, &DocumentHost::ready, this, &StudioController::showDocument);
    connect(&host_, &DocumentHost::opened, this, [this] {
        host_.document()->setUndoMemory(std::size_t(preferences_.undoMegabytes) << 20);
        if (!host_.isReplaying() && !files_->source().isPlayed && files_->source().session.empty()) {
            preferTo({}); // as volumes are opened where nobody prefers anything
        }
    });
    connect(&host_, &DocumentHost::emptied, this, &StudioController::pictureChanged);
    connect(&view_, &ViewModel::resized, this, [this] {
        picture_->setViewport(view_.viewport());
        hand_.tool().viewResized();
    });
    // The picture held still while a sketch was drawn on it; what it still lacks goes on now.
    connect(&hand_, &Hand::overlayChanged, this, [this] {
        if (!hand_.tool().isSketching() && host_.geometry() != nullptr && !picture_->isComplete()) {
            schedule(0);
        }
    });
}

void StudioController::showDocument() { picture_->setDocument(host_.document()); }

// Of the document, which is about to go.
void StudioController::letGo() {
    measurer_->stop();
    picture_->setDocument(nullptr);
    screenshot_.clear(); // it was to be of this one
}

// --- one slice of work

void StudioController::tick() {
    if (host_.isDeviceLost()) {
        return;
    }
    if (takeUpWaiting()) {
        schedule(0);
        return;
    }
    // A draft that has begun is finished first: one picture for each change, however fast they come.
    if (!picture_->isDrafting() && takeInput()) {
        schedule(0);
        return;
    }
    auto state = PictureLoop::State::Complete;
    if (!hand_.tool().isSketching()) {
        if (!host_.guard([&] { state = picture_->step(kPictureSliceMs); })) {
            host_.tell();
            return;
        }
        show();
    }
    if (!picture_->isDrafting()) {
        host_.tell();
    }
    // After the picture, a slice at a time.
    const bool slicesWait = !picture_->isDrafting() && slices_->step();
    scheduleNext(state, slicesWait);
}

// What waited for the document to be back. True: a session is being replayed, and nothing else is done.
bool StudioController::takeUpWaiting() {
    host_.doWaiting();
    view_.takeWaitingViewport();
    if (host_.isReplaying()) {
        files_->replayOne();
        return true;
    }
    return false;
}

// What the person and growth have done since the last picture. True: more growth before the next.
bool StudioController::takeInput() {
    const Timer edits;
    picture_->setHurried(host_.isHandAtWork());
    view_.flush();
    hand_.tool().advance();
    caughtUpMs_ = hand_.tool().isBehind() ? caughtUpMs_ : Timer::now();
    const bool growsOn = !hand_.tool().isSketching() && grow();
    picture_->charge(edits.milliseconds());
    return growsOn;
}

// What has been drawn, if it is a picture.
void StudioController::show() {
    answeredMs_ = picture_->isDrafting() ? answeredMs_ : caughtUpMs_;
    if (picture_->pictures() != picturesSeen_) {
        picturesSeen_ = picture_->pictures();
        const Timer painting;
        host_.tell();
        emit pictureChanged();
        picture_->charge(painting.milliseconds());
    }
    if (picture_->isComplete()) {
        writeScreenshot();
    }
}

bool StudioController::grow() {
    const Timer timer;
    if (!growth_->advance()) {
        return false;
    }
    picture_->interact();
    growthMs_ += timer.milliseconds();
    // Growing and drawing take turns: as long as the last picture took, or longer when only the end matters.
    constexpr double kToEndMs = 500;
    const double turnMs = host_.isHandAtWork() ? 0 : growth_->isToEnd() ? kToEndMs : picture_->draftMs();
    if (growth_->isPlaying() && growthMs_ < turnMs) {
        return true;
    }
    growthMs_ = 0;
    return false;
}

void StudioController::scheduleNext(PictureLoop::State state, bool slicesWait) {
    const bool isPlayingNow = growth_->isPlaying() && !growth_->isWaiting() && !hand_.tool().isSketching();
    if (state == PictureLoop::State::Busy || view_.isPending() || isPlayingNow || slicesWait) {
        schedule(0);
    } else if (state == PictureLoop::State::Waiting || growth_->isWaiting()) {
        schedule(growth_->isWaiting() ? 5 : kCalmPollMs);
    }
}

void StudioController::schedule(int milliseconds) {
    if (!timer_.isActive() || timer_.remainingTime() > milliseconds) {
        timer_.start(milliseconds);
    }
}

// --- preferences

void StudioController::setPreferences(const Preferences& preferences) {
    const Preferences before = std::exchange(preferences_, preferences);
    camera_.setTurntable(preferences_.turntable);
    growth_->setLimitPercent(preferences_.firstStrokePercent);
    files_->preferMemory(budgetsOf(preferences_));
    if (host_.document() != nullptr) {
        host_.document()->setUndoMemory(std::size_t(preferences_.undoMegabytes) << 20);
        if (!host_.isReplaying()) {
            preferTo(before);
        }
    }
}

void StudioController::setTurntable(bool isTurntable) {
    preferences_.turntable = isTurntable;
    preferences_.save();
    camera_.setTurntable(isTurntable);
    emit host_.changed();
}

void StudioController::setFirstStrokePercent(int percent) {
    preferences_.firstStrokePercent = percent;
    preferences_.save();
    growth_->setLimitPercent(percent);
}

// Windows are in Hounsfield units.
std::optional<Range> StudioController::preferredWindow() const {
    if (host_.volume()->unit == "HU") {
        for (const render::SliceWindow& window : render::kSliceWindows) {
            if (preferences_.sliceWindow == window.name) {
                return window.range;
            }
        }
    }
    return std::nullopt;
}

// Shows what is preferred now and was not before: the rest is as the person has it, or the session.
void StudioController::preferTo(const Preferences& before) {
    auto view = view_.shown();
    if (preferences_.smoothSampling != before.smoothSampling) {
        view.sampling = preferences_.smoothSampling ? field::Sampling::Tricubic : field::Sampling::Trilinear;
    }
    if (preferences_.shadows != before.shadows) {
        view.shadows = preferences_.shadows;
    }
    if (preferences_.sliceWindow != before.sliceWindow) {
        view.sliceWindow = preferredWindow();
    }
    if (preferences_.tintsSlices != before.tintsSlices) {
        view.tintsSlices = preferences_.tintsSlices;
    }
    view_.showView(view);
}

// --- what is shown

void StudioController::takeScreenshot(const std::filesystem::path& path) {
    if (host_.geometry() == nullptr || host_.isLoading()) {
        return;
    }
    if (path.extension() != ".png" && path.extension() != ".PNG") {
        host_.say(tr("Pictures are written as PNG: choose a name that ends in .png"));
        return;
    }
    editor_.interrupt();
    screenshot_ = path;
    host_.say(tr("Finishing the picture"));
    schedule(0);
    emit host_.changed();
}

void StudioController::writeScreenshot() {
    if (screenshot_.empty()) {
        return;
    }
    const auto path = std::exchange(screenshot_, {});
    if (host_.workLong([&] { image::writePng(path, picture_->readPicture()); })) {
        host_.say(tr("Saved picture %1").arg(QString::fromStdString(path.string())));
    }
    emit host_.changed();
}

std::optional<studio::Probe> StudioController::probe(QPointF position) {
    std::optional<studio::Probe> found;
    if (isIdle() && host_.geometry() != nullptr) {
        const glm::dvec2 pixel = glm::dvec2(position.x(), position.y()) * view_.devicePerLogical();
        host_.workLong([&] { found = host_.document()->surface().probe(pixel, view_.viewport()); });
    }
    return found;
}

bool StudioController::isSettled() {
    return !host_.isAway() && !view_.isViewportWaiting() && host_.document() != nullptr &&
           !host_.isLoading() && !view_.isPending() && !picture_->isDrafting() && !growth_->isBusy() &&
           !host_.facts()->isStrokeOpen();
}

// While the pen sketches, its stroke over the picture is the answer.
double StudioController::answeredMs() const {
    return hand_.tool().isSketching() ? Timer::now() : answeredMs_;
}

bool StudioController::isPictureComing() const {
    const Tool& tool = hand_.tool();
    return !tool.isSketching() && (picture_->isDrafting() || view_.isPending() || tool.isBehind());
}

bool StudioController::isIdle() {
    if (host_.isAway() || view_.isViewportWaiting() || host_.isToldSoon() || host_.isLoading() ||
        hand_.tool().isBusy() || growth_->isBusy() || view_.isPending() || !screenshot_.empty()) {
        return false;
    }
    return host_.geometry() == nullptr || (picture_->isComplete() && slices_->isComplete());
}

} // namespace vs::desktop
