// SPDX-License-Identifier: Apache-2.0
#include "engine/picture_loop.h"

#include "gl/context.h"
#include "studio/document/document.h"

#include <QPainter>

#include <algorithm>
#include <utility>

namespace vs::desktop {

namespace {

// From picture to picture. An input that comes just after a picture was begun is seen two pictures later: in
// less than a tenth of a second.
constexpr double kSoftwareFrameMs = 40;
constexpr double kHardwareFrameMs = 25;
constexpr double kFirstFrameMs = 25; // until the first picture after a rest: a hand waits for it
constexpr double kLeastShare = 0.35; // of a frame for its rays, however much else there is to do
constexpr double kSegmentsMs = 25;   // a draft, to smooth what grew
constexpr double kHurriedSegmentsMs = 3;
constexpr double kCalmMs = 180;      // longer than the pauses within a hand's movement
constexpr double kPartMs = 500;      // between looks at a picture that waits for bricks
constexpr double kLongPassMs = 1000; // from then on a person is told how far a picture is

glm::ivec2 sizeOf(const QImage& image) { return {image.width(), image.height()}; }

// Refers to the picture's own bytes.
QImage seenAs(const image::Image& picture) {
    return {picture.rgba.data(), picture.width, picture.height, qsizetype(4) * picture.width,
            QImage::Format_RGBX8888};
}

QRectF rectangle(const glm::dvec2& lo, const glm::dvec2& hi) {
    return {lo.x, lo.y, hi.x - lo.x, hi.y - lo.y};
}

} // namespace

PictureLoop::PictureLoop(bool isSoftwareRenderer, Run run)
    : run_(std::move(run)), frameMs_(isSoftwareRenderer ? kSoftwareFrameMs : kHardwareFrameMs),
      wholePace_(isSoftwareRenderer ? 2 : 1), partPace_(1) {}

void PictureLoop::setDocument(studio::Document* document) {
    document_ = document;
    pass_ = Pass::None;
    startedVersion_.reset();
    isFullDone_ = false;
    isBehind_ = false;
    shown_ = finished_ = base_ = {};
    brickFailures_.clear();
    wholePace_.forget();
    partPace_.forget();
    ++pictures_;
    rest();
}

void PictureLoop::setViewport(glm::ivec2 devicePixels) {
    if (devicePixels != viewport_) {
        viewport_ = devicePixels;
        interact();
    }
}

void PictureLoop::drawAnew() {
    startedVersion_.reset();
    shown_.content.reset();
    finished_.content.reset();
}

bool PictureLoop::isComplete() const {
    return document_ != nullptr && isFullDone_ && !isBehind_ &&
           startedVersion_ == document_->pictureVersion() && startedViewport_ == viewport_;
}

double PictureLoop::framesPerSecond() const {
    return meanFrameMs_ > 0 && sinceDraft_.milliseconds() < 500 ? 1000 / meanFrameMs_ : 0;
}

std::size_t PictureLoop::bricksComing() const {
    const bool mayWait = document_ != nullptr && pass_ == Pass::Full && document_->detail() != nullptr;
    return mayWait ? document_->detail()->coming() : 0;
}

std::optional<double> PictureLoop::refined() const {
    return pass_ == Pass::Full && passMs_ > kLongPassMs ? std::optional(passShare_) : std::nullopt;
}

image::Image PictureLoop::readPicture() const {
    image::Image picture(shown_.image.width(), shown_.image.height());
    const QImage straight = shown_.image.convertToFormat(QImage::Format_RGBX8888);
    for (int y = 0; y < picture.height; ++y) {
        const auto row = std::size_t(4) * std::size_t(picture.width);
        std::copy_n(straight.constScanLine(y), row,
                    picture.rgba.begin() + std::ptrdiff_t(std::size_t(y) * row));
    }
    return picture;
}

PictureLoop::State PictureLoop::step(double budgetMs) {
    if (document_ == nullptr || viewport_.x < 1 || viewport_.y < 1) {
        return State::Complete;
    }
    const bool isStale = startedVersion_ != document_->pictureVersion() || startedViewport_ != viewport_ ||
                         (isBehind_ && pass_ != Pass::Draft);
    const bool isCalm = !sinceInput_ || sinceInput_->milliseconds() >= kCalmMs;
    if (isStale) {
        begin(Pass::Draft);
        if (prepareMs_ > budgetMs) {
            return State::Busy;
        }
    } else if (pass_ == Pass::None) {
        if (isFullDone_) {
            return State::Complete;
        }
        if (!isCalm) {
            return State::Waiting;
        }
        begin(Pass::Full);
    } else if (pass_ == Pass::Full && !isCalm) {
        return State::Waiting; // a pen is moving over a picture that did not change
    }

    if (pass_ != Pass::None) { // there is something to cast
        advance(budgetMs);
    }
    return isComplete() ? State::Complete : State::Busy;
}

void PictureLoop::advance(double budgetMs) {
    const Timer timer;
    run_([&] { caster_.renderSome(budgetMs); });
    passMs_ += timer.milliseconds();
    if (const field::Detail* detail = document_->detail()) {
        brickFailures_ = detail->failures();
    }
    passShare_ = caster_.share();
    if (pass_ == Pass::Draft && caster_.isComplete()) {
        show();
        finishDraft();
        pass_ = Pass::None;
    } else if (pass_ == Pass::Full) {
        // Shown after about 1, 2, 4 and all 8 samples: between, nobody would see the difference.
        const int samples = caster_.completedSamples();
        if (samples > 0 && (samples >= 2 * samplesShown_ || caster_.isComplete())) {
            show();
            samplesShown_ = samples;
        } else if (samples == 0 && caster_.squaresAwaited() > 0 && sincePart_.milliseconds() > kPartMs &&
                   !shown_.image.isNull()) {
            showPixelsDone();
        }
        if (caster_.isComplete()) {
            finishFull();
        }
    }
}

bool PictureLoop::isFirstDraft() const { return sinceDraft_.milliseconds() > kCalmMs; }

// A draft that took long to prepare is followed by one that shows the segments as they are, so that the hand
// is answered in between; so is the first draft after a rest.
double PictureLoop::segmentsMs() const {
    if (!isHurried_) {
        return isFirstDraft() ? kHurriedSegmentsMs : kSegmentsMs;
    }
    return prepareMs_ > kLeastShare * frameMs_ ? 0 : kHurriedSegmentsMs;
}

void PictureLoop::begin(Pass pass) {
    const Timer timer;
    const bool isDraft = pass == Pass::Draft;
    if (isDraft) {
        meanBesideMs_ = 0.5 * meanBesideMs_ + 0.5 * std::exchange(besideMs_, 0);
    }
    base_ = isDraft ? shown_ : finished_;
    run_([&] {
        auto frame = document_->frame(viewport_, segmentsMs());
        content_ = document_->content();
        pixels_ = changedPixels(frame);
        passScale_ = isDraft && !pixels_.isEmpty() ? draftScale(timer.milliseconds()) : 1;
        frame.samples = isDraft ? 1 : kFullSamples;
        frame.endsEarly = true;
        if (isDraft) {
            frame.detail = nullptr; // what is worked on is there at once
            frame.sampleStep = 1;   // pixels of a draft are wider than that
            frame.scene.sampling =
                field::Sampling::Trilinear; // many times faster; the difference is seen at rest
        }
        if (!pixels_.isEmpty()) {
            start(frame);
        }
    });
    isBehind_ = document_->isBehind();
    pass_ = pass;
    startedVersion_ = document_->pictureVersion();
    startedViewport_ = viewport_;
    isFullDone_ = false;
    samplesShown_ = 0;
    sincePart_ = Timer();
    prepareMs_ = passMs_ = timer.milliseconds();
    passShare_ = 0;
    if (pixels_.isEmpty()) {
        takeOver();
    }
}

bool PictureLoop::isWhole() const { return pixels_ == Box2{glm::ivec2(0), viewport_}; }

// The pixels in which the frame may differ from the picture that the pass goes on from.
Box2 PictureLoop::changedPixels(const render::Frame& frame) const {
    const Box2 whole{glm::ivec2(0), viewport_};
    if (!base_.content || sizeOf(base_.image) != viewport_) {
        return whole;
    }
    const auto voxels = document_->changedSince(*base_.content);
    return voxels ? pixelsAround(*voxels, frame.rays, document_->volume().geometry) : whole;
}

double PictureLoop::draftScale(double preparedMs) {
    const double frameMs = isFirstDraft() ? std::min(frameMs_, kFirstFrameMs) : frameMs_;
    // Where preparing takes most of the time, fewer pixels would not help much and only look worse.
    const double forRays = std::max(frameMs - preparedMs - meanBesideMs_, kLeastShare * frameMs);
    const glm::dvec2 size(pixels_.size());
    partPace_.assume(wholePace_);
    return (isWhole() ? wholePace_ : partPace_).choose(size.x * size.y, forRays);
}

// Starts casting the pass's pixels, larger ones where it is a coarse draft.
void PictureLoop::start(render::Frame& frame) {
    const glm::ivec2 size =
        glm::max(glm::ivec2(glm::round(glm::dvec2(viewport_) / passScale_)), glm::ivec2(1));
    if (size != viewport_) {
        frame.rays = render::viewRays(document_->view().camera, document_->volume().geometry, size);
    }
    if (!isWhole()) {
        const glm::dvec2 larger = glm::dvec2(viewport_) / glm::dvec2(size);
        frame.window = Box2{glm::ivec2(glm::floor(glm::dvec2(pixels_.lo) / larger)),
                            glm::min(glm::ivec2(glm::ceil(glm::dvec2(pixels_.hi) / larger)), size)};
    }
    castSize_ = size;
    window_ = frame.window;
    caster_.start(frame);
    gl::Context::finish(); // or the first tile would be charged for it
}

// Nothing has changed that can be seen: the picture that there is shows it.
void PictureLoop::takeOver() {
    shown_ = {base_.image, content_};
    ++pictures_;
    if (pass_ == Pass::Full) {
        finishFull();
    }
    pass_ = Pass::None;
}

// Read back, and painted as the rest of the window is (doc/decisions/0010).
void PictureLoop::show() {
    image::Image picture;
    run_([&] { picture = caster_.readPicture(); });
    const QImage seen = seenAs(picture);
    if (!window_) {
        shown_.image = seen.convertToFormat(QImage::Format_RGB32); // a copy of its own
    } else {
        shown_.image = base_.image;
        const glm::dvec2 larger = glm::dvec2(viewport_) / glm::dvec2(castSize_);
        QPainter painter(&shown_.image);
        painter.setCompositionMode(QPainter::CompositionMode_Source);
        painter.setRenderHint(QPainter::SmoothPixmapTransform, passScale_ != 1);
        painter.drawImage(rectangle(glm::dvec2(window_->lo) * larger, glm::dvec2(window_->hi) * larger), seen,
                          QRectF(seen.rect()));
    }
    shown_.content = sizeOf(shown_.image) == viewport_ ? content_ : std::nullopt;
    ++pictures_;
}

// While bricks of finer levels come: over what is shown, the pixels that have all of theirs.
void PictureLoop::showPixelsDone() {
    image::Image picture;
    run_([&] { picture = caster_.readPixelsDone(); });
    const QImage seen(picture.rgba.data(), picture.width, picture.height, qsizetype(4) * picture.width,
                      QImage::Format_RGBA8888);
    if (sizeOf(shown_.image) != viewport_) { // a draft of fewer pixels
        shown_.image =
            shown_.image.scaled(viewport_.x, viewport_.y, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
    const glm::ivec2 corner = window_ ? window_->lo : glm::ivec2(0);
    QPainter(&shown_.image).drawImage(QPoint(corner.x, corner.y), seen);
    shown_.content.reset(); // no later picture goes on from what is fine in parts
    ++pictures_;
    sincePart_ = Timer();
}

void PictureLoop::finishDraft() {
    const glm::dvec2 size = window_ ? window_->size() : sizeOf(shown_.image);
    (isWhole() ? wholePace_ : partPace_).note(size.x * size.y, passMs_ - prepareMs_);
    const double sinceLast = sinceDraft_.milliseconds();
    lastDraftMs_ = passMs_;
    meanFrameMs_ = sinceLast > 500 || meanFrameMs_ == 0 ? passMs_ : 0.7 * meanFrameMs_ + 0.3 * sinceLast;
    sinceDraft_ = Timer();
}

void PictureLoop::finishFull() {
    const bool isRough = shown_.content && shown_.content->isRough;
    if (!isRough) { // later pictures go on from what is as fine as they are
        finished_ = shown_;
    }
    isFullDone_ = true;
    pass_ = Pass::None;
}

} // namespace vs::desktop
