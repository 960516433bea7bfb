// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "parts/chart_widget.h"

#include <QColor>

namespace vs::desktop {

// A histogram with a range as a band. Drag its two handles, or the band itself; the arrow keys move it by one
// bin, with Shift its upper end, with Ctrl its lower end only.
class HistogramView : public ChartWidget {
    Q_OBJECT

public:
    explicit HistogramView(QWidget* parent = nullptr);

    // `full` is what the bins cover.
    void setCounts(const std::vector<std::uint32_t>& counts, Range full, const QString& unit = {});
    void setRange(Range range);
    // Counts of a part of the voxels in as many bins, drawn over the others'; empty: none.
    void setPart(const std::vector<std::uint32_t>& counts, const QColor& colour);

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

    [[nodiscard]] Grip gripAt(double x) const;
    void drag(Grip grip, Range from, double by);

    std::vector<std::uint32_t> part_;
    QColor partColour_;
    Range range_{0, 1};
    Grip grip_ = Grip::None;
    double pressedValue_ = 0;
    Range pressedRange_;
};

} // namespace vs::desktop
