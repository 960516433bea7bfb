// SPDX-License-Identifier: Apache-2.0
// The page of the move tool: what stands beside the rest, and how far apart.
#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "panels/part_list.h"
#include "panels/tool_pages.h"
#include "parts/panel_parts.h"
#include "studio/document/document_facts.h"
#include "tools/move_tool.h"
#include "tools/tool_box.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

constexpr double kPercent = 100;

QPushButton* makePageButton(QFormLayout& form, const char* objectName, const QString& text,
                            const QString& tip) {
    auto* button = named(new QPushButton(text), objectName, tip);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);
    form.addRow(button);
    return button;
}

// The part in hand: its size, its place, what belongs to it.
void addPartInHand(QFormLayout& form, StudioController& studio, MoveTool& tool, PartList& list) {
    auto* size = named(new QLabel, "moveScale", MoveTool::tr("Its size"));
    size->setAlignment(Qt::AlignRight);
    form.addRow(MoveTool::tr("Size"), size);
    auto* all = makeCheckBox("partTakesAll", MoveTool::tr("With what Keep and Clip took"),
                             MoveTool::tr("What they took away around the part belongs to it too"), false);
    form.addRow(all);
    auto* reset = makePageButton(form, "moveReset", MoveTool::tr("Back to its own place"),
                                 MoveTool::tr("Put the part back to where it was cut out or lies"));
    auto* discard =
        makePageButton(form, "discardPart", MoveTool::tr("Discard"), MoveTool::tr("Draw it no more"));
    QObject::connect(reset, &QPushButton::clicked, &tool, &MoveTool::resetPlace);
    QObject::connect(discard, &QPushButton::clicked, &list, &PartList::discardCurrent);
    QObject::connect(all, &QCheckBox::toggled, &list, [&studio, &list](bool takesTrimmed) {
        if (const auto entry = list.current(); entry && entry->part) {
            studio::ChangePart change{*entry->part};
            change.takesTrimmed = takesTrimmed;
            studio.editor().apply(change);
        }
    });
    const auto show = [&tool, &list, size, all, reset, discard] {
        const auto place = tool.place();
        const auto entry = list.current();
        const bool isPart = entry && entry->part;
        const bool isInHand = place && entry && entry->isVisible;
        const QSignalBlocker quiet(all);
        size->setText(isInHand ? MoveTool::tr("%1 %").arg(kPercent * place->scale, 0, 'f', 0)
                               : QString("\u2013"));
        all->setEnabled(isPart);
        all->setChecked(isPart && entry->takesTrimmed);
        reset->setEnabled(isInHand && !(*place == render::Placement{}));
        discard->setEnabled(entry.has_value());
        discard->setText(!entry || isPart ? MoveTool::tr("Discard") : MoveTool::tr("Put back"));
    };
    QObject::connect(&list, &PartList::shown, size, show);
    show();
}

// All of them: pulled out, and moved apart.
void addAllParts(QFormLayout& form, StudioController& studio) {
    auto* out =
        makePageButton(form, "pullOutAll", MoveTool::tr("Pull all segments out"),
                       MoveTool::tr("Each in its own place, to be moved apart; again: put them all back"));
    QObject::connect(out, &QPushButton::clicked, out, [&studio] { studio.segments().pullAllOut(); });
    auto* spread = makeSlider("spread", MoveTool::tr("How far parts are moved apart from the middle"), 0,
                              int(kPercent * studio::kMostSpread), 0);
    QObject::connect(spread, &QSlider::valueChanged, spread,
                     [&studio](int percent) { studio.view().setSpread(percent / kPercent); });
    form.addRow(MoveTool::tr("Spread"),
                withValue(spread, [](int percent) { return MoveTool::tr("%1 %").arg(percent); }));
    const auto show = [&studio, out, spread] {
        const QSignalBlocker quiet(spread);
        spread->setValue(int(std::lround(kPercent * studio.view().shown().spread)));
        out->setEnabled(studio.segments().hasVoxels());
        out->setText(studio.segments().areAllOut() ? MoveTool::tr("Put all segments back")
                                                   : MoveTool::tr("Pull all segments out"));
    };
    QObject::connect(&studio.host(), &DocumentHost::changed, spread, show);
    show();
}

} // namespace

QWidget* makeMovePage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    MoveTool& tool = tools.get<MoveTool>();
    auto* list = new PartList(studio, tool);
    form->addRow(list);
    addPartInHand(*form, studio, tool, *list);
    addAllParts(*form, studio);
    return page;
}

} // namespace vs::desktop
