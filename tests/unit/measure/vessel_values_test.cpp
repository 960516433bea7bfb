// SPDX-License-Identifier: Apache-2.0
// Vessels measured by a scan's values against tubes whose diameters are known. Lengths are in steps (the
// smallest spacing).
#include "tubes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

namespace vs::segment {
namespace {

using Values = std::vector<double>;

// How much of each voxel lies inside, by as many places in it as make about four a step. Slices (along z) may
// be thinner than they lie apart.
Values coverageOf(const volume::GridGeometry& grid, const Solid& isInside, double thickness = 1) {
    const glm::dvec3 seen(1, 1, thickness);
    const glm::dvec3 steps = grid.spacing() / grid.stepMm();
    const glm::ivec3 counts(glm::ceil(4.0 * steps));
    Values coverage;
    forEachVoxel(grid.box(), [&](glm::ivec3 voxel, std::size_t) {
        // Where corners and centre agree, all of the voxel does: tubes are wider than voxels.
        int corners = 0;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner(i & 1, i >> 1 & 1, i >> 2);
            corners += isInside(worldAt(grid, glm::dvec3(voxel) + seen * (corner - 0.5))) ? 1 : 0;
        }
        if (corners == (isInside(worldAt(grid, voxel)) ? 8 : 0)) {
            coverage.push_back(corners == 8 ? 1 : 0);
            return;
        }
        int inside = 0;
        forEachVoxel({glm::ivec3(0), counts}, [&](glm::ivec3 at, std::size_t) {
            const glm::dvec3 offset = (glm::dvec3(at) + 0.5) / glm::dvec3(counts) - 0.5;
            inside += isInside(worldAt(grid, glm::dvec3(voxel) + seen * offset)) ? 1 : 0;
        });
        coverage.push_back(double(inside) / (counts.x * counts.y * counts.z));
    });
    return coverage;
}

// Convolves with a Gaussian.
Values blurred(Values values, const volume::GridGeometry& grid, double sigmaMm) {
    const VoxelSet places = emptySet(grid.box());
    for (int axis = 0; axis < 3; ++axis) {
        const double sigma = sigmaMm / grid.spacing()[axis];
        const int reach = int(std::ceil(3 * sigma));
        Values next;
        forEachVoxel(grid.box(), [&](glm::ivec3 voxel, std::size_t) {
            double sum = 0;
            double weights = 0;
            for (int i = -reach; i <= reach; ++i) {
                glm::ivec3 at = voxel;
                at[axis] = std::clamp(at[axis] + i, 0, grid.dims[axis] - 1);
                const double weight = std::exp(-0.5 * i * i / (sigma * sigma));
                sum += weight * values[places.indexOf(at)];
                weights += weight;
            }
            next.push_back(sum / weights);
        });
        values = next;
    }
    return values;
}

// A scan of coverages: 100 outside, 300 inside or, where the contrast is below 0, less than 100.
volume::Volume scanOf(const volume::GridGeometry& grid, const Values& coverage, double noise = 0,
                      double contrast = 200) {
    std::mt19937 random(5);
    std::normal_distribution<double> gaussian;
    volume::Volume scan;
    scan.geometry = grid;
    scan.type = volume::ScalarType::Float32;
    scan.bytes.resize(4 * coverage.size());
    for (std::size_t i = 0; i < coverage.size(); ++i) {
        const auto value = float(100 + contrast * (coverage[i] + noise * gaussian(random)));
        std::memcpy(&scan.bytes[4 * i], &value, 4);
    }
    return scan;
}

VoxelSet halfOf(const volume::GridGeometry& grid, const Values& coverage) {
    VoxelSet set = emptySet(grid.box());
    for (std::size_t i = 0; i < coverage.size(); ++i) {
        set.inside[i] = coverage[i] > 0.5 ? 1 : 0;
    }
    return set;
}

// Adds the voxels that share a face with the set, or takes away those that share one with what is outside.
VoxelSet grownBy(const VoxelSet& set, bool isGrown) {
    VoxelSet grown = set;
    forEachVoxel(set.box, [&](glm::ivec3 voxel, std::size_t i) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {-1, 1}) {
                glm::ivec3 beside = voxel;
                beside[axis] += side;
                if (set.contains(beside) == isGrown && set.contains(voxel) != isGrown) {
                    grown.inside[i] = isGrown ? 1 : 0;
                }
            }
        }
    });
    return grown;
}

struct Grid {
    const char* name;
    volume::GridGeometry geometry;
};
std::vector<Grid> gridsOf(double half) {
    const double size = 1.4 * half + 16;
    return {{"even", centredGrid(size, glm::dvec3(1))}, {"flat", centredGrid(size + 6, {1, 1, 3})}};
}

// All diameters are within 0.2 steps, and their mean within 1 %. Along the grid too,
// where no mask can tell.
TEST(VesselValues, TubesAreSubVoxelExact) {
    for (const double radius : {2.5, 5.0}) {
        for (const Grid& grid : gridsOf(16)) {
            for (const glm::dvec3 direction : {glm::dvec3(1, 2, 3), {1, 0, 0}, {1, 1, 0.1}}) {
                const auto tube = straight(direction, radius, 16);
                const Values coverage = coverageOf(grid.geometry, tube);
                const auto scan = scanOf(grid.geometry, coverage);
                const Errors e = measuredAlong(tube, grid.geometry, setWhere(grid.geometry, tube), &scan);
                EXPECT_LT(e.diameter, 0.2) << grid.name << radius;
                EXPECT_LT(std::abs(e.meanDiameter), 0.01 * 2 * radius) << grid.name << radius;
                EXPECT_LT(e.axis, 0.1) << grid.name << radius;
            }
        }
    }
}

