// SPDX-License-Identifier: Apache-2.0
// A fine sculpture as it was at one moment, laid over bricks of any level.
#include "sculpt/sculpture/fine_reader.h"
#include "sculpt/sculpture/fine_texels.h"

namespace vs::sculpt {

namespace {

// A sculpture as it was at one moment.
class Snapshot : public field::BrickOverlay {
public:
    Snapshot(std::shared_ptr<const FineBricks> bricks, const field::BrickGrid& grid, Precision precision)
        : bricks_(std::move(bricks)), grid_(grid), precision_(precision) {}

    [[nodiscard]] gl::Format format() const override { return formatOf(precision_); }
    [[nodiscard]] bool isEmpty() const override { return bricks_->empty(); }
    [[nodiscard]] std::vector<std::byte> texelsOf(const field::BrickGrid& level,
                                                  glm::ivec3 brick) const override {
        OtherGrid grid;
        grid.scale = grid_.perSceneVoxel / level.perSceneVoxel;
        grid.offset = grid_.origin - level.origin * grid.scale;
        if (glm::all(glm::lessThan(glm::abs(grid.scale - 1.0), glm::dvec3(1e-9)))) { // the very same
            grid.scale = glm::dvec3(1);
            grid.offset = glm::round(grid.offset);
        }
        const glm::ivec3 lo = brick * level.side;
        const Box3 box{lo, lo + level.texels()};
        const bool isFinest = grid.scale == glm::dvec3(1) && grid.offset == glm::dvec3(0);
        if (isFinest && intersect(box, {glm::ivec3(0), grid_.dims}) == box) {
            return anyIn(box) ? texelsIn(*bricks_, grid_.dims, gl::bytesPerTexel(format()), box)
                              : std::vector<std::byte>();
        }
        std::vector<float> values;
        FineReader reader(*bricks_, grid_.dims, precision_);
        sample(reader, *bricks_, grid, box, [&](std::size_t n, float value) {
            if (values.empty()) {
                values.resize(box.volume());
            }
            values[n] = value;
        });
        return values.empty() ? std::vector<std::byte>() : sculpt::texelsOf(values, precision_);
    }
    [[nodiscard]] bool isAlike(const BrickOverlay& other, const field::BrickGrid& level,
                               glm::ivec3 brick) const override {
        const auto* before = dynamic_cast<const Snapshot*>(&other);
        if (before == nullptr) {
            return false;
        }
        const glm::dvec3 scale = grid_.perSceneVoxel / level.perSceneVoxel;
        const glm::dvec3 offset = grid_.origin - level.origin * scale;
        const glm::dvec3 lo = glm::dvec3(brick * level.side) * scale + offset - 1.0;
        const glm::dvec3 hi = glm::dvec3(brick * level.side + level.texels()) * scale + offset + 1.0;
        bool isSame = true;
        forEachBrick({glm::ivec3(glm::floor(lo)), glm::ivec3(glm::ceil(hi)) + 1},
                     [&](int place) { isSame = isSame && at(place) == before->at(place); });
        return isSame;
    }

private:
    // Calls visit(place) with the bricks that meet a box, or are at the border nearest to it.
    template <typename Visit>
    void forEachBrick(const Box3& box, const Visit& visit) const {
        const glm::ivec3 counts = divideUp(grid_.dims, kFineBrick);
        const glm::ivec3 first = glm::clamp(glm::max(box.lo, 0) / kFineBrick, glm::ivec3(0), counts - 1);
        const glm::ivec3 last = glm::clamp(glm::max(box.hi - 1, 0) / kFineBrick, glm::ivec3(0), counts - 1);
        forEachVoxel(Box3{first, last + 1}, [&](glm::ivec3 brick, std::size_t) {
            visit((brick.z * counts.y + brick.y) * counts.x + brick.x);
        });
    }
    [[nodiscard]] FineBrick at(int place) const {
        const auto found = bricks_->find(place);
        return found == bricks_->end() ? FineBrick() : found->second;
    }
    [[nodiscard]] bool anyIn(const Box3& box) const {
        bool any = false;
        forEachBrick(box, [&](int place) { any = any || bricks_->contains(place); });
        return any;
    }

    std::shared_ptr<const FineBricks> bricks_;
    field::BrickGrid grid_;
    Precision precision_;
};

} // namespace

std::shared_ptr<const field::BrickOverlay> FineSculpture::snapshot() const {
    return std::make_shared<Snapshot>(bricks_, grid_, precision_);
}

} // namespace vs::sculpt
