// SPDX-License-Identifier: Apache-2.0
#include "volume/store/write_store.h"

#include "base/check.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "volume/store/box_reader.h"
#include "volume/store/store_extremes.h"
#include "volume/store/store_json.h"
#include "volume/store/store_progress.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstring>

namespace vs::volume {

namespace {

// In one line, what is written and how: only that is gone on with.
std::string identityOf(const StoreSource& source, const StoreLayout& layout) {
    std::string line =
        fmt::format("2: {}, chunks of {}, codec {} {} {} {}, {}", source.identity, layout.chunk,
                    int(layout.codec.kind), layout.codec.level, layout.codec.inner, layout.codec.shuffle,
                    layout.reducing == Reducing::Mean ? "mean" : "commonest");
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return line;
}

glm::ivec3 halvedAlong(glm::ivec3 dims) {
    return {dims.x > 1 ? 2 : 1, dims.y > 1 ? 2 : 1, dims.z > 1 ? 2 : 1};
}

class StoreWriter {
public:
    StoreWriter(const std::filesystem::path& path, const StoreSource& source, const StoreLayout& layout)
        : source_(source), layout_(layout), progress_(path, identityOf(source, layout)) {
        store_.path = path;
        store_.spatial = {2, 1, 0};
        for (const GridGeometry& geometry : levelsOf(source.facts.geometry, layout.chunk)) {
            ZarrArray array;
            array.folder = path / std::to_string(store_.levels.size());
            array.shape = {geometry.dims.z, geometry.dims.y, geometry.dims.x};
            array.chunks.assign(3, layout.chunk);
            array.type = storedTypeOf(source.type);
            array.codec = layout.codec;
            chunks_ += array.chunkCount(0) * chunksInSlab(array);
            store_.levels.push_back({std::move(array), geometry});
        }
        const auto& finest = store_.levels.front();
        if (const int side = extremesSide(finest.geometry.dims, layout.chunk); side > 0) {
            store_.extremes = {extremesArray(path, finest.array, finest.geometry.dims, side), side};
        }
    }

    void run() {
        writeStoreFile(store_.path / ".zgroup", {{"zarr_format", 2}});
        if (store_.extremes) {
            createZarrArray(store_.extremes->array);
        }
        for (std::size_t level = 0; level < store_.levels.size(); ++level) {
            createZarrArray(store_.levels[level].array);
            for (int slab = 0; slab < int(store_.levels[level].array.chunkCount(0)); ++slab) {
                if (!progress_.isDone(int(level), slab)) {
                    writeSlab(level, slab);
                    progress_.note(int(level), slab);
                }
                chunksDone_ += chunksInSlab(store_.levels[level].array);
            }
        }
        std::vector<GridGeometry> grids;
        for (const auto& level : store_.levels) {
            grids.push_back(level.geometry);
        }
        StoreFacts facts = source_.facts;
        facts.reducing = layout_.reducing == Reducing::Mean ? "mean" : "commonest";
        writeStoreFile(store_.path / ".zattrs",
                       multiscalesJson(facts, grids, store_.extremes ? store_.extremes->side : 0));
        progress_.finish();
    }

private:
    static std::int64_t chunksInSlab(const ZarrArray& array) {
        return array.chunkCount(1) * array.chunkCount(2);
    }
    // `inHand`: chunks of the slab in hand that are done.
    void tell(double inHand) const { reportProgress((double(chunksDone_) + inHand) / double(chunks_)); }

    void writeSlab(std::size_t level, int slab) {
        const std::vector<glm::ivec3> places = placesToWrite(level, slab);
        const int count = int(places.size());
        const int atOnce = 4 * processorCount();
        std::optional<SlabExtremes> extremes;
        if (level == 0 && store_.extremes) {
            extremes.emplace(store_.extremes->array, source_.type, store_.extremes->side,
                             slab * layout_.chunk);
        }
        for (int first = 0; first < count; first += atOnce) {
            tell(double(first) / count * double(chunksInSlab(store_.levels[level].array)));
            inParallel(std::min(atOnce, count - first),
                       [&](int n) { writeChunk(level, places[std::size_t(first + n)], extremes); });
        }
        if (extremes) {
            writeOrRemove(store_.extremes->array, std::array<std::int64_t, 4>{slab, 0, 0, 0},
                          extremes->bytes());
        }
    }

    // Chunks of a slab that may hold something, of which a sparse scan has few. Others have no file, and
    // never had one: only the same is gone on with.
    [[nodiscard]] std::vector<glm::ivec3> placesToWrite(std::size_t level, int slab) const {
        const ZarrArray& array = store_.levels[level].array;
        std::vector<glm::ivec3> places;
        tell(0);
        for (int y = 0; y < int(array.chunkCount(1)); ++y) {
            for (int x = 0; x < int(array.chunkCount(2)); ++x) {
                const glm::ivec3 place(x, y, slab);
                if (!isKnownToBeZero(level, place)) {
                    places.push_back(place);
                }
            }
        }
        return places;
    }

