// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/fill/fill.h"
#include "sculpt/sculpture/cut_target.h"

#include <memory>

namespace vs::sculpt {

// The window in which tools work on a fill: a sculpture in which nothing is cut, so that what a tool leaves
// in it is its energy. Made once, for all strokes.
class FillWindow {
public:
    static constexpr int kSide = 192; // voxels

    FillWindow() : sculpture_(Sculpture::window(glm::ivec3(kSide), Precision::Bits16)) {}

    // Has a tool work in a box no larger than the window, within these limits. Returns the box in which there
    // is energy, and that of its voxels, x fastest.
    struct Energies {
        Box3 box;
        std::vector<float> values;
    };
    Energies take(const Box3& box, const Limits& limits, const CutTarget::Work& work);

private:
    Sculpture sculpture_;
    gl::Texture memberships_; // where tools may work; made when first needed
};

// What tools fill, or take away from what is filled. The fill that `fill` shares is replaced by another one
// with each call of cutIn().
class FillTarget : public CutTarget {
public:
    // Fills with a material; 0: takes away.
    FillTarget(field::SharedFill& fill, std::uint8_t material, FillWindow& window, const Limits& limits)
        : fill_(fill), material_(material), window_(window), limits_(limits) {}

    Box3 cutIn(const Box3& box, const Work& work, const Reaches& reaches = {}) override;
    [[nodiscard]] int side() const override { return FillWindow::kSide; }
    [[nodiscard]] bool isEmpty() const override { return fill_->isEmpty(); }

private:
    Box3 cutInWindow(const Box3& box, const Work& work);

    field::SharedFill& fill_;
    std::uint8_t material_;
    FillWindow& window_;
    const Limits& limits_; // those that hold when it is cut
};

// Cuts the scan's sculpture, and what is filled with it.
class CutWithFill : public CutTarget {
public:
    CutWithFill(std::unique_ptr<CutTarget> scan, std::unique_ptr<CutTarget> fill)
        : scan_(std::move(scan)), fill_(std::move(fill)) {}

    Box3 cutIn(const Box3& box, const Work& work, const Reaches& reaches = {}) override {
        const Box3 cut = scan_->cutIn(box, work, reaches);
        return unite(cut, fill_->cutIn(box, work, reaches));
    }
    [[nodiscard]] int side() const override { return scan_->side(); }
    void finish() override { scan_->finish(); }
    [[nodiscard]] bool isEmpty() const override { return scan_->isEmpty(); }

private:
    std::unique_ptr<CutTarget> scan_;
    std::unique_ptr<CutTarget> fill_;
};

} // namespace vs::sculpt
