// SPDX-License-Identifier: Apache-2.0
#include "studio/document/finer_levels.h"

#include "base/parallel.h"
#include "volume/reading/read_volume.h"
#include "volume/reading/store_bricks.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>

namespace vs::studio {

namespace {

// What a voxel that is worked on takes beside its value: sculpture, labels, generations, membership.
constexpr std::size_t kWorkBytes = 8;
// More voxels are not worked on unless they are asked for: they take long to read.
constexpr std::size_t kManyVoxels = std::size_t(1) << 27;
constexpr int kLongestAxis = 2048; // of one texture

std::size_t workBytes(const volume::GridGeometry& level, volume::ScalarType type) {
    return level.voxelCount() * (volume::sizeOf(type) + kWorkBytes);
}

bool fitsATexture(const volume::GridGeometry& level) {
    return std::max({level.dims.x, level.dims.y, level.dims.z}) <= kLongestAxis;
}

// The finest level, where the device has room for it twice over; else the finest that leaves most of the room to
// bricks of the others.
int levelToWorkOn(const volume::BrickSource& store, const MemoryBudgets& budgets) {
    const auto& levels = store.levels();
    const std::size_t all = workBytes(levels.front(), store.type());
    if (fitsATexture(levels.front()) && all <= budgets.deviceBytes / 2 && all <= budgets.hostBytes) {
        return 0;
    }
    const auto isSmall = [&](const volume::GridGeometry& level) {
        return fitsATexture(level) && level.voxelCount() <= kManyVoxels &&
               workBytes(level, store.type()) <= std::min(budgets.deviceBytes / 2, budgets.hostBytes / 2);
    };
    const auto found = std::find_if(levels.begin(), levels.end(), isSmall);
    return int(std::min(found, levels.end() - 1) - levels.begin());
}

field::DetailOptions optionsFor(const MemoryBudgets& budgets, std::size_t workBytes) {
    field::DetailOptions options;
    options.deviceBytes = budgets.deviceBytes - std::min(workBytes, budgets.deviceBytes / 2);
    options.hostBytes = budgets.hostBytes / 4;
    options.threads = std::clamp(processorCount(), 2, 8);
    return options;
}

// What finer voxels have counts too: a mean of them is never as great as the greatest.
void widen(volume::Volume& volume, const volume::CellExtremes& extremes) {
    constexpr float notMeasured = 1e15F;
    Range range = volume.range;
    for (const glm::vec2& cell : extremes.ranges) {
        range.lo = cell.x > -notMeasured ? std::min(range.lo, double(cell.x)) : range.lo;
        range.hi = cell.y < notMeasured ? std::max(range.hi, double(cell.y)) : range.hi;
    }
    const bool areAllUsual = volume.usual == volume.range;
    volume.range = range;
    volume.usual = areAllUsual ? range : volume.usual;
}

OpenedScan openStore(const std::filesystem::path& path, volume::ReadOptions options, bool ofBricks,
                     const MemoryBudgets& budgets) {
    auto store = std::make_shared<volume::StoreBricks>(path, options);
    if (!options.level) {
        options.level = levelToWorkOn(*store, budgets);
    }
    OpenedScan opened{volume::readVolume(path, options), {}};
    if (*options.level == 0 && !ofBricks) {
        return opened;
    }
    FinerLevels finer{store, store->extremes(), {}};
    finer.options = optionsFor(budgets, workBytes(opened.read.volume.geometry, store->type()));
    finer.options.hasOwnLevel = ofBricks;
    if (field::brickGrid(store->levels().front(), opened.read.volume.geometry, finer.options.side)) {
        if (finer.extremes) {
            widen(opened.read.volume, *finer.extremes);
        } else {
            opened.read.notices.push_back(
                fmt::format("{}: what is where in its finer levels is not known before they are read, so pictures "
                            "of them take long; vstudio convert makes a store that says it",
                            path.string()));
        }
        opened.finer = std::move(finer);
    } else {
        opened.read.notices.push_back(fmt::format(
            "{}: its levels do not lie along the same axes, so pictures show level {} only", path.string(),
            *options.level));
    }
    return opened;
}

} // namespace

MemoryBudgets MemoryBudgets::filledIn() const {
    const auto memory = std::size_t(sysconf(_SC_PHYS_PAGES)) * std::size_t(sysconf(_SC_PAGESIZE));
    return {deviceBytes > 0 ? deviceBytes : memory / 2, hostBytes > 0 ? hostBytes : memory / 4};
}

FinerLevels ownLevel(const MemoryBudgets& budgets) {
    FinerLevels own{nullptr, {}, optionsFor(budgets.filledIn(), 0)};
    own.options.hasOwnLevel = true;
    return own;
}

OpenedScan openScan(const std::filesystem::path& path, const volume::ReadOptions& options, Storage storage,
                    const MemoryBudgets& budgets) {
    const bool ofBricks = storage == Storage::Bricks;
    if (storage != Storage::Dense && volume::hasLevels(path)) {
        return openStore(path, options, ofBricks, budgets.filledIn());
    }
    OpenedScan opened{volume::readVolume(path, options), {}};
    if (ofBricks) {
        opened.finer = ownLevel(budgets);
    }
    return opened;
}

} // namespace vs::studio
