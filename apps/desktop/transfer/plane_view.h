// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "transfer/function_chart.h"

#include "field/gradient.h"

#include <QImage>

namespace vs::desktop {

// Intensity across, gradient magnitude upwards: voxels as a density picture, shapes with colour and opacity
// over it. Drag a shape or a corner; drag elsewhere to draw a new one, or paint; the right button removes
// (while painting: erases).
class PlaneView : public FunctionChart {
    Q_OBJECT

public:
    enum class Drawing { Box, Triangle, Paint };

    explicit PlaneView(FunctionEditor& editor);

    void setJoint(const field::JointHistogram& joint);
    void setDrawing(Drawing drawing) { drawing_ = drawing; }
    // Sets the radius of the brush, in pixels.
    void setBrush(double radius) { brush_ = radius; }
    void forgetJoint();

    void addPart() override;
    void removeChosen() override;

    [[nodiscard]] QSize sizeHint() const override { return {260, 176}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void changeEvent(QEvent* event) override;

    [[nodiscard]] std::size_t partCount() const override { return function().shapes.size(); }
    void moveChosen(glm::dvec2 steps) override;

private:
    enum class Grip { None, Corner, Shape, New, Brush };

    [[nodiscard]] glm::dvec2 valueOf(QPointF place) const; // intensity, magnitude
    [[nodiscard]] QPointF placeOf(glm::dvec2 value) const;
    [[nodiscard]] glm::dvec2 perPixel() const;
    [[nodiscard]] std::optional<std::size_t> cornerAt(QPointF place) const;
    [[nodiscard]] bool isPainting() const;
    void beginPainting();
    void paintTo(QPointF place);
    void drawNew(QPointF to);
    void makeDensity();
    void paintFunction(QPainter& painter) const;
    void paintOutlines(QPainter& painter) const;

    field::JointHistogram joint_;
    QImage density_;
    Drawing drawing_ = Drawing::Box;
    double brush_ = 10;
    Grip grip_ = Grip::None;
    bool erases_ = false;
    std::size_t corner_ = 0;
    QPointF pressed_;
    QPointF last_;
    render::TransferFunction before_; // when the drag began
};

} // namespace vs::desktop
