// SPDX-License-Identifier: Apache-2.0
#include "parts/desktop_appearance.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusVariant>
#include <QEvent>
#include <QFileInfo>

namespace vs::desktop {

namespace {

const char* const kService = "org.freedesktop.portal.Desktop";
const char* const kPath = "/org/freedesktop/portal/desktop";
const char* const kInterface = "org.freedesktop.portal.Settings";
const char* const kGroup = "org.freedesktop.appearance";
const char* const kKey = "color-scheme";
constexpr uint kPrefersDark = 1;
constexpr uint kPrefersLight = 2;

// Without this, asking for a bus would start one.
bool hasSessionBus() {
    return !qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS") ||
           (!qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR") &&
            QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + "/bus"));
}

} // namespace

DesktopAppearance::DesktopAppearance(QApplication& application) {
    constexpr int kCalmMs = 20;
    calm_.setSingleShot(true);
    calm_.setInterval(kCalmMs);
    connect(&calm_, &QTimer::timeout, this, [this] { emit changed(isPortalLight_); });
    application.installEventFilter(this);
    if (hasSessionBus()) {
        ask();
    }
}

void DesktopAppearance::ask() {
    auto bus = QDBusConnection::sessionBus();
    if (!bus.isConnected()) {
        return;
    }
    // From whoever sends it: naming the sender would wait for the bus to say who that is.
    bus.connect({}, kPath, kInterface, "SettingChanged", this, SLOT(hear(QDBusMessage)));
    auto question = QDBusMessage::createMethodCall(kService, kPath, kInterface, "Read");
    question << kGroup << kKey;
    auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
    connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
        const auto values = answer->reply().arguments();
        if (!answer->isError() && values.size() == 1) {
            take(values.front());
        }
        answer->deleteLater();
    });
}

void DesktopAppearance::hear(const QDBusMessage& change) {
    const auto values = change.arguments(); // group, key, value
    if (values.size() == 3 && values[0] == kGroup && values[1] == kKey) {
        take(values[2]);
    }
}

void DesktopAppearance::take(QVariant colourScheme) {
    while (colourScheme.metaType() == QMetaType::fromType<QDBusVariant>()) { // two around what is read
        colourScheme = colourScheme.value<QDBusVariant>().variant();
    }
    const uint said = colourScheme.toUInt();
    isPortalLight_ = said == kPrefersDark    ? std::optional(false)
                     : said == kPrefersLight ? std::optional(true)
                                             : std::nullopt;
    calm_.start();
}

bool DesktopAppearance::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ThemeChange) { // Qt has taken the desktop's new colours
        calm_.start();
    }
    return QObject::eventFilter(watched, event);
}

} // namespace vs::desktop
