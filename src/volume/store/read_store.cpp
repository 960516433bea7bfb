// SPDX-License-Identifier: Apache-2.0
#include "volume/io/formats.h"

#include "base/parallel.h"
#include "base/progress.h"
#include "volume/io/take_values.h"
#include "volume/store/box_reader.h"
#include "volume/store/store_extremes.h"
#include "volume/store/store_progress.h"

#include <algorithm>
#include <cmath>

namespace vs::volume {

namespace {

std::vector<std::byte> readAll(const BoxReader& reader, std::size_t bytes) {
    std::vector<std::byte> out(bytes);
    const int count = reader.chunks();
    constexpr int atOnce = 64; // chunks between two looks at whether the person has given up
    for (int first = 0; first < count; first += atOnce) {
        reportProgress(double(first) / count);
        inParallel(std::min(atOnce, count - first), [&](int n) { reader.readInto(out, first + n); });
    }
    return out;
}

std::size_t chosenLevel(const Multiscales& store, std::optional<int> level) {
    if (level && (*level < 0 || *level >= int(store.levels.size()))) {
        refuse(store.path, fmt::format("it has no level {}", *level),
               fmt::format("choose one of {}", store.levelsText()));
    }
    return std::size_t(level.value_or(0));
}

// Tells whoever limits time and memory of the chunks' files. Returns how many there are.
int announceChunks(const BoxReader& reader, std::uint64_t bytes) {
    // Emptiness is stored as nothing: what the format promises for it is as sound as what it has files for.
    announceStored(bytes / 1000);
    constexpr int atOnce = 64;
    int files = 0;
    std::uint64_t stored = 0;
    for (int n = 0; n < reader.chunks(); ++n) {
        const std::uint64_t here = reader.storedBytes(n);
        files += here > 0 ? 1 : 0;
        stored += here;
        if (n % atOnce == atOnce - 1 || n + 1 == reader.chunks()) {
            reportProgress();
            announceStored(stored);
            stored = 0;
        }
    }
    return files;
}

} // namespace

ReadResult readStore(const std::filesystem::path& path, const ReadOptions& options) {
    requireFinished(path);
    Multiscales store = openMultiscales(path);
    const std::size_t level = chosenLevel(store, options.level);
    const int channel = chosenChannel(path, store.channels(), options.channel, namesOf(store));
    const int time = chosenFrame(path, store.times(), options.frame);
    const auto& [array, geometry] = store.levels[level];
    const glm::ivec3 dims = geometry.dims;
    const BoxReader reader(store, level, geometry.box(), channel, time);
    try {
        (void)checkedBytes(path, {dims.x, dims.y, dims.z}, bytesOf(array.type));
    } catch (const ReadError&) {
        if (store.levels.size() == 1) {
            throw;
        }
        refuse(path,
               fmt::format("level {} has {} x {} x {} voxels, more than this machine's memory", level, dims.x,
                           dims.y, dims.z),
               fmt::format("choose a coarser one with --level, of {}", store.levelsText()));
    }
    const int files = announceChunks(reader, geometry.voxelCount() * bytesOf(array.type));
    ReadResult result;
    result.notices = store.notices;
    if (files == 0) {
        result.notices.push_back(fmt::format("{}: no chunk of it is there; all of it has the value {}",
                                             array.folder.string(), array.fill));
    }
    if (level > 0) {
        result.notices.push_back(
            fmt::format("{}: this is level {} of {}", path.string(), level, store.levelsText()));
    }
    if (level > 0 && store.extremes) {
        try {
            result.ofFinest = rangeOfExtremes(store);
        } catch (const ReadError& error) { // the level is there all the same
            result.notices.push_back(error.what());
        }
    }
    Volume& volume = result.volume;
    volume.geometry = geometry;
    volume.unit = store.unit;
    if (takeValues(volume, array.type, readAll(reader, geometry.voxelCount() * bytesOf(array.type)))) {
        result.notices.push_back(
            fmt::format("{}: 64-bit values were rounded to 32-bit floats; some changed", path.string()));
    }
    volume.details.format = "OME-Zarr";
    volume.details.frame = time;
    volume.details.frames = store.times();
    return result;
}

} // namespace vs::volume
