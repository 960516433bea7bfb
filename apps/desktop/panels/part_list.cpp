// SPDX-License-Identifier: Apache-2.0
#include "panels/part_list.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"
#include "studio/document/document_facts.h"
#include "tools/move_tool.h"

#include <QKeyEvent>
#include <QSignalBlocker>

#include <algorithm>

namespace vs::desktop {

namespace {
constexpr int kLeastPartRows = 3;
constexpr int kMostPartRows = 8;
constexpr int kPartRowHeight = 24;    // logical pixels
constexpr int kLongestPartName = 200; // bytes, as in session files
} // namespace

PartList::PartList(StudioController& studio, MoveTool& tool) : studio_(studio), tool_(tool) {
    named(this, "partList", tr("Parts and segments that are pulled out"));
    setToolTip(tr("The box says whether it is seen; F2 or a double click renames, Delete discards"));
    setUniformItemSizes(true);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(this, &QListWidget::currentRowChanged, this, &PartList::takeInHand);
    connect(this, &QListWidget::itemChanged, this, &PartList::takeOver);
    connect(&studio.host(), &DocumentHost::changed, this, &PartList::refresh);
    refresh();
}

QSize PartList::sizeHint() const {
    return {160, std::clamp(count(), kLeastPartRows, kMostPartRows) * kPartRowHeight + 2 * frameWidth()};
}

std::vector<PartList::Entry> PartList::entries() const {
    std::vector<Entry> entries;
    if (studio_.host().geometry() == nullptr) {
        return entries;
    }
    const auto facts = studio_.host().facts();
    for (const studio::PartInfo& part : facts->parts) {
        entries.push_back({int(entries.size()), part.name, part.isVisible, part.takesTrimmed});
    }
    for (const studio::SegmentInfo& segment : facts->segments.segments) {
        if (segment.pulledOut) {
            entries.push_back({{}, segment.name, segment.pulledOut->isVisible});
        }
    }
    return entries;
}

std::optional<PartList::Entry> PartList::current() const {
    const int row = currentRow();
    return row >= 0 && row < int(entries_.size()) ? std::optional(entries_[std::size_t(row)]) : std::nullopt;
}

int PartList::rowInHand() const {
    const auto isInHand = [this](const Entry& entry) {
        return tool_.numberOf(entry.part, entry.name) == tool_.chosen();
    };
    const auto found = std::find_if(entries_.begin(), entries_.end(), isInHand);
    return found == entries_.end() ? -1 : int(found - entries_.begin());
}

void PartList::refresh() {
    const auto wanted = entries();
    if (state() == QAbstractItemView::EditingState && wanted == entries_) {
        return; // a name is being typed
    }
    QSignalBlocker quiet(this);
    const bool isLonger = wanted.size() != entries_.size();
    entries_ = wanted;
    while (count() > int(entries_.size())) {
        delete takeItem(count() - 1);
    }
    while (count() < int(entries_.size())) {
        auto* item = new QListWidgetItem(this);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable |
                       Qt::ItemIsUserCheckable);
        item->setSizeHint({0, kPartRowHeight});
    }
    QStringList seen;
    QStringList hidden;
    for (int row = 0; row < count(); ++row) {
        const Entry& entry = entries_[std::size_t(row)];
        const QString name = QString::fromStdString(entry.name);
        item(row)->setText(name);
        item(row)->setCheckState(entry.isVisible ? Qt::Checked : Qt::Unchecked);
        (entry.isVisible ? seen : hidden) << name;
    }
    // One that is not seen stays marked, so that it can be shown again.
    const auto marked = current();
    if (!marked || tool_.numberOf(marked->part, marked->name)) {
        setCurrentRow(rowInHand());
    }
    setProperty("report", seen.join(", ") + " | " + hidden.join(", "));
    if (isLonger) {
        setMaximumHeight(sizeHint().height());
        updateGeometry();
    }
    quiet.unblock();
    emit shown();
}

void PartList::takeInHand(int row) {
    if (row >= 0 && row < int(entries_.size())) {
        const Entry& entry = entries_[std::size_t(row)];
        if (const auto number = tool_.numberOf(entry.part, entry.name)) {
            tool_.choose(*number);
        }
    }
    emit shown();
}

void PartList::takeOver(QListWidgetItem* item) {
    const int changed = row(item);
    if (changed < 0 || changed >= int(entries_.size())) {
        return;
    }
    const Entry entry = entries_[std::size_t(changed)];
    const bool isVisible = item->checkState() == Qt::Checked;
    if (isVisible != entry.isVisible) {
        if (entry.part) {
            studio::ChangePart change{*entry.part};
            change.isVisible = isVisible;
            studio_.editor().apply(change);
        } else {
            studio_.segments().showPulledOut(entry.name, isVisible);
        }
    } else if (const QString wanted = item->text().trimmed(); item->text().toStdString() != entry.name) {
        {
            const QSignalBlocker quiet(this); // what is not taken over is as it was
            item->setText(QString::fromStdString(entry.name));
        }
        rename(entry, wanted);
    }
    refresh();
}

void PartList::rename(const Entry& entry, const QString& name) {
    const std::string text = name.toStdString();
    if (!entry.part) {
        studio_.segments().rename(entry.name, name);
    } else if (text.empty() || text.size() > kLongestPartName) {
        studio_.host().say(text.empty()
                               ? tr("A part needs a name")
                               : tr("A part's name has at most %1 characters").arg(kLongestPartName));
    } else if (text != entry.name) {
        studio::ChangePart change{*entry.part};
        change.name = text;
        studio_.editor().apply(change);
    }
}

void PartList::discardCurrent() {
    const auto entry = current();
    if (entry && entry->part) {
        studio_.editor().apply(studio::DiscardPart{*entry->part});
    } else if (entry) {
        studio_.segments().pullOut(entry->name); // which is out: it goes back
    }
}

void PartList::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete) {
        discardCurrent();
        return;
    }
    QListWidget::keyPressEvent(event);
}

} // namespace vs::desktop
