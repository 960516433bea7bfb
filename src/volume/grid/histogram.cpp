// SPDX-License-Identifier: Apache-2.0
#include "volume/grid/histogram.h"

#include "base/check.h"
#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>

namespace vs::volume {

namespace {

using Counts = std::vector<std::uint64_t>;

// Equal bins over the usual values of a volume.
class Bins {
public:
    Bins(const Range& usual, int bins)
        : usual_(usual), last_(bins - 1), scale_(usual.width() > 0 ? bins / usual.width() : 0.0) {}

    // Adds so many voxels of one value, if it is counted at all: a value that is not finite is in no range.
    void count(double value, std::uint64_t voxels, Counts& counts) const {
        if (usual_.contains(value)) {
            counts[std::size_t(std::clamp(int((value - usual_.lo) * scale_), 0, last_))] += voxels;
        }
    }

private:
    Range usual_;
    int last_;
    double scale_;
};

// Calls `visit` with each row of a box along x, as a span, for slices lo.z <= z < hi.z.
template <typename T, typename Visit>
void forEachRow(const T* values, glm::ivec3 dims, const Box3& box, const Visit& visit) {
    for (int z = box.lo.z; z < box.hi.z; ++z) {
        for (int y = box.lo.y; y < box.hi.y; ++y) {
            const std::size_t first =
                (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x);
            visit(std::span<const T>(values + first + box.lo.x, std::size_t(box.hi.x - box.lo.x)));
        }
    }
}

// How often each value of 8 or 16 bits is there. Neighbours often have one value, and adding to a number that
// was just added to waits: so they are counted in four tables in turn.
template <typename T>
void countNarrow(const T* values, glm::ivec3 dims, const Box3& box, const Bins& bins, Counts& counts) {
    using Unsigned = std::make_unsigned_t<T>;
    constexpr std::size_t kValues = std::size_t(std::numeric_limits<Unsigned>::max()) + 1;
    constexpr std::size_t kTables = 4;
    std::array<std::vector<std::uint64_t>, kTables> tables;
    tables.fill(std::vector<std::uint64_t>(kValues));
    forEachRow(values, dims, box, [&](std::span<const T> row) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            ++tables[i % kTables][Unsigned(row[i])];
        }
    });
    for (std::size_t value = 0; value < kValues; ++value) {
        const std::uint64_t voxels =
            tables[0][value] + tables[1][value] + tables[2][value] + tables[3][value];
        if (voxels > 0) {
            bins.count(double(T(Unsigned(value))), voxels, counts);
        }
    }
}

template <typename T>
void countValues(const T* values, glm::ivec3 dims, const Box3& box, const Bins& bins, Counts& counts) {
    if constexpr (sizeof(T) <= 2) {
        countNarrow(values, dims, box, bins, counts);
    } else {
        forEachRow(values, dims, box, [&](std::span<const T> row) {
            for (const T value : row) {
                bins.count(double(value), 1, counts);
            }
        });
    }
}

// Slices [lo.z, hi.z) of a box, the i-th of so many parts of them.
Box3 slicesOf(const Box3& box, int i, int parts) {
    const auto border = [&](int part) {
        return box.lo.z + int(std::int64_t(box.hi.z - box.lo.z) * part / parts);
    };
    return {{box.lo.x, box.lo.y, border(i)}, {box.hi.x, box.hi.y, border(i + 1)}};
}

} // namespace

Counts histogram(const Volume& volume, int bins) { return histogram(volume, volume.geometry.box(), bins); }

Counts histogram(const Volume& volume, const Box3& box, int bins) {
    VS_CHECK(bins >= 1 && intersect(box, volume.geometry.box()) == box);
    const int parts = processorCount();
    auto counts = std::vector<Counts>(std::size_t(parts));
    inParallel(parts, [&](int i) {
        counts[std::size_t(i)].resize(std::size_t(bins));
        visit(volume, [&](const auto* values) {
            countValues(values, volume.geometry.dims, slicesOf(box, i, parts), Bins(volume.usual, bins),
                        counts[std::size_t(i)]);
        });
    });
    for (std::size_t i = 1; i < counts.size(); ++i) {
        std::transform(counts[i].begin(), counts[i].end(), counts[0].begin(), counts[0].begin(),
                       std::plus<>());
    }
    return std::move(counts[0]);
}

double otsuThreshold(std::span<const std::uint64_t> counts, const Range& range) {
    double total = 0;
    double weighted = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        total += double(counts[i]);
        weighted += double(i) * double(counts[i]);
    }
    double below = 0;
    double weightedBelow = 0;
    double bestVariance = -1;
    std::size_t first = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i + 1 < counts.size(); ++i) {
        below += double(counts[i]);
        weightedBelow += double(i) * double(counts[i]);
        const double above = total - below;
        if (below <= 0 || above <= 0) {
            continue;
        }
        const double meanGap = weightedBelow / below - (weighted - weightedBelow) / above;
        const double variance = below * above * meanGap * meanGap;
        if (variance > bestVariance) {
            bestVariance = variance;
            first = i + 1;
        }
        last = variance >= bestVariance ? i + 1 : last;
    }
    return range.lo + range.width() * 0.5 * double(first + last) / double(counts.size());
}

} // namespace vs::volume
