// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPainterPath>
#include <QPointF>

namespace vs::desktop {

// One report of mouse or pen: where in the view (logical pixels, centres of pixels) and how hard.
struct Pen {
    QPointF position;
    double pressure = 1; // the tablet's, or what the pressure slider says for a mouse
};

// What a tool wants painted over the picture, in logical pixels of the view.
struct Overlay {
    enum class Tint { Pen, Idle, Cutting, Seed };
    QPainterPath path;
    Tint tint = Tint::Pen;
    bool isFilled = false;
    double width = 2;
};

// What the left button or the pen does. Models, not widgets: the view reports to the current tool, asks it
// for overlay, hint and cursor, and knows nothing else about it.
class Tool : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] virtual QString name() const = 0;
    // What to do next, for the line below the picture.
    [[nodiscard]] virtual QString hint() const = 0;
    [[nodiscard]] virtual Overlay overlay() const { return {}; }
    [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::CrossCursor; }

    virtual void press(const Pen& pen) = 0;
    virtual void move(const Pen& pen) = 0;
    virtual void release(const Pen& pen) = 0;
    virtual void hover(const Pen&) {}
    virtual void leave() {}
    // Escape or Clear: drops what is in hand, or else the sketch.
    virtual void clear() {}
    // The view's size changed, so places in it mean something else.
    virtual void viewResized() {}
    // Called between pictures: the time to change the document with what the pen has done since.
    virtual void advance() {}
    // A button is down, or work is left for advance().
    [[nodiscard]] virtual bool isBusy() const { return false; }
    // The picture must hold still while the pen draws on it.
    [[nodiscard]] virtual bool isSketching() const { return false; }

signals:
    void overlayChanged(); // and the hint and the cursor with it
};

} // namespace vs::desktop
