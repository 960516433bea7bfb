// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/fine_front.h"

#include "volume/grid/visit_type.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace vs::segment {

namespace {

// Calls f with a pointer to values of their own type.
template <typename F>
auto visitValues(volume::ScalarType type, const std::vector<std::byte>& values, F&& f) {
    return volume::visitType(
        type, [&](const auto* none) { return f(reinterpret_cast<decltype(none)>(values.data())); });
}

template <typename F>
void forEachTile(HostBrick& brick, F&& f) {
    for (std::uint32_t tile = 0; tile < brick.tiles.size(); ++tile) {
        f(brick.tiles[tile], tile, 8 * HostBricks::placeOfTile(tile));
    }
}

bool hasOpen(const HostBrick& brick) {
    return std::any_of(brick.tiles.begin(), brick.tiles.end(),
                       [](const HostTile& tile) { return tile.open.any() != 0; });
}

void closeByFence(HostBrick& brick, const Box3& box, const FineRules& rules) {
    const bool keepsCutPart = rules.constraints->view == field::SculptureView::Probe;
    const auto cuts = (*rules.fence)(box);
    forEachVoxel(box, [&](glm::ivec3 voxel, std::size_t i) {
        if ((cuts[i] >= 0.5F) != keepsCutPart) {
            const std::size_t cell = cellOf(voxel - box.lo);
            slices::clear(brick.tiles[cell >> 9U].open, std::uint32_t(cell & 511U));
        }
    });
}

void closeBits(HostBrick& brick, const CellBits& bits) {
    for (std::size_t tile = 0; tile < brick.tiles.size(); ++tile) {
        for (std::size_t z = 0; z < 8; ++z) {
            brick.tiles[tile].open.z[z] &= ~bits[tile * 8 + z];
        }
    }
}

} // namespace

void closeWhatIsOutOfBounds(HostBrick& brick, const Box3& box, const FineRules& rules) {
    if (rules.forbidden != nullptr) {
        const auto forbidden = rules.forbidden->find(brick.number);
        if (forbidden != rules.forbidden->end()) {
            closeBits(brick, *forbidden->second);
        }
    }
    if (rules.constraints->hasFence() && hasOpen(brick)) {
        closeByFence(brick, box, rules);
    }
}

void closeByValues(HostBrick& brick, const Box3& box, const FineRules& rules) {
    if (!hasOpen(brick)) {
        return;
    }
    // Gradients look at voxels beside a voxel.
    const int margin = rules.constraints->gradient ? 1 : 0;
    const Box3 around = grow(box, margin);
    const auto values = rules.values->read(around);
    rules.values->readAhead(grow(box, field::kBrick));
    visitValues(rules.values->type(), values, [&](const auto* first) {
        const HostRules byValue(first, around.size(), rules.values->field(), *rules.constraints);
        forEachTile(brick, [&](HostTile& tile, std::uint32_t, glm::ivec3 inBrick) {
            if (tile.open.any() != 0) {
                tile.open &= byValue.admitted(inBrick + margin);
            }
        });
    });
}

bool admitsByValue(glm::ivec3 voxel, const FineRules& rules) {
    const Box3 around = grow(Box3{voxel, voxel + 1}, 1);
    const auto values = rules.values->read(around);
    return visitValues(rules.values->type(), values, [&](const auto* first) {
        return HostRules(first, around.size(), rules.values->field(), *rules.constraints)
            .admits(glm::ivec3(1));
    });
}

void FineBricks::keepValues(const HostBrick& brick) {
    if (rules_.constraints != nullptr && hasPairs(*rules_.constraints) && hasOpen(brick)) {
        values_[brick.number] = rules_.values->read(boxAround(brick.place * field::kBrick));
    }
}

bool FineBricks::leaveToTiles(HostBrick& brick) {
    if (!hasOpen(brick)) {
        brick.isTested.fill(1);
        return true;
    }
    if (heldBytes_ >= mostHeldBytes_) {
        return false;
    }
    const Box3 box = boxOf(brick);
    brick.values = rules_.values->blockAround(box.lo);
    rules_.values->readAhead(grow(box, field::kBrick));
    note(brick);
    return true;
}

void FineBricks::note(HostBrick& brick) {
    holding_.push_back(&brick);
    if (held_.try_emplace(brick.values.get(), brick.values->size()).second) {
        heldBytes_ += brick.values->size();
    }
}

void FineBricks::forget() {
    HostBricks::forget();
    for (HostBrick* brick : std::exchange(holding_, {})) {
        brick->values.reset();
    }
    held_.clear();
    heldBytes_ = 0;
    values_.clear();
}

void FineBricks::letGoBehind(const std::vector<HostBrick*>& front) {
    keepOnly(front);
    std::erase_if(values_, [&](const auto& entry) { return !isMade(entry.first); });
    holding_.clear();
    held_.clear();
    heldBytes_ = 0;
    std::unordered_set<const HostBrick*> seen;
    for (HostBrick* brick : front) {
        if (seen.insert(brick).second && brick->values != nullptr) {
            note(*brick);
        }
    }
}

std::size_t FineBricks::memoryBytes() const {
    std::size_t bytes = madeBytes() + heldBytes_;
    for (const auto& [brick, values] : values_) {
        bytes += values.size();
    }
    return bytes;
}

void FineBricksToGrowInto::open(HostBrick& brick) {
    const Box3 box = boxOf(brick);
    forEachTile(brick, [&](HostTile& tile, std::uint32_t, glm::ivec3 inBrick) {
        tile.open = slices::box(glm::clamp(box.size() - inBrick, glm::ivec3(0), glm::ivec3(8)));
    });
    const auto cells = rules_.map->find(brick.number);
    if (cells != rules_.map->end()) {
        cells->second->forEachGrown([&](std::size_t cell, std::uint32_t) {
            slices::clear(brick.tiles[cell >> 9U].open, std::uint32_t(cell & 511U));
        });
    }
    closeWhatIsOutOfBounds(brick, box, rules_);
    const bool isByRange = !rules_.constraints->gradient && !hasPairs(*rules_.constraints);
    if (isByRange && leaveToTiles(brick)) {
        return;
    }
    closeByValues(brick, box, rules_);
    brick.isTested.fill(1);
    keepValues(brick);
}

void FineBricksOfSegment::open(HostBrick& brick) {
    for (HostTile& tile : brick.tiles) {
        tile.open = {};
    }
    const auto cells = rules_.map->find(brick.number);
    if (cells != rules_.map->end() && cells->second->holds(rules_.label, after_)) {
        cells->second->forEachGrown([&](std::size_t cell, std::uint32_t generation) {
            if (int(generation) > after_ && cells->second->label(cell) == rules_.label) {
                slices::set(brick.tiles[cell >> 9U].open, std::uint32_t(cell & 511U));
            }
        });
        if (rules_.constraints != nullptr) {
            closeWhatIsOutOfBounds(brick, boxOf(brick), rules_);
            closeByValues(brick, boxOf(brick), rules_);
        }
    }
    brick.isTested.fill(1);
    keepValues(brick);
}

} // namespace vs::segment
