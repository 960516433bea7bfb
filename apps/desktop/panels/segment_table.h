// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTableView>

namespace vs::desktop {

class SegmentModel;
class StudioController;

// The list of segments. The row that is marked is at work: new strokes and edits are its. A click on the
// swatch chooses a colour, on eye and lock toggles them; names are edited in place. By keyboard: arrow keys,
// Space or Enter on a cell, F2 for the name, Delete.
class SegmentTable : public QTableView {
    Q_OBJECT

public:
    static constexpr int kRowHeight = 26; // logical pixels

    explicit SegmentTable(StudioController& studio, QWidget* parent = nullptr);

    // Asks for the height of all its rows, within reason.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    void refresh();
    void activate(const QModelIndex& index);
    void chooseColour(int row);

    StudioController& studio_;
    SegmentModel* model_;
    bool isRefreshing_ = false;
};

} // namespace vs::desktop
