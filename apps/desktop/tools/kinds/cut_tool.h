// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/studio_tool.h"

namespace vs::desktop {

// A tool that cuts or, with its sign reversed, puts back what was cut. It remembers what was set for it.
class CutTool : public StudioTool {
    Q_OBJECT

public:
    static constexpr int kLeastRadius = 2;
    static constexpr int kMostRadius = 4;

    using StudioTool::StudioTool;

    [[nodiscard]] bool hasSign() const override { return true; }
    [[nodiscard]] bool isReversed() const override { return restores_; }
    void setReversed(bool reversed) override { setRestores(reversed); }
    [[nodiscard]] bool restores() const { return restores_ && !actsOnSegment() && !actsOnMaterial(); }
    void setRestores(bool restores);
    // Whether the tool can work on the segment at work instead of the scan, and whether it does: then it
    // takes away from it, or adds to it with the sign reversed.
    [[nodiscard]] virtual bool canActOnSegment() const { return false; }
    [[nodiscard]] bool actsOnSegment() const override;
    [[nodiscard]] bool adds() const override { return restores_ && actsOnSegment(); }
    // Whether it can work on material, and does.
    [[nodiscard]] virtual bool canActOnMaterial() const { return false; }
    [[nodiscard]] bool actsOnMaterial() const override;
    // The radiation's radius R, in steps. The larger, the rounder are a cut's edges.
    [[nodiscard]] int radius() const { return radius_; }
    void setRadius(int steps);

protected:
    [[nodiscard]] Overlay::Tint idleTint() const {
        return restores_ ? Overlay::Tint::ReadyToRestore : Overlay::Tint::Idle;
    }
    [[nodiscard]] Overlay::Tint cuttingTint() const {
        return restores_ ? Overlay::Tint::Restoring : Overlay::Tint::Cutting;
    }
    // A hint with what the tool works on when that is a segment, and how; a sketch says it by itself.
    [[nodiscard]] QString withTarget(const QString& hint) const;
    // What to draw, and how while there is room for it.
    [[nodiscard]] QString drawHint(const QString& what) const;
    // The pen has come down while the material in hand is to take the scan's value there. True: that is all
    // it was for.
    bool picksValue(const Pen& pen);
    // Whether its hints need to be told what it does with material; else they tell it themselves.
    [[nodiscard]] virtual bool saysWhatItFills() const { return true; }
    // Tells everybody that something was set.
    void tell();

private:
    bool restores_ = false;
    int radius_ = 3;
};

} // namespace vs::desktop
