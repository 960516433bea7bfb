// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/segment_list.h"

#include <QAbstractTableModel>

namespace vs::desktop {

class SegmentController;

// The segments as rows of a table: colour, name, millilitres, whether it is seen, whether it is locked. Names
// are edited in place, eye and lock are toggled; all by way of the controller.
class SegmentModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Colour, Name, Volume, Eye, Lock, Columns };
    static constexpr int kSortRole = Qt::UserRole; // what a column is sorted by

    explicit SegmentModel(SegmentController& segments, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex&) const override { return Columns; }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

    // Looks at the document again.
    void refresh();
    void toggle(const QModelIndex& index); // eye or lock
    [[nodiscard]] const studio::SegmentInfo& segment(int row) const;
    [[nodiscard]] int workingRow() const;

private:
    [[nodiscard]] QVariant sortKey(const QModelIndex& index) const;

    SegmentController& segments_;
    studio::SegmentList shown_; // a copy: the document may be gone before the next look
    std::vector<QString> millilitres_;
};

} // namespace vs::desktop
