// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"
#include "field/bricks/brick_overlay.h"
#include "sculpt/sculpture/limits.h"
#include "sculpt/sculpture/precision.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vs::sculpt {

inline constexpr int kFineBrick = 32; // voxels along a side

// Texels of a brick of 32^3 voxels (fewer at the grid's end), x fastest; one texel alone: all are alike.
// Null: nothing is cut there. Bricks never change; what changes is which one lies in a place.
using FineBrick = std::shared_ptr<const std::vector<std::byte>>;
using FineBricks = std::unordered_map<int, FineBrick>; // by place in the grid, x fastest; never null

// One change of a fine sculpture, as the bricks that certain places have on the other side of it, packed.
struct FineDelta {
    std::vector<std::pair<int, FineBrick>> bricks; // as packed() gives them
    std::size_t changedVoxels = 0;

    [[nodiscard]] bool isEmpty() const { return bricks.empty(); }
    [[nodiscard]] std::size_t memoryBytes() const;
};
// A brick as it is kept while nobody looks at it, smaller, and from that itself again. Of a brick that is
// null, or all alike, it is the same. Throw Error when there is no memory for it.
FineBrick packed(const FineBrick& brick);
FineBrick unpacked(const FineBrick& kept, std::size_t bytes);

// What has been cut away of a scan that is worked on at a coarser level, at its finest: a scalar from 0
// (untouched) to 1 (cut) for each voxel of that level, the cut face at 0.5, in bricks on the host. So it has
// the room that is cut faces, however large the scan is. Strokes change it window by window
// (FineTarget); from it the scene's own sculpture is derived, and what pictures of finer levels show.
class FineSculpture {
public:
    // `grid` is the finest level's, in the scene's voxel space; its side does not matter.
    FineSculpture(field::BrickGrid grid, Precision precision);

    [[nodiscard]] glm::ivec3 dims() const { return grid_.dims; }
    [[nodiscard]] const field::BrickGrid& grid() const { return grid_; }
    [[nodiscard]] Precision precision() const { return precision_; }
    [[nodiscard]] bool isEmpty() const { return bricks_->empty(); }
    [[nodiscard]] std::size_t brickCount() const { return bricks_->size(); }
    // Counts every change.
    [[nodiscard]] std::uint64_t version() const { return version_; }

    // Texels of a box, x fastest, as textures of that precision hold them.
    [[nodiscard]] std::vector<std::byte> texels(const Box3& box) const;
    // The bricks that meet `box` get these texels there. `box` begins and ends where bricks do, or the grid.
    // What was there before is added to `before`, where that has nothing for the place yet.
    void put(const Box3& box, std::span<const std::byte> texels, FineBricks& before);
    // A whole brick is cut, or whole again. Returns whether it was not.
    bool fill(glm::ivec3 brick, bool isCut, FineBricks& before);
    // Follows a cut that was made in the scene's sculpture: where its values in a box of the scene's voxels
    // (x fastest) rose, voxels rise to what is between them there, as far as limits let them. What was there
    // before is added to `originals`, as put() does.
    void raise(const Box3& sceneBox, std::span<const float> before, std::span<const float> after,
               FineBricks& originals, const Limits& limits = {});
    // Undo and redo. When it throws, nothing has changed.
    void swap(FineDelta& delta);
    // What undoes all that has happened since `before` was begun. Bricks that are as they were are left out.
    [[nodiscard]] FineDelta since(const FineBricks& before) const;
    // Puts everything back as it was then.
    void takeBack(const FineBricks& before);
    // Nothing is cut any more. Returns what undoes that.
    FineDelta clear();

    // The sculpture as it is now, for pictures: it stays so.
    [[nodiscard]] std::shared_ptr<const field::BrickOverlay> snapshot() const;
    // Values of boxes of it as it is now, x fastest: it stays so, and threads may ask at once.
    [[nodiscard]] std::function<std::vector<float>(const Box3&)> reader() const;
    // Whether nothing is cut in boxes of it, likewise.
    [[nodiscard]] std::function<bool(const Box3&)> emptyBoxes() const;
    // The voxels in which bricks have changed since an earlier version.
    [[nodiscard]] Box3 changedSince(std::uint64_t version) const;

    // The places in the scene's voxel space that a box of voxels reaches: voxels there depend on it.
    [[nodiscard]] Box3 sceneBox(const Box3& box) const;
    // Values at the scene's voxels of a box, x fastest.
    [[nodiscard]] std::vector<float> sceneValues(const Box3& sceneBox) const;
    // Smallest and greatest value in each of the scene's macrocells of a box of them, x fastest.
    [[nodiscard]] std::vector<glm::vec2> cellRanges(const Box3& cells) const;

private:
    [[nodiscard]] glm::ivec3 counts() const;
    [[nodiscard]] int placeOf(glm::ivec3 brick) const;
    [[nodiscard]] Box3 boxOf(int place) const;
    [[nodiscard]] FineBrick at(int place) const;
    [[nodiscard]] std::size_t bytesOf(int place) const;
    void set(int place, FineBrick brick);
    void noteChange(const Box3& box);
    FineBricks& writable();

    field::BrickGrid grid_;
    Precision precision_;
    std::shared_ptr<FineBricks> bricks_ = std::make_shared<FineBricks>(); // snapshots share it
    std::uint64_t version_ = 0;
    struct Change {
        std::uint64_t version = 0; // the one it led to
        Box3 box;
    };
    std::vector<Change> changes_; // the oldest first; the first holds all that came before it
};

} // namespace vs::sculpt
