// SPDX-License-Identifier: Apache-2.0
#include "dialogs/segment_checks.h"

#include "parts/panel_parts.h"

#include <QCheckBox>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace vs::desktop {

namespace {

constexpr int kMostRows = 6; // more are scrolled to

QIcon swatch(glm::dvec3 colour) {
    QPixmap picture(14, 14);
    picture.fill(QColor::fromRgbF(float(colour.r), float(colour.g), float(colour.b)));
    return picture;
}

} // namespace

SegmentChecks::SegmentChecks(std::vector<studio::ExportedSegment> segments) : segments_(std::move(segments)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    all_ = makeCheckBox("exportAll", tr("All segments"), tr("All of them, or none"), true);
    all_->setVisible(segments_.size() > 1);
    column->addWidget(all_);
    column->addWidget(makeList());
    connect(all_, &QCheckBox::clicked, this, &SegmentChecks::chooseAll);
}

QScrollArea* SegmentChecks::makeList() {
    auto* page = new QWidget;
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(8, 6, 8, 6);
    rows->setSpacing(4);
    for (const auto& segment : segments_) {
        const QString name = QString::fromStdString(segment.name);
        auto* box = named(new QCheckBox(name), "exportSegment", name);
        box->setIcon(swatch(segment.colour));
        box->setChecked(true);
        connect(box, &QCheckBox::toggled, this, &SegmentChecks::refresh);
        rows->addWidget(box, 0, Qt::AlignLeft);
        boxes_.push_back(box);
    }
    auto* list = named(new QScrollArea, "exportList", tr("Segments to export"));
    list->setWidget(page);
    list->setWidgetResizable(true);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->ensurePolished(); // its frame is the theme's
    if (!boxes_.empty()) {
        const int shown = std::min(int(boxes_.size()), kMostRows);
        const int row = boxes_.front()->sizeHint().height() + rows->spacing();
        list->setFixedHeight(shown * row - rows->spacing() + 12 + 2 * list->frameWidth());
    }
    return list;
}

// All, or none. From some it goes to all.
void SegmentChecks::chooseAll() {
    const bool takesAll = all_->checkState() != Qt::Unchecked;
    for (QCheckBox* box : boxes_) {
        const QSignalBlocker blocker(box);
        box->setChecked(takesAll);
    }
    refresh();
}

void SegmentChecks::refresh() {
    const std::size_t taken = chosen().size();
    all_->setCheckState(taken == 0                  ? Qt::Unchecked
                        : taken == segments_.size() ? Qt::Checked
                                                    : Qt::PartiallyChecked);
    emit changed();
}

std::vector<studio::ExportedSegment> SegmentChecks::chosen() const {
    std::vector<studio::ExportedSegment> found;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        if (boxes_[i]->isChecked()) {
            found.push_back(segments_[i]);
        }
    }
    return found;
}

} // namespace vs::desktop
