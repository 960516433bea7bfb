// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/slice_pen.h"

#include <QColor>
#include <QWidget>

#include <optional>

namespace vs::desktop {

class MeasureTool;
class SliceController;
class StudioController;
class ToolBox;

// The colour of a kind of slice: of its frame, and of the lines that show it on the others.
QColor sliceColour(render::SliceKind kind);

// One slice: its picture, the lines of the two others, the patient's directions at the edges, the stroke in
// hand, the window. The wheel and Page Up and Down go from slice to slice, Ctrl+wheel zooms, the middle
// button moves, the right one leads the window (with Shift too where the pen has a use for it), with Ctrl it
// zooms, and a click of it offers windows. The left one is the pen's (SlicePen), as is a tablet, whose eraser
// takes away.
class SliceCanvas : public QWidget {
    Q_OBJECT

public:
    SliceCanvas(StudioController& studio, ToolBox& tools, render::SliceKind kind, QWidget* parent = nullptr);

    // What is under the pen, in mm on the picture; nothing when it is elsewhere.
    [[nodiscard]] std::optional<glm::dvec2> placeUnderPen() const;
    [[nodiscard]] render::SliceKind kind() const { return kind_; }
    // Where a place of the widget lies, in mm on the slice's picture.
    [[nodiscard]] glm::dvec2 placeAt(QPointF inWidget) const;

signals:
    void penMoved();
    void enlargeRequested(); // by a double click

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    enum class Drag { None, Pen, Pan, Zoom, Window };

    // A button's use where the pen has none for it.
    [[nodiscard]] static Drag dragOf(Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

    [[nodiscard]] QPointF placeInWidget(QPointF inWindow) const;
    void press(QPointF place, bool isReversed, Qt::KeyboardModifiers modifiers);
    void move(QPointF place);
    void release();
    [[nodiscard]] bool isDrag() const; // what was pressed has been moved since, and is no click
    [[nodiscard]] QPointF pointOf(glm::dvec2 place) const;
    void tellViewport();
    void moveCrosshair(int right, int down);
    void paintCrosshair(QPainter& painter) const;
    [[nodiscard]] bool isInterpolated() const;
    void paintInterpolated(QPainter& painter) const;
    void paintLetters(QPainter& painter) const;
    void paintWindow(QPainter& painter) const;
    void paintPen(QPainter& painter) const;
    void offerWindows();
    [[nodiscard]] std::optional<QPointF> seenAt(glm::dvec3 world) const;

    StudioController& studio_;
    SliceController& slices_;
    SlicePen& pen_;
    const MeasureTool& measureTool_;
    render::SliceKind kind_;
    Drag drag_ = Drag::None;
    Qt::MouseButton button_ = Qt::NoButton;
    QPointF last_;
    QPointF pressed_;
    Range pressedWindow_; // when it was pressed
    std::optional<QPointF> under_;
    double wheel_ = 0; // notches not used yet: of wheels finer than one
};

} // namespace vs::desktop
