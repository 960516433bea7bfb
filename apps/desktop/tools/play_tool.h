// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/studio_tool.h"
#include "tools/playing/act.h"

#include "base/timer.h"
#include "studio/cases/steps.h"

#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace vs::desktop {

class CameraTool;

// Plays a session before one's eyes, step by step: strokes are drawn as they were, regions grow. In hand as
// long as it plays; what a person presses pauses it, and dragging turns the picture. Another tool can be
// taken at any time; an edit made by hand ends it, and what was played so far stays.
class PlayTool : public StudioTool {
    Q_OBJECT

public:
    PlayTool(StudioController& studio, CameraTool& camera);

    [[nodiscard]] QString name() const override { return "play"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Overlays overlays() const override;
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::OpenHandCursor; }
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void clear() override;
    void finishPending() override;
    void advance() override;
    [[nodiscard]] bool isBusy() const override { return isRunning_ || target_.has_value(); }

    // Whether there is something to play, or to go through.
    [[nodiscard]] bool hasSession() const { return !steps_.empty(); }
    [[nodiscard]] const std::vector<studio::Step>& steps() const { return steps_; }
    // The step that is being played, or comes next; as many as there are once all are done.
    [[nodiscard]] std::size_t step() const;
    // Whether some of that step has been done.
    [[nodiscard]] bool isWithinStep() const;
    [[nodiscard]] bool isRunning() const { return isRunning_; }
    [[nodiscard]] bool isAtEnd() const { return done_ == operations_.size(); }

    void play();
    void pause();
    // Goes to where a step begins, without playing what lies between: forward, or back by undo.
    void goTo(std::size_t step);
    // Plays one step and pauses.
    void playStep();
    // Ends it; what was played so far stays as it is.
    void goOnByHand();
    // 1: as a person would; 2: twice as fast.
    [[nodiscard]] double speed() const { return speed_; }
    void setSpeed(double speed) { speed_ = speed; }

signals:
    void changed();

private:
    // What there was before an operation, to go back to.
    struct Before {
        std::size_t edits = 0; // steps of the history
        studio::View view;
    };

    void take(const std::vector<studio::Operation>& operations);
    void run();
    void stop();
    void begin();
    bool act(const std::function<Act::State()>& work);
    void stopHere();
    bool finish(Act::State state);
    void jump();
    void goBack(std::size_t operation);
    void noticeHand();

    CameraTool& camera_;
    std::vector<studio::Operation> operations_;
    std::vector<studio::Step> steps_;
    std::vector<Before> before_; // of each operation that was done
    std::size_t done_ = 0;       // operations
    std::unique_ptr<Act> act_;   // of the next one, once it has begun
    double played_ = 0;          // seconds of it
    double lastMs_ = 0;          // Timer::now() when it was last advanced
    bool isRunning_ = false;
    bool isActing_ = false;             // what is done now, the act does
    std::optional<std::size_t> end_;    // operation before which it pauses
    std::optional<std::size_t> target_; // operation that is gone to
    std::uint64_t revision_ = 0;        // of the history, as playing left it
    double speed_ = 1;
    QTimer beat_;
};

} // namespace vs::desktop
