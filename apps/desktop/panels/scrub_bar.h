// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSlider>

#include <vector>

namespace vs::desktop {

// A slider over the generations: a press anywhere takes the handle there, and dragging goes on from there.
// Marks at some of them draw a pointer nearby to themselves.
class ScrubBar : public QSlider {
    Q_OBJECT

public:
    explicit ScrubBar(QWidget* parent = nullptr);
    void setMarks(const std::vector<int>& marks);

signals:
    void scrubbed(int generation); // by the person
    void released();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override; // scrolls the panel

private:
    [[nodiscard]] int valueAt(double x) const;
    [[nodiscard]] int placeOf(int generation) const;

    std::vector<int> marks_;
};

} // namespace vs::desktop
