// SPDX-License-Identifier: Apache-2.0
#include "theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace vs::desktop {

namespace {

const char* const kStyleSheet = R"(
QToolTip { color: #e3e6ea; background: #2f343a; border: 1px solid #4a525a; padding: 4px; }
QMainWindow::separator { background: #1f2226; width: 4px; height: 4px; }
QToolBar { background: #262a2f; border: 0; padding: 3px 4px; spacing: 1px; }
QToolBar::separator { background: #3a4047; width: 1px; height: 1px; margin: 5px 5px; }
QToolButton { color: #e3e6ea; background: transparent; border: 1px solid transparent; border-radius: 5px; padding: 3px 5px; }
QToolButton:hover { background: #333940; }
QToolButton:pressed { background: #1b3a4d; }
QToolButton:checked { background: #1d4259; border-color: #56b4e9; color: #ffffff; }
QToolButton:focus { border-color: #56b4e9; }
QToolButton[choice="true"] { background: #1f2327; border: 1px solid #3a4047; padding: 3px 4px; }
QToolButton[choice="true"]:hover { background: #333940; }
QToolButton[choice="true"]:checked { background: #1d4259; border-color: #56b4e9; }
QToolButton[fold="true"] { font-weight: 600; padding: 4px 4px; }
QToolButton[fold="true"]:checked { background: transparent; border-color: transparent; }
QToolButton[fold="true"]:hover { background: #333940; }
QToolButton[fold="true"]:focus { border-color: #56b4e9; }
QTableView { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; selection-background-color: #1d4259;
    selection-color: #ffffff; outline: 0; }
QTableView:focus { border-color: #56b4e9; }
QTableView::item { padding: 0 4px; }
QTableView::item:focus { border: 1px solid #56b4e9; }
QComboBox { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; padding: 3px 6px; }
QComboBox:focus { border-color: #56b4e9; }
QComboBox:disabled { color: #5f6770; }
QComboBox QAbstractItemView { background: #262a2f; border: 1px solid #3a4047; selection-background-color: #1d4259; }
QToolButton[column="true"] { padding: 3px 1px 2px 1px; font-size: 11px; }
QToolButton:disabled { color: #5f6770; }
QToolButton:checked:disabled { color: #5f6770; background: #2b3036; border-color: #3a4047; }
QMenuBar { background: #1f2226; padding: 1px 4px; }
QMenuBar::item { padding: 4px 9px; border-radius: 4px; background: transparent; }
QMenuBar::item:selected { background: #333940; }
QMenu { background: #262a2f; border: 1px solid #3a4047; padding: 4px; }
QMenu::item { padding: 5px 26px 5px 12px; border-radius: 4px; }
QMenu::item:selected { background: #1d4259; }
QMenu::item:disabled { color: #5f6770; }
QMenu::separator { height: 1px; background: #3a4047; margin: 4px 6px; }
QMenu::icon { padding-left: 8px; }
QDockWidget { color: #e3e6ea; }
QFrame#card { background: #262a2f; border: 1px solid #31363c; border-radius: 7px; }
QLabel#cardTitle { color: #e3e6ea; font-weight: 600; }
QFrame[separator="true"] { color: #3a4047; }
QLabel#cardTitle[restores="true"] { color: #56b4e9; }
QLabel[quiet="true"] { color: #9aa3ad; }
QLabel#hint { background: #262a2f; color: #e3e6ea; padding: 6px 12px; border-top: 1px solid #31363c; }
QPushButton { background: #333940; border: 1px solid #434a52; border-radius: 5px; padding: 5px 12px; }
QPushButton:hover { background: #3c434b; }
QPushButton:pressed { background: #1b3a4d; }
QPushButton:focus { border-color: #56b4e9; }
QPushButton:disabled { color: #5f6770; background: #2a2e33; border-color: #34393f; }
QPushButton#openButton { background: #1f6f9c; border-color: #2c86b8; color: #ffffff; font-weight: 600; padding: 9px 26px; }
QPushButton#openButton:hover { background: #2880b1; }
QSpinBox, QDoubleSpinBox, QLineEdit { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; padding: 3px 5px;
    selection-background-color: #1f6f9c; }
QSpinBox:focus, QDoubleSpinBox:focus, QLineEdit:focus { border-color: #56b4e9; }
QSpinBox:disabled, QDoubleSpinBox:disabled { color: #5f6770; }
QSlider::groove:horizontal { height: 4px; background: #181b1e; border-radius: 2px; }
QSlider::sub-page:horizontal { background: #56b4e9; border-radius: 2px; }
QSlider::handle:horizontal { width: 14px; margin: -5px 0; border-radius: 7px; background: #e3e6ea; }
QSlider::handle:horizontal:hover { background: #ffffff; }
QScrollBar:vertical { background: transparent; width: 8px; margin: 0; }
QScrollBar::handle:vertical { background: #434a52; border-radius: 4px; min-height: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; width: 0; }
QStatusBar { background: #1f2226; color: #e3e6ea; }
QStatusBar::item { border: 0; }
QProgressBar { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; text-align: center; }
QProgressBar::chunk { background: #1f6f9c; border-radius: 3px; }
)";

} // namespace

void applyTheme(QApplication& application) {
    application.setStyle(QStyleFactory::create("Fusion"));
    QPalette palette;
    palette.setColor(QPalette::Window, theme::kWindow);
    palette.setColor(QPalette::WindowText, theme::kText);
    palette.setColor(QPalette::Base, theme::kField);
    palette.setColor(QPalette::AlternateBase, theme::kPanel);
    palette.setColor(QPalette::Text, theme::kText);
    palette.setColor(QPalette::PlaceholderText, theme::kQuiet);
    palette.setColor(QPalette::Button, theme::kPanel);
    palette.setColor(QPalette::ButtonText, theme::kText);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::ToolTipBase, theme::kPanel);
    palette.setColor(QPalette::ToolTipText, theme::kText);
    palette.setColor(QPalette::Highlight, QColor(0x1f, 0x6f, 0x9c));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, theme::kAccent);
    palette.setColor(QPalette::Light, theme::kLine);
    palette.setColor(QPalette::Mid, theme::kLine);
    palette.setColor(QPalette::Dark, theme::kField);
    palette.setColor(QPalette::Shadow, Qt::black);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, theme::kDisabled);
    }
    application.setPalette(palette);
    application.setStyleSheet(kStyleSheet);
}

} // namespace vs::desktop
