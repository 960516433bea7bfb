// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <QWidget>

#include <cstdint>
#include <functional>
#include <vector>

namespace vs::desktop {

// A chart over intensities or gradient magnitudes: voxel counts as bars (all in a pale tone, those that can
// be seen in a full one), below them a strip of colours where there is one, and round numbers with the unit.
// The wheel goes closer, with Shift it moves along. What is drawn above the bars is up to its kinds.
class ChartWidget : public QWidget {
    Q_OBJECT

public:
    explicit ChartWidget(QWidget* parent = nullptr);

    // What the chart runs over; `unit` stands at its end, may be empty. Shows all of it.
    void setAxis(Range full, const QString& unit);
    // Equal bins over the whole axis.
    void setCounts(const std::vector<std::uint32_t>& counts);
    // What stands in the middle while there are no counts.
    void setEmptyText(const QString& text);
    // Sets how many of the counted voxels in each bin can be seen in the picture; empty: all of them.
    void setVisibleCounts(const std::vector<std::uint32_t>& counts);
    void setLogarithmic(bool isLogarithmic);
    [[nodiscard]] bool isLogarithmic() const { return isLogarithmic_; }
    // The strip: colour and opacity of a place of the axis; null: none.
    void setColourStrip(const std::function<QColor(double)>& colourAt);
    // Values are rounded to multiples of this (1 for whole numbers); 0: not at all.
    void setQuantum(double quantum) { quantum_ = quantum; }
    [[nodiscard]] double quantum() const { return quantum_; }

    [[nodiscard]] const Range& full() const { return full_; }
    [[nodiscard]] bool isEmpty() const { return counts_.empty(); }
    // Where a value of the axis is, in the widget's pixels, and back (rounded to the quantum).
    [[nodiscard]] double xOf(double value) const;
    [[nodiscard]] double valueAt(double x) const;
    // The area that the bars stand in, in the widget's pixels.
    [[nodiscard]] QRectF area() const;

    [[nodiscard]] QSize sizeHint() const override { return {260, 150}; }
    // The chart is never lower than this: what is under the pen must not move when rows around it come and
    // go.
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, sizeHint().height()}; }

signals:
    void zoomed();

protected:
    void wheelEvent(QWheelEvent* event) override;

    // What every chart paints, in this order, with a kind's own between: the frame, the bars (`emphasised` of
    // them in the accent colour), the axis.
    void paintFrame(QPainter& painter) const;
    void paintBars(QPainter& painter, const Range* emphasised) const;
    // Bars of a part of the counts, over the others; nothing if there are not as many.
    void paintPart(QPainter& painter, const std::vector<std::uint32_t>& counts, const QColor& colour) const;
    void paintAxis(QPainter& painter) const;
    // A word in an upper corner.
    void paintNote(QPainter& painter, Qt::AlignmentFlag side, const QString& text) const;
    [[nodiscard]] const Range& shown() const { return shown_; }
    // The least by which keys move a value: one bin, or one quantum.
    [[nodiscard]] double smallestStep() const;

private:
    [[nodiscard]] QPainterPath bars(const std::vector<std::uint32_t>& counts) const;
    void paintStrip(QPainter& painter, const QRectF& strip) const;

    Range full_{0, 1};
    Range shown_{0, 1};
    QString unit_;
    QString emptyText_ = tr("No volume");
    double quantum_ = 0;
    bool isLogarithmic_ = true;
    std::vector<std::uint32_t> counts_;
    std::vector<std::uint32_t> visible_;
    std::function<QColor(double)> colourAt_;
};

} // namespace vs::desktop
