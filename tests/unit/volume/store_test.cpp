// SPDX-License-Identifier: Apache-2.0
// Stores of OME-Zarr as they are written and read here; tests/cli/stores.py has other people's.
#include "base/error.h"
#include "base/progress.h"
#include "phantom/phantom.h"
#include "property.h"
#include "volume/grid/visit_type.h"
#include "volume/io/decode.h"
#include "volume/store/box_reader.h"
#include "volume/store/missing_chunks.h"
#include "volume/store/store_extremes.h"
#include "volume/store/write_store.h"

#include "test_files.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

namespace vs::volume {
namespace {

// Noise with an empty part, in a grid that lies aslant.
Volume drawVolume() {
    const glm::ivec3 dims(1 + *test::below(40), 1 + *test::below(40), 1 + *test::below(40));
    const auto type = kScalarTypes[std::size_t(*test::below(int(kScalarTypes.size())))];
    std::mt19937 random(std::mt19937::result_type(*test::below(1000)));
    const int firstFull = *test::below(40);
    Volume volume = phantom::makePhantom(
        dims, type, [&](glm::dvec3 p) { return p.x < firstFull ? 0.0 : double(random() % 100); });
    volume.name = "noise";
    volume.unit = "HU";
    volume.geometry.worldFromVoxel =
        glm::rotate(glm::translate(glm::dmat4(1), {12.3, -7.7, 1e3}), 0.3, glm::dvec3(1, 2, 3)) *
        glm::scale(glm::dmat4(1), {0.7, 0.9, 2.5});
    computeRange(volume);
    return volume;
}

Codec drawCodec() {
    Codec codec;
    codec.kind = Codec::Kind(*test::below(5));
    codec.level = 1 + *test::below(5);
    codec.inner = *test::coin() ? "lz4" : "zstd";
    codec.shuffle = *test::below(3);
    return codec;
}

TEST(Store, IsTheVolumeAndItsLevelsAreReduced) {
    test::checkProperty(60, [] {
        const TemporaryFolder folder;
        const Volume volume = drawVolume();
        const StoreLayout layout{8 + *test::below(20), drawCodec(),
                                 *test::coin() ? Reducing::Mean : Reducing::Commonest};
        writeStore(folder / "a.zarr", sourceOf(volume), layout);
        const Volume read = decodeVolume(folder / "a.zarr").volume;
        RC_ASSERT(read.bytes == volume.bytes);
        RC_ASSERT(read.type == volume.type);
        RC_ASSERT(read.unit == volume.unit);
        RC_ASSERT(checksum(read) == checksum(volume)); // the grid too, to the last bit
        Volume finer = volume;
        const auto levels = levelsOf(volume.geometry, layout.chunk);
        for (int level = 1; level < int(levels.size()); ++level) {
            const glm::ivec3 dims = finer.geometry.dims;
            finer =
                reduced(finer, {dims.x > 1 ? 2 : 1, dims.y > 1 ? 2 : 1, dims.z > 1 ? 2 : 1}, layout.reducing);
            ReadOptions options;
            options.level = level;
            const Volume coarse = decodeVolume(folder / "a.zarr", options).volume;
            RC_ASSERT(coarse.bytes == finer.bytes);
            RC_ASSERT(coarse.geometry.dims == finer.geometry.dims);
            for (int i = 0; i < 4; ++i) {
                RC_ASSERT(glm::length(coarse.geometry.worldFromVoxel[i] - finer.geometry.worldFromVoxel[i]) <
                          1e-9);
            }
        }
        RC_ASSERT(glm::all(glm::lessThanEqual(levels.back().dims, glm::ivec3(layout.chunk))));
    });
}

// A sparse scan is written without a look at all of it, and is the same.
TEST(Store, WhatIsKnownToBeZeroIsNotRead) {
    test::checkProperty(40, [] {
        const TemporaryFolder folder;
        const Volume volume = drawVolume();
        const StoreLayout layout{8 + *test::below(20), drawCodec(),
                                 *test::coin() ? Reducing::Mean : Reducing::Commonest};
        StoreSource source = sourceOf(volume);
        const auto valuesOf = source.read;
        const auto isZero = [&](const Box3& box) {
            const auto values = valuesOf(box);
            return std::all_of(values.begin(), values.end(), [](std::byte b) { return b == std::byte(0); });
        };
        writeStore(folder / "a.zarr", source, layout);
        std::atomic<bool> isReadInVain = false;
        source.read = [&](const Box3& box) {
            isReadInVain = isReadInVain || isZero(box);
            return valuesOf(box);
        };
        source.isZero = isZero;
        writeStore(folder / "b.zarr", source, layout);
        RC_ASSERT(!isReadInVain);
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "a.zarr")) {
            const auto other = folder / "b.zarr" / std::filesystem::relative(entry.path(), folder / "a.zarr");
            RC_ASSERT(std::filesystem::exists(other));
            RC_ASSERT((!entry.is_regular_file() || readFile(entry.path()) == readFile(other)));
        }
        const auto count = [&](const char* name) {
            return std::distance(std::filesystem::recursive_directory_iterator(folder / name), {});
        };
        RC_ASSERT(count("a.zarr") == count("b.zarr"));
    });
}

