// SPDX-License-Identifier: Apache-2.0
#include "volume/store/store_levels.h"

#include "volume/io/inspect.h"
#include "volume/io/take_values.h"
#include "volume/store/box_reader.h"
#include "volume/store/missing_chunks.h"
#include "volume/store/store_extremes.h"
#include "volume/store/store_progress.h"

namespace vs::volume {

StoreLevels::StoreLevels(const std::filesystem::path& path, const ReadOptions& options) {
    requireFinished(path);
    store_ = openMultiscales(path);
    channel_ = chosenChannel(path, store_.channels(), options.channel, namesOf(store_));
    time_ = chosenFrame(path, store_.times(), options.frame);
    for (const auto& level : store_.levels) {
        grids_.push_back(level.geometry);
    }
    Volume none;
    takeValues(none, store_.levels.front().array.type, {});
    type_ = none.type;
}

void StoreLevels::expectInside(int level, const Box3& box) const {
    if (level < 0 || level >= int(grids_.size()) || box.isEmpty() ||
        !(intersect(box, grids_[std::size_t(level)].box()) == box)) {
        throw ReadError("{}: a box outside of its levels was asked for", store_.path.string());
    }
}

std::vector<std::string> StoreLevels::filesOf(int level, const Box3& box) const {
    expectInside(level, box);
    const BoxReader reader(store_, std::size_t(level), box, channel_, time_);
    std::vector<std::string> names;
    for (int n = 0; n < reader.chunks(); ++n) {
        names.push_back(reader.file(n).lexically_relative(store_.path).string());
    }
    return names;
}

std::vector<std::string> StoreLevels::filesOfExtremes() const {
    std::vector<std::string> names;
    for (std::int64_t n = 0; store_.extremes && n < store_.extremes->array.chunkCount(0); ++n) {
        const std::array<std::int64_t, 4> chunk{n, 0, 0, 0};
        names.push_back(store_.extremes->array.chunkFile(chunk).lexically_relative(store_.path).string());
    }
    return names;
}

std::vector<std::byte> StoreLevels::read(int level, const Box3& box) const {
    expectInside(level, box);
    const StoredType stored = store_.levels[std::size_t(level)].array.type;
    const BoxReader reader(store_, std::size_t(level), box, channel_, time_);
    std::vector<std::byte> values(box.volume() * bytesOf(stored));
    announcePromised(values.size());
    for (int n = 0; n < reader.chunks(); ++n) {
        announceStored(reader.storedBytes(n));
        reader.readInto(values, n);
    }
    Volume part;
    part.geometry = makeGeometry(box.size());
    takeValues(part, stored, std::move(values));
    return std::move(part.bytes);
}

std::optional<CellExtremes> StoreLevels::extremes() const { return readExtremes(store_); }

std::optional<CellExtremes> StoreLevels::extremesByMissing() const {
    return volume::extremesByMissing(store_, channel_, time_);
}

} // namespace vs::volume
