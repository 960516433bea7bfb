// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"
#include "studio/document.h"

#include <QObject>

namespace vs::desktop {

class StudioController;

// Playback of the segmentation: plays in short slices between pictures, steps, plays backward. Each run is
// one Grow operation, appended when it pauses or when nothing grows any more.
class GrowthController : public QObject {
    Q_OBJECT

public:
    explicit GrowthController(StudioController& studio);

    void addSeeds(const studio::Seed& seed); // and plays, with auto start on
    void play();
    void pause();
    void step();
    void stepBack();
    void toEnd(); // as play(), without showing every step
    void setRange(Range range);

    // For another document: shows its region again when seeds land.
    void reset() { hasShownRegion_ = false; }

    [[nodiscard]] bool isAutoStart() const { return isAutoStart_; }
    void setAutoStart(bool on);
    // Generations per second; 0: as fast as it goes.
    [[nodiscard]] int speed() const { return speed_; }
    void setSpeed(int generationsPerSecond);

    [[nodiscard]] bool isPlaying() const { return isPlaying_; }
    [[nodiscard]] bool isToEnd() const { return isPlaying_ && isToEnd_; }
    [[nodiscard]] bool canPlay() const;
    [[nodiscard]] studio::Document::GrowthStatus status() const;

    // Called between pictures. True: the region changed, or wants to be called again soon.
    bool advance();
    // Playing with nothing to do before the next generation is due.
    [[nodiscard]] bool isWaiting() const { return isPlaying_ && isWaiting_; }

signals:
    void changed();

private:
    void run(bool toEnd);
    void showRegion();
    void finish();

    StudioController& studio_;
    bool isAutoStart_ = true;
    bool isPlaying_ = false;
    bool isToEnd_ = false;
    bool isWaiting_ = false;
    bool hasShownRegion_ = false;
    int speed_ = 0;
    Timer sincePlay_;
    Timer sinceBack_;   // the last generation taken back
    double played_ = 0; // generations in this run, by the clock's count
};

} // namespace vs::desktop
