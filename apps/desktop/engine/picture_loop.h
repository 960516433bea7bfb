// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"
#include "engine/draft_pace.h"
#include "render/rays/ray_caster.h"
#include "studio/state/picture_content.h"

#include <QImage>

#include <functional>
#include <optional>

namespace vs::studio {
class Document;
}

namespace vs::desktop {

// Keeps a picture of the document up to date in short portions. Whatever changed is shown first as a draft,
// as coarse as it must be to hold the frame rate (scale 1 .. 1/4); when nothing has moved for a moment the
// picture is made at full resolution and then refined to 8 samples per pixel. Of a picture that shows
// something already, only those pixels are made anew whose rays pass where voxels changed
// (doc/decisions/0034). No widgets; the engine's context must be current in every call.
class PictureLoop {
public:
    static constexpr int kFullSamples = 8;

    // A function that does what may take long while it has the document and the engine's context.
    using Run = std::function<void(const std::function<void()>& work)>;

    // The frame rate that is held while things move is lower on the software renderer.
    PictureLoop(bool isSoftwareRenderer, Run run);

    // Shows another document, or nothing for null, and forgets the picture of the one before. Nothing has
    // moved on it yet.
    void setDocument(studio::Document* document);
    void setViewport(glm::ivec2 devicePixels);
    // Makes the whole picture once more: not the document has changed, but what draws it.
    void drawAnew();
    // Says that something is moving: only drafts are made until it has been calm for a moment.
    void interact() { sinceInput_ = Timer(); }
    // Says that nothing will move now: the picture at full quality follows its draft at once.
    void rest() { sinceInput_.reset(); }
    // Works on the picture for a portion, which takes about `budgetMs`, or one tile where that is longer.
    // Throws Error when the picture cannot be made.
    enum class State { Busy, Waiting, Complete };
    State step(double budgetMs);

    // Says whether a hand is at work: it is answered before what grew meanwhile is smoothed.
    void setHurried(bool isHurried) { isHurried_ = isHurried; }
    // Takes note of time that a frame needs beside its rays (changes of the document, painting the window):
    // the next drafts are made so much smaller.
    void charge(double milliseconds) { besideMs_ += milliseconds; }

    // Whether a draft is under way: it must be finished before the document changes again, or nothing is ever
    // shown.
    [[nodiscard]] bool isDrafting() const { return pass_ == Pass::Draft; }
    // Whether the picture shows the document as it is now, at full quality.
    [[nodiscard]] bool isComplete() const;
    [[nodiscard]] glm::ivec2 viewport() const { return viewport_; }
    // What to show, in pixels of its own; null before the first picture. Replaced in step() only.
    [[nodiscard]] const QImage& shown() const { return shown_.image; }
    // Counts pictures shown.
    [[nodiscard]] int pictures() const { return pictures_; }
    // What the last draft took, macrocells and all.
    [[nodiscard]] double draftMs() const { return lastDraftMs_; }
    // Drafts per second of late; 0 when at rest.
    [[nodiscard]] double framesPerSecond() const;
    // How much of the full quality is done, 0 to 1, while a picture at rest takes long enough to be told of.
    [[nodiscard]] std::optional<double> refined() const;
    // Bricks of finer levels that the picture under way waits for.
    [[nodiscard]] std::size_t bricksComing() const;
    // What pictures of this document show coarser than their pixels ask for, a line each.
    [[nodiscard]] const std::vector<std::string>& brickFailures() const { return brickFailures_; }
    // The finished picture. isComplete() must hold.
    [[nodiscard]] image::Image readPicture() const;

private:
    enum class Pass { None, Draft, Full };

    // A picture, and what of the document it shows where it has the view's pixels.
    struct Picture {
        QImage image;
        std::optional<studio::PictureContent> content;
    };

    void begin(Pass pass);
    [[nodiscard]] bool isFirstDraft() const;
    [[nodiscard]] bool isWhole() const;
    [[nodiscard]] Box2 changedPixels(const render::Frame& frame) const;
    double draftScale(double preparedMs);
    void start(render::Frame& frame);
    void takeOver();
    void advance(double budgetMs);
    void show();
    void showPixelsDone();
    void finishDraft();
    void finishFull();
    [[nodiscard]] double segmentsMs() const;

    std::vector<std::string> brickFailures_;
    Run run_;
    render::RayCaster caster_;
    studio::Document* document_ = nullptr;
    glm::ivec2 viewport_{0};
    double frameMs_; // time from picture to picture while things move
    double lastDraftMs_ = 0;
    double prepareMs_ = 0; // of the running pass, before the first ray: macrocells and such
    DraftPace wholePace_;
    DraftPace partPace_; // of drafts of some of the picture
    Pass pass_ = Pass::None;
    std::optional<std::uint64_t> startedVersion_; // what the running or last pass shows
    glm::ivec2 startedViewport_{0};
    bool isFullDone_ = false;
    bool isHurried_ = false;
    bool isBehind_ = false;           // the last pass does not have all that the document has
    double passMs_ = 0;               // spent in this pass so far
    double passShare_ = 0;            // how much of it is done, 0 to 1
    std::optional<Timer> sinceInput_; // none: nothing has moved
    Timer sinceDraft_;
    double meanFrameMs_ = 0; // running mean of the time from draft to draft
    double besideMs_ = 0;    // charged since the last draft began
    double meanBesideMs_ = 0;
    int samplesShown_ = 0;
    Timer sincePart_; // of a picture that waits for bricks was shown
    int pictures_ = 0;

    Picture shown_;
    Picture finished_;                              // the last one at full quality
    Picture base_;                                  // that the running pass goes on from
    std::optional<studio::PictureContent> content_; // what its picture shows
    Box2 pixels_;                                   // of the view, which it makes anew
    double passScale_ = 1;                          // how many times larger its own pixels are
    glm::ivec2 castSize_{0};                        // of the whole view in its own pixels
    std::optional<Box2> window_;                    // of those, the ones that it casts; nothing: all
};

} // namespace vs::desktop
