// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace vs::desktop {

class StudioController;

// Looks around by keys while the 3D view has the keyboard: arrow keys turn, with Shift they move the picture,
// with Ctrl left and right roll it; + and - zoom. The widget owns it.
class CameraKeys : public QObject {
    Q_OBJECT

public:
    CameraKeys(QWidget& view, StudioController& studio);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool press(const QKeyEvent& event);

    StudioController& studio_;
};

} // namespace vs::desktop
