// SPDX-License-Identifier: Apache-2.0
#include "parts/theme.h"

#include "model/settings/preferences.h"

#include "base/check.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

#include <initializer_list>
#include <map>

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
QToolButton:checked { background: #1d4259; border-color: #56b4e9; color: #f7fbfe; }
QToolButton:focus { border-color: #56b4e9; }
QToolButton[choice="true"] { background: #1f2327; border: 1px solid #3a4047; padding: 3px 4px; }
QToolButton[choice="true"]:hover { background: #333940; }
QToolButton[choice="true"]:focus { border-color: #56b4e9; }
QToolButton[choice="true"]:checked { background: #1d4259; border-color: #56b4e9; }
QToolButton[fold="true"] { font-weight: 600; padding: 4px 4px; }
QToolButton[fold="true"]:checked { background: transparent; border-color: transparent; }
QToolButton[fold="true"]:hover { background: #333940; }
QToolButton[fold="true"]:focus { border-color: #56b4e9; }
QToolButton:checked:focus, QToolButton[choice="true"]:checked:focus { border-color: #f7fbfe; }
QTableView { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; selection-background-color: #1d4259;
    selection-color: #f7fbfe; outline: 0; }
QTableView:focus { border-color: #56b4e9; }
QTableView::item { padding: 0 4px; }
QTableView::item:focus { border: 1px solid #56b4e9; }
QComboBox { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; padding: 3px 6px; }
QComboBox:focus { border-color: #56b4e9; }
QComboBox::drop-down { border: 0; width: 20px; }
QComboBox::down-arrow { image: url(:/pictures/down-dark.svg); width: 12px; height: 12px; }
QCheckBox::indicator, QListView::indicator { width: 13px; height: 13px; border: 1px solid #7d868f; border-radius: 3px; background: #181b1e; }
QCheckBox::indicator:checked, QListView::indicator:checked { background: #1f6f9c; border-color: #2c86b8; image: url(:/pictures/check.svg); }
QCheckBox::indicator:disabled { border-color: #3a4047; }
QCheckBox::indicator:focus { border-color: #56b4e9; }
QComboBox:disabled { color: #5f6770; }
QComboBox QAbstractItemView { background: #262a2f; border: 1px solid #3a4047; selection-background-color: #1d4259;
    selection-color: #f7fbfe; }
QToolButton[column="true"] { padding: 3px 1px 2px 1px; font-size: 11px; }
QToolButton[slim="true"] { background: #1f2327; border: 1px solid #3a4047; padding: 0px 8px; }
QToolButton[slim="true"]:hover { background: #333940; }
QToolButton[badge="true"] { color: #e69f00; border-color: #e69f00; padding: 0px 8px; }
QToolButton[badge="true"]:hover { background: #333940; }
QToolButton:disabled { color: #5f6770; }
QToolButton:checked:disabled { color: #5f6770; background: #2b3036; border-color: #3a4047; }
QMenuBar { background: #1f2226; padding: 1px 4px; }
QMenuBar::item { padding: 4px 9px; border-radius: 4px; background: transparent; }
QMenuBar::item:selected { background: #333940; color: #e3e6ea; }
QMenu { background: #262a2f; border: 1px solid #3a4047; padding: 4px; }
QMenu::item { padding: 5px 26px 5px 12px; border-radius: 4px; }
QMenu::item:selected { background: #1d4259; color: #f7fbfe; }
QMenu::item:disabled { color: #5f6770; }
QMenu::separator { height: 1px; background: #3a4047; margin: 4px 6px; }
QMenu::icon { padding-left: 8px; }
QDockWidget { color: #e3e6ea; titlebar-close-icon: url(:/pictures/close-dark.svg);
    titlebar-normal-icon: url(:/pictures/float-dark.svg); }
QDockWidget::close-button, QDockWidget::float-button { border: 1px solid transparent; border-radius: 4px; padding: 1px; }
QDockWidget::close-button:hover, QDockWidget::float-button:hover { background: #333940; }
QFrame#card { background: #262a2f; border: 1px solid #31363c; border-radius: 7px; }
QLabel#cardTitle { color: #e3e6ea; font-weight: 600; }
QLabel#sectionTitle { color: #e3e6ea; font-weight: 600; font-size: 15px; }
QToolButton[onPicture="true"] { background: #262a2f; border: 1px solid #3a4047; padding: 1px; }
QToolButton[onPicture="true"]:hover { background: #333940; }
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
QPushButton[primary="true"] { background: #1f6f9c; border-color: #2c86b8; color: #ffffff; font-weight: 600; }
QPushButton[primary="true"]:hover { background: #2880b1; }
QFrame#recovery { background: #262a2f; border: 1px solid #e69f00; border-radius: 7px; }
QPushButton#openButton:hover { background: #2880b1; }
QSpinBox, QDoubleSpinBox, QLineEdit { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; padding: 3px 5px;
    selection-background-color: #1f6f9c; }
QSpinBox:focus, QDoubleSpinBox:focus, QLineEdit:focus { border-color: #56b4e9; }
QSpinBox:disabled, QDoubleSpinBox:disabled { color: #5f6770; }
QSlider:horizontal { min-height: 18px; }
QSlider::groove:horizontal { height: 4px; background: #16191c; border-radius: 2px; }
QSlider::sub-page:horizontal { background: #56b4e9; border-radius: 2px; }
QSlider::handle:horizontal { width: 14px; margin: -5px 0; border-radius: 7px; background: #e3e6ea; }
QSlider::handle:horizontal:focus { background: #56b4e9; }
QSlider::handle:horizontal:hover { background: #ffffff; }
QScrollBar:vertical { background: transparent; width: 8px; margin: 0; }
QScrollBar::handle:vertical { background: #434a52; border-radius: 4px; min-height: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; width: 0; }
QScrollArea#exportList { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; padding: 1px; }
QScrollArea#exportList > QWidget > QWidget { background: #181b1e; }
QTreeView, QListView { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; outline: 0; }
QTreeView::item, QListView::item { padding: 4px 6px; border: 0; }
QTreeView::item:selected, QListView::item:selected { background: #1d4259; color: #f7fbfe; }
QHeaderView::section { background: #262a2f; color: #9aa3ad; border: 0; border-bottom: 1px solid #3a4047; padding: 5px 6px; }
QLabel[keyCap="true"] { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; padding: 1px 7px; font-weight: 600; }
QDockWidget::title { background: #262a2f; padding: 5px 8px; border-bottom: 1px solid #3a4047; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QStatusBar { background: #1f2226; color: #e3e6ea; }
QStatusBar::item { border: 0; }
QProgressBar { background: #181b1e; border: 1px solid #3a4047; border-radius: 4px; text-align: center; }
QProgressBar::chunk { background: #1f6f9c; border-radius: 3px; }
)";

// What each colour of the sheet is in the light theme; those that are not here stay.
const std::map<QString, const char*> kLightInstead{
    {"#1f2226", "#e8ebee"}, {"#262a2f", "#f4f6f8"}, {"#181b1e", "#ffffff"}, {"#3a4047", "#c5ccd3"},
    {"#31363c", "#d3d9df"}, {"#e3e6ea", "#1f262c"}, {"#9aa3ad", "#58636d"}, {"#5f6770", "#99a3ac"},
    {"#56b4e9", "#0072b2"}, {"#2f343a", "#ffffff"}, {"#4a525a", "#b3bcc4"}, {"#333940", "#dfe5ea"},
    {"#1b3a4d", "#b5d8ee"}, {"#1d4259", "#cbe5f6"}, {"#f7fbfe", "#0d2433"}, {"#1f2327", "#ffffff"},
    {"#2b3036", "#e1e6ea"}, {"#434a52", "#bcc5cd"}, {"#3c434b", "#d5dce2"}, {"#2a2e33", "#e9edf0"},
    {"#34393f", "#d8dee3"}, {"#16191c", "#c9d1d8"}, {"#e69f00", "#8a5c00"}};

QString lightened(QString sheet) {
    // In one go over the text: a light colour of one may be the dark colour of another.
    QString result;
    for (int at = 0; at < sheet.size();) {
        const auto found = sheet[at] == '#' ? kLightInstead.find(sheet.mid(at, 7)) : kLightInstead.end();
        result += found != kLightInstead.end() ? QString(found->second) : QString(sheet[at]);
        at += found != kLightInstead.end() ? 7 : 1;
    }
    return result;
}

void setColours(bool isLight) {
    struct Pair {
        QColor& colour;
        const char* dark;
    };
    for (const Pair& pair : std::initializer_list<Pair>{{theme::kWindow, "#1f2226"},
                                                        {theme::kPanel, "#262a2f"},
                                                        {theme::kField, "#181b1e"},
                                                        {theme::kLine, "#3a4047"},
                                                        {theme::kText, "#e3e6ea"},
                                                        {theme::kQuiet, "#9aa3ad"},
                                                        {theme::kDisabled, "#5f6770"},
                                                        {theme::kAccent, "#56b4e9"}}) {
        pair.colour = QColor(isLight ? kLightInstead.at(pair.dark) : pair.dark);
    }
}

QPalette paletteOf() {
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
    return palette;
}

struct State {
    Theme theme;
    bool isDesktopLight;
    bool isLight;
};
std::optional<State> state; // nothing: before this program has chosen colours of its own

bool arePlainColoursLight() { return QApplication::palette().color(QPalette::Window).lightness() >= 128; }

void colour(QApplication& application, bool isLight) {
    setColours(isLight);
    application.setStyle(QStyleFactory::create("Fusion"));
    application.setPalette(paletteOf());
    application.setStyleSheet(isLight ? lightened(QString(kStyleSheet).replace("-dark.svg", "-light.svg"))
                                      : QString(kStyleSheet));
}

} // namespace

void applyTheme(QApplication& application, Theme theme) {
    const bool isDesktopNowLight = state ? state->isDesktopLight : arePlainColoursLight();
    const bool isLight = theme == Theme::Light || (theme == Theme::Desktop && isDesktopNowLight);
    if (!state || state->isLight != isLight) {
        colour(application, isLight);
    }
    state = State{theme, isDesktopNowLight, isLight};
}

void setDesktopTheme(QApplication& application, std::optional<bool> isLight) {
    VS_CHECK(state.has_value());
    if (!isLight) {
        application.setPalette(QPalette()); // what is left are the desktop's
        isLight = arePlainColoursLight();
        application.setPalette(paletteOf());
    }
    state->isDesktopLight = *isLight;
    applyTheme(application, state->theme);
}

bool isDesktopLight() { return state && state->isDesktopLight; }

} // namespace vs::desktop
