// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/sculpture/sculpture.h"

#include <functional>
#include <optional>

namespace vs::sculpt {

// What tools cut into: a sculpture, all of which is on the device, or one that is finer, window by window.
class CutTarget {
public:
    // A part that can be worked on.
    struct Part {
        Sculpture* sculpture = nullptr;
        Box3 within; // voxels of the grid that it has
        BrickBackup* backup =
            nullptr; // bricks are protected there before they change; null: they are already
    };
    // Cuts or restores in a part, and says in which box something may have changed.
    using Work = std::function<Box3(const Part&)>;

    CutTarget() = default;
    virtual ~CutTarget() = default;
    CutTarget(const CutTarget&) = delete;
    CutTarget& operator=(const CutTarget&) = delete;

    // Says whether anything at all would be cut in a box.
    using Reaches = std::function<bool(const Box3&)>;
    // Calls work() for parts that together have all of a box, one after the other, without those that nothing
    // reaches. Returns the box in which something may have changed.
    virtual Box3 cutIn(const Box3& box, const Work& work, const Reaches& reaches = {}) = 0;
    // The parts that cutIn() makes of a large box are the cells of a grid with this side; 0: it has one part.
    [[nodiscard]] virtual int side() const { return 0; }
    // Cuts or restores the brick (32^3) that a box is, all of it, or none where that is what limits allow.
    // Returns whether that could be done so.
    virtual bool fill(const Box3& /*brick*/, Combine /*how*/) { return false; }
    // Has what fill() did be seen.
    virtual void finish() {}
    [[nodiscard]] virtual bool isEmpty() const = 0;
};

// All of a sculpture.
class WholeTarget : public CutTarget {
public:
    WholeTarget(Sculpture& sculpture, BrickBackup* backup) : sculpture_(sculpture), backup_(backup) {}

    Box3 cutIn(const Box3& /*box*/, const Work& work, const Reaches& /*reaches*/ = {}) override {
        return work({&sculpture_, {glm::ivec3(0), sculpture_.dims()}, backup_});
    }
    [[nodiscard]] bool isEmpty() const override { return sculpture_.isEmpty(); }

private:
    Sculpture& sculpture_;
    BrickBackup* backup_;
};

// The window through which a fine sculpture is worked on: made once, for all strokes.
class FineWindow {
public:
    static constexpr int kSide = 192; // voxels

    explicit FineWindow(Precision precision) : sculpture_(Sculpture::window(glm::ivec3(kSide), precision)) {}

    // Shows a box of the fine sculpture that is no larger than the window and begins and ends with bricks.
    Sculpture& look(const FineSculpture& fine, const Box3& box, const Limits& limits);
    // What it shows has become that of the fine sculpture's version.
    void agrees(const FineSculpture& fine) { version_ = fine.version(); }
    // What it shows is that of no version.
    void disagrees() { version_.reset(); }
    [[nodiscard]] std::vector<std::byte> texels(const Box3& box) const;

private:
    Limits limitsIn(const Box3& box, const Limits& limits);

    Sculpture sculpture_;
    Box3 shown_;
    std::optional<std::uint64_t> version_;       // of the fine sculpture
    gl::Texture memberships_;                    // where tools may work; made when first needed
    std::weak_ptr<const Limits::InBox> limited_; // by which they were found, in this box
    Box3 limitedBox_;
};

// The finer sculpture of one that is derived from it. What is cut is seen in both when cutIn() or finish()
// return.
class FineTarget : public CutTarget {
public:
    // `originals` takes what bricks were before they changed, `backup` likewise for the derived sculpture.
    FineTarget(Sculpture& derived, FineWindow& window, FineBricks& originals, BrickBackup& backup)
        : derived_(derived), fine_(*derived.finer()), window_(window), originals_(originals),
          backup_(backup) {}

    Box3 cutIn(const Box3& box, const Work& work, const Reaches& reaches = {}) override;
    [[nodiscard]] int side() const override { return FineWindow::kSide; }
    bool fill(const Box3& brick, Combine how) override;
    [[nodiscard]] bool isEmpty() const override { return fine_.isEmpty(); }
    void finish() override;

private:
    Box3 cutInWindow(const Box3& box, const Work& work);

    Sculpture& derived_;
    FineSculpture& fine_;
    FineWindow& window_;
    FineBricks& originals_;
    BrickBackup& backup_;
    Box3 filled_;
};

} // namespace vs::sculpt
