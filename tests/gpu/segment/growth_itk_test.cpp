// SPDX-License-Identifier: Apache-2.0
// The region against ITK's ConnectedThresholdImageFilter and NeighborhoodConnectedImageFilter, on made-up and
// on real volumes.
#include "base/timer.h"
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"
#include "gpu/segment/itk_growing.h"
#include "test_data.h"
#include "volume/reading/read_volume.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <limits>

namespace vs::segment {
namespace {

using GrowthItkTest = GrowthCase;
const std::filesystem::path kTemplates = "/usr/share/mricron/templates";

// The voxel with a value in the range that lies nearest to the middle of the volume.
glm::ivec3 nearestInRange(const volume::Volume& volume, Range range) {
    const glm::ivec3 dims = volume.geometry.dims;
    glm::ivec3 best(-1);
    double nearest = std::numeric_limits<double>::infinity();
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const double apart = glm::length(glm::dvec3(x, y, z) - glm::dvec3(dims) / 2.0);
                if (apart < nearest && range.contains(volume.at({x, y, z}))) {
                    nearest = apart;
                    best = {x, y, z};
                }
            }
        }
    }
    return best;
}

void expectEqualsItk(const volume::Volume& volume, const std::vector<glm::ivec3>& seeds, Range range,
                     std::uint64_t atLeast) {
    const field::Field field = field::uploadVolume(volume);
    for (const auto connectivity : {Connectivity::Six, Connectivity::TwentySix}) {
        Growth growth(field, GrowthItkTest::GetParam());
        Constraints constraints;
        constraints.range = range;
        constraints.connectivity = connectivity;
        growth.setConstraints(constraints);
        growth.addSeeds(seeds);
        growth.advance(kAll);
        const auto itk = test::growWithItk(volume, seeds, range, connectivity == Connectivity::TwentySix);
        EXPECT_TRUE(growth.labels() == itk) << volume.name;
        EXPECT_GE(growth.voxelCount(), atLeast) << volume.name;
    }
}

TEST_P(GrowthItkTest, RandomVolumesOfEveryScalarType) {
    using enum volume::ScalarType;
    for (const auto type : {UInt8, Int8, UInt16, Int16, UInt32, Int32, Float32}) {
        const auto volume = randomVolume({37, 21, 19}, type, 0, 100);
        expectEqualsItk(volume, {{18, 10, 9}, {3, 4, 5}, {30, 2, 2}, {1, 1, 1}, {20, 20, 10}}, {10, 55}, 1);
    }
}

// 1 where the whole neighbourhood of (2 radius + 1)^3 lies in the range, as far as it lies in the grid: ITK
// goes on beyond the border with the values there, which belong to the neighbourhood already. One axis after
// the other.
std::vector<std::uint8_t> wholeNeighbourhoods(const volume::Volume& volume, Range range, int radius) {
    const glm::ivec3 dims = volume.geometry.dims;
    std::vector<std::uint8_t> inside(volume.geometry.voxelCount());
    volume::visit(volume, [&](const auto* values) {
        std::transform(values, values + inside.size(), inside.begin(),
                       [&](auto value) { return std::uint8_t(range.contains(double(value)) ? 1 : 0); });
    });
    const std::ptrdiff_t strides[3] = {1, dims.x, std::ptrdiff_t(dims.x) * dims.y};
    for (int axis = 0; axis < 3; ++axis) {
        const auto before = inside;
        for (std::ptrdiff_t i = 0; i < std::ptrdiff_t(inside.size()); ++i) {
            const int place = int(i / strides[axis] % dims[axis]);
            const int last = std::min(place + radius, dims[axis] - 1);
            for (int other = std::max(place - radius, 0); other <= last; ++other) {
                inside[std::size_t(i)] &= before[std::size_t(i + (other - place) * strides[axis])];
            }
        }
    }
    return inside;
}

void expectEqualsItkNeighbourhoods(const volume::Volume& volume, const std::vector<glm::ivec3>& seeds,
                                   Range range, int radius, std::uint64_t atLeast) {
    const field::Field field = field::uploadVolume(volume);
    const auto inside = wholeNeighbourhoods(volume, range, radius);
    // Both let seeds in without asking for their neighbourhoods, so only those that would pass are given.
    std::vector<glm::ivec3> admitted;
    std::copy_if(seeds.begin(), seeds.end(), std::back_inserter(admitted), [&](glm::ivec3 seed) {
        const glm::ivec3 dims = volume.geometry.dims;
        return inside[(std::size_t(seed.z) * dims.y + seed.y) * dims.x + seed.x] != 0;
    });
    Growth growth(field, GrowthItkTest::GetParam());
    Constraints constraints;
    constraints.range = range;
    growth.setConstraints(constraints);
    growth.confine(inside);
    growth.addSeeds(admitted);
    growth.advance(kAll);
    EXPECT_TRUE(growth.labels() == test::growNeighbourhoodsWithItk(volume, admitted, range, radius))
        << volume.name << ", radius " << radius;
    EXPECT_GE(growth.voxelCount(), atLeast) << volume.name << ", radius " << radius;
}