    [[nodiscard]] Box3 boxOf(std::size_t level, glm::ivec3 place) const {
        return intersect({place * layout_.chunk, (place + 1) * layout_.chunk},
                         store_.levels[level].geometry.box());
    }

    // The source says it of the finest level; coarser ones hold nothing where the one before has no chunks.
    [[nodiscard]] bool isKnownToBeZero(std::size_t level, glm::ivec3 at) const {
        const Box3 box = boxOf(level, at);
        if (level == 0) {
            return source_.isZero && source_.isZero(box);
        }
        const auto& finer = store_.levels[level - 1];
        const glm::ivec3 by = halvedAlong(finer.geometry.dims);
        const Box3 below = intersect({box.lo * by, box.hi * by}, finer.geometry.box());
        bool isZero = true;
        forEachVoxel(Box3{below.lo / layout_.chunk, divideUp(below.hi, layout_.chunk)}, [&](glm::ivec3 chunk,
                                                                                            std::size_t) {
            const std::array<std::int64_t, 3> place{chunk.z, chunk.y, chunk.x};
            std::error_code error; // what cannot be asked for is read, and refused then
            isZero = isZero && !std::filesystem::exists(finer.array.chunkFile(place), error) && !error;
        });
        return isZero;
    }

    // One of nothing but zeros has no file.
    static void writeOrRemove(const ZarrArray& array, std::span<const std::int64_t> chunk,
                              std::span<const std::byte> values) {
        if (std::all_of(values.begin(), values.end(), [](std::byte b) { return b == std::byte(0); })) {
            array.removeChunk(chunk);
        } else {
            array.writeChunk(chunk, values);
        }
    }

    void writeChunk(std::size_t level, glm::ivec3 place, std::optional<SlabExtremes>& extremes) const {
        const ZarrArray& array = store_.levels[level].array;
        const std::array<std::int64_t, 3> chunk{place.z, place.y, place.x};
        const Box3 box = boxOf(level, place);
        const auto values = level == 0 ? source_.read(box) : reducedTo(level, box);
        VS_CHECK_EQ(values.size(), box.volume() * sizeOf(source_.type));
        if (extremes) {
            extremes->add(box, values);
        }
        writeOrRemove(array, chunk, filledUp(values, box.size()));
    }

    // A box of a level from the level before.
    [[nodiscard]] std::vector<std::byte> reducedTo(std::size_t level, const Box3& box) const {
        const GridGeometry& finer = store_.levels[level - 1].geometry;
        const glm::ivec3 by = halvedAlong(finer.dims);
        const Box3 source = intersect({box.lo * by, box.hi * by}, finer.box());
        Volume part;
        part.type = source_.type;
        part.geometry = makeGeometry(source.size());
        part.bytes = readBox(store_, level - 1, source);
        return reducedValues(part, by, layout_.reducing);
    }

    // A whole chunk, zeros beyond the box.
    [[nodiscard]] std::vector<std::byte> filledUp(const std::vector<std::byte>& values,
                                                  glm::ivec3 size) const {
        const auto side = std::size_t(layout_.chunk);
        const std::size_t row = std::size_t(size.x) * sizeOf(source_.type);
        if (size == glm::ivec3(layout_.chunk)) {
            return values;
        }
        std::vector<std::byte> chunk(side * side * side * sizeOf(source_.type));
        for (std::size_t z = 0; z < std::size_t(size.z); ++z) {
            for (std::size_t y = 0; y < std::size_t(size.y); ++y) {
                std::memcpy(chunk.data() + (z * side + y) * side * sizeOf(source_.type),
                            values.data() + (z * std::size_t(size.y) + y) * row, row);
            }
        }
        return chunk;
    }

    const StoreSource& source_;
    StoreLayout layout_;
    StoreProgress progress_;
    Multiscales store_;
    std::int64_t chunks_ = 0; // of all levels
    std::int64_t chunksDone_ = 0;
};

} // namespace

StoreSource sourceOf(const Volume& volume) {
    StoreSource source;
    source.facts = {volume.geometry, volume.unit, volume.name};
    source.type = volume.type;
    source.identity = fmt::format("{} {}", volume.name, checksum(volume));
    source.read = [&volume](const Box3& box) { return valuesIn(volume, box); };
    return source;
}

std::vector<GridGeometry> levelsOf(const GridGeometry& finest, int chunk) {
    std::vector<GridGeometry> levels{finest};
    while (glm::any(glm::greaterThan(levels.back().dims, glm::ivec3(chunk)))) {
        const GridGeometry& finer = levels.back();
        const glm::ivec3 by = halvedAlong(finer.dims);
        const glm::dmat4 finerFromVoxel =
            glm::scale(glm::translate(glm::dmat4(1), (glm::dvec3(by) - 1.0) / 2.0), glm::dvec3(by));
        levels.push_back({(finer.dims + by - 1) / by, finer.worldFromVoxel * finerFromVoxel});
    }
    return levels;
}

void writeStore(const std::filesystem::path& path, const StoreSource& source, const StoreLayout& layout) {
    StoreWriter(path, source, layout).run();
}

} // namespace vs::volume
