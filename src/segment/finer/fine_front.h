// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_cells.h"
#include "segment/finer/fine_values.h"
#include "segment/growth/constraints.h"
#include "segment/growth/host_bricks.h"
#include "segment/growth/host_rules.h"

#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

namespace vs::segment {

// How far a cut has gone at the voxels of a box of the finest level, x fastest: from 0 to 1, cut from 0.5.
using FineFence = std::function<std::vector<float>(const Box3&)>;
using ForbiddenBits = std::unordered_map<std::uint32_t, std::shared_ptr<const CellBits>>; // by brick

// What spreading at the finest level goes by.
struct FineRules {
    FineValues* values = nullptr;
    const FineMap* map = nullptr;
    const Constraints* constraints = nullptr; // null: none
    const FineFence* fence = nullptr;         // where the constraints have one
    const ForbiddenBits* forbidden = nullptr; // null: nothing is
    std::uint8_t label = 1;
};

// Closes the voxels of a brick that rules refuse whatever their values: the fence, what is forbidden.
void closeWhatIsOutOfBounds(HostBrick& brick, const Box3& box, const FineRules& rules);
// Closes those that rules refuse by their values alone. Throws ReadError.
void closeByValues(HostBrick& brick, const Box3& box, const FineRules& rules);
// Whether they let in one voxel, by its value alone.
bool admitsByValue(glm::ivec3 voxel, const FineRules& rules);

// Bricks of the finest level that a set may spread into. Their values are read when a brick is come to. Where
// rules ask for a range alone, each tile of it is asked about when it is, as long as the values that are kept
// for that are not too many; else the brick is as a whole, and its values are let go of, unless rules for
// pairs of neighbours will ask for them again.
class FineBricks : public HostBricks {
public:
    // `mostHeldBytes`: of values that are kept for tiles.
    explicit FineBricks(glm::ivec3 dims, std::size_t mostHeldBytes = 0)
        : HostBricks(dims), dims_(dims), mostHeldBytes_(mostHeldBytes) {}
    // All must stay until the next call.
    void goBy(const FineRules& rules) { rules_ = rules; }
    // From now on bricks are made anew.
    void forget();
    [[nodiscard]] const FineRules& rules() const { return rules_; }

    // The voxels of a box two voxels wider than the brick that a voxel lies in; that is in hand.
    [[nodiscard]] const std::vector<std::byte>& valuesAround(glm::ivec3 voxel) const {
        return values_.at(found(voxel)->number);
    }
    [[nodiscard]] static Box3 boxAround(glm::ivec3 voxel) {
        const glm::ivec3 lo = voxel / field::kBrick * field::kBrick;
        return {lo - kMargin, lo + field::kBrick + kMargin};
    }
    // A brick that is in hand, by a voxel.
    [[nodiscard]] const HostBrick& inHand(glm::ivec3 voxel) const { return *found(voxel); }
    // Lets go of all but what the front needs.
    void letGoBehind(const std::vector<HostBrick*>& front);
    [[nodiscard]] std::size_t memoryBytes() const;

    static constexpr int kMargin = 2; // gradients of neighbours
    [[nodiscard]] static bool hasPairs(const Constraints& constraints) {
        return constraints.difference || constraints.gradientDifference;
    }

protected:
    [[nodiscard]] Box3 boxOf(const HostBrick& brick) const {
        const glm::ivec3 lo = brick.place * field::kBrick;
        return {lo, glm::min(lo + field::kBrick, dims_)};
    }
    void keepValues(const HostBrick& brick);
    // Leaves what values decide in a brick to be asked tile by tile; false: too many are kept. Throws
    // ReadError.
    bool leaveToTiles(HostBrick& brick);

    glm::ivec3 dims_;
    FineRules rules_;

private:
    void note(HostBrick& brick);

    std::unordered_map<std::uint32_t, std::vector<std::byte>> values_; // for rules for pairs
    std::vector<HostBrick*> holding_;                                  // bricks with values of their own
    std::unordered_map<const void*, std::size_t> held_; // the blocks that these are in, and their bytes
    std::size_t heldBytes_ = 0;
    std::size_t mostHeldBytes_;
};

// The bricks in which a segment may grow: open is what nobody has and the rules let in.
class FineBricksToGrowInto final : public FineBricks {
public:
    using FineBricks::FineBricks;

private:
    void open(HostBrick& brick) override;
};

// The bricks of a segment: open is what it has of generations after one; with constraints, what these would
// let in of that.
class FineBricksOfSegment final : public FineBricks {
public:
    FineBricksOfSegment(glm::ivec3 dims, int after) : FineBricks(dims), after_(after) {}

private:
    void open(HostBrick& brick) override;

    int after_;
};

// The rules that are left to be asked of open voxels: of tiles that were not asked about whether their values
// are in range, of pairs of neighbours the rules for these.
template <typename T>
class FineRulesLeft {
public:
    explicit FineRulesLeft(const FineBricks& bricks)
        : bricks_(bricks),
          has_(bricks.rules().constraints != nullptr && FineBricks::hasPairs(*bricks.rules().constraints)),
          rules_(nullptr, FineBricks::boxAround(glm::ivec3(0)).size(), bricks.rules().values->field(),
                 bricks.rules().constraints != nullptr ? *bricks.rules().constraints : Constraints()) {}

    // Values are found by their voxel, not by a number in all of the level.
    [[nodiscard]] static bool asksOnlyForRange() { return false; }
    [[nodiscard]] static bool isInRangeAt(std::size_t /*index*/) { return true; }
    [[nodiscard]] bool hasPairs() const { return has_; }
    [[nodiscard]] bool admits(glm::ivec3 voxel) const {
        const Box3 block = bricks_.rules().values->blockBox(voxel);
        return inBlock(voxel, block).admits(voxel - block.lo);
    }
    [[nodiscard]] Slices admitted(glm::ivec3 origin) const {
        const Box3 block = bricks_.rules().values->blockBox(origin);
        return inBlock(origin, block).admitted(origin - block.lo);
    }
    [[nodiscard]] bool admitsFrom(glm::ivec3 parent, glm::ivec3 child) const {
        if (!has_) {
            return true;
        }
        const auto* values = reinterpret_cast<const T*>(bricks_.valuesAround(child).data());
        const glm::ivec3 lo = FineBricks::boxAround(child).lo;
        return rules_.of(values).admitsFrom(parent - lo, child - lo);
    }

private:
    [[nodiscard]] HostRules<T> inBlock(glm::ivec3 voxel, const Box3& block) const {
        return rules_.of(reinterpret_cast<const T*>(bricks_.inHand(voxel).values->data()), block.size());
    }

    const FineBricks& bricks_;
    bool has_;
    HostRules<T> rules_; // of values that are said with each question
};

} // namespace vs::segment
