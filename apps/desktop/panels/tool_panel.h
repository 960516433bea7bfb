// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include <map>

class QLabel;
class QVBoxLayout;

namespace vs::desktop {

class StudioController;
class ToolBox;
class Tool;

// Settings of the current tool.
class ToolPanel : public QWidget {
    Q_OBJECT

public:
    ToolPanel(StudioController& studio, ToolBox& tools, QWidget* parent = nullptr);

private:
    struct Page {
        QString title;
        QWidget* widget = nullptr;
    };

    void refresh();

    StudioController& studio_;
    QVBoxLayout* pagesBelow_;
    std::map<const Tool*, Page> pages_;
    QWidget* shown_ = nullptr;
    QWidget* pressure_;
    QLabel* title_;
};

} // namespace vs::desktop
