// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/fine_labels.h"

#include "base/error.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "segment/finer/fine_cells.h"
#include "volume/grid/known_ranges.h"
#include "volume/grid/visit_type.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace vs::segment {

namespace {

constexpr int kBlock = 2 * field::kBrick; // voxels along a side of what is read at once
constexpr int kAtOnce = 256;              // blocks between two looks at whether to go on
constexpr const char* kOfSets = "sets-";

std::int64_t wholeNumber(double value, const std::string& name) {
    if (!(std::abs(value) < 1e15) || value != std::floor(value)) {
        throw ReadError("{}: holds the value {:g}; a label map holds whole numbers only", name, value);
    }
    return std::int64_t(value);
}

void requireFew(std::size_t labels, std::size_t most, const std::string& name) {
    if (labels > most) {
        throw ReadError("{}: holds more than {} different values; a label map has at most so many", name,
                        most);
    }
}

// The voxels of a block by their values, brick by brick.
using BlockBits = std::map<std::int64_t, std::map<std::uint32_t, CellBits>>;
template <typename T>
BlockBits bitsOf(const T* values, const Box3& block, const FineSet& grid, const std::string& name,
                 std::size_t mostLabels) {
    BlockBits bits;
    T last{};
    std::int64_t label = 0;
    std::map<std::uint32_t, CellBits>* ofLabel = nullptr;
    const field::BrickGrid bricks{grid.dims(), field::kBrick};
    forEachVoxel(block, [&](glm::ivec3 v, std::size_t i) {
        if (values[i] == T{}) {
            return;
        }
        if (ofLabel == nullptr || values[i] != last) {
            last = values[i];
            label = wholeNumber(double(last), name);
            ofLabel = &bits[label];
            requireFew(bits.size(), mostLabels, name);
        }
        const glm::ivec3 brick = v / field::kBrick;
        set((*ofLabel)[std::uint32_t(bricks.placeOf(brick))], cellOf(v - brick * field::kBrick));
    });
    return bits;
}

FineSet& setOf(LabelSets& sets, std::int64_t value, glm::ivec3 dims) {
    return sets.try_emplace(value, dims).first->second;
}

} // namespace

LabelSets labelSets(const volume::BrickSource& map, int level, std::size_t mostLabels) {
    const glm::ivec3 dims = map.levels().at(std::size_t(level)).dims;
    const field::BrickGrid blocks{dims, kBlock};
    const FineSet grid(dims);
    const volume::KnownRanges known(map, level);
    LabelSets sets;
    std::mutex mutex;
    const auto read = [&](int place) {
        const Box3 block = blocks.boxOf(blocks.brickAt(place));
        if (const auto range = known.in(block); range && range->lo == 0 && range->hi == 0) {
            return;
        }
        const std::vector<std::byte> bytes = map.read(level, block);
        const BlockBits bits = volume::visitType(map.type(), [&](const auto* none) {
            return bitsOf(reinterpret_cast<decltype(none)>(bytes.data()), block, grid, map.name(),
                          mostLabels);
        });
        const std::lock_guard lock(mutex);
        for (const auto& [value, ofLabel] : bits) {
            FineSet& set = setOf(sets, value, dims);
            requireFew(sets.size(), mostLabels, map.name());
            for (const auto& [brick, cells] : ofLabel) {
                set.add(brick, cells);
            }
        }
    };
    const int count = int(blocks.count());
    for (int first = 0; first < count; first += kAtOnce) {
        reportProgress(double(first) / double(count));
        inParallel(std::min(kAtOnce, count - first), [&](int n) { read(first + n); });
    }
    return sets;
}

LabelSets labelSets(std::span<const std::uint8_t> labels, const std::vector<std::int64_t>& values,
                    glm::ivec3 dims) {
    const BlockBits bits =
        bitsOf(labels.data(), {glm::ivec3(0), dims}, FineSet(dims), "a label map", values.size());
    LabelSets sets;
    for (const auto& [number, ofLabel] : bits) {
        FineSet& set = setOf(sets, values.at(std::size_t(number)), dims);
        for (const auto& [brick, cells] : ofLabel) {
            set.add(brick, cells);
        }
    }
    return sets;
}

std::string checksum(const LabelSets& sets) {
    Hash64 hash;
    for (const auto& [value, set] : sets) {
        hash.add(std::uint64_t(value));
        for (int axis = 0; axis < 3; ++axis) {
            hash.add(std::uint64_t(set.dims()[axis]));
        }
        for (const auto& [brick, bits] : set.bricks()) {
            hash.add(std::uint64_t(brick));
            for (const std::uint64_t word : bits) {
                hash.add(word);
            }
        }
    }
    return kOfSets + hash.text();
}

bool isOfSets(const std::string& checksum) { return checksum.rfind(kOfSets, 0) == 0; }

} // namespace vs::segment
