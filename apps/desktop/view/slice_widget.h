// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/slice_canvas.h"

#include <QWidget>

class QLabel;
class QSlider;
class QToolButton;

namespace vs::desktop {

class ToolBox;
// A slice with its name in its colour, a slider through all slices, and where it lies.
class SliceWidget : public QWidget {
    Q_OBJECT

public:
    SliceWidget(StudioController& studio, ToolBox& tools, render::SliceKind kind, QWidget* parent = nullptr);

    [[nodiscard]] render::SliceKind kind() const { return kind_; }
    [[nodiscard]] const SliceCanvas& canvas() const { return *canvas_; }
    // What the button at the right says: whether the slice is large now.
    void setLarge(bool isLarge);

signals:
    void penMoved();
    void enlargeRequested();

private:
    QWidget* makeHeader();
    void refresh();

    StudioController& studio_;
    SliceController& slices_;
    render::SliceKind kind_;
    SliceCanvas* canvas_;
    QSlider* slider_ = nullptr;
    QLabel* place_ = nullptr;
    QToolButton* enlarge_ = nullptr;
};

} // namespace vs::desktop
