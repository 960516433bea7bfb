// SPDX-License-Identifier: Apache-2.0
// A desktop's portal for tests: answers what the desktop prefers, and tells when it changes. Reads a line at
// a time, and prints it when it is done:
//   scheme N        the colour scheme: 0 no preference, 1 dark, 2 light
//   grab FILE       a picture of the screen
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QGuiApplication>
#include <QPixmap>
#include <QScreen>
#include <QSocketNotifier>

#include <iostream>
#include <string>

namespace {

const QString kGroup = "org.freedesktop.appearance";
const QString kKey = "color-scheme";

class Portal : public QObject {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.portal.Settings")

public:
    void prefer(uint scheme) {
        scheme_ = scheme;
        emit SettingChanged("org.gnome.desktop.interface", kKey, QDBusVariant(QString("neither")));
        emit SettingChanged(kGroup, kKey, QDBusVariant(scheme_));
    }

public slots:
    // Wrapped twice, as the real one does.
    // NOLINTNEXTLINE(readability-identifier-naming): the names on the bus
    [[nodiscard]] QDBusVariant Read(const QString& group, const QString& key) const {
        const uint known = group == kGroup && key == kKey ? scheme_ : 0;
        return QDBusVariant(QVariant::fromValue(QDBusVariant(known)));
    }

signals:
    // NOLINTNEXTLINE(readability-identifier-naming): the names on the bus
    void SettingChanged(const QString& group, const QString& key, const QDBusVariant& value);

private:
    uint scheme_ = 0;
};

bool obey(Portal& portal, const std::string& line) {
    const std::string what = line.substr(0, line.find(' '));
    const std::string word = line.substr(std::min(what.size() + 1, line.size()));
    if (what == "scheme") {
        portal.prefer(uint(std::stoul(word)));
        return true;
    }
    return what == "grab" &&
           QGuiApplication::primaryScreen()->grabWindow(0).toImage().save(QString::fromStdString(word));
}

} // namespace

int main(int argc, char** argv) {
    QGuiApplication application(argc, argv);
    auto bus = QDBusConnection::sessionBus();
    qRegisterMetaType<QDBusVariant>("QDBusVariant"); // or the signal is not passed on
    Portal portal;
    if (!bus.registerObject("/org/freedesktop/portal/desktop", &portal,
                            QDBusConnection::ExportAllSlots | QDBusConnection::ExportAllSignals) ||
        !bus.registerService("org.freedesktop.portal.Desktop")) {
        std::cerr << "no session bus to be the portal of\n";
        return 1;
    }
    QSocketNotifier lines(0, QSocketNotifier::Read);
    QObject::connect(&lines, &QSocketNotifier::activated, &application, [&portal] {
        std::string line;
        if (!std::getline(std::cin, line) || !obey(portal, line)) {
            QGuiApplication::quit();
            return;
        }
        std::cout << line << std::endl;
    });
    std::cout << "ready" << std::endl;
    return QGuiApplication::exec();
}

#include "fake_portal.moc"
