// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/playing/act.h"

#include "studio/operations/drawn.h"

#include <vector>

namespace vs::desktop {

// What was drawn on the picture: its lines appear as a pen would draw them, and then it is done.
class DrawnAct : public Act {
public:
    DrawnAct(studio::Operation operation, StudioController& studio);

    State advance(double seconds) override;
    State complete() override;
    std::optional<studio::Operation> stopHere() override { return operation_; }
    [[nodiscard]] Overlays overlays() const override;

protected:
    // Does what is due so many seconds after all was drawn. At once, unless it is overridden.
    virtual State carryOut(double seconds);
    [[nodiscard]] const studio::Canvas& canvas() const { return canvas_; }
    // Lines of the canvas as they are seen in the view. Nothing when the person looks from elsewhere.
    [[nodiscard]] std::optional<QPolygonF> seen(const studio::Drawn::Line& line) const;

    studio::Operation operation_; // with its canvas
    studio::Drawn drawn_;
    bool isAllDrawn_ = false;

private:
    void addPart(Overlays& overlays, const studio::Drawn::Line& line, double& left, bool isClosed) const;

    studio::Canvas canvas_;
    double length_ = 0;  // of all lines, pixels of the canvas
    double seconds_ = 0; // that drawing them takes
    double shown_ = 0;   // of the length
};

// A peel, drill or laser, which cuts while it goes on.
class CutAct : public DrawnAct {
public:
    using DrawnAct::DrawnAct;

    State complete() override;
    // A stroke that has begun to cut is finished: half of one is not what anybody drew.
    std::optional<studio::Operation> stopHere() override;
    [[nodiscard]] Overlays overlays() const override;

protected:
    State carryOut(double seconds) override;

private:
    State begin();
    State cutTo(double share);
    State commit();

    bool isOpen_ = false;
    std::size_t places_ = 0; // of the pen, done so far
};

} // namespace vs::desktop
