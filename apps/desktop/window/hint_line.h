// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace vs::desktop {

// The line of hints below the picture: two lines where it is narrow, whatever it says, so that a new hint
// never changes the picture's size.
class HintLine : public QLabel {
public:
    static constexpr int kRoomForHints =
        1000; // logical pixels: the longest hint of either language is so long

    HintLine();
    // Shows a hint, also as the line's tip, for the longest ones in the narrowest windows.
    void say(const QString& hint);

protected:
    void resizeEvent(QResizeEvent* event) override;
};

} // namespace vs::desktop
