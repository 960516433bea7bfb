// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/studio/studio_controller.h"
#include "tools/tool_box.h"
#include "window/main_window.h"

#include <QEvent>
#include <QPointingDevice>

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace vs::desktop {

// The real window on a display without a screen, and hands that Xvfb does not have: a tablet and fingers. One
// for all tests; open() begins anew.
class StudioWindow {
public:
    static StudioWindow& instance();
    // The folder of the running program's results, and a volume to work on (--volume).
    static std::filesystem::path folder;
    static std::filesystem::path volume;

    StudioController& studio() { return *studio_; }
    ToolBox& tools() { return *tools_; }
    MainWindow& window() { return *window_; }
    QWidget& view() { return part("view"); }
    // A widget by its name; fails the test, with an exception, when there is none.
    QWidget& part(const char* name);
    template <class Widget>
    Widget& part(const char* name) {
        return dynamic_cast<Widget&>(part(name));
    }

    // Opens the volume again, without edits, and waits for the picture; nothing is left of the test before.
    void open();
    void close(); // as long as the QApplication lives
    // Handles events until the condition holds; throws after a time that a shared machine needs at worst.
    static void wait(const char* what, const std::function<bool()>& condition);
    void settle(); // what was done is shown, though perhaps as a draft
    void rest();   // the program is idle: the picture is at full quality
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void trigger(const char* action);
    // A picture of what the widget shows now, to be looked at.
    void photograph(QWidget& widget, const std::string& name);

    // The pen's tip or its eraser end, at a place of a widget given in fractions of it.
    enum class End { Tip, Eraser };
    struct Touch {
        QPointF place;
        double pressure = 0;
        QPointF tilt = {};
    };
    void pen(QEvent::Type type, QWidget& widget, const Touch& touch, End end = End::Tip);
    // Presses at the first place, goes through the others, lifts at the last.
    void stroke(QWidget& widget, const std::vector<Touch>& way, End end = End::Tip);
    void leaveTablet(End end = End::Tip);
    // A closed square of the free-form pen around the middle.
    void drawMask(double halfWidth = 0.06);

    // Fingers, in logical pixels of a widget. Reports one step; no points: all are lifted.
    void fingers(QWidget& widget, const std::vector<QPointF>& places);

private:
    StudioWindow();

    std::unique_ptr<StudioController> studio_;
    ToolBox* tools_ = nullptr; // the studio owns it
    std::unique_ptr<MainWindow> window_;
    QPointingDevice tip_;
    QPointingDevice eraser_;
    QPointingDevice* screen_;
    std::vector<QPointF> down_; // fingers
};

} // namespace vs::desktop
