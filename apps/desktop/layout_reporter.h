// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <nlohmann/json.hpp>

#include <QObject>
#include <QTimer>

#include <filesystem>

namespace vs::desktop {

class MainWindow;
class StudioController;

// Writes where everything is and what the program is doing into a JSON file whenever that changes, so that
// scripts can find buttons and wait until the program is idle. Rectangles are [x, y, width, height] in pixels
// of the screen.
class LayoutReporter : public QObject {
    Q_OBJECT

public:
    LayoutReporter(StudioController& studio, MainWindow& window, std::filesystem::path path);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void write();
    [[nodiscard]] nlohmann::json documentReport() const;

    StudioController& studio_;
    MainWindow& window_;
    std::filesystem::path path_;
    QTimer timer_;
    nlohmann::json ofDocument_; // when it was last here
    std::string written_;
    int inputs_ = 0; // mouse buttons, wheel turns and keys that arrived
};

} // namespace vs::desktop
