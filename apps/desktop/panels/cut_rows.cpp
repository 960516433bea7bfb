// SPDX-License-Identifier: Apache-2.0
#include "panels/cut_rows.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "panels/material_rows.h"
#include "parts/panel_parts.h"
#include "tools/kinds/cut_tool.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vs::desktop {

namespace {

using Treatment = studio::SegmentInfo::Treatment;

// The scan, the segment at work or material; one choice for all tools that can do more than the first.
void addTarget(QFormLayout* form, CutTool& tool, StudioController& studio, const QString& prefix) {
    using Target = Hand::Target;
    const QByteArray scan = (prefix + "OnScan").toLatin1();
    const QByteArray segment = (prefix + "OnSegment").toLatin1();
    const QByteArray material = (prefix + "OnMaterial").toLatin1();
    std::vector<Target> targets{Target::Scan};
    std::vector<ChoiceRow::Choice> choices{
        {scan.constData(), CutTool::tr("Scan"), CutTool::tr("Cuts the scan, or puts back what was cut")}};
    if (tool.canActOnSegment()) {
        targets.push_back(Target::Segment);
        choices.push_back(
            {segment.constData(), CutTool::tr("Segment"),
             CutTool::tr("Takes away from the segment at work, or adds to it; the scan stays as it is")});
    }
    if (tool.canActOnMaterial()) {
        targets.push_back(Target::Material);
        choices.push_back({material.constData(), CutTool::tr("Material"),
                           CutTool::tr("Adds material, or takes it away; the scan stays as it is")});
    }
    const auto chosen = [&tool, &studio, targets] {
        const bool acts = tool.actsOnSegment() || tool.actsOnMaterial();
        const auto at = std::find(targets.begin(), targets.end(), studio.hand().target());
        return acts ? int(at - targets.begin()) : 0;
    };
    auto* target = new ChoiceRow(choices, chosen());
    QObject::connect(target, &ChoiceRow::chosen, &studio,
                     [&studio, targets](int n) { studio.hand().setTarget(targets.at(std::size_t(n))); });
    QObject::connect(&studio.host(), &DocumentHost::changed, target,
                     [chosen, target] { target->choose(chosen()); });
    form->addRow(target); // three of them want all of the width
}

// What the two signs are called.
void nameSigns(ChoiceRow& sign, const CutTool& tool) {
    if (tool.actsOnSegment()) {
        sign.rename(0, CutTool::tr("Remove"), CutTool::tr("Takes away from the segment at work (R)"));
        sign.rename(1, CutTool::tr("Add"), CutTool::tr("Adds to it what is in the displayed range (R)"));
    } else if (tool.actsOnMaterial()) {
        sign.rename(0, CutTool::tr("Fill"), CutTool::tr("Adds material (R)"));
        sign.rename(1, CutTool::tr("Take away"), CutTool::tr("Takes material away; the scan stays (R)"));
    } else {
        sign.rename(0, CutTool::tr("Cut"), CutTool::tr("Takes away (R)"));
        sign.rename(1, CutTool::tr("Restore"),
                    CutTool::tr("Puts back what was cut, never more than there was (R)"));
    }
}

QStringList namesOf(const studio::SegmentList& list,
                    const std::function<bool(const studio::SegmentInfo&)>& isMeant) {
    QStringList names;
    for (const studio::SegmentInfo& info : list.segments) {
        if (isMeant(info)) {
            names << QString::fromStdString(info.name);
        }
    }
    constexpr int kMost = 6;
    if (names.size() > kMost) {
        names = names.mid(0, kMost - 1) << CutTool::tr("%1 more").arg(names.size() - (kMost - 1));
    }
    return names;
}

// What holds for all tools that cut, in words; empty: they take everything.
QString limitsSaid(const studio::SegmentList& list) {
    const QStringList only = namesOf(list, [](const studio::SegmentInfo& info) {
        return !info.isSpared() && info.treatment == Treatment::TakeOnly;
    });
    const QStringList spared = namesOf(list, [](const studio::SegmentInfo& info) { return info.isSpared(); });
    QStringList said;
    if (!only.isEmpty()) {
        said << CutTool::tr("Only %1 is taken.").arg(only.join(", "));
    }
    if (!spared.isEmpty()) {
        said << CutTool::tr("Spared: %1.").arg(spared.join(", "));
    }
    return said.join(" ");
}

} // namespace

void addLimits(QFormLayout* form, StudioTool& tool, StudioController& studio, const QString& prefix) {
    const QByteArray all = (prefix + "TakesAll").toLatin1();
    const QByteArray spare = (prefix + "Spares").toLatin1();
    const QByteArray only = (prefix + "TakesOnly").toLatin1();
    // In the order of the treatments.
    auto* choice = new ChoiceRow(
        {{all.constData(), CutTool::tr("Take"), CutTool::tr("Takes the segment at work like all else")},
         {spare.constData(), CutTool::tr("Spare"),
          CutTool::tr("Spares the segment at work: cuts end at its surface")},
         {only.constData(), CutTool::tr("Only"),
          CutTool::tr("Takes nothing but the segment at work: cuts end at its surface")}},
        0);
    auto* said = makeQuietLabel({});
    said->setWordWrap(true);
    QObject::connect(choice, &ChoiceRow::chosen, &studio, [&studio](int n) {
        studio.segments().setTreatment(studio.segments().list().working().name, Treatment(n));
    });
    auto* label = new QLabel(CutTool::tr("Segment"));
    const auto show = [choice, said, label, &tool, &studio] {
        const auto* cuts = qobject_cast<const CutTool*>(&tool);
        const bool isUseful = studio.segments().hasVoxels() && (cuts == nullptr || !cuts->actsOnSegment());
        const studio::SegmentList list = studio.segments().list();
        choice->choose(int(list.working().treatment));
        said->setText(limitsSaid(list));
        choice->setVisible(isUseful);
        label->setVisible(isUseful);
        said->setVisible(isUseful && !said->text().isEmpty());
    };
    QObject::connect(&studio.host(), &DocumentHost::changed, choice, show);
    form->addRow(label, choice);
    form->addRow(said);
    show();
}

void addCutOrRestore(QFormLayout* form, CutTool& tool, StudioController& studio, const QString& prefix) {
    if (tool.canActOnSegment() || tool.canActOnMaterial()) {
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
    if (tool.canActOnMaterial()) {
        addMaterial(form, tool, studio, prefix);
    }
    addLimits(form, tool, studio, prefix);
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
    QObject::connect(&studio.host(), &DocumentHost::corrected, value, show);
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
