// SPDX-License-Identifier: Apache-2.0
#include "panels/history_panel.h"
#include "panels/tool_rows.h"
#include "parts/panel_parts.h"
#include "window/action_table.h"
#include "window/main_window.h"
#include "window/tool_column.h"

#include <QDockWidget>
#include <QMenuBar>
#include <QResizeEvent>
#include <QScrollArea>
#include <QToolBar>
#include <QToolButton>

#include <map>

namespace vs::desktop {

// The names of the tools' actions, of the reversed sign after those that cut, and of the shapes.
std::vector<std::string> MainWindow::toolNames() {
    std::vector<std::string> names;
    auto group = ToolRow::Group::Views;
    for (const ToolRow& row : toolRows(tools_)) {
        if (row.group != group) {
            if (group == ToolRow::Group::Cuts) {
                names.emplace_back("restore");
            }
            names.emplace_back("-");
            group = row.group;
        }
        names.push_back(row.actionName());
    }
    for (const char* name : {"-", "freeForm", "ellipse", "circle", "rectangle", "polyline", "stencil"}) {
        names.emplace_back(name);
    }
    return names;
}

void MainWindow::makeMenus() {
    const auto menu = [this](const QString& title, const std::vector<std::string>& names) {
        auto* list = menuBar()->addMenu(title);
        for (const std::string& name : names) {
            if (name == "-") {
                list->addSeparator();
            } else {
                list->QWidget::addAction(actions_->find(name));
            }
        }
    };
    menu(tr("&File"), {"open",
                       "playFile",
                       "openFolder",
                       "newBlock",
                       "openLabels",
                       "startScreen",
                       "-",
                       "playAgain",
                       "playOrPause",
                       "-",
                       "saveSession",
                       "saveSessionAs",
                       "exportLabels",
                       "export",
                       "screenshot",
                       "exportPicture",
                       "film",
                       "copyPicture",
                       "-",
                       "properties",
                       "-",
                       "quit"});
    menu(tr("&Edit"), {"undo", "redo", "showHistory", "addNote", "-", "paste", "pasteAll", "pullOut",
                       "moveTool", "-", "unCut", "reSeed", "-", "clearSketch", "-", "preferences"});
    menu(tr("&View"), {"resetView",
                       "fitView",
                       "-",
                       "mode.surface",
                       "mode.mip",
                       "mode.xray",
                       "mode.overlay",
                       "mode.segment",
                       "mode.volume",
                       "-",
                       "viewCut",
                       "viewProbe",
                       "viewWhole",
                       "-",
                       "hideAbove",
                       "tintSegments",
                       "voxelSegments",
                       "invert",
                       "-",
                       "smoothSampling",
                       "shadows",
                       "annotations"});
    makeCameraMenu();
    makeSliceMenu();
    makeColourMenu();
    menu(tr("&Tools"), toolNames());
    menu(tr("&Segmentation"),
         {"addSegment", "islandTool", "paintTool", "-", "playPause", "growStopKey", "growBackwardKey",
          "growStepKey", "growBackKey", "growToEndKey", "beforeLeak"});
    menu(tr("&Help"), {"shortcuts", "about"});
}

void MainWindow::makeToolBars() {
    bar_ = addToolBar(tr("File, view and mode"));
    bar_->setObjectName("mainBar");
    bar_->setAccessibleName(bar_->windowTitle());
    bar_->setMovable(false);
    bar_->setIconSize(QSize(22, 22));
    for (const char* name : {"open",         "openFolder",  "startScreen", "saveSession",
                             "exportLabels", "screenshot",  "-",           "undo",
                             "redo",         "-",           "resetView",   "-",
                             "mode.surface", "mode.mip",    "mode.xray",   "mode.overlay",
                             "mode.segment", "mode.volume", "-",           "viewCut",
                             "viewProbe",    "viewWhole",   "-",           "slices"}) {
        if (*name == '-') {
            bar_->addSeparator();
            continue;
        }
        QAction* const shown = actions_->find(name);
        bar_->QWidget::addAction(shown);
        auto* button = qobject_cast<QToolButton*>(bar_->widgetForAction(shown));
        button->setObjectName(name);
        button->setAccessibleName(shown->text());
        button->setFocusPolicy(Qt::TabFocus);
    }
    fitToolBar(width());
}

// A window too narrow for the texts shows the icons alone, so that no button is lost.
void MainWindow::fitToolBar(int width) {
    const auto show = [this](Qt::ToolButtonStyle style, int leastWidth) {
        bar_->setToolButtonStyle(style);
        for (auto* button : bar_->findChildren<QToolButton*>()) {
            if (button->defaultAction() != nullptr) {
                button->setMinimumWidth(leastWidth);
            }
        }
        return bar_->sizeHint().width();
    };
    if (show(Qt::ToolButtonTextUnderIcon, 52) > width) {
        show(Qt::ToolButtonIconOnly, 34);
    }
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    fitToolBar(event->size().width());
}

void MainWindow::makeToolColumn() {
    auto* dock = named(new QDockWidget(tr("Tools and shapes")), "toolColumn", tr("Tools and shapes"));
    dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
    dock->setTitleBarWidget(new QWidget(dock)); // none
    auto* column = new ToolColumn;
    std::map<int, std::string> byPlace;
    for (const ToolRow& row : toolRows(tools_)) {
        if (row.button > 0) {
            byPlace[row.button] = row.actionName();
        }
    }
    for (const auto& [place, name] : byPlace) {
        column->add(actions_->find(name));
    }
    for (const char* name : {"restore", "-", "freeForm", "ellipse", "circle", "rectangle", "polyline",
                             "stencil", "clearSketch", "-", "paste", "moveTool", "-", "unCut", "reSeed"}) {
        if (*name == '-') {
            column->addSeparator();
        } else {
            column->add(actions_->find(name));
        }
    }
    auto* scroll = new QScrollArea; // small screens
    scroll->setWidget(column);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus); // Tab goes to what is in it
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFixedWidth(column->sizeHint().width() + 6);
    dock->setWidget(scroll);
    addDockWidget(Qt::RightDockWidgetArea, history_);
    splitDockWidget(history_, dock, Qt::Horizontal); // the tools stay at the window's border
    history_->hide();
}

} // namespace vs::desktop
