// SPDX-License-Identifier: Apache-2.0
// What is written comes back with the same values in the same place, in every format.
#include "base/error.h"
#include "volume/io/decode.h"
#include "volume/io/write.h"

#include "test_files.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace vs::volume {
namespace {

GridGeometry obliqueGrid() {
    GridGeometry grid;
    grid.dims = {7, 5, 4};
    auto m = glm::translate(glm::dmat4(1.0), {-12.5, 30.25, 101.0});
    m = glm::rotate(m, 0.4, glm::normalize(glm::dvec3(1, 2, 0.5)));
    grid.worldFromVoxel = glm::scale(m, {0.7, 1.1, 2.5});
    return grid;
}

GridGeometry shearedGrid() {
    GridGeometry grid = obliqueGrid();
    grid.worldFromVoxel[2] += 0.3 * grid.worldFromVoxel[1];
    return grid;
}

template <typename T>
std::vector<T> ramp(const GridGeometry& grid) {
    std::vector<T> values(grid.voxelCount());
    std::iota(values.begin(), values.end(), T(3));
    return values;
}

void expectSamePlace(const GridGeometry& a, const GridGeometry& b) {
    ASSERT_EQ(a.dims, b.dims);
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 3; ++r) {
            // NIfTI keeps orientations as 32-bit floats.
            EXPECT_NEAR(a.worldFromVoxel[c][r], b.worldFromVoxel[c][r], 2e-5 * (c == 3 ? 100 : 1))
                << c << ' ' << r;
        }
    }
}

template <typename T>
void expectRoundTrip(const std::string& name, const GridGeometry& grid, ScalarType type) {
    const TemporaryFolder folder;
    const auto values = ramp<T>(grid);
    writeGrid(folder / name, grid, std::span<const T>(values));
    const auto result = decodeVolume(folder / name);
    EXPECT_EQ(result.volume.type, type) << name;
    expectSamePlace(result.volume.geometry, grid);
    ASSERT_EQ(result.volume.bytes.size(), values.size() * sizeof(T)) << name;
    EXPECT_EQ(std::memcmp(result.volume.bytes.data(), values.data(), result.volume.bytes.size()), 0) << name;
    EXPECT_TRUE(result.notices.empty()) << name << ": " << result.notices.front();
    EXPECT_EQ(result.volume.name, name);
}

class Formats : public testing::TestWithParam<const char*> {};

TEST_P(Formats, KeepObliqueGridsAndValues) {
    const std::string name = GetParam();
    expectRoundTrip<std::uint8_t>(name, obliqueGrid(), ScalarType::UInt8);
    expectRoundTrip<std::uint32_t>(name, obliqueGrid(), ScalarType::UInt32);
    expectRoundTrip<float>(name, obliqueGrid(), ScalarType::Float32);
}

TEST_P(Formats, LeaveNothingButTheFile) {
    const TemporaryFolder folder;
    const auto values = ramp<float>(obliqueGrid());
    for (int i = 0; i < 2; ++i) { // the second time over the first
        writeGrid(folder / GetParam(), obliqueGrid(), std::span<const float>(values));
    }
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        EXPECT_NE(entry.path().filename().string().front(), '.');
        ++files;
    }
    EXPECT_EQ(files, std::string(GetParam()).ends_with(".mhd") ? 2U : 1U);
}

INSTANTIATE_TEST_SUITE_P(All, Formats, testing::Values("a.nii.gz", "a.nii", "a.nrrd", "a.mha", "a.mhd"));

