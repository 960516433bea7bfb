// SPDX-License-Identifier: Apache-2.0
// DICOM series of real scanners: every slice must lie where its own header puts it.
#include "base/error.h"
#include "volume/io/decode.h"

#include "test_files.h"

#include <itkGDCMImageIO.h>
#include <itkGDCMSeriesFileNames.h>
#include <itkImageSeriesReader.h>

#include <cmath>
#include <cstring>
#include <optional>

namespace vs::volume {
namespace {

using Slice = itk::Image<double, 3>;

std::vector<Slice::Pointer> readSlices(const std::filesystem::path& folder) {
    std::vector<Slice::Pointer> slices;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const auto reader = itk::ImageFileReader<Slice>::New();
        reader->SetImageIO(itk::GDCMImageIO::New());
        reader->SetFileName(entry.path().string());
        reader->Update();
        slices.push_back(reader->GetOutput());
    }
    return slices;
}

// Linear between voxels; nothing outside.
std::optional<double> sample(const Volume& volume, glm::dvec3 voxel) {
    const glm::ivec3 dims = volume.geometry.dims;
    for (int axis = 0; axis < 3; ++axis) {
        voxel[axis] =
            std::abs(voxel[axis] - std::round(voxel[axis])) < 1e-3 ? std::round(voxel[axis]) : voxel[axis];
        if (voxel[axis] < 0 || voxel[axis] > dims[axis] - 1) {
            return std::nullopt;
        }
    }
    const glm::ivec3 low(glm::floor(voxel));
    const glm::dvec3 part = voxel - glm::dvec3(low);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        glm::ivec3 at = low;
        for (int axis = 0; axis < 3; ++axis) {
            const int high = (corner >> axis) & 1;
            weight *= high != 0 ? part[axis] : 1 - part[axis];
            at[axis] += high;
        }
        sum += weight > 0 ? weight * volume.at(at) : 0.0;
    }
    return sum;
}

struct Difference {
    double meanAbsolute = 0;
    double largest = 0;
    std::size_t count = 0;
};

// Between a source slice and the volume, looked up where the slice's header puts each pixel, moved by
// `shiftVoxels`.
Difference compare(const Volume& volume, const Slice& slice, glm::dvec3 shiftVoxels) {
    Difference difference;
    const auto voxelFromWorld = volume.geometry.voxelFromWorld();
    const auto size = slice.GetLargestPossibleRegion().GetSize();
    for (itk::IndexValueType y = 0; y < itk::IndexValueType(size[1]); y += 3) {
        for (itk::IndexValueType x = 0; x < itk::IndexValueType(size[0]); x += 3) {
            const Slice::IndexType index{{x, y, 0}};
            Slice::PointType point;
            slice.TransformIndexToPhysicalPoint(index, point);
            const glm::dvec3 voxel(voxelFromWorld * glm::dvec4(point[0], point[1], point[2], 1));
            if (const auto value = sample(volume, voxel + shiftVoxels)) {
                const double off = std::abs(*value - slice.GetPixel(index));
                difference.meanAbsolute += off;
                difference.largest = std::max(difference.largest, off);
                ++difference.count;
            }
        }
    }
    difference.meanAbsolute /= double(std::max<std::size_t>(difference.count, 1));
    return difference;
}

// The volume agrees with each slice best where the header puts it: half a voxel off along any axis is worse.
void expectSlicesInPlace(const Volume& volume, const std::vector<Slice::Pointer>& slices, double tolerance) {
    ASSERT_GT(slices.size(), 1U);
    for (const auto& slice : slices) {
        const auto here = compare(volume, *slice, glm::dvec3(0));
        const auto size = slice->GetLargestPossibleRegion().GetSize();
        const std::size_t compared = (size[0] + 2) / 3 * ((size[1] + 2) / 3);
        EXPECT_GE(here.count, std::size_t(0.99 * double(compared))) << "not covered";
        EXPECT_LE(here.meanAbsolute, tolerance) << "slice at " << slice->GetOrigin();
        for (int axis = 0; axis < 3; ++axis) {
            for (const double step : {-0.5, 0.5}) {
                glm::dvec3 shift(0);
                shift[axis] = step;
                const auto there = compare(volume, *slice, shift);
                EXPECT_TRUE(there.count == 0 || here.meanAbsolute <= there.meanAbsolute)
                    << "slice at " << slice->GetOrigin() << " fits better " << step << " voxels along axis "
                    << axis;
            }
        }
    }
}