// Few of a hundred values are out of the range, so that whole neighbourhoods of 27 are common and touch, also
// at the border, while those of 125 are rare.
TEST_P(GrowthItkTest, WholeNeighbourhoodsOfRandomVolumes) {
    using enum volume::ScalarType;
    for (const auto type : {UInt8, Int16, Float32}) {
        const auto volume = randomVolume({37, 21, 19}, type, 0, 100);
        std::vector<glm::ivec3> seeds;
        for (int i = 0; i < 37; ++i) { // from border to border; some neighbourhoods are whole
            seeds.push_back({i, i * 20 / 36, i * 18 / 36});
        }
        expectEqualsItkNeighbourhoods(volume, seeds, {0, 98}, 1, 1000);
        expectEqualsItkNeighbourhoods(volume, seeds, {0, 98}, 2, 1);
        expectEqualsItkNeighbourhoods(volume, seeds, {0, 55}, 0, 1000);
    }
}

TEST_P(GrowthItkTest, WholeNeighbourhoodsOfTheBrainTemplate) {
    const auto path = kTemplates / "ch2.nii.gz";
    ASSERT_TRUE(std::filesystem::exists(path)) << path << " is not installed (package mricron-data)";
    const auto volume = volume::readVolume(path).volume;
    const std::vector<glm::ivec3> seeds{{90, 108, 90}, {60, 100, 90}, {120, 120, 80}};
    const Range range{70, 130};
    expectEqualsItkNeighbourhoods(volume, seeds, range, 1, 1);
}

TEST_P(GrowthItkTest, BrainTemplate) {
    const auto path = kTemplates / "ch2.nii.gz";
    ASSERT_TRUE(std::filesystem::exists(path)) << path << " is not installed (package mricron-data)";
    expectEqualsItk(volume::readVolume(path).volume, {{90, 108, 90}, {60, 100, 90}, {120, 120, 80}},
                    {70, 130}, 500000);
}

TEST_P(GrowthItkTest, CompressedCtSeries) {
    const auto path = test::dataFolder() / "dicom_ct_j2k";
    if (!std::filesystem::exists(path)) {
        GTEST_SKIP() << path << " is not here; set VOLUME_STUDIO_TEST_DATA";
    }
    const auto volume = volume::readVolume(path).volume;
    const Range range{-50, 200};
    expectEqualsItk(volume, {nearestInRange(volume, range)}, range, 100000);
}

TEST_P(GrowthItkTest, ObliqueMrSeries) {
    const auto archive = test::dataFolder() / "dicom_t1_7t.tar.gz";
    if (!std::filesystem::exists(archive)) {
        GTEST_SKIP() << archive << " is not here; set VOLUME_STUDIO_TEST_DATA";
    }
    const auto folder =
        std::filesystem::temp_directory_path() / fmt::format("vs_oblique_series_{}", getpid());
    std::filesystem::create_directories(folder);
    const std::string unpack = fmt::format("tar -xzf '{}' -C '{}'", archive.string(), folder.string());
    ASSERT_EQ(std::system(unpack.c_str()), 0);
    std::filesystem::path series = folder;
    while (std::filesystem::directory_iterator(series)->is_directory()) {
        series = std::filesystem::directory_iterator(series)->path();
    }
    const auto volume = volume::readVolume(series).volume;
    std::filesystem::remove_all(folder);
    const Range range{45, 90};
    expectEqualsItk(volume, {nearestInRange(volume, range)}, range, 100000);
}

// Also says how fast both are, in turns, so that both see the same load of the machine.
TEST_P(GrowthItkTest, LargeBrainTemplate) {
    const auto path = kTemplates / "ch2better.nii.gz";
    ASSERT_TRUE(std::filesystem::exists(path)) << path << " is not installed (package mricron-data)";
    const auto volume = volume::readVolume(path).volume;
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field, GrowthItkTest::GetParam());
    const glm::ivec3 seed(150, 185, 200);
    Constraints constraints;
    constraints.range = {40, 130};
    growth.setConstraints(constraints);
    for (int run = 0; run < 3; ++run) {
        growth.reset();
        growth.addSeeds(std::span(&seed, 1));
        const Timer timer;
        growth.advance(kAll);
        const double ours = timer.milliseconds();
        double itk = 0;
        const auto labels = test::growWithItk(volume, {seed}, constraints.range, false, &itk);
        EXPECT_EQ(growth.voxelCount(), 13023248U);
        EXPECT_TRUE(growth.labels() == labels);
        const double voxels = double(growth.voxelCount()) / 1000.0;
        fmt::print("million voxels/s: {:.1f} here, {:.1f} ITK{}\n", voxels / ours, voxels / itk,
                   run == 0 ? " (first run, with compiling)" : "");
    }
}

INSTANTIATE_TEST_SUITE_P(OnDeviceAndHost, GrowthItkTest, kEngines, nameOfEngine);

} // namespace
} // namespace vs::segment
