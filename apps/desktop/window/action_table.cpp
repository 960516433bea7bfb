// SPDX-License-Identifier: Apache-2.0
#include "window/action_table.h"

#include "parts/icons.h"

#include <QAction>
#include <QActionGroup>
#include <QWidget>

#include <utility>

namespace vs::desktop {

ActionTable::ActionTable(QWidget& window, std::function<bool()> isOpen)
    : QObject(&window), window_(window), isOpen_(std::move(isOpen)) {}

QAction* ActionTable::add(ActionRow row) {
    auto* action = new QAction(row.text, &window_);
    action->setObjectName(QString::fromStdString(row.name));
    if (row.icon != nullptr) {
        action->setIcon(icon(row.icon));
    }
    const QString keys = row.shortcut.toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? row.tip : row.tip + "  (" + keys + ")");
    action->setStatusTip(QString());
    action->setShortcut(row.shortcut);
    action->setCheckable(bool(row.isChecked));
    window_.addAction(action);
    if (row.run) {
        connect(action, &QAction::triggered, &window_, row.run);
    }
    actions_[row.name] = action;
    rows_.push_back({action, std::move(row.isEnabled), std::move(row.isChecked)});
    return action;
}

QAction* ActionTable::addChoice(QActionGroup* group, ActionRow row) {
    QAction* action = add(std::move(row));
    action->setCheckable(true);
    group->addAction(action);
    return action;
}

namespace {

void show(QAction& action, bool isChecked) {
    // Of several of which one must be checked, one is unchecked by the other that is checked.
    const auto* group = action.actionGroup();
    if (isChecked || group == nullptr ||
        group->exclusionPolicy() != QActionGroup::ExclusionPolicy::Exclusive) {
        action.setChecked(isChecked);
    }
}

} // namespace

// Each action is set once: its button is painted again for every change, even one that is taken back.
void ActionTable::refresh() {
    const bool isOpen = isOpen_();
    for (const Asked& row : rows_) {
        row.action->setEnabled(row.isEnabled ? row.isEnabled() : isOpen);
        if (row.isChecked) {
            show(*row.action, row.isChecked());
        }
    }
}

} // namespace vs::desktop
