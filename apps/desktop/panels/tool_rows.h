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
// ("peelTool"), the picture on its button too.
struct ToolRow {
    enum class Group { Views, Cuts, Marks }; // in the menu
    Tool& tool;
    Group group;
    int button;      // its place in the column of tools, from 1; 0: it stands elsewhere there
    const char* key; // that takes it in hand
    QString text;    // of its button
    QString tip;
    QString title;                                     // of its page
    QWidget* (*makePage)(StudioController&, ToolBox&); // what can be set for it

    [[nodiscard]] std::string actionName() const;
};

// All tools, in the order of their pages.
std::vector<ToolRow> toolRows(ToolBox& tools);

} // namespace vs::desktop
