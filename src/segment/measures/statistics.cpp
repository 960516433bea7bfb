// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/statistics.h"

#include "base/check.h"
#include "base/parallel.h"
#include "segment/measures/surface_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace vs::segment {
namespace {

// Sorts values into bins whose order is theirs: one for each whole number where few enough are between the
// volume's smallest and largest, else equal parts of that range.
struct Bins {
    double lo = 0;
    double perUnit = 1;
    std::size_t count = 1;
    bool holdOneValue = true; // each

    explicit Bins(const volume::Volume& volume) {
        constexpr double most = 65536;
        holdOneValue = volume.type != volume::ScalarType::Float32 && volume.range.width() < most;
        const Range& range = holdOneValue ? volume.range : volume.usual;
        const double width = range.width();
        lo = range.lo;
        count = std::size_t(holdOneValue ? width + 1 : most);
        perUnit = holdOneValue ? 1.0 : width > 0 ? (most - 1) / width : 0.0;
    }

    // What is not usual counts as the nearest of what is.
    [[nodiscard]] std::size_t of(double value) const {
        return std::size_t(std::clamp((value - lo) * perUnit, 0.0, double(count - 1)));
    }
};

// What is known of one label's voxels after some of them.
struct Tally {
    std::uint64_t voxels = 0;
    std::array<std::uint64_t, 3> indexSums{};
    std::array<std::uint64_t, 6> indexProducts{}; // sums of xx, yy, zz, xy, xz, yz
    Box3 box;
    std::uint64_t finite = 0;
    double shift = 0;   // a value of the label: sums about it do not cancel
    double sum = 0;     // of value - shift
    double squares = 0; // of its square
    double lo = std::numeric_limits<double>::infinity();
    double hi = -std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> counts; // by bin

    void addRun(glm::ivec3 first, int length) {
        const auto n = std::uint64_t(length);
        voxels += n;
        indexSums[0] += n * std::uint64_t(first.x) + n * (n - 1) / 2;
        indexSums[1] += n * std::uint64_t(first.y);
        indexSums[2] += n * std::uint64_t(first.z);
        addProducts(glm::u64vec3(first), n);
        box = unite(box, {first, first + glm::ivec3(length, 1, 1)});
    }

    void addProducts(glm::u64vec3 first, std::uint64_t n) {
        const std::uint64_t steps = n * (n - 1) / 2; // of 0 to n - 1, and of their squares
        const std::uint64_t stepSquares = n * (n - 1) * (2 * n - 1) / 6;
        const std::uint64_t xs = n * first.x + steps;
        indexProducts[0] += n * first.x * first.x + 2 * first.x * steps + stepSquares;
        indexProducts[1] += n * first.y * first.y;
        indexProducts[2] += n * first.z * first.z;
        indexProducts[3] += xs * first.y;
        indexProducts[4] += xs * first.z;
        indexProducts[5] += n * first.y * first.z;
    }

    // Mean of the voxels' indices.
    [[nodiscard]] glm::dvec3 middle() const {
        return glm::dvec3(double(indexSums[0]), double(indexSums[1]), double(indexSums[2])) / double(voxels);
    }

    // Of all places in the voxels, which are blocks: in voxels squared.
    [[nodiscard]] glm::dmat3 covariance() const {
        constexpr double ofABlock = 1.0 / 12;
        const auto mean = [this](std::size_t i) { return double(indexProducts[i]) / double(voxels); };
        const glm::dmat3 products(mean(0), mean(3), mean(4), mean(3), mean(1), mean(5), mean(4), mean(5),
                                  mean(2));
        return products - glm::outerProduct(middle(), middle()) + glm::dmat3(ofABlock);
    }

    template <typename T>
    void addValues(const T* values, int length, const Bins& bins) {
        counts.resize(bins.count);
        for (int i = 0; i < length; ++i) {
            const auto value = double(values[i]);
            if (std::is_floating_point_v<T> && !std::isfinite(value)) {
                continue;
            }
            shift = finite == 0 ? value : shift;
            ++finite;
            sum += value - shift;
            squares += (value - shift) * (value - shift);
            lo = std::min(lo, value);
            hi = std::max(hi, value);
            ++counts[bins.of(value)];
        }
    }

