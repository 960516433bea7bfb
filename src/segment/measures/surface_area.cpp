// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/surface_area.h"

#include "base/check.h"
#include "base/parallel.h"

#include <bit>
#include <cmath>
#include <vector>

namespace vs::segment {
namespace {

constexpr int kNormalReach = 4;    // voxels that a normal looks to each side
constexpr double kSmoothing = 1.4; // sigma in voxels: less shows the stairs, more rounds edges further
constexpr int kTaps = 2 * kNormalReach + 1;

// A block owns the faces on the upper sides of its voxels. A row of them with the reach around is one word.
constexpr glm::ivec3 kBlock{64 - kTaps, 24, 24};
constexpr glm::ivec3 kRows = kBlock + kTaps;

using Areas = std::array<double, 256>;

// Gaussian weights of the voxels around a place on one axis and their first moments about it.
struct Kernel {
    std::array<double, kTaps> weight{};
    std::array<double, kTaps> moment{};
    std::array<glm::dvec2, 1 << kTaps> ofRow{}; // sums of both over the voxels of a row, given as bits

    // `centre` is where the place lies from the voxel: 0 on it, 0.5 on its upper side.
    explicit Kernel(double centre) {
        for (int i = centre > 0 ? 1 : 0; i < kTaps; ++i) { // as far down as up
            const double x = i - kNormalReach - centre;
            weight[std::size_t(i)] = std::exp(-0.5 * x * x / (kSmoothing * kSmoothing));
            moment[std::size_t(i)] = x * weight[std::size_t(i)];
        }
        for (std::size_t bits = 0; bits < ofRow.size(); ++bits) {
            for (std::size_t i = 0; i < kTaps; ++i) {
                ofRow[bits] += (bits >> i & 1) != 0 ? glm::dvec2(weight[i], moment[i]) : glm::dvec2(0);
            }
        }
    }
};

const Kernel& kernelOf(bool acrossFace) {
    static const Kernel onVoxel(0.0);
    static const Kernel onFace(0.5);
    return acrossFace ? onFace : onVoxel;
}

// The voxels of one label in and around a block. Bit x of row (y, z) is the voxel lo + (x, y, z) -
// kNormalReach.
class BlockMask {
public:
    BlockMask(const volume::GridGeometry& geometry, std::span<const std::uint8_t> labels, glm::ivec3 lo,
              std::uint8_t label)
        : rows_(std::size_t(kRows.y) * std::size_t(kRows.z)) {
        const glm::ivec3 dims = geometry.dims;
        const glm::ivec3 from = glm::max(lo - kNormalReach, glm::ivec3(0));
        const glm::ivec3 to = glm::min(lo - kNormalReach + kRows, dims);
        for (int z = from.z; z < to.z; ++z) {
            for (int y = from.y; y < to.y; ++y) {
                const auto* values = labels.data() + (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) *
                                                         std::size_t(dims.x);
                std::uint64_t bits = 0;
                for (int x = from.x; x < to.x; ++x) {
                    bits |= std::uint64_t(values[x] == label) << (x - lo.x + kNormalReach);
                }
                rows_[std::size_t((z - lo.z + kNormalReach) * kRows.y + y - lo.y + kNormalReach)] = bits;
            }
        }
    }

    // A row of the block or around it; y and z count from the block's first.
    [[nodiscard]] std::uint64_t row(int y, int z) const {
        return rows_[std::size_t((z + kNormalReach) * kRows.y + y + kNormalReach)];
    }