class DicomData : public testing::Test {
protected:
    void SetUp() override {
        if (data_.empty()) {
            GTEST_SKIP() << "no test data: set VOLUME_STUDIO_TEST_DATA";
        }
    }

    // Unpacks an archive of one folder and returns that folder.
    std::filesystem::path unpack(const std::string& name) {
        const auto command = fmt::format("tar xzf '{}' -C '{}'", (data_ / (name + ".tar.gz")).string(),
                                         folder_.path().string());
        EXPECT_EQ(std::system(command.c_str()), 0);
        return folder_ / name;
    }

    std::filesystem::path data_ = testData();
    TemporaryFolder folder_;
};

TEST_F(DicomData, MissingSlicesKeepTheirNeighboursInPlace) {
    const auto folder = data_ / "bad" / "dicomdir_missing_slice";
    const auto result = decodeVolume(folder);
    EXPECT_EQ(result.notices.size(), 1U);
    EXPECT_EQ(result.volume.geometry.dims, glm::ivec3(64, 64, 7));
    EXPECT_EQ(result.volume.type, ScalarType::Int16);
    expectSlicesInPlace(result.volume, readSlices(folder), 1e-6); // the grid meets every slice: equal values
}

TEST_F(DicomData, UnevenSlicesStayInPlace) {
    const auto folder = data_ / "bad" / "dicomdir_uneven_spacing";
    const auto result = decodeVolume(folder);
    EXPECT_EQ(result.notices.size(), 1U);
    expectSlicesInPlace(result.volume, readSlices(folder), 1e-6); // 0.4 mm divides all distances
}

TEST_F(DicomData, TiltedGantryIsStraightened) {
    const auto folder = unpack("dicom_ct_tilt_ge");
    const auto result = decodeVolume(folder);
    ASSERT_EQ(result.notices.size(), 1U);
    EXPECT_NE(result.notices[0].find("tilted by 18.5 degrees"), std::string::npos) << result.notices[0];
    const glm::dmat3 axes(result.volume.geometry.worldFromVoxel);
    EXPECT_NEAR(glm::dot(glm::normalize(axes[1]), glm::normalize(axes[2])), 0, 1e-9);
    EXPECT_NEAR(glm::dot(glm::normalize(axes[0]), glm::normalize(axes[2])), 0, 1e-9);
    // Interpolated twice, so edges soften; the mean over a slice with air, skin and bone stays small.
    expectSlicesInPlace(result.volume, readSlices(folder), 20);
}

TEST_F(DicomData, SlopesOfEachSliceAreHonoured) {
    const auto folder = data_ / "bad" / "dicomdir_slope_per_slice";
    const auto result = decodeVolume(folder);
    EXPECT_EQ(result.notices.size(), 1U);
    for (const auto& slice : readSlices(folder)) {
        EXPECT_LT(compare(result.volume, *slice, glm::dvec3(0)).largest, 1e-3);
    }
}

