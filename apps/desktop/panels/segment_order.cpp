// SPDX-License-Identifier: Apache-2.0
#include "panels/segment_order.h"

#include "panels/segment_model.h"

namespace vs::desktop {

SegmentOrder::SegmentOrder(SegmentModel& segments, QObject* parent)
    : QSortFilterProxyModel(parent), segments_(segments) {
    setSourceModel(&segments_);
    setSortRole(SegmentModel::kSortRole);
    collator_.setNumericMode(true);
    collator_.setCaseSensitivity(Qt::CaseInsensitive);
}

void SegmentOrder::search(const QString& text) {
    text_ = text.trimmed();
    invalidateFilter();
}

bool SegmentOrder::filterAcceptsRow(int row, const QModelIndex&) const {
    return QString::fromStdString(segments_.segment(row).name).contains(text_, Qt::CaseInsensitive);
}

bool SegmentOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    return left.column() == SegmentModel::Name
               ? collator_.compare(left.data(sortRole()).toString(), right.data(sortRole()).toString()) < 0
               : QSortFilterProxyModel::lessThan(left, right);
}

} // namespace vs::desktop
