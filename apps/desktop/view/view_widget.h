// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/annotation_overlay.h"
#include "view/orientation_cube.h"

#include <QElapsedTimer>
#include <QWidget>

#include <optional>

namespace vs::desktop {

class StudioController;
class ToolBox;
struct Pen;

// Shows the picture with annotations and the tool's overlay on top, and hands mouse, pen and wheel to the
// controllers. Middle button, right button, Shift+drag and the wheel look around whatever the tool is.
class ViewWidget : public QWidget {
    Q_OBJECT

public:
    ViewWidget(StudioController& studio, ToolBox& tools, QWidget* parent = nullptr);

    // Where the pen is, if it is over the view.
    [[nodiscard]] std::optional<QPointF> penPosition() const { return penPosition_; }
    // Whether scale bar and orientation marker are shown; they are at first.
    void setAnnotated(bool isAnnotated);
    [[nodiscard]] const OrientationCube& cube() const { return cube_; }

signals:
    void penMoved();
    void painted(); // and is on the screen by the next turn of the event loop

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    enum class Drag { None, Tool, Pan, Zoom, Cube };

    [[nodiscard]] glm::ivec2 deviceSize() const;
    [[nodiscard]] std::optional<QPointF> seenAt(glm::dvec3 world) const;
    [[nodiscard]] Pen penAt(QPointF inWindow, Qt::KeyboardModifiers modifiers) const;
    void press(const Pen& pen, Drag drag);
    bool pressOnCube(const Pen& pen);
    void pointAtCube(const std::optional<QPointF>& place);
    void showCursor();
    void move(const Pen& pen);
    void release(const Pen& pen);

    StudioController& studio_;
    ToolBox& tools_;
    AnnotationOverlay annotations_;
    OrientationCube cube_;
    bool isAnnotated_ = true;
    Drag drag_ = Drag::None;
    Qt::MouseButton button_ = Qt::NoButton; // that began the drag
    QPointF last_;
    QPointF pressed_;
    std::optional<QPointF> penPosition_;
};

} // namespace vs::desktop
