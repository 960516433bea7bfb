// SPDX-License-Identifier: Apache-2.0
#include "panels/cut_rows.h"

#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"
#include "tools/kinds/cut_tool.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>

#include <cmath>

namespace vs::desktop {

namespace {

// The scan or the segment at work; one choice for all tools that can do both.
void addTarget(QFormLayout* form, CutTool& tool, StudioController& studio, const QString& prefix) {
    const QByteArray scan = (prefix + "OnScan").toLatin1();
    const QByteArray segment = (prefix + "OnSegment").toLatin1();
    auto* target = new ChoiceRow(
        {{scan.constData(), CutTool::tr("Scan"), CutTool::tr("Cuts the scan, or puts back what was cut")},
         {segment.constData(), CutTool::tr("Segment"),
          CutTool::tr("Takes away from the segment at work, or adds to it; the scan stays as it is")}},
        tool.actsOnSegment() ? 1 : 0);
    QObject::connect(target, &ChoiceRow::chosen, &studio,
                     [&studio](int n) { studio.hand().setBrushesSegment(n == 1); });
    QObject::connect(&studio.host(), &DocumentHost::changed, target,
                     [&tool, target] { target->choose(tool.actsOnSegment() ? 1 : 0); });
    form->addRow(CutTool::tr("Acts on"), target);
}

// What the two signs are called.
void nameSigns(ChoiceRow& sign, const CutTool& tool) {
    if (tool.actsOnSegment()) {
        sign.rename(0, CutTool::tr("Remove"), CutTool::tr("Takes away from the segment at work (R)"));
        sign.rename(1, CutTool::tr("Add"), CutTool::tr("Adds to it what is in the displayed range (R)"));
    } else {
        sign.rename(0, CutTool::tr("Cut"), CutTool::tr("Takes away (R)"));
        sign.rename(1, CutTool::tr("Restore"),
                    CutTool::tr("Puts back what was cut, never more than there was (R)"));
    }
}

} // namespace

void addCutOrRestore(QFormLayout* form, CutTool& tool, StudioController& studio, const QString& prefix) {
    if (tool.canActOnSegment()) {
        addTarget(form, tool, studio, prefix);
    }
    const QByteArray cut = (prefix + "Cuts").toLatin1();
    const QByteArray restore = (prefix + "Restores").toLatin1();
    auto* sign =
        new ChoiceRow({{cut.constData(), {}, {}}, {restore.constData(), {}, {}}}, tool.isReversed() ? 1 : 0);
    nameSigns(*sign, tool);
    QObject::connect(sign, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setRestores(n == 1); });
    QObject::connect(&studio.host(), &DocumentHost::changed, sign, [&tool, sign] {
        sign->choose(tool.isReversed() ? 1 : 0);
        nameSigns(*sign, tool);
    });
    form->addRow(sign);
}

QString stepsAndMm(double steps, StudioController& studio) {
    const volume::GridGeometry* grid = studio.host().geometry();
    const QString text = QString::number(steps, 'f', steps == std::floor(steps) ? 0 : 1);
    return grid == nullptr ? text
                           : CutTool::tr("%1 · %2 mm").arg(text).arg(steps * grid->stepMm(), 0, 'g', 3);
}

QWidget* withSteps(QSlider* slider, int perStep, StudioController& studio) {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    auto* value = new QLabel;
    value->setMinimumWidth(value->fontMetrics().horizontalAdvance("000.0 · 000 mm"));
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(slider, 1);
    row->addWidget(value);
    const auto show = [slider, value, perStep, &studio] {
        value->setText(stepsAndMm(double(slider->value()) / perStep, studio));
    };
    QObject::connect(slider, &QSlider::valueChanged, value, show);
    QObject::connect(&studio.host(), &DocumentHost::opened, value, show);
    show();
    return holder;
}

void addRadius(QFormLayout* form, CutTool& tool, const QString& prefix) {
    std::vector<QByteArray> names;
    for (int radius = CutTool::kLeastRadius; radius <= CutTool::kMostRadius; ++radius) {
        names.push_back((prefix + "Radius%1").arg(radius).toLatin1());
    }
    std::vector<ChoiceRow::Choice> choices;
    for (std::size_t n = 0; n < names.size(); ++n) {
        choices.push_back({names[n].constData(), QString::number(CutTool::kLeastRadius + int(n)),
                           CutTool::tr("Radius of the cut's soft edge in steps (a step is the smallest voxel "
                                       "spacing): the larger, the rounder are the cut's edges")});
    }
    auto* radius = new ChoiceRow(choices, tool.radius() - CutTool::kLeastRadius);
    QObject::connect(radius, &ChoiceRow::chosen, &tool,
                     [&tool](int n) { tool.setRadius(CutTool::kLeastRadius + n); });
    form->addRow(CutTool::tr("Radius (steps)"), radius);
}

} // namespace vs::desktop