TEST_F(DicomData, RegularSeriesEqualsItksReader) {
    const auto unpacked = unpack("dicom_t1_7t");
    for (const auto& folder : {data_ / "dicom_ct_j2k", unpacked}) {
        const auto result = decodeVolume(folder);
        EXPECT_TRUE(result.notices.empty());
        EXPECT_EQ(result.volume.unit, folder == unpacked ? "" : "HU");
        EXPECT_EQ(result.volume.details.modality, folder == unpacked ? "MR" : "CT");
        EXPECT_FALSE(result.volume.details.isAngiography);
        const auto names = itk::GDCMSeriesFileNames::New();
        names->SetDirectory(folder.string());
        const auto reader = itk::ImageSeriesReader<itk::Image<std::int16_t, 3>>::New();
        reader->SetImageIO(itk::GDCMImageIO::New());
        reader->SetFileNames(names->GetInputFileNames());
        reader->Update();
        const auto* image = reader->GetOutput();
        const auto& grid = result.volume.geometry;
        for (unsigned axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(std::size_t(grid.dims[int(axis)]), image->GetLargestPossibleRegion().GetSize()[axis]);
        }
        ASSERT_EQ(result.volume.type, ScalarType::Int16);
        EXPECT_EQ(
            std::memcmp(result.volume.bytes.data(), image->GetBufferPointer(), result.volume.bytes.size()),
            0);
        for (const glm::ivec3 corner : {glm::ivec3(0), grid.dims - 1}) {
            itk::Image<std::int16_t, 3>::PointType point;
            image->TransformIndexToPhysicalPoint({{corner.x, corner.y, corner.z}}, point);
            const glm::dvec3 ours(grid.worldFromVoxel * glm::dvec4(corner, 1));
            EXPECT_NEAR(glm::length(ours - glm::dvec3(point[0], point[1], point[2])), 0, 0.02);
        }
    }
}

TEST_F(DicomData, OneFileStandsForItsSeries) {
    const auto folder = data_ / "bad" / "good_dicomdir";
    EXPECT_EQ(decodeVolume(folder / "s03.dcm").volume.bytes, decodeVolume(folder).volume.bytes);
}

TEST_F(DicomData, SeriesArePickedByNumberOrIdentifier) {
    const auto folder = data_ / "bad" / "dicomdir_two_series";
    std::string message;
    std::vector<SeriesChoice> choices;
    try {
        decodeVolume(folder);
    } catch (const SeveralSeries& error) {
        message = error.what();
        choices = error.choices();
    }
    EXPECT_NE(message.find("--series"), std::string::npos);
    ASSERT_EQ(choices.size(), 2U);
    EXPECT_EQ(choices[1].uid, "1.3.6.1.4.1.5962.1.3.4.1.20040826185059.5457.9");
    EXPECT_EQ(choices[1].images, 3);
    EXPECT_FALSE(choices[1].modality.empty());
    EXPECT_GT(choices[1].size.x, 0);
    ReadOptions options;
    options.series = "2";
    const auto byNumber = decodeVolume(folder, options).volume;
    EXPECT_EQ(byNumber.geometry.dims.z, 3);
    options.series = "1.3.6.1.4.1.5962.1.3.4.1.20040826185059.5457.9";
    EXPECT_EQ(decodeVolume(folder, options).volume.bytes, byNumber.bytes);
    options.series = "3";
    EXPECT_THROW(decodeVolume(folder, options), ReadError);
}

TEST_F(DicomData, EncodingsOfOneImageAgree) {
    const auto folder = data_ / "dicom_odd" / "single";
    const auto plain = decodeVolume(folder / "MR_small.dcm").volume;
    for (const char* name : {"MR_small_RLE.dcm", "MR_small_bigendian.dcm", "MR_small_implicit.dcm",
                             "MR_small_jp2klossless.dcm"}) {
        const auto other = decodeVolume(folder / name).volume;
        EXPECT_EQ(other.bytes, plain.bytes) << name;
        EXPECT_EQ(other.geometry, plain.geometry) << name;
    }
    EXPECT_EQ(decodeVolume(data_ / "dicom_odd" / "rle").volume.bytes,
              decodeVolume(data_ / "dicom_odd" / "jpeg2000_lossless").volume.bytes);
}

} // namespace
} // namespace vs::volume
