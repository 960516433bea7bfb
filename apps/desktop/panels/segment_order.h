// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCollator>
#include <QSortFilterProxyModel>

namespace vs::desktop {

class SegmentModel;

// The segments whose names hold what is searched for, in the order of a column: names as people sort them
// (Rib 2 before Rib 10).
class SegmentOrder : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit SegmentOrder(SegmentModel& segments, QObject* parent = nullptr);

    void search(const QString& text);

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    SegmentModel& segments_;
    QCollator collator_;
    QString text_;
};

} // namespace vs::desktop
