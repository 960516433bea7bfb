// SPDX-License-Identifier: Apache-2.0
// A brick's texels are made from whose its voxels are (Owned), of the finest level or of shares of it.
#include "segment/membership/fine_membership.h"

#include "segment/finer/fine_growth.h"
#include "segment/finer/finest_edges.h"
#include "segment/membership/fine_members.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace vs::segment {

namespace {

class Snapshot final : public field::BrickOverlay {
public:
    Snapshot(const FineGrowth& growth, const field::BrickGrid& finest, FineShown shown)
        : map_(growth.map()), atWork_(growth.label()), playhead_(growth.state().playhead), grid_(finest),
          shown_(std::move(shown)) {}

    [[nodiscard]] gl::Format format() const override {
        return shown_.hasTranslucent ? gl::Format::RGBA8 : gl::Format::RG8;
    }
    [[nodiscard]] bool isEmpty() const override { return map_.empty(); }

    [[nodiscard]] std::vector<std::byte> texelsOf(const field::BrickGrid& level,
                                                  glm::ivec3 brick) const override {
        const Owned owned = ownedAround(level, brick);
        if (!isAnyShown(owned.members)) {
            return {};
        }
        const std::size_t kinds = shown_.hasTranslucent ? 2 : 1;
        const std::size_t channels = gl::bytesPerTexel(format());
        const Box3 box = boxOf(level, brick);
        const Box3 own = intersect(box, {glm::ivec3(0), level.dims});
        std::vector<std::byte> texels(channels * box.volume());
        // What lies beyond the grid is what is at its border.
        const auto fill = [&](std::size_t channel, const Values<std::uint8_t>& values) {
            forEachVoxel(box, [&](glm::ivec3 v, std::size_t i) {
                texels[channels * i + channel] = std::byte(values.at(glm::min(v, level.dims - 1)));
            });
        };
        for (std::size_t kind = 0; kind < kinds; ++kind) {
            fill(kind, membership(owned.members, kind == 0 ? kOpaque : kTranslucent, own, level));
        }
        fill(kinds, owned.labels);
        return texels;
    }

    [[nodiscard]] bool isAlike(const BrickOverlay& other, const field::BrickGrid& level,
                               glm::ivec3 brick) const override {
        const auto* before = dynamic_cast<const Snapshot*>(&other);
        if (before == nullptr || !isMadeAlike(*before)) {
            return false;
        }
        const Box3 box = padded(level, brick);
        bool isSame = true;
        bool isAny = false;
        forEachBrick(FinestEdges(grid_, level, box).finestIn(box), [&](std::uint32_t number, glm::ivec3) {
            isAny = isAny || cellsOf(number) != nullptr;
            isSame = isSame && showsAlike(*before, number);
        });
        return isSame && (!isAny || areCutsAlike(*before, level, brick));
    }

    [[nodiscard]] Box3 changedSince(const Snapshot& before) const {
        const Box3 all{glm::ivec3(0), grid_.dims};
        if (!isMadeAlike(before) || shown_.view != before.shown_.view) {
            return all;
        }
        Box3 box;
        const auto note = [&](std::uint32_t number) {
            if (!showsAlike(before, number)) {
                const glm::ivec3 counts = divideUp(grid_.dims, field::kBrick);
                const auto row = std::uint32_t(counts.x);
                const auto rows = std::uint32_t(counts.y);
                const glm::ivec3 place(number % row, number / row % rows, number / row / rows);
                box = unite(box, {place * field::kBrick, (place + 1) * field::kBrick});
            }
        };
        for (const auto& [number, cells] : map_) {
            note(number);
        }
        for (const auto& [number, cells] : before.map_) {
            note(number);
        }
        return box;
    }

private:
    static constexpr int kPad = kKernelReach + kBehindCuts; // which holds what is thin at coarser levels, too

