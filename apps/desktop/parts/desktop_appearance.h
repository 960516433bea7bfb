// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDBusMessage>
#include <QObject>
#include <QTimer>
#include <QVariant>

#include <optional>

class QApplication;

namespace vs::desktop {

// Hears from the desktop whether its windows are dark or light, while the program runs: asks its portal
// (org.freedesktop.portal.Settings) without waiting for it, and listens to it and to Qt.
class DesktopAppearance : public QObject {
    Q_OBJECT

public:
    explicit DesktopAppearance(QApplication& application);

signals:
    // The desktop's windows are light or dark from now on. Nothing: there is no portal, or it has no
    // preference; the colours that Qt takes from the desktop count.
    void changed(std::optional<bool> isLight);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private slots:
    // The portal's signal.
    void hear(const QDBusMessage& change);

private:
    void ask();
    void take(QVariant colourScheme);

    std::optional<bool> isPortalLight_; // nothing: the portal has not said
    QTimer calm_; // news come in bursts; and no widget may look at a document that is elsewhere (LongWork)
};

} // namespace vs::desktop