TEST(Store, ABoxIsThatPartOfTheVolume) {
    test::checkProperty(60, [] {
        const TemporaryFolder folder;
        const Volume volume = drawVolume();
        writeStore(folder / "a.zarr", sourceOf(volume), {8 + *test::below(20), drawCodec()});
        const Multiscales store = openMultiscales(folder / "a.zarr");
        const glm::ivec3 dims = volume.geometry.dims;
        const glm::ivec3 lo(*test::below(dims.x), *test::below(dims.y), *test::below(dims.z));
        const glm::ivec3 size(1 + *test::below(dims.x - lo.x), 1 + *test::below(dims.y - lo.y),
                              1 + *test::below(dims.z - lo.z));
        RC_ASSERT(readBox(store, 0, {lo, lo + size}) == sourceOf(volume).read({lo, lo + size}));
    });
}

TEST(Store, ChunksOfNothingHaveNoFile) {
    const TemporaryFolder folder;
    const Volume volume = phantom::makePhantom({64, 64, 64}, ScalarType::UInt8, [](glm::dvec3 p) {
        return p.x < 16 && p.y < 16 && p.z < 16 ? 9 : 0;
    });
    writeStore(folder / "a.zarr", sourceOf(volume), {16, {}});
    EXPECT_TRUE(std::filesystem::exists(folder / "a.zarr/0/0/0/0"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.zarr/0/0/0/1"));
    EXPECT_TRUE(decodeVolume(folder / "a.zarr").volume.bytes == volume.bytes);
}

std::vector<glm::vec2> rangesOf(const CellExtremes& extremes) {
    std::vector<glm::vec2> ranges;
    visitType(extremes.type, [&]<typename T>(const T*) {
        const auto* pairs = reinterpret_cast<const T*>(extremes.ranges.data());
        for (std::size_t i = 0; i < extremes.ranges.size() / sizeof(T); i += 2) {
            ranges.emplace_back(float(pairs[i]), float(pairs[i + 1]));
        }
    });
    return ranges;
}

TEST(Store, ExtremesAreThoseOfTheVoxels) {
    test::checkProperty(40, [] {
        const TemporaryFolder folder;
        const Volume volume = drawVolume();
        const std::filesystem::path path = folder / "a.zarr";
        writeStore(path, sourceOf(volume), {*test::coin() ? 8 : 16, drawCodec()});
        const Multiscales store = openMultiscales(path);
        const auto known = readExtremes(store);
        RC_ASSERT(known.has_value());
        RC_ASSERT(known->type == volume.type);
        const auto ranges = rangesOf(*known);
        forEachVoxel({glm::ivec3(0), known->cells}, [&](glm::ivec3 cell, std::size_t n) {
            double lo = std::numeric_limits<double>::max();
            double hi = -lo;
            const Box3 box = intersect({cell * known->side, (cell + 1) * known->side}, volume.geometry.box());
            forEachVoxel(box, [&](glm::ivec3 v, std::size_t) {
                lo = std::min(lo, volume.at(v));
                hi = std::max(hi, volume.at(v));
            });
            RC_ASSERT(ranges[n] == glm::vec2(lo, hi));
        });
        const auto all = rangeOfExtremes(store);
        RC_ASSERT(all.has_value());
        RC_ASSERT(all->lo == volume.range.lo);
        RC_ASSERT(all->hi == volume.range.hi);
    });
}

// What is said by which chunks have no file holds of every voxel, and nothing is said where all have one.
TEST(Store, MissingChunksSayWhatIsThere) {
    test::checkProperty(40, [] {
        const TemporaryFolder folder;
        const Volume volume = drawVolume();
        const std::filesystem::path path = folder / "a.zarr";
        writeStore(path, sourceOf(volume), {8 + *test::below(20), drawCodec()});
        const Multiscales store = openMultiscales(path);
        const glm::ivec3 dims = volume.geometry.dims;
        const BoxReader all(store, 0, {glm::ivec3(0), dims});
        int missing = 0;
        for (int n = 0; n < all.chunks(); ++n) {
            if (*test::below(4) == 0) {
                std::filesystem::remove(all.file(n));
            }
            missing += std::filesystem::exists(all.file(n)) ? 0 : 1;
        }
        const auto known = extremesByMissing(store, 0, 0);
        RC_ASSERT(known.has_value() == (missing > 0));
        if (known) {
            Volume now = volume;
            now.bytes = readBox(store, 0, {glm::ivec3(0), dims});
            forEachVoxel(volume.geometry.box(), [&](glm::ivec3 v, std::size_t) {
                const glm::ivec3 cell = v / known->side;
                const glm::vec2 range = rangesOf(
                    *known)[std::size_t((cell.z * known->cells.y + cell.y) * known->cells.x + cell.x)];
                const double value = now.at(v);
                RC_ASSERT((value >= range.x && value <= range.y));
            });
        }
    });
    // A corner of a larger one, in a chunk by itself.
    const TemporaryFolder folder;
    const Volume volume = phantom::makePhantom({96, 64, 64}, ScalarType::UInt8, [](glm::dvec3 p) {
        return p.x < 16 && p.y < 16 && p.z < 16 ? 9 : 0;
    });
    writeStore(folder / "a.zarr", sourceOf(volume), {16, {}});
    std::ofstream(folder / "a.zarr/0/notes.txt") << "no chunk";
    const auto known = extremesByMissing(openMultiscales(folder / "a.zarr"), 0, 0);
    ASSERT_TRUE(known.has_value());
    EXPECT_EQ(glm::ivec3(3, 2, 2), known->cells);
    const auto ranges = rangesOf(*known);
    EXPECT_TRUE(std::isinf(ranges.front().y));
    EXPECT_EQ(11, std::count(ranges.begin(), ranges.end(), glm::vec2(0)));
}

// Given up at any moment, it is gone on with, and nobody takes it for finished before.
TEST(Store, WhatIsGivenUpIsGoneOnWith) {
    const TemporaryFolder folder;
    const Volume volume =
        phantom::makePhantom({70, 60, 50}, ScalarType::Int16, [](glm::dvec3 p) { return p.x + p.y * p.z; });
    int tries = 0;
    for (bool isDone = false; !isDone; ++tries) {
        int left = 6; // a slab and more: 20 chunks, of which one processor takes four at once
        const ProgressListener listener([&](std::optional<double>) { return left-- > 0; });
        try {
            writeStore(folder / "a.zarr", sourceOf(volume), {16, {}});
            isDone = true;
        } catch (const GivenUp&) {
            EXPECT_THROW((void)decodeVolume(folder / "a.zarr"), ReadError);
        }
        ASSERT_LT(tries, 100);
    }
    EXPECT_GT(tries, 2);
    EXPECT_TRUE(decodeVolume(folder / "a.zarr").volume.bytes == volume.bytes);
    EXPECT_THROW(writeStore(folder / "a.zarr", sourceOf(volume), {16, {}}), WriteError);
}

TEST(Store, WhatIsThereAlreadyIsLeftAlone) {
    const TemporaryFolder folder;
    writeFile(folder / "mine.txt", "mine");
    const Volume volume = phantom::makePhantom({9, 9, 9}, ScalarType::UInt8, [](glm::dvec3) { return 1; });
    EXPECT_THROW(writeStore(folder.path(), sourceOf(volume)), WriteError);
    EXPECT_FALSE(std::filesystem::exists(folder / ".zgroup"));
}

} // namespace
} // namespace vs::volume
