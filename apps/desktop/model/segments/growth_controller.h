// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"
#include "model/segments/growth_limit.h"
#include "studio/document/document.h"
#include "studio/document/document_facts.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace vs::desktop {

class DocumentHost;
class Editor;
class ViewModel;

// Playback of the segmentation and its rules: plays in short slices between pictures, forward, backward and
// (after an absorbing stroke) taking away; scrubs. Each run is one operation, appended when it pauses or when
// there is nothing left to do.
class GrowthController : public QObject {
    Q_OBJECT

public:
    GrowthController(DocumentHost& host, ViewModel& view, Editor& editor);

    // Gets ready what the first seeds of a scan would wait for; nothing happens when there is no room. And
    // gives that back where none came.
    void prepare();
    void giveBack();

    // --- strokes
    void addSeeds(const studio::Seed& seed); // and plays, with auto start on
    // Targeted shrink: one expansion, and on from there until paused, with auto start on.
    void absorb(const studio::Absorb& stroke);

    // The strokes of the seed tool absorb: play and step go on with the one last drawn.
    void setStrokesAbsorb(bool on) { strokesAbsorb_ = on; }

    // --- playback
    void play();
    void playBackward();
    void pause(); // also ends scrubbing and a change of rules in hand
    // Ends growing for good: nothing but play() or a stroke goes on with it, and no limit asks any more.
    void stop();
    [[nodiscard]] bool canStop() const { return isBusy() || hasStoppedAtLimit(); }
    void step();
    void takeBack();
    void toEnd(); // as play(), without showing every step
    // Shows the last generation before the leak that comes before the one shown (segment::leaks).
    void backBeforeLeak();
    [[nodiscard]] std::optional<int> generationBeforeLeak() const;
    // Runs an edit that needs playing to stop, and then goes on playing.
    void whilePaused(const std::function<void()>& edit);

    // Shows a generation with the next picture. All until endScrub() is one operation.
    void scrubTo(int generation);
    void endScrub();

    // --- rules of the segment at work
    // Changes those that are set. What comes while a hand holds on (`isHeld`), or shortly after one another,
    // is one operation; growing goes on when it is over.
    void changeRules(const studio::SetGrowthRules& rules, bool isHeld);
    void releaseRules();
    // A change is in hand that the document does not have yet.
    [[nodiscard]] bool areRulesPending() const { return rules_ && rules_->isStale; }
    // Whether a stroke brings the displayed range with it, or goes by the range of the rules once there is
    // one. Changing that range by hand switches this off.
    [[nodiscard]] bool takesDisplayedRange() const { return takesDisplayedRange_; }
    void setTakesDisplayedRange(bool on);
    // The range that the next stroke goes by: with strokes that bring none a segment without one of its own
    // takes over that of the segment before it.
    [[nodiscard]] Range range() const;

    // --- the size at which growth from a first stroke stops
    [[nodiscard]] int limitPercent() const { return limit_.percent(); }
    void setLimitPercent(int percent);
    // It has stopped there; play() goes on.
    [[nodiscard]] bool hasStoppedAtLimit() const;

    // For another document: shows its region again when seeds land.
    void reset();

    [[nodiscard]] bool isAutoStart() const { return isAutoStart_; }
    void setAutoStart(bool on);
    // Generations per second; 0: as fast as it goes.
    [[nodiscard]] int speed() const { return speed_; }
    void setSpeed(int generationsPerSecond);

    [[nodiscard]] bool isPlaying() const { return run_ != Run::None; }
    [[nodiscard]] bool isBackward() const { return run_ == Run::Backward; }
    [[nodiscard]] bool isToEnd() const { return run_ == Run::ToEnd; }
    [[nodiscard]] bool canPlay() const;
    // Something is under way or waits for the next picture.
    [[nodiscard]] bool isBusy() const;
    [[nodiscard]] studio::GrowthStatus status() const;

    // Called between pictures. True: the region changed, or wants to be called again soon.
    bool advance();
    // Playing with nothing to do before the next generation is due.
    [[nodiscard]] bool isWaiting() const { return isPlaying() && isWaiting_; }
    // Once, when there is something to see: later the person's own choice of mode stands.
    void showRegion();

signals:
    void changed();

private:
    enum class Run { None, Forward, ToEnd, Backward, Absorbing };
    // A change of rules in hand.
    struct Rules {
        studio::SetGrowthRules wanted;
        bool isStale = true;    // not in the document yet
        bool isApplied = false; // but one before it is
        Run resumes = Run::None;
    };

    void start(Run run);
    void finish();
    void limitFirstStroke();
    [[nodiscard]] std::uint64_t mostVoxels() const;
    void sayLimit();
    int due();
    bool growOn();
    bool goBack();
    bool absorbFurther(int expansions);
    [[nodiscard]] const studio::Absorb* lastAbsorbed() const;
    void showScrubbed();
    void applyRules();
    void finishRules(bool resumes);

    DocumentHost& host_;
    ViewModel& view_;
    Editor& editor_;
    bool isAutoStart_ = true;
    bool strokesAbsorb_ = false;
    Run run_ = Run::None;
    bool isWaiting_ = false;
    bool isJustBegun_ = false; // no portion has grown since start()
    bool hasShownRegion_ = false;
    bool takesDisplayedRange_ = true;
    GrowthLimit limit_;
    Range heldRange_;        // the last one that strokes went by, while they bring none
    bool hasRunOut_ = false; // the last run ended because nothing grew any more
    int speed_ = 0;
    std::optional<int> scrubbed_; // generation that the next picture shows
    std::optional<Rules> rules_;
    QTimer rulesCalm_;
    Timer sinceStart_;
    Timer sinceBack_;   // the last generation taken back
    double played_ = 0; // generations in this run, by the clock's count
};

} // namespace vs::desktop
