// SPDX-License-Identifier: Apache-2.0
#include "studio/document/finer_levels.h"

#include "base/error.h"
#include "base/parallel.h"
#include "gl/limits.h"
#include "studio/document/document.h"
#include "volume/reading/read_volume.h"
#include "volume/reading/store_bricks.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vs::studio {

namespace {

// What a voxel that is worked on takes beside its value: sculpture, labels, generations, membership, cells
// (doc/performance.md, "Memory on the device").
constexpr std::size_t kWorkBytes = 10;
// What strokes take that cut the finest level, window by window.
constexpr std::size_t kWindowBytes = std::size_t(54) << 20;
// More voxels are not worked on unless they are asked for: they take long to read.
constexpr std::size_t kManyVoxels = std::size_t(1) << 27;
// What bricks take where nobody said how much they may: more would hardly ever be used.
constexpr std::size_t kUsualPool = std::size_t(1) << 30;
constexpr int kFewBricks = 128;
constexpr int kSmallestBrick = 16;
constexpr int kLongestAxis = 2048; // of one texture

std::size_t machineMemory() {
    return std::size_t(sysconf(_SC_PHYS_PAGES)) * std::size_t(sysconf(_SC_PAGESIZE));
}

std::size_t workBytes(const volume::GridGeometry& level, volume::ScalarType type) {
    return level.voxelCount() * (volume::sizeOf(type) + kWorkBytes);
}

bool fitsATexture(const volume::GridGeometry& level) {
    return std::max({level.dims.x, level.dims.y, level.dims.z}) <= kLongestAxis;
}

// The finest level, where the device has room for it twice over; else the finest that leaves most of the room
// to bricks of the others.
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

std::size_t bytesOfBricks(int count, int side, volume::ScalarType type) {
    const auto texels = std::size_t(side + 1);
    return std::size_t(count) * texels * texels * texels * gl::bytesPerTexel(field::brickTexels(type).format);
}

field::DetailOptions optionsFor(const MemoryBudgets& budgets, std::size_t workBytes,
                                volume::ScalarType type) {
    field::DetailOptions options;
    const std::size_t left =
        budgets.deviceBytes - std::min(workBytes + kWindowBytes, budgets.deviceBytes / 2);
    options.deviceBytes = budgets.isDeviceChosen ? left : std::min(left, kUsualPool);
    options.hostBytes = budgets.hostBytes / 4;
    // Many small bricks fit rays better than few large ones.
    while (options.side > kSmallestBrick &&
           bytesOfBricks(kFewBricks, options.side, type) > options.deviceBytes) {
        options.side /= 2;
    }
    options.threads = std::clamp(processorCount(), 2, 8);
    return options;
}

// Not where cells are those of which nobody knows anything.
bool isAllKnown(const std::optional<volume::CellExtremes>& extremes) {
    if (!extremes || extremes->type != volume::ScalarType::Float32) {
        return extremes.has_value();
    }
    const std::span values(reinterpret_cast<const float*>(extremes->ranges.data()),
                           extremes->ranges.size() / sizeof(float));
    return std::none_of(values.begin(), values.end(), [](float value) { return std::isinf(value); });
}

std::optional<FinerLevels> finerLevels(FinerLevels finer, const volume::Volume& scan,
                                       const volume::ReadOptions& read, std::vector<std::string>& notices) {
    const auto store = std::make_shared<volume::StoreBricks>(scan.path, read);
    if (!field::brickGrid(store->levels().front(), scan.geometry, finer.options.side)) {
        notices.push_back(
            fmt::format("{}: its levels do not lie along the same axes, so pictures show level {} "
                        "only",
                        scan.path.string(), read.level.value_or(0)));
        return {};
    }
    finer.source = store;
    finer.extremes = store->extremes();
    finer.isAllKnown = isAllKnown(finer.extremes);
    finer.options.areRangesKnown = finer.isAllKnown;
    if (!finer.isAllKnown) {
        notices.push_back(
            fmt::format("{}: what is where in its finer levels is not known before they are read, "
                        "so pictures of them take long; vstudio convert makes a store that says it",
                        scan.path.string()));
    }
    return finer;
}

} // namespace

