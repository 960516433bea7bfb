// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"

#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "model/segments/segment_measurer.h"
#include "model/slices/slice_controller.h"
#include "model/studio/tool.h"
#include "model/texts/library_texts.h"

#include "base/progress.h"

namespace vs::desktop {

namespace {
constexpr double kPictureSliceMs = 8;
constexpr int kCalmPollMs = 40; // until the picture may refine
constexpr double kHandMs = 300; // after the last input: a hand that is at work is answered first

// In hand before there are tools.
class NoTool : public Tool {
public:
    using Tool::Tool;
    [[nodiscard]] QString name() const override { return {}; }
    [[nodiscard]] QString hint() const override { return {}; }
    void press(const Pen&) override {}
    void move(const Pen&) override {}
    void release(const Pen&) override {}
};

} // namespace

StudioController::StudioController()
    : picture_(std::make_unique<PictureLoop>(host_.device().isSoftware,
                                             [this](const auto& work) { longWork_.run(work); })),
      segments_(new SegmentController(*this)), measurer_(new SegmentMeasurer(*this)),
      growth_(new GrowthController(*this)), tool_(new NoTool(this)),
      slices_(std::make_unique<SliceController>(*this)) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &StudioController::tick);
    connect(growth_, &GrowthController::changed, this, &StudioController::tellSoon);
    connect(&longWork_, &LongWork::lasts, this, [this](int thousandths) {
        if (!isReplaying()) { // which counts its operations
            thousandths < 0 ? emit progress(0, 0) : emit progress(thousandths, 1000);
        }
    });
    connectLoader();
}

StudioController::~StudioController() {
    host_.makeCurrent();
    measurer_->stop();
    segments_->stop();
    document_.reset(); // before the ray caster: its frames point into it
    slices_.reset();
    picture_.reset();
}

studio::Document* StudioController::document() {
    host_.makeCurrent();
    return document_.get();
}

void StudioController::giveUp() {
    longWork_.giveUp();
    loader_.giveUp();
    isReplayGivenUp_ = true;
    emit givenUp();
}

std::uint64_t StudioController::documentVersion() const {
    if (!isAway()) {
        versionSeen_ = document_ ? document_->version() : 0;
    }
    return versionSeen_;
}

void StudioController::tick() {
    host_.makeCurrent();
    for (const auto& work : std::exchange(waiting_, {})) {
        work();
    }
    if (const auto viewport = std::exchange(newViewport_, {})) {
        setViewport(viewport->first, viewport->second);
    }
    if (isReplaying()) {
        replayOne();
        schedule(0);
        return;
    }
    // A draft that has begun is finished first: one picture for each change, however fast they come.
    if (!picture_->isDrafting()) {
        const Timer edits;
        picture_->setHurried(isHandAtWork());
        flushView();
        tool_->advance();
        caughtUpMs_ = tool_->isBehind() ? caughtUpMs_ : Timer::now();
        const bool growsOn = !tool_->isSketching() && grow();
        picture_->charge(edits.milliseconds());
        if (growsOn) {
            schedule(0);
            return;
        }
    }
    auto state = PictureLoop::State::Complete;
    if (!tool_->isSketching()) {
        if (!guard([&] { state = picture_->step(kPictureSliceMs); })) {
            tell();
            return;
        }
        answeredMs_ = picture_->isDrafting() ? answeredMs_ : caughtUpMs_;
        if (picture_->pictures() != picturesSeen_) {
            picturesSeen_ = picture_->pictures();
            const Timer painting;
            tell();
            emit pictureChanged();
            picture_->charge(painting.milliseconds());
        }
        if (picture_->isComplete()) {
            writeScreenshot();
        }
    }
    if (!picture_->isDrafting()) {
        tell();
    }
    // After the picture, a slice at a time.
    const bool slicesWait = !picture_->isDrafting() && slices_->step();
    const bool isPlayingNow = growth_->isPlaying() && !growth_->isWaiting() && !tool_->isSketching();
    if (state == PictureLoop::State::Busy || isViewPending_ || isPlayingNow || slicesWait) {
        schedule(0);
    } else if (state == PictureLoop::State::Waiting || growth_->isWaiting()) {
        schedule(growth_->isWaiting() ? 5 : kCalmPollMs);
    }
}

bool StudioController::isHandAtWork() const { return sinceWoken_.milliseconds() < kHandMs; }

bool StudioController::grow() {
    const Timer timer;
    if (!growth_->advance()) {
        return false;
    }
    picture_->interact();
    growthMs_ += timer.milliseconds();
    // Growing and drawing take turns: as long as the last picture took, or longer when only the end matters.
    constexpr double kToEndMs = 500;
    const double turnMs = isHandAtWork() ? 0 : growth_->isToEnd() ? kToEndMs : picture_->draftMs();
    if (growth_->isPlaying() && growthMs_ < turnMs) {
        return true;
    }
    growthMs_ = 0;
    return false;
}

// changed() with the next picture: painting a label alone costs the window as much as painting all of it.
void StudioController::tellSoon() {
    isToldSoon_ = true;
    schedule(0);
}

void StudioController::tell() {
    if (std::exchange(isToldSoon_, false)) {
        emit changed();
    }
}

void StudioController::schedule(int milliseconds) {
    if (!timer_.isActive() || timer_.remainingTime() > milliseconds) {
        timer_.start(milliseconds);
    }
}

void StudioController::wake() {
    sinceWoken_ = Timer();
    picture_->interact();
    schedule(0);
}

