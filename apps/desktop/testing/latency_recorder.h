// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/watched_application.h"

#include <QObject>

#include <filesystem>
#include <vector>

namespace vs::desktop {

class StudioController;
class ViewWidget;

// Notes when each input arrived at the window system, when the program turned to it, and when the window
// first showed a picture that it had been reckoned into; when which picture was shown; and what kept the
// window from everything else for long. Writes a JSON object when the program ends: {"inputs": [{"kind",
// "arrived", "handled", "shown"}], "frames": [{"shown", "picture", "width", "isComplete"}], "blocks":
// [{"began", "ms", "threadMs", "programMs", "receiver", "event"}]}, with times in ms of the machine's steady
// clock, of which `threadMs` and `programMs` are processor time, pictures counted and `width` in the
// picture's own pixels.
class LatencyRecorder : public QObject {
    Q_OBJECT

public:
    LatencyRecorder(WatchedApplication& application, StudioController& studio, const ViewWidget& view,
                    std::filesystem::path path);
    ~LatencyRecorder() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Input {
        const char* kind;
        double arrivedMs;
        double handledMs;
        double shownMs; // 0: not yet
    };
    struct Frame {
        double shownMs;
        int picture;
        int width;
        bool isComplete;
    };

    void notePainted();
    void write() const;

    WatchedApplication& application_;
    StudioController& studio_;
    std::filesystem::path path_;
    std::vector<Input> inputs_;
    std::vector<Frame> frames_;
    std::vector<WatchedApplication::Busy> blocks_;
    std::size_t unanswered_ = 0; // the first input that was not shown
};

} // namespace vs::desktop
