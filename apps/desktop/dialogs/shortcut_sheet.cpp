// SPDX-License-Identifier: Apache-2.0
#include "dialogs/shortcut_sheet.h"

#include "model/texts/texts.h"
#include "parts/panel_parts.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <set>
#include <vector>

namespace vs::desktop {

namespace {

struct Row {
    QString text;
    QString keys;
    QString name; // of the action
    QString tip = {};
};

struct Group {
    QString title;
    std::vector<Row> rows;
};

Row rowOf(const QAction& action) {
    QStringList keys;
    for (const QKeySequence& key : action.shortcuts()) {
        keys << key.toString(QKeySequence::NativeText);
    }
    QString text = action.text().remove('&');
    return {text.remove("…"), keys.join("  "), action.objectName(), action.toolTip()};
}

// What a menu and the menus in it hold.
void collect(const QList<QAction*>& actions, Group& group, std::set<const QAction*>& seen) {
    for (const QAction* action : actions) {
        if (action->menu() != nullptr) {
            collect(action->menu()->actions(), group, seen);
        } else if (!action->shortcuts().isEmpty() && seen.insert(action).second) {
            group.rows.push_back(rowOf(*action));
        }
    }
}

std::vector<Group> groupsOf(const QMainWindow& window) {
    std::vector<Group> groups;
    std::set<const QAction*> seen;
    for (const QAction* menu : window.menuBar()->actions()) {
        Group group{QString(menu->text()).remove('&'), {}};
        if (menu->menu() != nullptr) {
            collect(menu->menu()->actions(), group, seen);
        }
        groups.push_back(group);
    }
    Group others{ShortcutSheet::tr("Elsewhere"), {}};
    collect(window.findChildren<QAction*>(), others, seen);
    groups.push_back(others);
    std::erase_if(groups, [](const Group& group) { return group.rows.empty(); });
    return groups;
}

Group mouse() {
    return {tr("Whatever the tool"),
            {{tr("Turn the picture"), tr("Arrow keys"), {}},
             {tr("Roll the picture"), tr("Ctrl+Left, Right"), {}},
             {tr("Zoom"), tr("+  -"), {}},
             {tr("Move the picture"), tr("Shift+Arrow keys"), {}},
             {tr("Turn the picture"), tr("One finger"), {}},
             {tr("Move, zoom and roll"), tr("Two fingers"), {}},
             {tr("Move the picture"), tr("Middle button"), {}},
             {tr("Move the picture"), tr("Shift+Drag"), {}},
             {tr("Zoom"), tr("Wheel"), {}},
             {tr("Zoom"), tr("Right button"), {}},
             {tr("Window of slices: level and width"), tr("Right button on a slice"), {}},
             {tr("Zoom a slice"), tr("Ctrl+Right button, Ctrl+Wheel"), {}},
             {tr("Do what is prepared"), tr("Enter"), {}},
             {tr("Restore while it is held"), tr("R"), {}},
             {tr("The tool turned round"), tr("Eraser of the pen"), {}}}};
}

QWidget* makeGroup(const Group& group) {
    QVBoxLayout* content = nullptr;
    auto* card = makeCard(group.title, content);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(18);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(0, 1);
    for (int n = 0; n < int(group.rows.size()); ++n) {
        const Row& row = group.rows[std::size_t(n)];
        auto* keys = new QLabel(row.keys);
        keys->setProperty("keyCap", true);
        if (!row.name.isEmpty()) {
            keys->setObjectName("key_" + row.name);
        }
        auto* text = new QLabel(row.text);
        text->setToolTip(row.tip);
        grid->addWidget(text, n, 0);
        grid->addWidget(keys, n, 1, Qt::AlignRight);
    }
    content->addLayout(grid);
    return card;
}

} // namespace

ShortcutSheet::ShortcutSheet(QMainWindow& window) : QDialog(&window) {
    setObjectName("shortcutSheet");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Keyboard shortcuts"));
    auto groups = groupsOf(window);
    groups.push_back(mouse());

    // Each group goes to the column that is shortest so far.
    constexpr std::size_t kColumns = 3;
    auto* page = new QWidget;
    auto* row = new QHBoxLayout(page);
    row->setSpacing(12);
    std::vector<QVBoxLayout*> columns(kColumns);
    std::vector<std::size_t> lengths(kColumns, 0);
    for (auto& column : columns) {
        column = new QVBoxLayout;
        column->setSpacing(12);
        row->addLayout(column, 1);
    }
    for (const Group& group : groups) {
        const auto shortest = std::min_element(lengths.begin(), lengths.end()) - lengths.begin();
        columns[std::size_t(shortest)]->addWidget(makeGroup(group));
        lengths[std::size_t(shortest)] += group.rows.size() + 3;
    }
    for (auto* column : columns) {
        column->addStretch(1);
    }
    auto* scroll = new QScrollArea;
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto* outer = new QVBoxLayout(this);
    outer->addWidget(scroll, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    outer->addWidget(buttons);
    constexpr int kRoomForBars = 50;
    resize(QSize(page->sizeHint().width() + kRoomForBars, 720).boundedTo(window.size()));
}

} // namespace vs::desktop