void StudioController::look(const studio::View& view) {
    if (document_ == nullptr || view == view_) {
        return;
    }
    view_ = view;
    isViewPending_ = true;
    wake();
}

void StudioController::flushView() {
    if (isViewPending_ && document_ != nullptr && !document_->isStrokeOpen()) {
        isViewPending_ = false;
        guard([this] { document_->look(view_); });
        tellSoon();
    }
}

studio::Canvas StudioController::canvas() {
    host_.makeCurrent();
    flushView();
    return {view_, picture_->viewport()};
}

bool StudioController::guard(const std::function<void()>& work) {
    host_.makeCurrent();
    try {
        work();
        return true;
    } catch (const GivenUp&) {
        say(tr("Given up: nothing was changed"));
        return false;
    } catch (const std::exception& e) {
        say(QString::fromUtf8(e.what()));
        return false;
    }
}

bool StudioController::workLong(const std::function<void()>& work) {
    return guard([&] { longWork_.run(work); });
}

bool StudioController::perform(const std::function<studio::Outcome()>& edit) {
    studio::Outcome outcome;
    const bool isDone = guard([&] { longWork_.run([&] { outcome = edit(); }, LongWork::Input::GivesUp); });
    if (isDone) {
        report(outcome);
    }
    return isDone;
}

void StudioController::whenHere(std::function<void()> work) {
    if (isAway()) {
        waiting_.push_back(std::move(work));
        schedule(0);
    } else {
        work();
    }
}

bool StudioController::apply(const studio::Operation& operation, const std::filesystem::path& outputFolder) {
    return change([&] { return document_->apply(operation, outputFolder); });
}

bool StudioController::rewind(int generations) {
    return change([&] { return document_->rewindFurther(generations); });
}

bool StudioController::change(const std::function<studio::Outcome()>& edit) {
    if (document_ == nullptr || isLoading() || isAway()) {
        return false;
    }
    tool_->settle();
    if (document_->isStrokeOpen()) {
        return false;
    }
    growth_->pause(); // what has grown so far is an operation of its own
    flushView();
    const bool done = perform(edit);
    view_ = document_->view();
    wake();
    emit changed();
    return done;
}

// "Peel: 120 voxels changed", "Undone: peel"; and "Nothing was cut: ...", which says by itself what was
// tried.
void StudioController::report(const studio::Outcome& outcome) {
    const auto capitalised = [](const QString& text) { return text.left(1).toUpper() + text.mid(1); };
    const QString name = capitalised(libraryText(outcome.name));
    const QString message = libraryText(outcome.message);
    if (outcome.name == "undo" || outcome.name == "redo") {
        say((outcome.name == "undo" ? tr("Undone: %1") : tr("Redone: %1")).arg(message));
    } else if (outcome.message.starts_with("nothing ")) {
        say(capitalised(message));
    } else {
        say(message.isEmpty() ? name : name + ": " + message);
    }
}

void StudioController::say(const QString& message) {
    message_ = message;
    emit messageChanged();
}

void StudioController::setTool(Tool& tool) {
    if (tool_ != &tool) {
        tool_->clear(); // leaving a tool changes nothing: a stroke in hand is dropped
        tool_ = &tool;
        wake();
        emit overlayChanged();
        emit changed();
    }
}

void StudioController::listenTo(Tool& tool) {
    connect(&tool, &Tool::settingsChanged, this, &StudioController::changed);
    connect(&tool, &Tool::overlayChanged, this, &StudioController::overlayChanged);
    // The picture held still while a sketch was drawn on it; what it still lacks goes on now.
    connect(&tool, &Tool::overlayChanged, this, [this] {
        if (!tool_->isSketching() && document_ != nullptr && !picture_->isComplete()) {
            schedule(0);
        }
    });
}

void StudioController::setShape(studio::Shape shape) {
    if (tool_->isSketching()) { // a polyline that was under way
        tool_->clear();
    }
    shape_ = shape;
    emit overlayChanged(); // the hint
    emit changed();
}

void StudioController::setTabletPressure(double pressure) { emit tabletPressureChanged(pressure); }

std::optional<studio::Document::Probe> StudioController::probe(QPointF position) {
    std::optional<studio::Document::Probe> found;
    if (isIdle() && document_ != nullptr) {
        const glm::dvec2 pixel = glm::dvec2(position.x(), position.y()) * devicePerLogical();
        workLong([&] { found = document_->probe(pixel, picture_->viewport()); });
    }
    return found;
}

bool StudioController::isSettled() {
    return !isAway() && !newViewport_ && document_ != nullptr && !isLoading() && !isViewPending_ &&
           !picture_->isDrafting() && !growth_->isBusy() && !document_->isStrokeOpen();
}

// While the pen sketches, its stroke over the picture is the answer.
double StudioController::answeredMs() const { return tool_->isSketching() ? Timer::now() : answeredMs_; }

bool StudioController::isPictureComing() const {
    return !tool_->isSketching() && (picture_->isDrafting() || isViewPending_ || tool_->isBehind());
}

bool StudioController::isIdle() {
    if (isAway() || newViewport_ || isToldSoon_ || isLoading() || tool_->isBusy() || growth_->isBusy() ||
        isViewPending_ || !screenshot_.empty()) {
        return false;
    }
    return document_ == nullptr || (picture_->isComplete() && slices_->isComplete());
}

} // namespace vs::desktop
