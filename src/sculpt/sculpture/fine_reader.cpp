// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/fine_reader.h"

#include "field/field.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>

namespace vs::sculpt {

namespace {

// The values of all 16-bit floats.
const std::vector<float>& halves() {
    static const std::vector<float> values = [] {
        std::vector<float> all(1U << 16);
        for (std::size_t n = 0; n < all.size(); ++n) {
            all[n] = glm::unpackHalf1x16(std::uint16_t(n));
        }
        return all;
    }();
    return values;
}

// The voxels of the other grid whose samples meet a box of fine voxels.
Box3 reachedBy(const Box3& fine, const OtherGrid& grid) {
    return {glm::ivec3(glm::ceil((glm::dvec3(fine.lo) - 1.0 - grid.offset) / grid.scale)),
            glm::ivec3(glm::floor((glm::dvec3(fine.hi) - grid.offset) / grid.scale)) + 1};
}

} // namespace

FineReader::FineReader(const FineBricks& bricks, glm::ivec3 dims, Precision precision)
    : bricks_(bricks), dims_(dims), counts_(divideUp(dims, kFineBrick)), precision_(precision),
      texelBytes_(gl::bytesPerTexel(formatOf(precision))) {}

Box3 FineReader::boxOf(glm::ivec3 brick) const {
    return {brick * kFineBrick, glm::min((brick + 1) * kFineBrick, dims_)};
}

const std::vector<std::byte>* FineReader::brickAt(glm::ivec3 brick) {
    const int place = (brick.z * counts_.y + brick.y) * counts_.x + brick.x;
    if (place != place_) {
        const auto found = bricks_.find(place);
        place_ = place;
        last_ = found == bricks_.end() ? nullptr : found->second.get();
    }
    return last_;
}

float FineReader::decoded(const std::vector<std::byte>& texels, std::size_t n) const {
    const std::byte* at = texels.data() + (texels.size() == texelBytes_ ? 0 : n * texelBytes_);
    if (precision_ == Precision::Bits16) {
        std::uint16_t code = 0;
        std::memcpy(&code, at, sizeof(code));
        return halves()[code];
    }
    if (precision_ == Precision::Bits8) {
        return float(std::to_integer<int>(*at)) / 255.0F;
    }
    float value = 0;
    std::memcpy(&value, at, sizeof(value));
    return value;
}

float FineReader::at(glm::ivec3 voxel) {
    voxel = glm::clamp(voxel, glm::ivec3(0), dims_ - 1);
    const glm::ivec3 brick = voxel / kFineBrick;
    const std::vector<std::byte>* texels = brickAt(brick);
    if (texels == nullptr) {
        return 0;
    }
    const Box3 box = boxOf(brick);
    const glm::ivec3 size = box.size();
    const glm::ivec3 v = voxel - box.lo;
    return decoded(*texels,
                   (std::size_t(v.z) * std::size_t(size.y) + std::size_t(v.y)) * std::size_t(size.x) +
                       std::size_t(v.x));
}

float FineReader::between(const glm::dvec3& place) {
    const glm::dvec3 inside = glm::clamp(place, glm::dvec3(0), glm::dvec3(dims_ - 1));
    const glm::ivec3 v(inside);
    const glm::vec3 f(inside - glm::dvec3(v));
    const glm::ivec3 next = glm::min(v + 1, dims_ - 1);
    if (v / kFineBrick == next / kFineBrick) {
        const std::vector<std::byte>* texels = brickAt(v / kFineBrick);
        if (texels == nullptr || texels->size() == texelBytes_) { // all alike
            return texels == nullptr ? 0 : decoded(*texels, 0);
        }
    }
    const auto row = [&](int y, int z) {
        const float a = at({v.x, y, z});
        return f.x > 0 ? a + (at({next.x, y, z}) - a) * f.x : a;
    };
    const auto plane = [&](int z) {
        const float a = row(v.y, z);
        return f.y > 0 ? a + (row(next.y, z) - a) * f.y : a;
    };
    const float a = plane(v.z);
    return f.z > 0 ? a + (plane(next.z) - a) * f.z : a;
}

glm::vec2 FineReader::rangeOf(const Box3& voxels) {
    glm::vec2 range(1e30F, -1e30F);
    const auto include = [&](float value) {
        range.x = std::min(range.x, value);
        range.y = std::max(range.y, value);
    };
    const Box3 bricks{voxels.lo / kFineBrick, (voxels.hi - 1) / kFineBrick + 1};
    forEachVoxel(bricks, [&](glm::ivec3 brick, std::size_t) {
        const std::vector<std::byte>* texels = brickAt(brick);
        if (texels == nullptr || texels->size() == texelBytes_) {
            include(texels == nullptr ? 0 : decoded(*texels, 0));
            return;
        }
        const Box3 box = boxOf(brick);
        const Box3 part = intersect(voxels, box);
        const glm::ivec3 size = box.size();
        for (int z = part.lo.z; z < part.hi.z; ++z) {
            for (int y = part.lo.y; y < part.hi.y; ++y) {
                const std::size_t row =
                    (std::size_t(z - box.lo.z) * std::size_t(size.y) + std::size_t(y - box.lo.y)) *
                    std::size_t(size.x);
                for (int x = part.lo.x; x < part.hi.x; ++x) {
                    include(decoded(*texels, row + std::size_t(x - box.lo.x)));
                }
            }
        }
    });
    return range;
}

void sample(FineReader& reader, const FineBricks& bricks, const OtherGrid& grid, const Box3& voxels,
            const std::function<void(std::size_t, float)>& tell) {
    if (bricks.empty() || voxels.isEmpty()) {
        return;
    }
    const glm::ivec3 size = voxels.size();
    // The bricks that the box's samples meet, with what lies beyond the grid at its border.
    const glm::ivec3 top = reader.counts() - 1;
    const glm::ivec3 first =
        glm::clamp(glm::ivec3(glm::floor(grid.finePlace(voxels.lo))) / kFineBrick, glm::ivec3(0), top);
    const glm::ivec3 last = glm::clamp(
        (glm::ivec3(glm::floor(grid.finePlace(voxels.hi - 1))) + 1) / kFineBrick, glm::ivec3(0), top);
    forEachVoxel(Box3{first, last + 1}, [&](glm::ivec3 brick, std::size_t) {
        if (reader.brickAt(brick) == nullptr) {
            return;
        }
        Box3 reached = reachedBy(reader.boxOf(brick), grid);
        for (int axis = 0; axis < 3; ++axis) { // what lies beyond the border is what is at it
            reached.lo[axis] = brick[axis] == 0 ? voxels.lo[axis] : reached.lo[axis];
            reached.hi[axis] = brick[axis] == top[axis] ? voxels.hi[axis] : reached.hi[axis];
        }
        forEachVoxel(intersect(reached, voxels), [&](glm::ivec3 v, std::size_t) {
            const glm::ivec3 at = v - voxels.lo;
            tell((std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
                     std::size_t(at.x),
                 reader.between(grid.finePlace(v)));
        });
    });
}

} // namespace vs::sculpt
