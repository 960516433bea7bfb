// SPDX-License-Identifier: Apache-2.0
#include "cut_rows.h"

#include "cut_tool.h"
#include "panel_parts.h"

#include <QFormLayout>

namespace vs::desktop {

void addCutOrRestore(QFormLayout* form, CutTool& tool, const QString& prefix) {
    const QByteArray cut = (prefix + "Cuts").toLatin1();
    const QByteArray restore = (prefix + "Restores").toLatin1();
    auto* sign = new ChoiceRow({{cut.constData(), CutTool::tr("Cut"), CutTool::tr("Takes away (R)")},
                                {restore.constData(), CutTool::tr("Restore"),
                                 CutTool::tr("Puts back what was cut, never more than there was (R)")}},
                               tool.restores() ? 1 : 0);
    QObject::connect(sign, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setRestores(n == 1); });
    QObject::connect(&tool, &CutTool::settingsChanged, sign,
                     [&tool, sign] { sign->choose(tool.restores() ? 1 : 0); });
    form->addRow(sign);
}

void addRadius(QFormLayout* form, CutTool& tool, const QString& prefix) {
    std::vector<QByteArray> names;
    for (int radius = CutTool::kLeastRadius; radius <= CutTool::kMostRadius; ++radius) {
        names.push_back((prefix + "Radius%1").arg(radius).toLatin1());
    }
    std::vector<ChoiceRow::Choice> choices;
    for (std::size_t n = 0; n < names.size(); ++n) {
        choices.push_back({names[n].constData(), QString::number(CutTool::kLeastRadius + int(n)),
                           CutTool::tr("Steps: the larger, the rounder are the cut's edges")});
    }
    auto* radius = new ChoiceRow(choices, tool.radius() - CutTool::kLeastRadius);
    QObject::connect(radius, &ChoiceRow::chosen, &tool,
                     [&tool](int n) { tool.setRadius(CutTool::kLeastRadius + n); });
    form->addRow(CutTool::tr("Radius"), radius);
}

} // namespace vs::desktop
