// SPDX-License-Identifier: Apache-2.0
#include "engine/picture_loop.h"

#include "gl/context.h"
#include "studio/document/document.h"

#include <array>
#include <cmath>
#include <utility>

namespace vs::desktop {

namespace {

// From picture to picture. An input that comes just after a picture was begun is seen two pictures later: in
// less than a tenth of a second.
constexpr double kSoftwareFrameMs = 40;
constexpr double kHardwareFrameMs = 25;
constexpr double kLeastShare = 0.35; // of a frame for its rays, however much else there is to do
constexpr double kSegmentsMs = 25;   // a draft, to smooth what grew
constexpr double kHurriedSegmentsMs = 3;
constexpr double kCalmMs = 180;      // longer than the pauses within a hand's movement
constexpr double kLongPassMs = 1000; // from then on a person is told how far a picture is
constexpr std::array kScales{1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0};

} // namespace

PictureLoop::PictureLoop(bool isSoftwareRenderer, Run run)
    : run_(std::move(run)), frameMs_(isSoftwareRenderer ? kSoftwareFrameMs : kHardwareFrameMs),
      scale_(isSoftwareRenderer ? 2 : 1) {}

void PictureLoop::setDocument(studio::Document* document) {
    document_ = document;
    pass_ = Pass::None;
    startedVersion_.reset();
    isFullDone_ = false;
    isBehind_ = false;
    shown_ = QImage();
    nanosPerPixel_ = 0;
    ++pictures_;
    rest();
}

void PictureLoop::setViewport(glm::ivec2 devicePixels) {
    if (devicePixels != viewport_) {
        viewport_ = devicePixels;
        interact();
    }
}

bool PictureLoop::isComplete() const {
    return document_ != nullptr && isFullDone_ && !isBehind_ &&
           startedVersion_ == document_->pictureVersion() && startedViewport_ == viewport_;
}

double PictureLoop::framesPerSecond() const {
    return meanFrameMs_ > 0 && sinceDraft_.milliseconds() < 500 ? 1000 / meanFrameMs_ : 0;
}

std::optional<double> PictureLoop::refined() const {
    return pass_ == Pass::Full && passMs_ > kLongPassMs ? std::optional(passShare_) : std::nullopt;
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

    const Timer timer;
    run_([&] { caster_.renderSome(budgetMs); });
    passMs_ += timer.milliseconds();
    passShare_ = caster_.share();
    if (pass_ == Pass::Draft && caster_.isComplete()) {
        show();
        finishDraft();
        pass_ = Pass::None;
    } else if (pass_ == Pass::Full) {
        // Shown after 1, 2, 4 and 8 samples: between, nobody would see the difference.
        const int samples = caster_.completedSamples();
        if (samples > 0 && samples >= 2 * samplesShown_) {
            show();
            samplesShown_ = samples;
        }
        if (caster_.isComplete()) {
            isFullDone_ = true;
            pass_ = Pass::None;
        }
    }
    return isComplete() ? State::Complete : State::Busy;
}

// A draft that took long to prepare is followed by one that shows the segments as they are, so that the hand
// is answered in between.
double PictureLoop::segmentsMs() const {
    if (!isHurried_) {
        return kSegmentsMs;
    }
    return prepareMs_ > kLeastShare * frameMs_ ? 0 : kHurriedSegmentsMs;
}

void PictureLoop::begin(Pass pass) {
    const Timer timer;
    glm::ivec2 size = viewport_;
    if (pass == Pass::Draft) {
        meanBesideMs_ = 0.5 * meanBesideMs_ + 0.5 * std::exchange(besideMs_, 0);
        scale_ = wantedScale();
        size = glm::max(glm::ivec2(glm::round(glm::dvec2(viewport_) / scale_)), glm::ivec2(1));
    }
    run_([&] {
        auto frame = document_->frame(size, segmentsMs());
        frame.samples = pass == Pass::Full ? kFullSamples : 1;
        frame.endsEarly = true;
        if (pass != Pass::Full) {
            frame.sampleStep = 1; // pixels of a draft are wider than that
            frame.scene.sampling =
                field::Sampling::Trilinear; // many times faster; the difference is seen at rest
        }
        caster_.start(frame);
        gl::Context::finish(); // or the first tile would be charged for it
    });
    isBehind_ = document_->isBehind();
    pass_ = pass;
    startedVersion_ = document_->pictureVersion();
    startedViewport_ = viewport_;
    isFullDone_ = false;
    samplesShown_ = 0;
    prepareMs_ = passMs_ = timer.milliseconds();
    passShare_ = 0;
}

// Read back, and painted as the rest of the window is (doc/decisions/0010).
void PictureLoop::show() {
    image::Image picture;
    run_([&] { picture = caster_.readPicture(); });
    const QImage straight(picture.rgba.data(), picture.width, picture.height, qsizetype(4) * picture.width,
                          QImage::Format_RGBX8888);
    shown_ = straight.convertToFormat(QImage::Format_RGB32); // a copy of its own
    ++pictures_;
}

void PictureLoop::finishDraft() {
    const glm::dvec2 size(shown_.width(), shown_.height());
    const double nanos = (passMs_ - prepareMs_) * 1e6 / (size.x * size.y);
    // The first draft of a mode includes compiling its shader, so one slow draft is not believed at once.
    nanosPerPixel_ =
        nanosPerPixel_ == 0 ? nanos : 0.5 * nanosPerPixel_ + 0.5 * std::min(nanos, 2 * nanosPerPixel_);
    const double sinceLast = sinceDraft_.milliseconds();
    lastDraftMs_ = passMs_;
    meanFrameMs_ = sinceLast > 500 || meanFrameMs_ == 0 ? passMs_ : 0.7 * meanFrameMs_ + 0.3 * sinceLast;
    sinceDraft_ = Timer();
}

double PictureLoop::wantedScale() const {
    if (nanosPerPixel_ == 0) {
        return scale_;
    }
    const double pixels = double(viewport_.x) * double(viewport_.y);
    // Where preparing takes most of the time, fewer pixels would not help much and only look worse.
    const double forRays = std::max(frameMs_ - prepareMs_ - meanBesideMs_, kLeastShare * frameMs_);
    const double wanted = std::sqrt(nanosPerPixel_ * 1e-6 * pixels / forRays);
    // Stays where it is when that is nearly right, or the picture would flicker between two scales.
    if (wanted > 0.7 * scale_ && wanted < 1.1 * scale_) {
        return scale_;
    }
    for (const double scale : kScales) {
        if (scale >= 0.95 * wanted) {
            return scale;
        }
    }
    return kScales.back();
}

} // namespace vs::desktop
