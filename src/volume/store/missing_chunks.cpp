// SPDX-License-Identifier: Apache-2.0
#include "volume/store/missing_chunks.h"

#include "volume/io/inspect.h"
#include "volume/io/take_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace vs::volume {

namespace {

namespace fs = std::filesystem;

constexpr int kMostFiles = 300'000; // some seconds
constexpr std::size_t kMostCells = std::size_t(1) << 24;
constexpr float kAnything = std::numeric_limits<float>::infinity();

std::size_t countOf(glm::ivec3 cells) {
    return std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z);
}

// The numbers in the name of a chunk's file, in the array's folder; empty: it is not one.
std::vector<std::int64_t> chunkOf(const std::string& name, char separator, std::size_t axes) {
    std::vector<std::int64_t> chunk;
    const char* at = name.data();
    const char* const end = at + name.size();
    while (at < end) {
        std::int64_t number = 0;
        const auto [next, error] = std::from_chars(at, end, number);
        const bool isLast = next == end;
        if (error != std::errc() || number < 0 || (!isLast && *next != separator)) {
            return {};
        }
        chunk.push_back(number);
        at = isLast ? end : next + 1;
    }
    return chunk.size() == axes ? chunk : std::vector<std::int64_t>();
}

// The grid of an array's chunks in space, and which of them are meant.
class Chunks {
public:
    Chunks(const Multiscales& store, int channel, int time)
        : store_(store), array_(store.levels.front().array), dims_(store.levels.front().geometry.dims),
          fixed_(array_.shape.size(), 0) {
        const auto fix = [&](int axis, int index) {
            if (axis >= 0) {
                fixed_[std::size_t(axis)] = index / array_.chunks[std::size_t(axis)];
            }
        };
        fix(store.channelAxis, channel);
        fix(store.timeAxis, time);
        for (int i = 0; i < 3; ++i) {
            const int axis = store.spatial[std::size_t(i)];
            side_[i] = axis < 0 ? 1 : int(std::min<std::int64_t>(array_.chunks[std::size_t(axis)], dims_[i]));
        }
    }

    [[nodiscard]] std::size_t count() const { return countOf(counts()); }
    // The voxels of a chunk; empty: it is of another channel or time, or beyond the grid.
    [[nodiscard]] Box3 voxelsOf(const std::vector<std::int64_t>& chunk) const {
        glm::ivec3 place(0);
        for (std::size_t axis = 0; axis < chunk.size(); ++axis) {
            const auto of = std::find(store_.spatial.begin(), store_.spatial.end(), int(axis));
            if (of == store_.spatial.end() && chunk[axis] != fixed_[axis]) {
                return {};
            }
            if (of != store_.spatial.end()) {
                place[int(of - store_.spatial.begin())] = int(std::min<std::int64_t>(chunk[axis], 1 << 20));
            }
        }
        if (glm::any(glm::greaterThanEqual(place, counts()))) {
            return {};
        }
        return {place * side_, glm::min((place + 1) * side_, dims_)};
    }

private:
    [[nodiscard]] glm::ivec3 counts() const { return (dims_ - 1) / side_ + 1; }

    const Multiscales& store_;
    const ZarrArray& array_;
    glm::ivec3 dims_;
    glm::ivec3 side_{1};
    std::vector<std::int64_t> fixed_; // chunk along the axes that are not of space
};

} // namespace

std::optional<CellExtremes> extremesByMissing(const Multiscales& store, int channel, int time) {
    const ZarrArray& array = store.levels.front().array;
    const glm::ivec3 dims = store.levels.front().geometry.dims;
    Volume filled; // as values that are read are
    filled.geometry = makeGeometry(glm::ivec3(1));
    takeValues(filled, array.type, array.fillValue());
    const auto fill = float(filled.at(glm::ivec3(0)));
    if (!std::isfinite(fill)) {
        return {};
    }
    int side = 32;
    while (countOf(divideUp(dims, side)) > kMostCells) {
        side *= 2;
    }
    const glm::ivec3 cells = divideUp(dims, side);
    announcePromised(countOf(cells) * sizeof(glm::vec2));
    std::vector<glm::vec2> ranges(countOf(cells), glm::vec2(fill));
    const Chunks chunks(store, channel, time);
    std::size_t there = 0;
    int files = 0;
    std::error_code error;
    const auto withLinks = fs::directory_options::follow_directory_symlink;
    for (fs::recursive_directory_iterator at(array.folder, withLinks, error), end; !error && at != end;
         at.increment(error)) {
        if (++files > kMostFiles) {
            return {};
        }
        const std::string name = at->path().lexically_relative(array.folder).generic_string();
        const auto chunk = chunkOf(name, array.separator, array.shape.size());
        const Box3 voxels = chunk.empty() ? Box3() : chunks.voxelsOf(chunk);
        if (voxels.isEmpty()) {
            continue;
        }
        ++there;
        forEachVoxel(Box3{voxels.lo / side, (voxels.hi - 1) / side + 1}, [&](glm::ivec3 cell, std::size_t) {
            ranges[(std::size_t(cell.z) * std::size_t(cells.y) + std::size_t(cell.y)) * std::size_t(cells.x) +
                   std::size_t(cell.x)] = {-kAnything, kAnything};
        });
    }
    if (error || there >= chunks.count()) {
        return {};
    }
    const auto bytes = std::as_bytes(std::span(ranges));
    return CellExtremes{side, cells, ScalarType::Float32, {bytes.begin(), bytes.end()}};
}

} // namespace vs::volume
