// SPDX-License-Identifier: Apache-2.0
#include "panels/segment_table.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "panels/segment_model.h"
#include "panels/segment_order.h"

#include <QActionGroup>
#include <QColorDialog>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPersistentModelIndex>
#include <QScrollBar>

#include <algorithm>

namespace vs::desktop {

namespace {
constexpr int kLeastRows = 2;
// That there is always room for; where there is no more, the others are scrolled to.
constexpr int kFewRows = 5;
constexpr int kFewOfLong = 12;
} // namespace

SegmentTable::SegmentTable(StudioController& studio, QWidget* parent)
    : QTableView(parent), studio_(studio), model_(new SegmentModel(studio.segments(), this)),
      order_(new SegmentOrder(*model_, this)) {
    setModel(order_);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setTabKeyNavigation(false); // Tab goes on to the next control
    setShowGrid(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setIconSize(QSize(17, 17));
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(kRowHeight);
    auto* header = horizontalHeader();
    header->setSortIndicatorClearable(true); // then as they were made
    header->setSortIndicator(-1, Qt::AscendingOrder);
    header->setSectionsClickable(true);
    header->setHighlightSections(false);
    header->setMinimumSectionSize(20);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(SegmentModel::Name, QHeaderView::Stretch);
    setColumnWidth(SegmentModel::Colour, 28);
    setColumnWidth(SegmentModel::Volume, 72);
    setColumnWidth(SegmentModel::Eye, 28);
    setColumnWidth(SegmentModel::Lock, 28);
    setSortingEnabled(true);
    connect(&studio_.host(), &DocumentHost::changed, this, &SegmentTable::refresh);
    connect(order_, &QAbstractItemModel::layoutChanged, this, [this] { setProperty("report", names()); });
    refresh();
}

bool SegmentTable::isLong() const { return model_->rowCount() > kLong; }

int SegmentTable::heightOf(int rows) const {
    const int header = isLong() ? horizontalHeader()->sizeHint().height() : 0;
    return rows * kRowHeight + header + 2 * frameWidth();
}

QSize SegmentTable::sizeHint() const {
    return {200, heightOf(std::clamp(model_->rowCount(), kLeastRows, isLong() ? kFewOfLong : kFewRows))};
}

void SegmentTable::search(const QString& text) {
    isRefreshing_ = true; // no row is chosen by that
    order_->search(text);
    isRefreshing_ = false;
    refresh();
}

const studio::SegmentInfo& SegmentTable::segmentAt(const QModelIndex& index) const {
    return model_->segment(order_->mapToSource(index).row());
}

void SegmentTable::refresh() {
    isRefreshing_ = true;
    const int rows = model_->rowCount();
    const int column = std::max(0, currentIndex().column());
    model_->refresh();
    if (model_->rowCount() != rows || horizontalHeader()->isHidden() == isLong()) {
        horizontalHeader()->setVisible(isLong());
        if (!isLong()) { // nothing that cannot be seen is in force
            sortByColumn(-1, Qt::AscendingOrder);
            order_->search({});
        }
        setMaximumHeight(std::max(sizeHint().height(), isLong() ? heightOf(model_->rowCount()) : 0));
        updateGeometry();
        emit lengthChanged();
    }
    const QModelIndex working = order_->mapFromSource(model_->index(model_->workingRow(), column));
    if (currentIndex().row() != working.row()) {
        setCurrentIndex(working); // none, where it was not searched for
        if (working.isValid()) {
            scrollTo(working);
        }
    }
    setProperty("report", names());
    isRefreshing_ = false;
}

// Of the rows, for scripts: those after | are hidden.
QString SegmentTable::names() const {
    QStringList seen;
    QStringList hidden;
    for (int row = 0; row < order_->rowCount(); ++row) {
        const studio::SegmentInfo& info = segmentAt(order_->index(row, 0));
        (info.isVisible ? seen : hidden) << QString::fromStdString(info.name);
    }
    return seen.join(", ") + " | " + hidden.join(", ");
}

void SegmentTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTableView::currentChanged(current, previous);
    if (!isRefreshing_ && current.isValid() && order_->mapToSource(current).row() != model_->workingRow()) {
        studio_.segments().workOn(segmentAt(current).name);
    }
}

void SegmentTable::mousePressEvent(QMouseEvent* event) {
    const QModelIndex index = indexAt(event->position().toPoint());
    const bool isButton =
        index.isValid() && index.column() != SegmentModel::Name && index.column() != SegmentModel::Volume;
    if (event->button() == Qt::LeftButton && isButton) {
        setFocus(Qt::MouseFocusReason);
        if (index.column() == SegmentModel::Eye && event->modifiers().testFlag(Qt::AltModifier)) {
            showOnlyOrAll(segmentAt(index));
        } else {
            activate(index);
        }
        return;
    }
    if (event->button() == Qt::RightButton) {
        return; // offers what can be done, and goes to work on nothing
    }
    QTableView::mousePressEvent(event);
}

// All again where that one is alone.
void SegmentTable::showOnlyOrAll(const studio::SegmentInfo& info) {
    const auto& segments = studio_.segments().list().segments;
    const auto seen = std::count_if(segments.begin(), segments.end(),
                                    [](const studio::SegmentInfo& segment) { return segment.isVisible; });
    if (info.isVisible && seen == 1) {
        studio_.segments().showAll();
    } else {
        studio_.segments().showOnly(std::string(info.name));
    }
}

void SegmentTable::contextMenuEvent(QContextMenuEvent* event) {
    const QModelIndex index =
        event->reason() == QContextMenuEvent::Mouse ? indexAt(event->pos()) : currentIndex();
    if (!index.isValid()) {
        return;
    }
    const studio::SegmentInfo info = segmentAt(index); // a copy: the list may change while the menu is open
    auto* menu = new QMenu(this);
    menu->setObjectName("segmentMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [menu](const char* name, const QString& text, auto run) {
        menu->addAction(text, run)->setObjectName(name);
    };
    add("showOnlySegment", tr("Show only this"), [this, info] { studio_.segments().showOnly(info.name); });
    add("showAllSegments", tr("Show all"), [this] { studio_.segments().showAll(); });
    add("pullOutSegment", info.pulledOut ? tr("Put back") : tr("Pull out"),
        [this, info] { studio_.segments().pullOut(info.name); });
    menu->addSeparator();
    const QPersistentModelIndex name(index.siblingAtColumn(SegmentModel::Name));
    add("renameSegment", tr("Rename"), [this, name] { edit(name); });
    add("colourSegment", tr("Colour\u2026"), [this, info] { chooseColour(info); });
    menu->addSeparator();
    addTreatments(*menu, info);
    menu->popup(event->globalPos());
}

// What tools do with a segment, as a choice in its menu.
void SegmentTable::addTreatments(QMenu& menu, const studio::SegmentInfo& info) {
    using Treated = studio::SegmentInfo::Treatment;
    auto* choice = new QActionGroup(&menu);
    const auto add = [&](const char* name, const QString& text, Treated treatment) {
        auto* action = menu.addAction(text);
        action->setObjectName(name);
        action->setCheckable(true);
        action->setChecked(info.treatment == treatment);
        choice->addAction(action);
        connect(action, &QAction::triggered, this,
                [this, name = info.name, treatment] { studio_.segments().setTreatment(name, treatment); });
    };
    add("toolsTake", tr("Tools take it like all else"), Treated::Take);
    add("toolsSpare", tr("Tools spare it"), Treated::Spare);
    add("toolsTakeOnly", tr("Tools take only this"), Treated::TakeOnly);
}

void SegmentTable::activate(const QModelIndex& index) {
    if (index.column() == SegmentModel::Colour) {
        chooseColour(segmentAt(index));
    } else {
        model_->toggle(order_->mapToSource(index));
    }
}

void SegmentTable::chooseColour(const studio::SegmentInfo& info) {
    auto* dialog = new QColorDialog(
        QColor::fromRgbF(float(info.colour.r), float(info.colour.g), float(info.colour.b)), this);
    dialog->setObjectName("segmentColour");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    dialog->setWindowTitle(tr("Colour of %1").arg(QString::fromStdString(info.name)));
    connect(dialog, &QColorDialog::colorSelected, this,
            [this, name = info.name](const QColor& colour) { studio_.segments().setColour(name, colour); });
    dialog->open();
}

void SegmentTable::keyPressEvent(QKeyEvent* event) {
    const QModelIndex index = currentIndex();
    switch (event->key()) {
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (index.column() == SegmentModel::Name) {
            edit(index);
        } else if (index.column() != SegmentModel::Volume) {
            activate(index);
        }
        return;
    case Qt::Key_Delete:
        studio_.segments().removeWorking();
        return;
    default:
        QTableView::keyPressEvent(event);
    }
}

} // namespace vs::desktop