    [[nodiscard]] static Box3 boxOf(const field::BrickGrid& level, glm::ivec3 brick) {
        return {brick * level.side, brick * level.side + level.texels()};
    }
    [[nodiscard]] static Box3 padded(const field::BrickGrid& level, glm::ivec3 brick) {
        return intersect(grow(boxOf(level, brick), kPad), {glm::ivec3(0), level.dims});
    }
    [[nodiscard]] const FineCells* cellsOf(std::uint32_t number) const {
        const auto found = map_.find(number);
        return found == map_.end() ? nullptr : found->second.get();
    }
    // Generations of a segment that are shown end with this one.
    [[nodiscard]] std::uint32_t lastShown(std::uint8_t label) const {
        return label == atWork_ ? std::uint32_t(playhead_) : std::numeric_limits<std::uint32_t>::max();
    }
    [[nodiscard]] bool isMadeAlike(const Snapshot& before) const {
        return before.shown_.smoothing == shown_.smoothing &&
               before.shown_.hasTranslucent == shown_.hasTranslucent &&
               before.shown_.sceneSpacing == shown_.sceneSpacing;
    }
    // The same voxels of a brick are shown in the same way.
    [[nodiscard]] bool showsAlike(const Snapshot& before, std::uint32_t number) const {
        const FineCells* cells = cellsOf(number);
        if (cells != before.cellsOf(number)) {
            return false;
        }
        return cells == nullptr ||
               std::all_of(cells->spans().begin(), cells->spans().end(), [&](const auto& entry) {
                   const std::uint8_t label = entry.first;
                   const auto shownOf = [first = entry.second.first,
                                         last = entry.second.last](std::uint32_t upTo) {
                       return upTo < first ? 0U : std::min(upTo, last);
                   };
                   return shown_.looks[label] == before.shown_.looks[label] &&
                          shownOf(lastShown(label)) == shownOf(before.lastShown(label));
               });
    }
    [[nodiscard]] bool areCutsAlike(const Snapshot& before, const field::BrickGrid& level,
                                    glm::ivec3 brick) const {
        if (shown_.view != before.shown_.view ||
            (shown_.cuts == nullptr) != (before.shown_.cuts == nullptr)) {
            return false;
        }
        bool isSame = true;
        const Box3 around = intersect(grow(Box3{brick, brick + 1}, 1), {glm::ivec3(0), level.counts()});
        forEachVoxel(shown_.cuts == nullptr ? Box3() : around, [&](glm::ivec3 near, std::size_t) {
            isSame = isSame && shown_.cuts->isAlike(*before.shown_.cuts, level, near);
        });
        return isSame;
    }

    // Calls visit(number, first voxel) with the bricks of the finest level that meet a box.
    template <typename Visit>
    void forEachBrick(const Box3& finest, const Visit& visit) const {
        const glm::ivec3 counts = divideUp(grid_.dims, field::kBrick);
        if (finest.isEmpty()) {
            return;
        }
        forEachVoxel(Box3{finest.lo / field::kBrick, (finest.hi - 1) / field::kBrick + 1},
                     [&](glm::ivec3 place, std::size_t) {
                         const int number = (place.z * counts.y + place.y) * counts.x + place.x;
                         visit(std::uint32_t(number), place * field::kBrick);
                     });
    }
    [[nodiscard]] static bool isAnyShown(const Members& members) {
        return std::any_of(members.all.begin(), members.all.end(), [](Member whose) { return whose != 0; });
    }
    [[nodiscard]] bool isAnyShown(const FineCells& cells) const {
        return std::any_of(cells.spans().begin(), cells.spans().end(), [&](const auto& entry) {
            return shown_.looks[entry.first] != Look::Hidden && entry.second.first <= lastShown(entry.first);
        });
    }
    // Calls visit(voxel, whose, label) with the voxels of the finest level in a box that are shown in
    // segments.
    template <typename Visit>
    void forEachMember(const Box3& finest, const Visit& visit) const {
        forEachBrick(finest, [&](std::uint32_t number, glm::ivec3 lo) {
            const FineCells* cells = cellsOf(number);
            if (cells == nullptr || !isAnyShown(*cells)) {
                return;
            }
            cells->forEachGrown([&](std::size_t cell, std::uint32_t generation) {
                const std::uint8_t label = cells->label(cell);
                const auto whose = Member(shown_.looks[label]);
                const glm::ivec3 voxel = lo + voxelOfCell(cell);
                if (whose != 0 && generation <= lastShown(label) &&
                    glm::all(glm::greaterThanEqual(voxel, finest.lo)) &&
                    glm::all(glm::lessThan(voxel, finest.hi))) {
                    visit(voxel, whose, label);
                }
            });
        });
    }

