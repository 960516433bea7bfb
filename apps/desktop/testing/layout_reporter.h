// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testing/input_fence.h"

#include <nlohmann/json.hpp>

#include <QObject>
#include <QTimer>

#include <filesystem>

namespace vs::desktop {

class StudioController;
class ToolBox;
class ViewWidget;

// Writes where everything is and what the program is doing into a JSON file whenever that changes, so that
// scripts can find buttons, wait until the program is idle, and know which of their input it has answered
// (InputFence). Rectangles are [x, y, width, height] in pixels of the screen, as all layouts that are asked
// for will have them.
class LayoutReporter : public QObject {
    Q_OBJECT

public:
    LayoutReporter(StudioController& studio, ToolBox& tools, QWidget& window, const ViewWidget& view,
                   std::filesystem::path path);

private:
    void write();
    [[nodiscard]] nlohmann::json documentReport() const;
    [[nodiscard]] nlohmann::json zonesOnScreen() const;

    StudioController& studio_;
    ToolBox& tools_;
    QWidget& window_;
    const ViewWidget& view_;
    std::filesystem::path path_;
    InputFence fence_;
    QTimer timer_;
    nlohmann::json ofDocument_; // when it was last here
    std::string written_;
};

} // namespace vs::desktop
