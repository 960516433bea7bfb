// SPDX-License-Identifier: Apache-2.0
#include "volume/store/store_extremes.h"

#include "base/check.h"
#include "base/parallel.h"
#include "volume/grid/visit_type.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

namespace vs::volume {

StoredType storedTypeOf(ScalarType type) {
    switch (type) {
    case ScalarType::UInt8:
        return StoredType::UInt8;
    case ScalarType::Int8:
        return StoredType::Int8;
    case ScalarType::UInt16:
        return StoredType::UInt16;
    case ScalarType::Int16:
        return StoredType::Int16;
    case ScalarType::UInt32:
        return StoredType::UInt32;
    case ScalarType::Int32:
        return StoredType::Int32;
    case ScalarType::Float32:
        break;
    }
    return StoredType::Float32;
}

namespace {

constexpr std::size_t kMostCells = std::size_t(1) << 25;

std::size_t countOf(glm::ivec3 cells) {
    return std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z);
}

// Values that are not finite stand for nothing that is seen; what lies between them and others has any value
// below those.
template <typename T>
void widen(T value, T& lo, T& hi) {
    if constexpr (std::is_floating_point_v<T>) {
        constexpr T belowAll = -1e30F;
        value = std::isfinite(value) ? value : belowAll;
    }
    lo = std::min(lo, value);
    hi = std::max(hi, value);
}

template <typename T>
void addCells(std::byte* bytes, glm::ivec3 cells, glm::ivec3 first, int side, const Box3& box,
              const T* values) {
    auto* ranges = reinterpret_cast<T*>(bytes);
    const glm::ivec3 size = box.size();
    forEachVoxel({glm::ivec3(0), divideUp(size, side)}, [&](glm::ivec3 cell, std::size_t) {
        T lo = std::numeric_limits<T>::max();
        T hi = std::numeric_limits<T>::lowest();
        const Box3 inBox = intersect({cell * side, (cell + 1) * side}, {glm::ivec3(0), size});
        for (int z = inBox.lo.z; z < inBox.hi.z; ++z) {
            for (int y = inBox.lo.y; y < inBox.hi.y; ++y) {
                const T* row =
                    values + (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x);
                for (int x = inBox.lo.x; x < inBox.hi.x; ++x) {
                    widen(row[x], lo, hi);
                }
            }
        }
        const glm::ivec3 at = first + cell;
        T* out = ranges +
                 2 * ((std::size_t(at.z) * std::size_t(cells.y) + std::size_t(at.y)) * std::size_t(cells.x) +
                      std::size_t(at.x));
        out[0] = lo;
        out[1] = hi;
    });
}

std::optional<ScalarType> scalarTypeOf(StoredType stored) {
    for (const ScalarType type : kScalarTypes) {
        if (storedTypeOf(type) == stored) {
            return type;
        }
    }
    return {};
}

// Of a store that has them: the values of this program's types are its own, others become floats when they
// are read.
std::optional<ScalarType> typeOfExtremes(const Multiscales& store) {
    return store.extremes ? scalarTypeOf(store.extremes->array.type) : std::nullopt;
}

// Calls visit(first, values) with the number of the first cell of each chunk, of several at once, and the
// bytes of all of its cells; without a file all values are 0, and it is not called.
template <typename Visit>
void forEachChunk(const Multiscales& store, std::size_t bytesOfCell, const Visit& visit) {
    const ZarrArray& array = store.extremes->array;
    const glm::ivec3 cells = divideUp(store.levels.front().geometry.dims, store.extremes->side);
    const auto perSlice = std::size_t(cells.x) * std::size_t(cells.y);
    const int deep = int(array.chunks.front());
    for (int n = 0; n < int(array.chunkCount(0)); ++n) {
        announceStored(array.storedBytes(std::array<std::int64_t, 4>{n, 0, 0, 0}));
    }
    inParallel(int(array.chunkCount(0)), [&](int n) {
        if (const auto values = array.readChunk(std::array<std::int64_t, 4>{n, 0, 0, 0})) {
            const auto slices = std::size_t(std::min(deep, cells.z - n * deep));
            visit(std::size_t(n) * std::size_t(deep) * perSlice,
                  std::span(*values).first(slices * perSlice * bytesOfCell));
        }
    });
}

} // namespace

