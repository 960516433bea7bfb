// SPDX-License-Identifier: Apache-2.0
#include "panels/segment_table.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "panels/segment_model.h"

#include <QColorDialog>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>

#include <algorithm>

namespace vs::desktop {

namespace {
constexpr int kLeastRows = 2;
constexpr int kMostRows = 5; // more are scrolled to
} // namespace

SegmentTable::SegmentTable(StudioController& studio, QWidget* parent)
    : QTableView(parent), studio_(studio), model_(new SegmentModel(studio.segments(), this)) {
    setModel(model_);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setTabKeyNavigation(false); // Tab goes on to the next control
    setShowGrid(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setIconSize(QSize(17, 17));
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(kRowHeight);
    auto* header = horizontalHeader();
    header->hide();
    header->setMinimumSectionSize(20);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(SegmentModel::Name, QHeaderView::Stretch);
    setColumnWidth(SegmentModel::Colour, 28);
    setColumnWidth(SegmentModel::Volume, 72);
    setColumnWidth(SegmentModel::Eye, 28);
    setColumnWidth(SegmentModel::Lock, 28);
    connect(&studio_.host(), &DocumentHost::changed, this, &SegmentTable::refresh);
    refresh();
}

QSize SegmentTable::sizeHint() const {
    const int rows = std::clamp(model_ != nullptr ? model_->rowCount() : 0, kLeastRows, kMostRows);
    return {200, rows * kRowHeight + 2 * frameWidth()};
}

void SegmentTable::refresh() {
    isRefreshing_ = true;
    const int rows = model_->rowCount();
    const int column = std::max(0, currentIndex().column());
    model_->refresh();
    if (model_->rowCount() != rows) {
        updateGeometry();
    }
    const int working = model_->workingRow();
    if (currentIndex().row() != working) {
        setCurrentIndex(model_->index(working, column));
        scrollTo(currentIndex());
    }
    isRefreshing_ = false;
}

void SegmentTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTableView::currentChanged(current, previous);
    if (!isRefreshing_ && current.isValid() && current.row() != model_->workingRow()) {
        studio_.segments().workOn(model_->segment(current.row()).name);
    }
}

void SegmentTable::mousePressEvent(QMouseEvent* event) {
    const QModelIndex index = indexAt(event->position().toPoint());
    const bool isButton =
        index.isValid() && index.column() != SegmentModel::Name && index.column() != SegmentModel::Volume;
    if (event->button() == Qt::LeftButton && isButton) {
        setFocus(Qt::MouseFocusReason);
        activate(index);
        return;
    }
    QTableView::mousePressEvent(event);
}

void SegmentTable::activate(const QModelIndex& index) {
    if (index.column() == SegmentModel::Colour) {
        chooseColour(index.row());
    } else {
        model_->toggle(index);
    }
}

void SegmentTable::chooseColour(int row) {
    const studio::SegmentInfo info = model_->segment(row);
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
