// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/segment_list.h"

#include <QTableView>

namespace vs::desktop {

class SegmentModel;
class SegmentOrder;
class StudioController;

// The list of segments. The row that is marked is at work: new strokes and edits are its. A click on the
// swatch chooses a colour, on eye and lock toggles them, with Alt on the eye shows that one alone or all
// again; names are edited in place, the right button offers all of it. By keyboard: arrow keys, Space or
// Enter on a cell, F2 for the name, Delete. A long list has a header to sort it by.
class SegmentTable : public QTableView {
    Q_OBJECT

public:
    static constexpr int kRowHeight = 26; // logical pixels
    static constexpr int kLong = 8;       // more segments than these are searched and sorted

    explicit SegmentTable(StudioController& studio, QWidget* parent = nullptr);

    // Asks for the height of a few rows; maximumHeight() is that of all.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
    // Shows those whose names hold a text.
    void search(const QString& text);
    [[nodiscard]] bool isLong() const;

signals:
    void lengthChanged(); // isLong() may be another

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void mousePressEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void refresh();
    [[nodiscard]] QString names() const;
    void addTreatments(QMenu& menu, const studio::SegmentInfo& info);
    void activate(const QModelIndex& index);
    void chooseColour(const studio::SegmentInfo& info);
    void showOnlyOrAll(const studio::SegmentInfo& info);
    [[nodiscard]] int heightOf(int rows) const;
    [[nodiscard]] const studio::SegmentInfo& segmentAt(const QModelIndex& index) const;

    StudioController& studio_;
    SegmentModel* model_;
    SegmentOrder* order_; // of the model's rows, which this shows
    bool isRefreshing_ = false;
};

} // namespace vs::desktop
