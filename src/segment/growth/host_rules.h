// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/constraints.h"
#include "segment/growth/slices.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>

namespace vs::segment {

// What the rules of growth say of a volume's voxels, by their values: shaders/constraints.glsl on the host,
// with equal answers. The fence is not among them. Internal to this folder.
template <typename T>
class HostRules {
public:
    // The values, x fastest, must outlive this: those of the field, or of a box of so many voxels, which the
    // voxels that are asked about are then counted in; its outermost ones have no gradients of their own.
    HostRules(const T* values, const field::Field& field, const Constraints& constraints)
        : HostRules(values, field.geometry.dims, field, constraints) {}
    HostRules(const T* values, glm::ivec3 dims, const field::Field& field, const Constraints& constraints)
        : values_(values), dims_(dims), range_(comparable(field, constraints.range)),
          gradient_(rounded(constraints.gradient)), difference_(differenceOf(field, constraints.difference)),
          gradientDifference_(rounded(constraints.gradientDifference)),
          gradientAlong_(gradientColumns(field)) {}

    // The rules asked of values that lie elsewhere, of a box of the same size, or of another.
    [[nodiscard]] HostRules of(const T* values) const { return of(values, dims_); }
    [[nodiscard]] HostRules of(const T* values, glm::ivec3 dims) const {
        HostRules rules = *this;
        rules.values_ = values;
        rules.dims_ = dims;
        return rules;
    }
    [[nodiscard]] glm::ivec3 dims() const { return dims_; }
    [[nodiscard]] std::size_t indexOf(glm::ivec3 voxel) const {
        return (std::size_t(voxel.z) * std::size_t(dims_.y) + std::size_t(voxel.y)) * std::size_t(dims_.x) +
               std::size_t(voxel.x);
    }

    // What a voxel alone decides.
    [[nodiscard]] bool admits(glm::ivec3 voxel) const {
        return isInRange(values_[indexOf(voxel)]) && (!gradient_ || isWithin(magnitude(voxel), *gradient_));
    }
    [[nodiscard]] bool asksOnlyForRange() const { return !gradient_ && !hasPairs(); }
    [[nodiscard]] bool isInRangeAt(std::size_t index) const { return isInRange(values_[index]); }

    // Whether there are rules for pairs; what a pair of neighbours decides.
    [[nodiscard]] bool hasPairs() const { return difference_ || gradientDifference_; }
    [[nodiscard]] bool admitsFrom(glm::ivec3 parent, glm::ivec3 child) const {
        return (!difference_ || isWithin(valueAt(child) - valueAt(parent), *difference_)) &&
               (!gradientDifference_ || isWithin(magnitude(child) - magnitude(parent), *gradientDifference_));
    }

    // What the voxels of the tile at `origin` decide alone; those outside the grid are refused.
    [[nodiscard]] Slices admitted(glm::ivec3 origin) const {
        const glm::ivec3 size = glm::min(dims_ - origin, glm::ivec3(8));
        Slices admitted;
        for (int z = 0; z < size.z; ++z) {
            const T* row = values_ + indexOf(origin + glm::ivec3(0, 0, z));
            for (int y = 0; y < size.y; ++y, row += dims_.x) {
                const std::uint64_t bits = size.x == 8 ? inRange(row) : inRange(row, size.x);
                admitted.z[std::size_t(z)] |= bits << unsigned(8 * y);
            }
        }
        if (gradient_) {
            slices::forEach(admitted, [&](std::uint32_t place) {
                if (!isWithin(magnitude(origin + slices::voxelAt(place)), *gradient_)) {
                    slices::clear(admitted, place);
                }
            });
        }
        return admitted;
    }

private:
    // What ranges are compared in: whole numbers of the type itself, or floats.
    using Compared = std::conditional_t<std::is_integral_v<T> && sizeof(T) <= 2, T, float>;
    struct Ends {
        Compared lo{};
        Compared hi{};
    };

    static Ends comparable(const field::Field& field, const Range& range) {
        const glm::vec2 ends = comparableRange(field, range);
        return ends.x <= ends.y ? Ends{Compared(ends.x), Compared(ends.y)} : Ends{Compared(1), Compared(0)};
    }
    static std::optional<glm::vec2> rounded(const std::optional<Range>& range) {
        return range ? std::optional(glm::vec2(float(range->lo), float(range->hi))) : std::nullopt;
    }

    static std::optional<glm::vec2> differenceOf(const field::Field& field,
                                                 const std::optional<Range>& range) {
        return range ? std::optional(comparableDifference(field, range)) : std::nullopt;
    }

    [[nodiscard]] bool isInRange(T value) const {
        const auto compared = Compared(value);
        return compared >= range_.lo && compared <= range_.hi;
    }
    static bool isWithin(float value, glm::vec2 range) { return value >= range.x && value <= range.y; }

    // Eight numbers that the processor compares at once; g++ and clang make the best of what it has.
    template <typename Number>
    using Eight [[gnu::vector_size(8 * sizeof(Number))]] = Number;

    // Bit x: whether voxel x of a row of eight is in the range.
    [[nodiscard]] std::uint64_t inRange(const T* row) const {
        Eight<T> values;
        std::memcpy(&values, row, sizeof(values));
        const auto compared = __builtin_convertvector(values, Eight<Compared>);
        const auto is =
            __builtin_convertvector((compared >= range_.lo) & (compared <= range_.hi), Eight<signed char>);
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, &is, sizeof(bytes));
        return (bytes & slices::kColumn) * 0x0102040810204080ULL >> 56U; // gathers one bit of each byte
    }
    [[nodiscard]] std::uint64_t inRange(const T* row, int count) const {
        std::array<T, 8> eight{};
        std::copy_n(row, count, eight.begin());
        return inRange(eight.data()) & ((1U << unsigned(count)) - 1);
    }

    // The device has one number for all values that are not finite.
    [[nodiscard]] float valueAt(glm::ivec3 voxel) const {
        const auto value = float(values_[indexOf(voxel)]);
        return std::is_integral_v<T> || std::isfinite(value) ? value : field::kNonFinite;
    }

    // Central differences; beyond the grid values are those at its border. Rounded one by one, as on the
    // device: this folder is compiled without contraction.
    [[nodiscard]] float magnitude(glm::ivec3 voxel) const {
        const auto along = [&](int axis) {
            glm::ivec3 before = voxel;
            glm::ivec3 after = voxel;
            before[axis] = std::max(voxel[axis] - 1, 0);
            after[axis] = std::min(voxel[axis] + 1, dims_[axis] - 1);
            return valueAt(after) - valueAt(before);
        };
        const glm::vec3 x = gradientAlong_[0] * along(0);
        const glm::vec3 y = gradientAlong_[1] * along(1);
        const glm::vec3 z = gradientAlong_[2] * along(2);
        const glm::vec3 gradient = (x + y) + z;
        const glm::vec3 squares = gradient * gradient;
        return std::sqrt((squares.x + squares.y) + squares.z);
    }

    const T* values_;
    glm::ivec3 dims_;
    Ends range_;
    std::optional<glm::vec2> gradient_;
    std::optional<glm::vec2> difference_;
    std::optional<glm::vec2> gradientDifference_;
    glm::mat3 gradientAlong_;
};

} // namespace vs::segment