TEST(Write, KeepsShearWhereTheFormatCan) {
    expectRoundTrip<float>("a.nrrd", shearedGrid(), ScalarType::Float32);
    expectRoundTrip<float>("a.mha", shearedGrid(), ScalarType::Float32);
    const TemporaryFolder folder;
    const auto values = ramp<float>(shearedGrid());
    EXPECT_THROW(writeGrid(folder / "a.nii.gz", shearedGrid(), std::span<const float>(values)), WriteError);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Write, RefusesInOneLineWhatCannotBeWritten) {
    const TemporaryFolder folder;
    const auto grid = obliqueGrid();
    const auto values = ramp<float>(grid);
    for (const char* name : {"missing/a.nrrd", "a.png", "a"}) {
        try {
            writeGrid(folder / name, grid, std::span<const float>(values));
            ADD_FAILURE() << name << " was written";
        } catch (const WriteError& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Read, CountsNonFiniteValues) {
    const TemporaryFolder folder;
    auto values = ramp<float>(obliqueGrid());
    values[3] = std::numeric_limits<float>::quiet_NaN();
    values[9] = std::numeric_limits<float>::infinity();
    for (const char* name : {"a.nii", "a.nii.gz", "a.nrrd", "a.mha"}) {
        writeGrid(folder / name, obliqueGrid(), std::span<const float>(values));
        const auto result = decodeVolume(folder / name);
        EXPECT_EQ(result.volume.nonFiniteCount, 2U) << name;
        EXPECT_EQ(result.volume.range, (Range{3, 142})) << name;
        EXPECT_EQ(result.notices.size(), 1U) << name;
    }
}

TEST(Read, NrrdTextAndBigEndianAndDetached) {
    const TemporaryFolder folder;
    const std::string head = "NRRD0004\ntype: int16\ndimension: 3\nsizes: 2 2 1\nspacings: 1 2 3\n";
    writeFile(folder / "text.nrrd", head + "encoding: ascii\n\n1 -2\n300 4\n");
    writeFile(folder / "big.nrrd",
              head + "encoding: raw\nendian: big\n\n" + std::string("\0\1\xFF\xFE\1\x2C\0\4", 8));
    writeFile(folder / "two.nhdr",
              head + "encoding: raw\nendian: little\nbyte skip: -1\ndata file: two.raw\n");
    writeFile(folder / "two.raw", "skip" + std::string("\1\0\xFE\xFF\x2C\1\4\0", 8));
    for (const char* name : {"text.nrrd", "big.nrrd", "two.nhdr"}) {
        const auto volume = decodeVolume(folder / name).volume;
        EXPECT_EQ(volume.type, ScalarType::Int16) << name;
        EXPECT_EQ(volume.at({0, 0, 0}), 1) << name;
        EXPECT_EQ(volume.at({1, 0, 0}), -2) << name;
        EXPECT_EQ(volume.at({0, 1, 0}), 300) << name;
        EXPECT_EQ(volume.at({1, 1, 0}), 4) << name;
        EXPECT_EQ(volume.geometry.spacing(), glm::dvec3(1, 2, 3)) << name;
    }
}

TEST(Read, VtkLegacy) {
    const TemporaryFolder folder;
    writeFile(folder / "a.vtk",
              "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
              "SPACING 1 1 2\nORIGIN 5 6 7\nPOINT_DATA 8\nSCALARS s short 1\nLOOKUP_TABLE default\n"
              "1 2 3 4 5 6 7 8\n");
    const auto volume = decodeVolume(folder / "a.vtk").volume;
    EXPECT_EQ(volume.type, ScalarType::Int16);
    EXPECT_EQ(volume.at({1, 1, 1}), 8);
    EXPECT_EQ(glm::dvec3(volume.geometry.worldFromVoxel[3]), glm::dvec3(5, 6, 7));
}

TEST(Read, PicksOneVolumeOfFour) {
    const TemporaryFolder folder;
    const std::string head = "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 2 1 1 3\nencoding: raw\n";
    writeFile(folder / "plain.nrrd", head + "\nabcdef");
    writeFile(folder / "list.nrrd", head + "kinds: domain domain domain list\n\nabcdef");
    ReadOptions options;
    for (const char* name : {"plain.nrrd", "list.nrrd"}) {
        EXPECT_THROW(decodeVolume(folder / name), ReadError) << name;
        options.frame = 1;
        const auto volume = decodeVolume(folder / name, options).volume;
        EXPECT_EQ(volume.geometry.dims, glm::ivec3(2, 1, 1)) << name;
        EXPECT_EQ(volume.at({0, 0, 0}), 'c') << name;
        EXPECT_EQ(volume.at({1, 0, 0}), 'd') << name;
        options.frame = 3;
        EXPECT_THROW(decodeVolume(folder / name, options), ReadError) << name;
    }
}

// A NIfTI header with the fields that a test cares about.
std::string niftiFile(std::int16_t datatype, std::int16_t bits, float slope, float intercept,
                      const std::string& data, std::int16_t frames = 1) {
    std::string header(352, '\0');
    const auto put = [&](std::size_t at, auto value) {
        std::memcpy(header.data() + at, &value, sizeof value);
    };
    put(0, std::int32_t(348));
    const std::int16_t dims[] = {std::int16_t(frames > 1 ? 4 : 3), 2, 1, 1, frames, 1, 1, 1};
    for (std::size_t i = 0; i < 8; ++i) {
        put(40 + 2 * i, dims[i]);
        put(76 + 4 * i, 1.0F);
    }
    put(70, datatype);
    put(72, bits);
    put(108, 352.0F);
    put(112, slope);
    put(116, intercept);
    std::memcpy(header.data() + 344, "n+1", 4);
    return header + data;
}

TEST(Read, NiftiSlopeAndWideTypesAndFrames) {
    const TemporaryFolder folder;
    writeFile(folder / "slope.nii", niftiFile(2, 8, 2.5F, -1, "\1\3"));
    const auto scaled = decodeVolume(folder / "slope.nii").volume;
    EXPECT_EQ(scaled.type, ScalarType::Float32);
    EXPECT_EQ(scaled.at({1, 0, 0}), 6.5);
    writeFile(folder / "none.nii", niftiFile(2, 8, 0, 7, "\1\3"));
    EXPECT_EQ(decodeVolume(folder / "none.nii").volume.at({1, 0, 0}), 3);

    const std::int64_t wide[] = {5, (std::int64_t(1) << 40) + 1};
    writeFile(folder / "wide.nii",
              niftiFile(1024, 64, 1, 0, {reinterpret_cast<const char*>(wide), sizeof wide}));
    const auto rounded = decodeVolume(folder / "wide.nii");
    EXPECT_EQ(rounded.volume.type, ScalarType::Float32);
    EXPECT_EQ(rounded.notices.size(), 1U);

    writeFile(folder / "four.nii", niftiFile(2, 8, 1, 0, "abcdef", 3));
    EXPECT_THROW(decodeVolume(folder / "four.nii"), ReadError);
    ReadOptions options;
    options.frame = 2;
    EXPECT_EQ(decodeVolume(folder / "four.nii", options).volume.at({0, 0, 0}), 'e');
}

TEST(Read, ShearedNiftiKeepsItsSform) {
    const TemporaryFolder folder;
    auto file = niftiFile(2, 8, 1, 0, "ab");
    const float rows[3][4] = {{1, 0, 0.5F, 10}, {0, 1, 0, 20}, {0, 0, 2, 30}};
    std::memcpy(file.data() + 280, rows, sizeof rows);
    const std::int16_t code = 1;
    std::memcpy(file.data() + 254, &code, 2);
    writeFile(folder / "a.nii", file);
    const auto result = decodeVolume(folder / "a.nii");
    EXPECT_EQ(result.notices.size(), 1U);
    const auto& m = result.volume.geometry.worldFromVoxel; // LPS: the first two rows change sign
    EXPECT_EQ(glm::dvec3(m[2]), glm::dvec3(-0.5, 0, 2));
    EXPECT_EQ(glm::dvec3(m[3]), glm::dvec3(-10, -20, 30));
}

} // namespace
} // namespace vs::volume
