// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QKeySequence>
#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <string>
#include <vector>

class QAction;
class QActionGroup;
class QWidget;

namespace vs::desktop {

// What a person can do in the window by button, menu or key.
struct ActionRow {
    std::string name; // objectName of the action and of its button
    const char* icon; // null: none
    QString text;
    QString tip;
    QKeySequence shortcut;
    std::function<void()> run;            // empty: whoever adds it listens to the action
    std::function<bool()> isEnabled = {}; // empty: while a document is open
    std::function<bool()> isChecked = {}; // empty: it cannot be checked, or keeps that by itself
};

// All actions of the window, each described in one row: what it is called, what it does, when it can be done,
// and when it is checked.
class ActionTable : public QObject {
    Q_OBJECT

public:
    // The window takes the shortcuts; `isOpen` says whether a document is open.
    ActionTable(QWidget& window, std::function<bool()> isOpen);

    QAction* add(ActionRow row);
    // Adds one of several actions of which one is checked.
    QAction* addChoice(QActionGroup* group, ActionRow row);
    // The action of a row that there is.
    [[nodiscard]] QAction* find(const std::string& name) const { return actions_.at(name); }

    // Asks every row whether it is enabled and checked now.
    void refresh();

private:
    struct Asked {
        QAction* action;
        std::function<bool()> isEnabled;
        std::function<bool()> isChecked;
    };

    QWidget& window_;
    std::function<bool()> isOpen_;
    std::map<std::string, QAction*> actions_;
    std::vector<Asked> rows_;
};

} // namespace vs::desktop
