// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/slice_widget.h"

#include <QPointer>
#include <QWidget>

#include <array>
#include <optional>

class QGridLayout;

namespace vs::desktop {

class StudioController;
class ToolBox;
class ViewWidget;

// The 3D view and the three slices, in one of a few arrangements.
class ViewGrid : public QWidget {
    Q_OBJECT

public:
    // Only3D; all four the same size; or one of the slices large and the rest in a column beside it.
    enum class Arrangement { Only3D, Four, Axial, Coronal, Sagittal };

    ViewGrid(StudioController& studio, ToolBox& tools, ViewWidget* view, QWidget* parent = nullptr);

    [[nodiscard]] Arrangement arrangement() const { return arrangement_; }
    void arrange(Arrangement arrangement);
    // One slice large, or all the same size again if it was.
    void enlarge(render::SliceKind kind);
    // What is offered where a slice is clicked on with the right button.
    void offerOnSlices(const QList<QAction*>& actions);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

signals:
    void arranged();
    // A pen is over a slice (mm on its picture), or has left it (nothing).
    void penMoved(render::SliceKind kind, std::optional<glm::dvec2> place);

private:
    ViewWidget* view_;
    std::array<SliceWidget*, 3> slices_{};
    QGridLayout* grid_;
    Arrangement arrangement_ = Arrangement::Only3D;
    QPointer<QWidget> framed_; // has the keyboard, which came by Tab
};

} // namespace vs::desktop
