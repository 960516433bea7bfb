// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/state/pasted_parts.h"

#include <QListWidget>

#include <optional>
#include <string>
#include <vector>

namespace vs::desktop {

class MoveTool;
class StudioController;

// The pasted parts and the segments that are pulled out, those that are hidden too. The row that is marked is
// in the move tool's hand; the box before a name says whether it is seen; names are edited in place; Delete
// discards a part and puts a segment back.
class PartList : public QListWidget {
    Q_OBJECT

public:
    // A pasted part, by its number from 0, or a segment that is pulled out, by its name.
    struct Entry {
        std::optional<int> part;
        std::string name;
        bool isVisible = true;
        bool takesTrimmed = false; // of a part

        bool operator==(const Entry&) const = default;
    };

    PartList(StudioController& studio, MoveTool& tool);

    [[nodiscard]] std::optional<Entry> current() const;
    void discardCurrent();

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void shown(); // what there is, or which is in hand, may be another

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] std::vector<Entry> entries() const;
    // The row of the part that is in the tool's hand.
    [[nodiscard]] int rowInHand() const;
    void refresh();
    void takeInHand(int row);
    void takeOver(QListWidgetItem* item);
    void rename(const Entry& entry, const QString& name);

    StudioController& studio_;
    MoveTool& tool_;
    std::vector<Entry> entries_; // as the rows show them
};

} // namespace vs::desktop