    // The direction of the mask's gradient in voxel space, on the upper side of a voxel along `axis`.
    [[nodiscard]] glm::dvec3 gradient(glm::ivec3 voxel, int axis) const {
        const Kernel& along = kernelOf(axis == 0);
        const Kernel& up = kernelOf(axis == 1);
        const Kernel& high = kernelOf(axis == 2);
        glm::dvec3 sum(0);
        for (std::size_t z = 0; z < kTaps; ++z) {
            for (std::size_t y = 0; y < kTaps; ++y) {
                const auto bits =
                    row(voxel.y + int(y) - kNormalReach, voxel.z + int(z) - kNormalReach) >> voxel.x;
                const glm::dvec2 x = along.ofRow[bits & (along.ofRow.size() - 1)];
                sum += glm::dvec3(up.weight[y] * high.weight[z] * x.y, up.moment[y] * high.weight[z] * x.x,
                                  up.weight[y] * high.moment[z] * x.x);
            }
        }
        return sum;
    }

private:
    std::vector<std::uint64_t> rows_;
};

double areaInBlock(const BlockMask& mask, const glm::dmat3& worldFromVoxel) {
    constexpr std::uint64_t inside = ((std::uint64_t(1) << kBlock.x) - 1) << kNormalReach;
    const glm::dmat3 worldFromGradient = glm::transpose(glm::inverse(worldFromVoxel));
    const double voxelMm3 = std::abs(glm::determinant(worldFromVoxel));
    double area = 0;
    for (int z = 0; z < kBlock.z; ++z) {
        for (int y = 0; y < kBlock.y; ++y) {
            const std::uint64_t row = mask.row(y, z);
            const std::array<std::uint64_t, 3> above{row >> 1, mask.row(y + 1, z), mask.row(y, z + 1)};
            for (int axis = 0; axis < 3; ++axis) {
                const glm::dvec3 face = voxelMm3 * worldFromGradient[axis];
                for (auto faces = (row ^ above[std::size_t(axis)]) & inside; faces != 0; faces &= faces - 1) {
                    const glm::ivec3 voxel(std::countr_zero(faces) - kNormalReach, y, z);
                    const glm::dvec3 normal = worldFromGradient * mask.gradient(voxel, axis);
                    const double length = glm::length(normal);
                    area += length > 0 ? std::abs(glm::dot(face, normal)) / length : glm::length(face);
                }
            }
        }
    }
    return area;
}

// Labels in a box of voxels, cut to the grid.
std::array<bool, 256> labelsIn(const glm::ivec3 dims, std::span<const std::uint8_t> labels, Box3 box) {
    std::array<bool, 256> found{};
    box = intersect(box, {glm::ivec3(0), dims});
    for (int z = box.lo.z; z < box.hi.z; ++z) {
        for (int y = box.lo.y; y < box.hi.y; ++y) {
            const auto row = (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x);
            for (int x = box.lo.x; x < box.hi.x; ++x) {
                found[labels[row + std::size_t(x)]] = true;
            }
        }
    }
    found[0] = false;
    return found;
}

} // namespace

std::array<double, 256> surfaceAreas(const volume::GridGeometry& geometry,
                                     std::span<const std::uint8_t> labels) {
    VS_CHECK_EQ(labels.size(), geometry.voxelCount());
    // The grid's own lower sides belong to voxels before the first.
    const glm::ivec3 blocks = (geometry.dims + kBlock) / kBlock;
    std::vector<Areas> layers(std::size_t(blocks.z), Areas{});
    inParallel(blocks.z, threadsForMemory(), [&](int layer) {
        for (int y = 0; y < blocks.y; ++y) {
            for (int x = 0; x < blocks.x; ++x) {
                const glm::ivec3 lo = glm::ivec3(x, y, layer) * kBlock - 1;
                const auto found = labelsIn(geometry.dims, labels, {lo, lo + kBlock + 1});
                for (std::size_t label = 1; label < found.size(); ++label) {
                    if (found[label]) {
                        const BlockMask mask(geometry, labels, lo, std::uint8_t(label));
                        layers[std::size_t(layer)][label] +=
                            areaInBlock(mask, glm::dmat3(geometry.worldFromVoxel));
                    }
                }
            }
        }
    });
    Areas areas{};
    for (const Areas& layer : layers) { // in this order, so that the sums do not depend on the threads
        for (std::size_t label = 0; label < areas.size(); ++label) {
            areas[label] += layer[label];
        }
    }
    return areas;
}

} // namespace vs::segment
