// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSlider>

namespace vs::desktop {

// A slider over the generations: a press anywhere takes the handle there, and dragging goes on from there.
class ScrubBar : public QSlider {
    Q_OBJECT

public:
    explicit ScrubBar(QWidget* parent = nullptr);

signals:
    void scrubbed(int generation); // by the person
    void released();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override; // scrolls the panel

private:
    [[nodiscard]] int valueAt(double x) const;
};

} // namespace vs::desktop
