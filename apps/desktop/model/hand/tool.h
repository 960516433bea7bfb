// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPainterPath>
#include <QPointF>

#include <vector>

namespace vs::desktop {

// One report of mouse or pen: where in the view (logical pixels, centres of pixels) and how hard.
struct Pen {
    QPointF position;
    double pressure = 1;      // the tablet's, or what the pressure slider says for a mouse
    QPointF tiltDegrees = {}; // to the right and towards the person; a mouse stands upright
    bool isMouse = true;
    Qt::KeyboardModifiers modifiers = {};
    bool isDoubleClick = false; // pressed the second time within a moment, at the same place
};

// A line that a tool wants painted over the picture, in logical pixels of the view.
struct Overlay {
    // Idle and Cutting are what a mask looks like before and while it cuts, ReadyToRestore and Restoring what
    // it looks like with the sign reversed.
    enum class Tint { Pen, Idle, Cutting, ReadyToRestore, Restoring, Seed };
    static constexpr double kMaskFill = 0.14; // what is cut must be seen through it, in its own colours

    QPainterPath path;
    Tint tint = Tint::Pen;
    double fill = 0;  // its inside's opacity
    double width = 2; // 0: no line
};
using Overlays = std::vector<Overlay>;

// What the left button or the pen does. Models, not widgets: the view reports to the current tool, asks it
// for overlay, hint and cursor, and knows nothing else about it.
class Tool : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] virtual QString name() const = 0;
    // What to do next, for the line below the picture.
    [[nodiscard]] virtual QString hint() const = 0;
    [[nodiscard]] virtual Overlays overlays() const { return {}; }
    [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::CrossCursor; }

    // The hand has taken it: the time to get ready what its first stroke would wait for. And it has put it
    // down.
    virtual void taken() {}
    virtual void putDown() {}
    virtual void press(const Pen& pen) = 0;
    virtual void move(const Pen& pen) = 0;
    virtual void release(const Pen& pen) = 0;
    virtual void hover(const Pen&) {}
    virtual void leave() {}
    // A turn of the wheel (notches away from the person). True: the tool has taken it; else it zooms.
    virtual bool wheel(double, const Pen&) { return false; }
    // Whether Shift+drag is the tool's own, and does not move the picture.
    [[nodiscard]] virtual bool takesShift() const { return false; }
    // The sign reversed: the tool undoes what it else does (restores, absorbs, adds). Of tools that have one.
    [[nodiscard]] virtual bool hasSign() const { return false; }
    [[nodiscard]] virtual bool isReversed() const { return false; }
    virtual void setReversed(bool) {}
    // What it cuts is the segment at work, not the scan; and it adds to it.
    [[nodiscard]] virtual bool actsOnSegment() const { return false; }
    [[nodiscard]] virtual bool adds() const { return false; }
    // What it would cut is filled with material or, with its sign reversed, what is filled is taken away.
    [[nodiscard]] virtual bool actsOnMaterial() const { return false; }
    // Enter: does what has been prepared. False: nothing was.
    virtual bool accept() { return false; }
    // Tab: goes to the next thing that can be worked on, or to the one before. False: there is no other.
    virtual bool next(bool) { return false; }
    // Escape or Clear: drops what is in hand, or else the sketch.
    virtual void clear() {}
    // Something else is about to be done: what waits only for a moment of calm is done first.
    virtual void finishPending() {}
    // The view's size changed, so places in it mean something else.
    virtual void viewResized() {}
    // Called between pictures: the time to change the document with what the pen has done since.
    virtual void advance() {}
    // advance() has left some of what the pen did for its next call.
    [[nodiscard]] virtual bool isBehind() const { return false; }
    // A button is down, or work is left for advance().
    [[nodiscard]] virtual bool isBusy() const { return false; }
    // The picture must hold still while the pen draws on it.
    [[nodiscard]] virtual bool isSketching() const { return false; }

signals:
    void overlayChanged();  // and the hint and the cursor with it
    void settingsChanged(); // what is set for it: pages look again
};

} // namespace vs::desktop
