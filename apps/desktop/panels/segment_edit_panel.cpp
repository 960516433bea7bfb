// SPDX-License-Identifier: Apache-2.0
#include "panels/segment_edit_panel.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "parts/fold_card.h"
#include "parts/panel_parts.h"
#include "tools/island_tool.h"
#include "tools/tool_box.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <map>
#include <vector>

namespace vs::desktop {

namespace {

using Kind = studio::EditSegment::Kind;

// What can be done to a segment, as the list offers it.
struct Edit {
    enum class Does { Edits, Clicks, Cuts, Keeps };

    QString text;
    QString explanation;
    Kind kind = Kind::KeepLargest;
    Does does = Does::Edits;
    QString unit = {}; // empty: it needs no amount
    double usual = 0;
    double least = 0;
    bool needsOther = false;
    bool beginsGroup = false;
};

const std::vector<Edit>& edits() {
    static const std::vector<Edit> all{
        {tr("Grow or shrink by a margin"), tr("Grows by so much all around; below zero it shrinks."),
         Kind::Margin, Edit::Does::Edits, "mm", 2, -100},
        {tr("Smooth"), tr("Rounds what is rougher than this."), Kind::Smooth, Edit::Does::Edits, "mm", 2},
        {tr("Fill holes"), tr("Fills what is enclosed, up to this size; 0 fills all."), Kind::FillHoles,
         Edit::Does::Edits, "ml", 0},
        {tr("Open: cut thin bridges"), tr("Shrinks, then grows: what is thinner than twice this goes."),
         Kind::Open, Edit::Does::Edits, "mm", 1.5},
        {tr("Close: bridge gaps"), tr("Grows, then shrinks: gaps narrower than twice this are filled."),
         Kind::Close, Edit::Does::Edits, "mm", 1.5},
        {tr("Hollow"), tr("Leaves a wall of this thickness inside the surface."), Kind::Hollow,
         Edit::Does::Edits, "mm", 2},
        {tr("Drop or keep the part clicked"),
         tr("Click parts in the picture: each is dropped or, with R, kept alone."),
         Kind::DropIsland,
         Edit::Does::Clicks,
         {},
         0,
         0,
         false,
         true},
        {tr("Keep the largest part"), tr("Drops all parts that are not connected to the largest."),
         Kind::KeepLargest},
        {tr("Drop small parts"), tr("Drops connected parts smaller than this."), Kind::DropSmall,
         Edit::Does::Edits, "ml", 0.5},
        {tr("Unite with another"),
         tr("Takes in all of the other, which is left empty."),
         Kind::Unite,
         Edit::Does::Edits,
         {},
         0,
         0,
         true,
         true},
        {tr("Subtract another"), tr("Takes away what lies within this distance of the other."),
         Kind::Subtract, Edit::Does::Edits, "mm", 0, 0, true},
        {tr("Intersect with another"), tr("Keeps only what lies within this distance of the other."),
         Kind::Intersect, Edit::Does::Edits, "mm", 2, 0, true},
        {tr("Cut it away from the scan"), tr("Cuts the segment out of the scan, with this margin around it."),
         Kind::Margin, Edit::Does::Cuts, "mm", 0, -100, false, true},
        {tr("Cut away all but it"), tr("Cuts everything else away, but for this margin around it."),
         Kind::Margin, Edit::Does::Keeps, "mm", 1, -100}};
    return all;
}

} // namespace

SegmentEditPanel::SegmentEditPanel(StudioController& studio, ToolBox& tools, QWidget* parent)
    : QWidget(parent), studio_(studio), tools_(tools), card_(new FoldCard(tr("Edit segment"), "editFold")) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(card_);
    auto* column = card_->content();