int extremesSide(glm::ivec3 dims, int chunk) {
    int side = 4;
    while (countOf(divideUp(dims, side)) > kMostCells) {
        side *= 2;
    }
    return chunk % side == 0 ? side : 0;
}

ZarrArray extremesArray(const std::filesystem::path& store, const ZarrArray& finest, glm::ivec3 dims,
                        int side) {
    const glm::ivec3 cells = divideUp(dims, side);
    ZarrArray array;
    array.folder = store / "ranges";
    array.shape = {cells.z, cells.y, cells.x, 2};
    array.chunks = {finest.chunks.front() / side, cells.y, cells.x, 2};
    array.type = finest.type;
    array.codec = finest.codec;
    return array;
}

SlabExtremes::SlabExtremes(const ZarrArray& extremes, ScalarType type, int side, int firstZ)
    : type_(type), side_(side), firstZ_(firstZ / side),
      cells_(int(extremes.chunks[2]), int(extremes.chunks[1]), int(extremes.chunks[0])),
      bytes_(extremes.chunkBytes()) {
    VS_CHECK_EQ(bytes_.size(), 2 * countOf(cells_) * sizeOf(type));
}

void SlabExtremes::add(const Box3& box, std::span<const std::byte> values) {
    const glm::ivec3 first = box.lo / side_ - glm::ivec3(0, 0, firstZ_);
    visitType(type_, [&]<typename T>(const T*) {
        addCells(bytes_.data(), cells_, first, side_, box, reinterpret_cast<const T*>(values.data()));
    });
}

std::optional<CellExtremes> readExtremes(const Multiscales& store) {
    const auto type = typeOfExtremes(store);
    if (!type) {
        return {};
    }
    const std::size_t bytesOfCell = 2 * sizeOf(*type);
    CellExtremes all{
        store.extremes->side, divideUp(store.levels.front().geometry.dims, store.extremes->side), *type, {}};
    announcePromised(countOf(all.cells) * bytesOfCell);
    all.ranges.resize(countOf(all.cells) * bytesOfCell);
    forEachChunk(store, bytesOfCell, [&](std::size_t first, std::span<const std::byte> values) {
        std::copy(values.begin(), values.end(), all.ranges.begin() + std::ptrdiff_t(first * bytesOfCell));
    });
    return all;
}

std::optional<Range> rangeOfExtremes(const Multiscales& store) {
    const auto type = typeOfExtremes(store);
    if (!type) {
        return {};
    }
    const ZarrArray& array = store.extremes->array;
    const auto chunks = std::size_t(array.chunkCount(0));
    announcePromised(std::size_t(processorCount()) * array.chunkBytes());
    // What no file holds is 0.
    return visitType(*type, [&]<typename T>(const T*) -> std::optional<Range> {
        std::mutex mutex;
        std::optional<Range> all;
        const auto widenBy = [&](Range range) {
            const std::lock_guard lock(mutex);
            all = all ? Range{std::min(all->lo, range.lo), std::max(all->hi, range.hi)} : range;
        };
        std::atomic<std::size_t> there = 0;
        forEachChunk(store, 2 * sizeof(T), [&](std::size_t /*first*/, std::span<const std::byte> bytes) {
            ++there;
            const std::span pairs(reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T));
            T lo = std::numeric_limits<T>::max();
            T hi = std::numeric_limits<T>::lowest();
            for (std::size_t i = 0; i < pairs.size(); i += 2) {
                const bool isMeasured = std::abs(double(pairs[i])) < kNotMeasured &&
                                        std::abs(double(pairs[i + 1])) < kNotMeasured;
                lo = isMeasured ? std::min(lo, pairs[i]) : lo;
                hi = isMeasured ? std::max(hi, pairs[i + 1]) : hi;
            }
            if (lo <= hi) {
                widenBy({double(lo), double(hi)});
            }
        });
        if (there < chunks) {
            widenBy({0, 0});
        }
        return all;
    });
}

} // namespace vs::volume
