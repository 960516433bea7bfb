// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <string>
#include <vector>

class QWidget;

namespace vs::desktop {

class StudioController;
class Tool;
class ToolBox;

// What the window says and shows of a tool: its button and its page. The action is named after the tool
// ("peelTool").
struct ToolRow {
    enum class Group { Views, Cuts, Marks }; // in the menu
    Tool& tool;
    Group group;
    int button;      // its place in the column of tools, from 1; 0: it stands elsewhere there
    const char* key; // that takes it in hand
    QString text;    // of its button
    QString tip;
    QString title; // of its page
    // Makes what can be set for it; null: its page says the tip.
    QWidget* (*makePage)(StudioController&, ToolBox&) = nullptr;
    // The picture on its button, one of parts/icons.cpp; null: that of the tool's name.
    const char* picture = nullptr;

    [[nodiscard]] std::string actionName() const;
    [[nodiscard]] std::string pictureName() const;
};

// All tools, in the order of their pages.
std::vector<ToolRow> toolRows(ToolBox& tools);

} // namespace vs::desktop
