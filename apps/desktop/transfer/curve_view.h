// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/colours/function_edits.h"
#include "transfer/function_chart.h"

namespace vs::desktop {

// Opacity and colour over intensity, or over gradient magnitude, on its histogram. A click adds a point, a
// drag moves it; dragging under the curve moves a whole hill; the right button removes.
class CurveView : public FunctionChart {
    Q_OBJECT

public:
    using FunctionChart::FunctionChart;

    void addPart() override;
    void removeChosen() override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

    [[nodiscard]] std::size_t partCount() const override { return function().points.size(); }
    void moveChosen(glm::dvec2 steps) override;

private:
    enum class Grip { None, Point, Hill };

    [[nodiscard]] QPointF placeOf(const render::ControlPoint& point) const;
    [[nodiscard]] double opacityAt(double y) const;
    [[nodiscard]] std::optional<std::size_t> pointAt(QPointF place) const;
    [[nodiscard]] std::optional<render::Hill> hillAt(QPointF place) const;
    void addAt(QPointF place);
    void dragHill(QPointF to);
    void paintCurve(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;

    Grip grip_ = Grip::None;
    bool hasMoved_ = false;
    QPointF pressed_;
    QPointF offset_; // from the pen to the point that is dragged
    render::Hill hill_;
    render::TransferFunction before_; // when the drag began
};

} // namespace vs::desktop
