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

// The voxels of a brick that rules let in by themselves: their values, the fence, what is forbidden. Throws
// ReadError.
void closeWhatRulesRefuse(HostBrick& brick, const Box3& box, const FineRules& rules);
// Whether they let in one voxel, by its value alone.
bool admitsByValue(glm::ivec3 voxel, const FineRules& rules);

// Bricks of the finest level that a set may spread into. Each is asked about as a whole when it is come to:
// its values are read then, and let go of, unless rules for pairs of neighbours will ask for them again.
class FineBricks : public HostBricks {
public:
    explicit FineBricks(glm::ivec3 dims) : HostBricks(dims), dims_(dims) {}
    // All must stay until the next call.
    void goBy(const FineRules& rules) { rules_ = rules; }
    [[nodiscard]] const FineRules& rules() const { return rules_; }

    // The voxels of a box two voxels wider than the brick that a voxel lies in; that is in hand.
    [[nodiscard]] const std::vector<std::byte>& valuesAround(glm::ivec3 voxel) const {
        return values_.at(found(voxel)->number);
    }
    [[nodiscard]] static Box3 boxAround(glm::ivec3 voxel) {
        const glm::ivec3 lo = voxel / field::kBrick * field::kBrick;
        return {lo - kMargin, lo + field::kBrick + kMargin};
    }
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

    glm::ivec3 dims_;
    FineRules rules_;
    std::unordered_map<std::uint32_t, std::vector<std::byte>> values_; // for rules for pairs
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

// The rules that are left to be asked of open voxels: those for pairs of neighbours.
template <typename T>
class FinePairs {
public:
    explicit FinePairs(const FineBricks& bricks)
        : bricks_(bricks),
          has_(bricks.rules().constraints != nullptr && FineBricks::hasPairs(*bricks.rules().constraints)),
          rules_(nullptr, FineBricks::boxAround(glm::ivec3(0)).size(), bricks.rules().values->field(),
                 has_ ? *bricks.rules().constraints : Constraints()) {}

    [[nodiscard]] bool asksOnlyForRange() const { return !has_; }
    [[nodiscard]] bool hasPairs() const { return has_; }
    [[nodiscard]] bool isInRangeAt(std::size_t /*index*/) const { return true; }
    [[nodiscard]] bool admits(glm::ivec3 /*voxel*/) const { return true; }
    [[nodiscard]] Slices admitted(glm::ivec3 /*origin*/) const { return slices::box(glm::ivec3(8)); }
    [[nodiscard]] bool admitsFrom(glm::ivec3 parent, glm::ivec3 child) const {
        if (!has_) {
            return true;
        }
        const auto* values = reinterpret_cast<const T*>(bricks_.valuesAround(child).data());
        const glm::ivec3 lo = FineBricks::boxAround(child).lo;
        return rules_.of(values).admitsFrom(parent - lo, child - lo);
    }

private:
    const FineBricks& bricks_;
    bool has_;
    HostRules<T> rules_; // of values that are said with each question
};

} // namespace vs::segment
