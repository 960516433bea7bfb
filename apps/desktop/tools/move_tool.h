// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/studio_tool.h"
#include "tools/movable_parts.h"
#include "tools/placement_by_hand.h"

#include "base/math.h"

#include <QTimer>

#include <optional>

namespace vs::desktop {

class CameraTool;

// Moves, turns and scales pasted parts and segments that are pulled out by hand. Each has a handle with its
// number; the chosen one has its box around it. Seen while it moves; one operation when it is let go.
class MoveTool : public StudioTool {
    Q_OBJECT

public:
    MoveTool(StudioController& studio, CameraTool& camera);

    [[nodiscard]] QString name() const override { return "move"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Overlays overlays() const override;
    [[nodiscard]] Qt::CursorShape cursor() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void hover(const Pen& pen) override;
    bool wheel(double notches, const Pen& pen) override;
    [[nodiscard]] bool takesShift() const override { return isOver_; }
    bool next(bool forward) override;
    void clear() override;
    void finishPending() override;
    [[nodiscard]] bool isBusy() const override { return before_.has_value() || isTurningView_; }

    // The number of the chosen part, counted from 0.
    [[nodiscard]] int chosen() const { return chosen_; }
    void choose(int part);
    [[nodiscard]] int count() const { return parts_.count(); }
    // The number of a pasted part (at that place of the view) or else of the segment of that name, while it
    // can be moved.
    [[nodiscard]] std::optional<int> numberOf(std::optional<int> pasted, const std::string& segment) const {
        return pasted ? parts_.numberOf(std::size_t(*pasted)) : parts_.numberOf(segment);
    }
    // Where the parts' handles are, in logical pixels of the view.
    [[nodiscard]] std::vector<QPointF> handles() const;
    // Where the chosen part was put, or is in the hand; nothing if there is none.
    [[nodiscard]] std::optional<render::Placement> place() const;
    // Puts the chosen part back where it was pasted from or lies, upright and at its own size.
    void resetPlace();

private:
    void findParts();
    [[nodiscard]] HeldPart held(int part) const;
    [[nodiscard]] std::optional<int> handleAt(QPointF position) const;
    [[nodiscard]] bool isOverChosen(QPointF position) const;
    void begin();
    void show(const render::Placement& place);
    void commit();
    void drop();

    CameraTool& camera_;
    int chosen_ = 0;
    std::optional<MovableParts::Identity> identity_; // of the chosen one
    MovableParts parts_;
    bool isOver_ = false; // the pen hovers over the chosen part or a handle
    bool isTurningView_ = false;
    std::optional<render::Placement> before_; // where the chosen one was, while it is in hand
    QPointF last_;
    QTimer calm_; // the wheel has no end of its own
};

} // namespace vs::desktop
