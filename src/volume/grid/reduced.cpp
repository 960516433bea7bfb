// SPDX-License-Identifier: Apache-2.0
#include "volume/grid/reduced.h"

#include "base/check.h"
#include "base/parallel.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <vector>

namespace vs::volume {

namespace {

template <typename T>
T meanOf(const std::vector<T>& block) {
    double sum = 0;
    std::size_t count = 0;
    for (const T value : block) {
        if (std::abs(double(value)) < kNotMeasured) { // which no NaN is
            sum += double(value);
            ++count;
        }
    }
    if (count == 0) {
        return block.front();
    }
    const double mean = sum / double(count);
    return std::is_integral_v<T> ? T(std::lround(mean)) : T(mean);
}

template <typename T>
T commonestOf(std::vector<T>& block) {
    std::sort(block.begin(), block.end());
    T best = block.front();
    std::ptrdiff_t most = 0;
    for (auto first = block.begin(); first != block.end();) {
        const auto last = std::find_if(first, block.end(), [&](T value) { return value != *first; });
        if (last - first > most) {
            most = last - first;
            best = *first;
        }
        first = std::max(last, std::next(first)); // NaN equals not even itself
    }
    return best;
}

template <typename T>
void reduceSlice(const T* from, glm::ivec3 dims, glm::ivec3 by, Reducing how, int k, glm::ivec2 size, T* to) {
    std::vector<T> block;
    for (int j = 0; j < size.y; ++j) {
        for (int i = 0; i < size.x; ++i) {
            const glm::ivec3 lo = glm::ivec3(i, j, k) * by;
            const glm::ivec3 hi = glm::min(lo + by, dims);
            block.clear();
            for (int z = lo.z; z < hi.z; ++z) {
                for (int y = lo.y; y < hi.y; ++y) {
                    const T* row =
                        from + (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x);
                    block.insert(block.end(), row + lo.x, row + hi.x);
                }
            }
            *to++ = how == Reducing::Mean ? meanOf(block) : commonestOf(block);
        }
    }
}

// Fills in the values of a grid of `size` voxels, on so many threads.
void reduceAll(const Volume& volume, glm::ivec3 by, Reducing how, glm::ivec3 size, int threads,
               std::vector<std::byte>& bytes) {
    bytes.resize(Box3{glm::ivec3(0), size}.volume() * sizeOf(volume.type));
    visit(volume, [&]<typename T>(const T* from) {
        T* to = reinterpret_cast<T*>(bytes.data());
        inParallel(size.z, threads, [&](int k) {
            reduceSlice(from, volume.geometry.dims, by, how, k, size,
                        to + std::size_t(k) * std::size_t(size.x) * std::size_t(size.y));
        });
    });
}

} // namespace

Volume reduced(const Volume& volume, glm::ivec3 by, Reducing how) {
    VS_CHECK(glm::all(glm::greaterThanEqual(by, glm::ivec3(1))));
    Volume result;
    result.type = volume.type;
    result.name = volume.name;
    result.unit = volume.unit;
    result.details = volume.details;
    const glm::ivec3 dims = volume.geometry.dims;
    result.geometry.dims = (dims + by - 1) / by;
    result.geometry.worldFromVoxel =
        glm::scale(glm::translate(volume.geometry.worldFromVoxel, 0.5 * glm::dvec3(by - 1)), glm::dvec3(by));
    reduceAll(volume, by, how, result.geometry.dims, processorCount(), result.bytes);
    computeRange(result);
    return result;
}

std::vector<std::byte> reducedValues(const Volume& volume, glm::ivec3 by, Reducing how) {
    std::vector<std::byte> bytes;
    reduceAll(volume, by, how, (volume.geometry.dims + by - 1) / by, 1, bytes);
    return bytes;
}

} // namespace vs::volume