    void add(const Tally& other) {
        voxels += other.voxels;
        box = unite(box, other.box);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            indexSums[axis] += other.indexSums[axis];
        }
        for (std::size_t i = 0; i < indexProducts.size(); ++i) {
            indexProducts[i] += other.indexProducts[i];
        }
        if (other.finite == 0) {
            return;
        }
        shift = finite == 0 ? other.shift : shift;
        const double move = other.shift - shift;
        squares += other.squares + 2 * move * other.sum + move * move * double(other.finite);
        sum += other.sum + move * double(other.finite);
        finite += other.finite;
        lo = std::min(lo, other.lo);
        hi = std::max(hi, other.hi);
        counts.resize(other.counts.size());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            counts[i] += other.counts[i];
        }
    }

    // The bins of the two values in the middle, which are one where the number is odd.
    [[nodiscard]] std::array<std::size_t, 2> middleBins() const {
        std::array<std::size_t, 2> bins{};
        for (const std::size_t which : {0, 1}) {
            std::uint64_t left = which == 0 ? (finite - 1) / 2 : finite / 2;
            for (std::size_t& bin = bins[which]; left >= counts[bin]; ++bin) {
                left -= counts[bin];
            }
        }
        return bins;
    }
};

using Tallies = std::array<Tally, 256>;

// Calls run(label, first voxel, place of it, length) for every run of one label along a row of these slices.
template <typename F>
void forEachRun(glm::ivec3 dims, std::span<const std::uint8_t> labels, int firstSlice, int endSlice,
                const F& run) {
    for (int z = firstSlice; z < endSlice; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            const auto start = (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x);
            const std::uint8_t* row = labels.data() + start;
            for (int x = 0; x < dims.x;) {
                const int first = x;
                while (x < dims.x && row[x] == row[first]) {
                    ++x;
                }
                if (row[first] != 0) {
                    run(row[first], glm::ivec3(first, y, z), start + std::size_t(first), x - first);
                }
            }
        }
    }
}

Tallies tally(const volume::Volume& volume, std::span<const std::uint8_t> labels, const Bins& bins) {
    const glm::ivec3 dims = volume.geometry.dims;
    const int parts = std::min(threadsForMemory(), dims.z);
    std::vector<Tallies> tallies(static_cast<std::size_t>(parts));
    inParallel(parts, [&](int part) {
        Tallies& own = tallies[std::size_t(part)];
        volume::visit(volume, [&](const auto* values) {
            forEachRun(dims, labels, dims.z * part / parts, dims.z * (part + 1) / parts,
                       [&](std::uint8_t label, glm::ivec3 first, std::size_t place, int length) {
                           own[label].addRun(first, length);
                           own[label].addValues(values + place, length, bins);
                       });
        });
    });
    for (std::size_t part = 1; part < tallies.size(); ++part) {
        for (std::size_t label = 1; label < 256; ++label) {
            tallies[0][label].add(tallies[part][label]);
        }
    }
    return std::move(tallies[0]);
}

// The median is the middle of what lies in the middle bins, less what is known to lie below or above it.
double medianWithin(const Tally& tally, std::array<std::size_t, 2> bins, std::vector<double>& values) {
    std::uint64_t below = 0;
    for (std::size_t bin = 0; bin < bins[0]; ++bin) {
        below += tally.counts[bin];
    }
    const auto valueAt = [&](std::uint64_t rank) {
        const auto place = values.begin() + std::ptrdiff_t(rank - below);
        std::nth_element(values.begin(), place, values.end());
        return *place;
    };
    return 0.5 * (valueAt((tally.finite - 1) / 2) + valueAt(tally.finite / 2));
}