MemoryBudgets MemoryBudgets::orElse(const MemoryBudgets& other) const {
    return {deviceBytes > 0 ? deviceBytes : other.deviceBytes, hostBytes > 0 ? hostBytes : other.hostBytes,
            isDeviceChosen || (deviceBytes == 0 && other.isDeviceChosen)};
}

MemoryBudgets MemoryBudgets::filledIn() const {
    const std::size_t memory = machineMemory();
    const std::size_t onDevice = gl::deviceMemoryBytes();
    return MemoryBudgets{deviceBytes, hostBytes, isDeviceChosen || deviceBytes > 0}.orElse(
        {onDevice > 0 ? onDevice / 4 * 3 : memory / 2, memory / 4, false});
}

std::size_t memoryOf(const std::string& text, const std::string& what) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string unit(end, text.data() + text.size());
    const double mebibytes = unit.empty() || unit == "MiB" ? number : unit == "GiB" ? 1024 * number : -1;
    if (error != std::errc() || !(mebibytes >= 1) || mebibytes > 1e9) {
        throw UsageError("{} {}: it is no amount of memory; give one as 512MiB or 4GiB", what, text);
    }
    return std::size_t(mebibytes * 1024 * 1024);
}

std::optional<int> levelToWorkOn(const std::filesystem::path& path, const volume::ReadOptions& options,
                                 Storage storage, const MemoryBudgets& budgets) {
    if (options.level || storage == Storage::Dense || !volume::hasLevels(path)) {
        return options.level;
    }
    const int level = levelToWorkOn(volume::StoreBricks(path, options), budgets.filledIn());
    return level > 0 ? std::optional(level) : std::nullopt;
}

std::optional<int> levelInReach(const std::filesystem::path& path, const volume::ReadOptions& options,
                                const MemoryBudgets& budgets) {
    if (options.level || !volume::hasLevels(path)) {
        return options.level;
    }
    try {
        const volume::StoreBricks store(path, options);
        const bool areChosen = budgets.deviceBytes > 0 || budgets.hostBytes > 0;
        const bool isInReach = !areChosen && fitsATexture(store.levels().front()) &&
                               workBytes(store.levels().front(), store.type()) <= machineMemory();
        const int level = isInReach ? 0 : levelToWorkOn(store, budgets.filledIn());
        return level > 0 ? std::optional(level) : std::nullopt;
    } catch (const ReadError&) { // a scan instead that has no such channel: who reads it says so
        return {};
    }
}

std::optional<FinerLevels> finerLevels(const volume::Volume& scan, const volume::ReadOptions& read,
                                       Storage storage, const MemoryBudgets& budgets,
                                       std::vector<std::string>& notices) {
    const bool ofBricks = storage == Storage::Bricks;
    const bool hasLevels = !scan.path.empty() && volume::hasLevels(scan.path);
    if (storage == Storage::Dense || !(ofBricks || (hasLevels && read.level.value_or(0) > 0))) {
        return {};
    }
    const MemoryBudgets room = budgets.filledIn();
    FinerLevels finer{nullptr, {}, optionsFor(room, workBytes(scan.geometry, scan.type), scan.type)};
    finer.options.hasOwnLevel = ofBricks;
    if (!hasLevels) {
        finer.options.areRangesKnown = true; // macrocells are of its own voxels
        return finer;
    }
    try {
        return finerLevels(std::move(finer), scan, read, notices);
    } catch (const Error& error) { // what is worked on has been read all the same
        notices.push_back(
            fmt::format("{}; pictures show level {} only", error.what(), read.level.value_or(0)));
        return {};
    }
}

void showFinerLevels(Document& document, const std::optional<FinerLevels>& levels,
                     std::vector<std::string>& notices) {
    try {
        if (levels) {
            document.showFinerLevels(*levels);
        }
    } catch (const Error& error) {
        notices.push_back(fmt::format("{}; pictures show what is worked on only", error.what()));
    }
}

OpenedScan openScan(const std::filesystem::path& path, const volume::ReadOptions& options, Storage storage,
                    const MemoryBudgets& budgets) {
    OpenedScan opened;
    opened.options = options;
    opened.options.level = levelToWorkOn(path, options, storage, budgets);
    opened.read = volume::readVolume(path, opened.options);
    opened.finer = finerLevels(opened.read.volume, opened.options, storage, budgets, opened.read.notices);
    return opened;
}

} // namespace vs::studio