// How thick slices are is told by the values: nothing else says it in most files.
TEST(VesselValues, SlicesThinnerThanTheyLieApart) {
    for (const double radius : {3.0, 5.0}) {
        for (const double thickness : {0.1, 0.4, 0.7}) {
            const auto grid = centredGrid(44, {1, 1, 3});
            const auto tube = straight({2, 1, 1}, radius, 16);
            const Values coverage = coverageOf(grid, tube, thickness);
            for (const double noise : {0.0, 0.08}) {
                const auto scan = scanOf(grid, coverage, noise);
                const Errors e = measuredAlong(tube, grid, halfOf(grid, coverage), &scan);
                EXPECT_LT(e.diameter, 0.2) << thickness << " " << radius;
                EXPECT_LT(std::abs(e.meanDiameter), 0.01 * 2 * radius) << thickness << " " << radius;
            }
        }
    }
}

TEST(VesselValues, TurnedVoxelsThatAreFiveTimesAsThick) {
    const auto grid = turnedGrid(14, {0.4, 0.7, 2});
    const auto tube = straight({1, 2, 3}, 2, 7); // five steps
    const auto scan = scanOf(grid, coverageOf(grid, tube));
    const Errors e = measuredAlong(tube, grid, setWhere(grid, tube), &scan);
    EXPECT_LT(e.diameter, 0.1); // the mask alone is wrong by 0.13
    EXPECT_LT(std::abs(e.meanDiameter), 0.03);
}

// A mask at the half of a blurred scan is too thin, the more the thinner the vessel. Dark vessels are vessels
// as well.
TEST(VesselValues, BlurAndNoise) {
    for (const Grid& grid : gridsOf(16)) {
        const auto tube = straight({1, 2, 3}, 3.5, 16);
        const Values values = blurred(coverageOf(grid.geometry, tube), grid.geometry, 0.7);
        const VoxelSet mask = halfOf(grid.geometry, values);
        const Errors byMask = measuredAlong(tube, grid.geometry, mask);
        for (const double noise : {0.0, 0.05, 0.15}) {
            for (const double contrast : {200.0, -80.0}) {
                const auto scan = scanOf(grid.geometry, values, noise, contrast);
                const Errors e = measuredAlong(tube, grid.geometry, mask, &scan);
                EXPECT_LT(std::abs(e.meanDiameter), 0.01 * 7) << grid.name << noise;
                EXPECT_LT(e.diameter, 0.1 + 2.5 * noise) << grid.name << noise;
                EXPECT_LT(std::abs(e.meanDiameter), std::abs(byMask.meanDiameter)) << grid.name << noise;
            }
        }
    }
}

// Values that only repeat the mask, and walls that lie elsewhere, leave the mask the word.
TEST(VesselValues, WithoutAnEdgeThereTheMaskDecides) {
    for (const Grid& grid : gridsOf(16)) {
        const auto tube = straight({1, 2, 3}, 5, 16);
        const VoxelSet mask = setWhere(grid.geometry, tube);
        const auto binary = scanOf(grid.geometry, Values(mask.inside.begin(), mask.inside.end()));
        const Values coverage = coverageOf(grid.geometry, tube);
        const auto scan = scanOf(grid.geometry, coverage, 0.05);
        const auto even = scanOf(grid.geometry, Values(coverage.size(), 0.5), 0.15);
        const auto differ = [&](const VoxelSet& set, const volume::Volume& values) {
            const Errors byMask = measuredAlong(tube, grid.geometry, set);
            const Errors e = measuredAlong(tube, grid.geometry, set, &values);
            return std::abs(e.meanDiameter - byMask.meanDiameter);
        };
        EXPECT_EQ(differ(mask, binary), 0) << grid.name;
        EXPECT_EQ(differ(mask, even), 0) << grid.name;
        // Hundredths, since the axis is moved once more.
        EXPECT_LT(differ(grownBy(mask, true), scan), 0.05) << grid.name;
        EXPECT_LT(differ(grownBy(mask, false), scan), 0.05) << grid.name;
    }
}

// On the side where vessels touch there is no edge; on all others there is.
TEST(VesselValues, TouchingNeighbours) {
    const auto grid = centredGrid(44, glm::dvec3(1));
    const auto tube = straight({1, 0.4, 0.3}, 4, 16);
    auto neighbour = tube;
    neighbour.middle = 8.2 * glm::normalize(glm::cross(tube.direction, glm::dvec3(0, 0, 1)));
    const auto both = [&](glm::dvec3 place) { return tube(place) || neighbour(place); };
    const Values values = coverageOf(grid, both);
    const auto scan = scanOf(grid, values);
    const VoxelSet mask = halfOf(grid, values);
    EXPECT_LT(measuredAlong(tube, grid, mask, &scan).diameter, 0.06); // the mask alone is wrong by 0.1
}

} // namespace
} // namespace vs::segment
