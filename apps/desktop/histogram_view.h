// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <QColor>
#include <QPainterPath>
#include <QWidget>

#include <cstdint>
#include <vector>

namespace vs::desktop {

// Voxel counts over the intensities, on a logarithmic scale, with the displayed range as a band. Drag its two
// handles, or the band itself; the arrow keys move it by one bin, with Shift its upper end only.
class HistogramView : public QWidget {
    Q_OBJECT

public:
    explicit HistogramView(QWidget* parent = nullptr);

    // `full` is what the bins cover.
    void setCounts(const std::vector<std::uint32_t>& counts, Range full);
    void setRange(Range range);
    // Counts of a part of the voxels in as many bins, drawn over the others'; empty: none.
    void setPart(const std::vector<std::uint32_t>& counts, const QColor& colour);
    // Values are rounded to multiples of this (1 for whole numbers); 0: not at all.
    void setQuantum(double quantum) { quantum_ = quantum; }

    [[nodiscard]] QSize sizeHint() const override { return {260, 132}; }

signals:
    void rangeDragged(vs::Range range);
    void released(); // the pointer that dragged, or the key

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    enum class Grip { None, Lo, Hi, Band };

    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] QPainterPath barsOf(const std::vector<std::uint32_t>& counts) const;
    [[nodiscard]] double xOf(double value) const;
    [[nodiscard]] double valueAt(double x) const;
    [[nodiscard]] Grip gripAt(double x) const;
    void drag(Grip grip, Range from, double by);

    std::vector<std::uint32_t> counts_;
    std::vector<std::uint32_t> part_;
    QColor partColour_;
    Range full_{0, 1};
    Range range_{0, 1};
    double quantum_ = 0;
    Grip grip_ = Grip::None;
    double pressedValue_ = 0;
    Range pressedRange_;
};

} // namespace vs::desktop
