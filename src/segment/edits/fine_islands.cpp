// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/fine_islands.h"

#include "base/error.h"
#include "base/progress.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace vs::segment {

namespace {

// Voxels from `begin` to before `end` along x.
struct Run {
    int z, y, begin, end;
};

bool isBefore(const Run& a, const Run& b) {
    return std::tie(a.z, a.y, a.begin) < std::tie(b.z, b.y, b.begin);
}

// The rows of a set in the order of z, y and x; those that touch are one.
std::vector<Run> runsOf(const FineSet& set) {
    std::vector<Run> runs;
    set.forEachRow([&](int begin, int end, int y, int z) {
        if (!runs.empty() && runs.back().z == z && runs.back().y == y && runs.back().end == begin) {
            runs.back().end = end;
            return;
        }
        runs.push_back({z, y, begin, end});
        if (runs.size() % 65536 == 0) {
            reportProgress();
        }
    });
    return runs;
}

// What lies between a set's rows, and two runs without end in each row where the set has any; other rows are
// outside as a whole.
constexpr int kEndless = std::numeric_limits<int>::max() / 2;
std::vector<Run> gapsIn(const std::vector<Run>& runs) {
    std::vector<Run> gaps;
    for (std::size_t n = 0; n < runs.size(); ++n) {
        const Run& run = runs[n];
        const bool isFirst = n == 0 || runs[n - 1].z != run.z || runs[n - 1].y != run.y;
        const bool isLast = n + 1 == runs.size() || runs[n + 1].z != run.z || runs[n + 1].y != run.y;
        gaps.push_back({run.z, run.y, isFirst ? -kEndless : runs[n - 1].end, run.begin});
        if (isLast) {
            gaps.push_back({run.z, run.y, run.end, kEndless});
        }
    }
    return gaps;
}

// Sets of numbers that are joined two by two (Tarjan 1975, with path halving).
class Joined {
public:
    explicit Joined(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0U); }
    std::uint32_t rootOf(std::uint32_t n) {
        while (parents_[n] != n) {
            n = parents_[n] = parents_[parents_[n]];
        }
        return n;
    }
    // The lower root stays one, so that it is the first of all.
    void join(std::uint32_t a, std::uint32_t b) {
        a = rootOf(a);
        b = rootOf(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parents_;
};

// Where in a list of runs a row begins and ends.
struct Row {
    int z, y;
    std::uint32_t begin, end;
};

std::vector<Row> rowsOf(const std::vector<Run>& runs) {
    std::vector<Row> rows;
    for (std::uint32_t n = 0; n < runs.size(); ++n) {
        if (rows.empty() || rows.back().z != runs[n].z || rows.back().y != runs[n].y) {
            rows.push_back({runs[n].z, runs[n].y, n, n});
        }
        rows.back().end = n + 1;
    }
    return rows;
}

const Row* rowAt(const std::vector<Row>& rows, int z, int y) {
    const auto found = std::lower_bound(rows.begin(), rows.end(), std::pair(z, y),
                                        [](const Row& row, auto at) { return std::pair(row.z, row.y) < at; });
    return found != rows.end() && found->z == z && found->y == y ? &*found : nullptr;
}

// Joins the runs of two rows that lie side by side, or, `diagonally`, corner to corner.
void joinRows(const std::vector<Run>& runs, const Row& a, const Row& b, bool diagonally, Joined& joined) {
    const int more = diagonally ? 1 : 0;
    for (std::uint32_t i = a.begin, j = b.begin; i < a.end && j < b.end;) {
        if (runs[i].begin < runs[j].end + more && runs[j].begin < runs[i].end + more) {
            joined.join(i, j);
        }
        (runs[i].end < runs[j].end ? i : j)++;
    }
}

// The steps (z, y) to rows before one that its voxels may be joined with.
std::span<const std::array<int, 2>> stepsOf(Connectivity connectivity) {
    static constexpr std::array<std::array<int, 2>, 4> kSteps{{{-1, 0}, {0, -1}, {-1, -1}, {-1, 1}}};
    return std::span(kSteps).first(connectivity == Connectivity::Six ? 2 : 4);
}

Joined joinedRuns(const std::vector<Run>& runs, const std::vector<Row>& rows, Connectivity connectivity) {
    Joined joined(runs.size());
    for (const Row& row : rows) {
        if ((&row - rows.data()) % 65536 == 0) {
            reportProgress();
        }
        for (const auto [dz, dy] : stepsOf(connectivity)) {
            if (const Row* other = rowAt(rows, row.z + dz, row.y + dy)) {
                joinRows(runs, row, *other, connectivity != Connectivity::Six, joined);
            }
        }
    }
    return joined;
}

// The islands of a set.
class Islands {
public:
    Islands(const FineSet& set, Connectivity connectivity)
        : set_(set), runs_(runsOf(set)), joined_(joinedRuns(runs_, rowsOf(runs_), connectivity)) {}

    // Voxels of each island, by the number of its first run.
    std::vector<std::uint64_t> sizes() {
        std::vector<std::uint64_t> voxels(runs_.size());
        for (std::uint32_t n = 0; n < runs_.size(); ++n) {
            voxels[joined_.rootOf(n)] += std::uint64_t(runs_[n].end - runs_[n].begin);
        }
        return voxels;
    }
    std::uint32_t at(glm::ivec3 voxel) {
        const auto after =
            std::upper_bound(runs_.begin(), runs_.end(), Run{voxel.z, voxel.y, voxel.x, 0}, isBefore);
        return joined_.rootOf(std::uint32_t(after - runs_.begin()) - 1);
    }
    // All islands that are wanted(number of its first run).
    template <typename Wanted>
    FineSet those(Wanted wanted) {
        FineSet result(set_.dims());
        for (std::uint32_t n = 0; n < runs_.size(); ++n) {
            const Run& run = runs_[n];
            if (wanted(joined_.rootOf(n))) {
                result.addRow(run.begin, run.end, run.y, run.z);
            }
        }
        return result;
    }

private:
    const FineSet& set_;
    std::vector<Run> runs_;
    Joined joined_;
};

// The voxel of the set nearest to a place, counted in voxels.
glm::ivec3 nearestVoxel(const FineSet& set, glm::ivec3 place, glm::ivec3 reach) {
    const Box3 around{place - reach, place + reach + 1};
    const auto mask = set.within(around);
    std::optional<glm::ivec3> nearest;
    std::int64_t smallest = 0;
    forEachVoxel(around, [&](glm::ivec3 voxel, std::size_t i) {
        const glm::i64vec3 step(voxel - place);
        const std::int64_t squared = step.x * step.x + step.y * step.y + step.z * step.z;
        if (mask[i] != 0 && (!nearest || squared < smallest)) {
            nearest = voxel;
            smallest = squared;
        }
    });
    if (!nearest) {
        throw Error(
            "the finest level's voxel {},{},{} is more than {} voxels away from the segment; take one on it",
            place.x, place.y, place.z, std::max({reach.x, reach.y, reach.z}));
    }
    return *nearest;
}

FineSet keepOrDrop(const FineSet& set, glm::ivec3 place, glm::ivec3 reach, Connectivity connectivity,
                   bool keep) {
    const glm::ivec3 voxel = nearestVoxel(set, place, reach);
    Islands islands(set, connectivity);
    const std::uint32_t chosen = islands.at(voxel);
    return islands.those([&](std::uint32_t island) { return (island == chosen) == keep; });
}

double millilitres(std::uint64_t voxels, const volume::GridGeometry& geometry) {
    return double(voxels) * geometry.voxelMm3() / 1000;
}

} // namespace

FineSet keepIsland(const FineSet& set, glm::ivec3 place, Connectivity connectivity, glm::ivec3 reach) {
    return keepOrDrop(set, place, reach, connectivity, true);
}

FineSet dropIsland(const FineSet& set, glm::ivec3 place, Connectivity connectivity, glm::ivec3 reach) {
    return keepOrDrop(set, place, reach, connectivity, false);
}

FineSet keepLargestIsland(const FineSet& set, Connectivity connectivity) {
    if (set.isEmpty()) {
        return set;
    }
    Islands islands(set, connectivity);
    const auto sizes = islands.sizes();
    const auto largest = std::uint32_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    return islands.those([&](std::uint32_t island) { return island == largest; });
}

FineSet dropSmallIslands(const FineSet& set, const volume::GridGeometry& geometry, double minimumMl,
                         Connectivity connectivity) {
    Islands islands(set, connectivity);
    const auto sizes = islands.sizes();
    return islands.those(
        [&](std::uint32_t island) { return millilitres(sizes[island], geometry) >= minimumMl; });
}

FineSet fillHoles(const FineSet& set, const volume::GridGeometry& geometry, double largestMl,
                  Connectivity connectivity) {
    std::vector<Run> gaps = gapsIn(runsOf(set));
    const std::vector<Row> rows = rowsOf(gaps);
    Joined joined = joinedRuns(gaps, rows, connectivity);
    // What touches the outside: runs without end, and those beside a row that is outside as a whole.
    std::vector<bool> isOutside(gaps.size());
    for (const Row& row : rows) {
        bool isBesideOutside = false;
        for (const auto [dz, dy] : stepsOf(connectivity)) {
            isBesideOutside = isBesideOutside || rowAt(rows, row.z + dz, row.y + dy) == nullptr ||
                              rowAt(rows, row.z - dz, row.y - dy) == nullptr;
        }
        for (std::uint32_t n = row.begin; n < row.end; ++n) {
            if (isBesideOutside || n == row.begin || n + 1 == row.end) {
                isOutside[joined.rootOf(n)] = true;
            }
        }
    }
    std::vector<std::uint64_t> sizes(gaps.size());
    for (std::uint32_t n = 0; n < gaps.size(); ++n) {
        sizes[joined.rootOf(n)] += std::uint64_t(gaps[n].end - gaps[n].begin);
    }
    FineSet result = set;
    for (std::uint32_t n = 0; n < gaps.size(); ++n) {
        const std::uint32_t root = joined.rootOf(n);
        if (!isOutside[root] && millilitres(sizes[root], geometry) <= largestMl) {
            result.addRow(gaps[n].begin, gaps[n].end, gaps[n].y, gaps[n].z);
        }
    }
    return result;
}

} // namespace vs::segment