// The median of each label, whose bin is all that is known of it.
std::array<double, 256> refinedMedians(const volume::Volume& volume, std::span<const std::uint8_t> labels,
                                       const Bins& bins, const Tallies& tallies) {
    std::array<std::array<std::size_t, 2>, 256> middle{};
    std::array<std::vector<double>, 256> values;
    for (std::size_t label = 1; label < 256; ++label) {
        if (tallies[label].finite > 0) {
            middle[label] = tallies[label].middleBins();
        }
    }
    volume::visit(volume, [&](const auto* all) {
        const auto collect = [&](std::uint8_t label, glm::ivec3, std::size_t place, int length) {
            for (std::size_t i = place; i < place + std::size_t(length); ++i) {
                const auto value = double(all[i]);
                if (std::isfinite(value)) {
                    const std::size_t bin = bins.of(value);
                    if (bin == middle[label][0] || bin == middle[label][1]) {
                        values[label].push_back(value);
                    }
                }
            }
        };
        forEachRun(volume.geometry.dims, labels, 0, volume.geometry.dims.z, collect);
    });
    std::array<double, 256> medians{};
    for (std::size_t label = 1; label < 256; ++label) {
        if (tallies[label].finite > 0) {
            medians[label] = medianWithin(tallies[label], middle[label], values[label]);
        }
    }
    return medians;
}

std::array<double, 256> medians(const volume::Volume& volume, std::span<const std::uint8_t> labels,
                                const Bins& bins, const Tallies& tallies) {
    if (!bins.holdOneValue) {
        return refinedMedians(volume, labels, bins, tallies);
    }
    std::array<double, 256> result{};
    for (std::size_t label = 1; label < 256; ++label) {
        if (tallies[label].finite > 0) {
            const auto middle = tallies[label].middleBins();
            result[label] = bins.lo + 0.5 * double(middle[0] + middle[1]);
        }
    }
    return result;
}

Intensities intensitiesOf(const Tally& tally, double median) {
    Intensities result;
    if (tally.finite == 0) {
        return result;
    }
    const auto n = double(tally.finite);
    const double offset = tally.sum / n;
    result.voxels = tally.finite;
    result.mean = tally.shift + offset;
    result.deviation = std::sqrt(std::max(tally.squares / n - offset * offset, 0.0));
    result.smallest = tally.lo;
    result.largest = tally.hi;
    result.median = median;
    return result;
}

} // namespace

std::vector<SegmentStatistics> measure(const volume::Volume& volume, std::span<const std::uint8_t> labels) {
    return measure(volume, volume.geometry, labels);
}

std::vector<SegmentStatistics> measure(const volume::Volume& volume, const volume::GridGeometry& geometry,
                                       std::span<const std::uint8_t> labels) {
    VS_CHECK(geometry.dims == volume.geometry.dims);
    VS_CHECK_EQ(labels.size(), geometry.voxelCount());
    const Bins bins(volume);
    const Tallies tallies = tally(volume, labels, bins);
    const auto middle = medians(volume, labels, bins, tallies);
    const auto areas = surfaceAreas(geometry, labels);
    std::array<Box3, 256> boxes;
    std::transform(tallies.begin(), tallies.end(), boxes.begin(), [](const Tally& one) { return one.box; });
    const auto shapes = topologies(geometry.dims, labels, boxes);
    const glm::dmat3 worldFromIndex(geometry.worldFromVoxel);
    std::vector<SegmentStatistics> result;
    for (std::size_t label = 1; label < 256; ++label) {
        const Tally& one = tallies[label];
        if (one.voxels == 0) {
            continue;
        }
        SegmentStatistics& record = result.emplace_back();
        record.label = std::uint8_t(label);
        record.voxels = one.voxels;
        record.millilitres = double(one.voxels) * geometry.voxelMm3() / 1000.0;
        record.intensities = intensitiesOf(one, middle[label]);
        record.box = one.box;
        record.boxMm = glm::dvec3(one.box.size()) * geometry.spacing();
        record.centroid = glm::dvec3(geometry.worldFromVoxel * glm::dvec4(one.middle(), 1.0));
        record.surfaceMm2 = areas[label];
        record.sphericity = sphericity(record.millilitres, record.surfaceMm2);
        record.axes = principalAxes(worldFromIndex * one.covariance() * glm::transpose(worldFromIndex));
        record.topology = shapes[label];
    }
    return result;
}

} // namespace vs::segment