    // Whose the voxels of a level are, in a brick and as far around as counts for it.
    [[nodiscard]] Owned ownedAround(const field::BrickGrid& level, glm::ivec3 brick) const {
        const Box3 box = padded(level, brick);
        const FinestEdges edges(grid_, level, box);
        Owned owned = level.dims == grid_.dims ? ownedAtFinest(box) : ownedByShares(edges);
        if (isAnyShown(owned.members) && shown_.fence && shown_.view != field::SculptureView::Whole) {
            hideCut(edges, owned.members);
            goOnBehindCuts(owned.members);
        }
        return owned;
    }
    [[nodiscard]] Owned ownedAtFinest(const Box3& box) const {
        Owned owned(box);
        forEachMember(box, [&](glm::ivec3 voxel, Member whose, std::uint8_t label) {
            const std::size_t i = owned.members.indexOf(voxel);
            owned.members.all[i] = whose;
            owned.labels.all[i] = label;
        });
        return owned;
    }
    [[nodiscard]] Owned ownedByShares(const FinestEdges& edges) const {
        // The voxel of the level that each finest one lies in, along each axis.
        std::array<std::vector<int>, 3> levelOf;
        for (int axis = 0; axis < 3; ++axis) {
            for (int v = edges.box.lo[axis]; v < edges.box.hi[axis]; ++v) {
                const int count = edges.edge(axis, v + 1) - edges.edge(axis, v);
                levelOf[std::size_t(axis)].insert(levelOf[std::size_t(axis)].end(), std::size_t(count), v);
            }
        }
        const Box3 finest = edges.finestIn(edges.box);
        Shares shares(edges.box);
        forEachMember(finest, [&](glm::ivec3 voxel, Member whose, std::uint8_t label) {
            const glm::ivec3 at = voxel - finest.lo;
            shares.add(
                {levelOf[0][std::size_t(at.x)], levelOf[1][std::size_t(at.y)], levelOf[2][std::size_t(at.z)]},
                whose, label);
        });
        return shares.owned([&](glm::ivec3 v) { return edges.finestIn({v, v + 1}).volume(); });
    }
    // What the viewer does not see is marked so.
    void hideCut(const FinestEdges& edges, Members& members) const {
        const bool isProbe = shown_.view == field::SculptureView::Probe;
        // The finest voxel in the middle of one of the level's, along an axis.
        const auto middleOf = [&](int axis, int v) {
            return std::min((edges.edge(axis, v) + edges.edge(axis, v + 1)) / 2, grid_.dims[axis] - 1);
        };
        const Box3 finest = edges.finestIn(members.box);
        for (int z = members.box.lo.z; z < members.box.hi.z; ++z) {
            for (int y = members.box.lo.y; y < members.box.hi.y; ++y) {
                const glm::ivec2 at(middleOf(1, y), middleOf(2, z));
                const Box3 row{{finest.lo.x, at}, {finest.hi.x, at + 1}};
                const std::vector<float> cut = shown_.fence(row);
                for (int x = members.box.lo.x; x < members.box.hi.x; ++x) {
                    Member& whose = members.at({x, y, z});
                    const bool isCut = cut[std::size_t(middleOf(0, x) - row.lo.x)] >= 0.5F;
                    whose = isCut != isProbe ? Member(whose + kBehind) : whose;
                }
            }
        }
    }

    [[nodiscard]] Values<std::uint8_t> membership(const Members& members, Member channel, const Box3& own,
                                                  const field::BrickGrid& level) const {
        return membershipOf(members, channel, own, shown_.sceneSpacing / level.perSceneVoxel,
                            shown_.smoothing);
    }

    FineMap map_;
    std::uint8_t atWork_;
    int playhead_;
    field::BrickGrid grid_;
    FineShown shown_;
};

} // namespace

std::shared_ptr<const field::BrickOverlay>
fineMembership(const FineGrowth& growth, const field::BrickGrid& finest, const FineShown& shown) {
    return std::make_shared<Snapshot>(growth, finest, shown);
}

Box3 changedBetween(const field::BrickOverlay& before, const field::BrickOverlay& now) {
    return dynamic_cast<const Snapshot&>(now).changedSince(dynamic_cast<const Snapshot&>(before));
}

} // namespace vs::segment