    edit_ = named(new QComboBox, "segmentEdit", tr("What to do with the segment at work"));
    edit_->setMaxVisibleItems(20);
    for (const Edit& edit : edits()) {
        if (edit.beginsGroup) {
            edit_->insertSeparator(edit_->count());
        }
        edit_->addItem(edit.text, int(&edit - edits().data()));
    }
    column->addWidget(edit_);
    explanation_ = makeQuietLabel({});
    explanation_->setWordWrap(true);
    column->addWidget(explanation_);

    const auto addRow = [&](QWidget* holder, QLabel* label, QWidget* field) {
        auto* row = new QHBoxLayout(holder);
        row->setContentsMargins(0, 0, 0, 0);
        row->addWidget(label);
        row->addWidget(field, 1);
        column->addWidget(holder);
    };
    amountRow_ = new QWidget;
    amountText_ = makeQuietLabel(tr("Amount"));
    amount_ = makeSpinBox("editAmount", tr("By how much"));
    amount_->setDecimals(2);
    addRow(amountRow_, amountText_, amount_);
    otherRow_ = new QWidget;
    other_ = named(new QComboBox, "editOther", tr("The other segment"));
    addRow(otherRow_, makeQuietLabel(tr("Other")), other_);
    perform_ = named(new QPushButton, "editPerform", tr("Apply"));
    perform_->setFocusPolicy(Qt::TabFocus);
    column->addWidget(perform_);

    connect(edit_, &QComboBox::currentIndexChanged, this, &SegmentEditPanel::show);
    connect(perform_, &QPushButton::clicked, this, &SegmentEditPanel::perform);
    connect(&studio_.host(), &DocumentHost::changed, this, &SegmentEditPanel::refresh);
    show();
}

// The edit that was chosen, with its usual amount.
void SegmentEditPanel::show() {
    const Edit& edit = edits()[edit_->currentData().toUInt()];
    explanation_->setText(edit.explanation);
    amountRow_->setVisible(!edit.unit.isEmpty());
    amount_->setSuffix(" " + edit.unit);
    constexpr double kMost = 1000;
    amount_->setRange(edit.least, kMost);
    amount_->setSingleStep(0.5);
    amount_->setValue(edit.usual);
    otherRow_->setVisible(edit.needsOther);
    perform_->setText(edit.does == Edit::Does::Clicks ? tr("Click in the picture") : tr("Apply"));
    refresh();
}

void SegmentEditPanel::refresh() {
    const Edit& edit = edits()[edit_->currentData().toUInt()];
    const auto& list = studio_.segments().list();
    const QString chosen = other_->currentText();
    QStringList others;
    for (const studio::SegmentInfo& segment : list.segments) {
        if (segment.label != list.atWork) {
            others.push_back(QString::fromStdString(segment.name));
        }
    }
    QStringList shown;
    for (int n = 0; n < other_->count(); ++n) {
        shown.push_back(other_->itemText(n));
    }
    if (shown != others) {
        other_->clear();
        other_->addItems(others);
        other_->setCurrentText(chosen);
    }
    const bool isCut = edit.does == Edit::Does::Cuts || edit.does == Edit::Does::Keeps;
    const bool isFilled = studio_.segments().voxels(list.atWork) > 0 || edit.kind == Kind::Unite;
    perform_->setEnabled(isFilled && (isCut || !list.working().isLocked) &&
                         (!edit.needsOther || !others.isEmpty()));
}

void SegmentEditPanel::perform() {
    const Edit& edit = edits()[edit_->currentData().toUInt()];
    amount_->interpretText();
    const double amount = edit.unit.isEmpty() ? 0 : amount_->value();
    if (edit.does == Edit::Does::Clicks) {
        studio_.hand().take(tools_.get<IslandTool>());
    } else if (edit.does == Edit::Does::Edits) {
        studio::EditSegment operation;
        operation.kind = edit.kind;
        operation.amount = amount;
        operation.other = edit.needsOther ? other_->currentText().toStdString() : std::string();
        studio_.segments().perform(operation);
    } else {
        studio_.segments().perform(studio::CutSegment{edit.does == Edit::Does::Keeps, amount});
    }
}

} // namespace vs::desktop
