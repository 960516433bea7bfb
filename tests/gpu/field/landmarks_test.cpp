// SPDX-License-Identifier: Apache-2.0
// The peaks of a scan that presets are fastened to: on heads whose tissues are known, at all noises, scales
// and resolutions, and on real scans.
#include "field/landmarks.h"

#include "gpu/gl_test.h"
#include "phantom/head_anatomy.h"
#include "phantom/head_phantom.h"
#include "phantom/phantom.h"
#include "test_data.h"
#include "volume/reading/read_volume.h"

#include <filesystem>
#include <random>

namespace vs::field {
namespace {

Landmarks landmarksOf(const volume::Volume& volume) { return findLandmarks(uploadVolume(volume)); }

class LandmarksTest : public test::GlTest {
protected:
    static volume::Volume head(double noisePercent, double biasPercent, glm::ivec3 dims = {91, 109, 91}) {
        return phantom::makeHeadPhantom({dims, noisePercent, biasPercent, 3}).volume;
    }
};

// Peaks are broadened and drawn together by voxels on borders and by noise: a fifth of what parts grey from
// white, and as much as noise moves them.
TEST_F(LandmarksTest, AreTheMatterOfAHead) {
    for (const double noise : {0.0, 1.0, 3.0, 5.0}) {
        for (const double bias : {0.0, 20.0}) {
            const Landmarks found = landmarksOf(head(noise, bias));
            const double apart = phantom::t1::white - phantom::t1::grey;
            const double tolerance = 0.25 * apart + 0.02 * noise * phantom::t1::white;
            EXPECT_LT(found.air, 0.05 * phantom::t1::white + 0.02 * noise * phantom::t1::white);
            EXPECT_NEAR(found.brighter, phantom::t1::white, tolerance) << noise << ", bias " << bias;
            EXPECT_NEAR(found.darker, phantom::t1::grey, tolerance) << noise << ", bias " << bias;
            EXPECT_LT(found.air, found.tissue);
            EXPECT_LT(found.tissue, found.darker);
            EXPECT_LT(found.darker, found.brighter);
            EXPECT_LT(found.brighter, found.top);
        }
    }
}

// The same scan in other numbers, or of other resolution, has its landmarks in the same places.
TEST_F(LandmarksTest, FollowTheScale) {
    const auto plain = head(3, 0);
    const Landmarks expected = landmarksOf(plain);
    for (const auto& [times, plus] : {std::pair{1.0, 0.0}, {7.0, 0.0}, {3.0, -500.0}, {100.0, 1000.0}}) {
        const auto scaled = phantom::makePhantom(
            plain.geometry.dims, volume::ScalarType::Int16,
            [&, times = times, plus = plus](glm::dvec3 p) { return plus + times * plain.at(glm::ivec3(p)); });
        const Landmarks found = landmarksOf(scaled);
        const double step = times * 2; // two of the values that the scan has
        EXPECT_NEAR(found.air, plus + times * expected.air, step) << times;
        EXPECT_NEAR(found.tissue, plus + times * expected.tissue, step) << times;
        EXPECT_NEAR(found.darker, plus + times * expected.darker, step) << times;
        EXPECT_NEAR(found.brighter, plus + times * expected.brighter, step) << times;
        EXPECT_NEAR(found.top, plus + times * expected.top, step) << times;
    }
}

TEST_F(LandmarksTest, AscendWhateverTheVoxelsAre) {
    std::mt19937 random(8);
    std::uniform_int_distribution<int> any(-3000, 3000);
    for (int n = 0; n < 60; ++n) {
        const std::vector<int> values{any(random), any(random), any(random), any(random)};
        std::uniform_int_distribution<int> which(0, n % 7);
        const auto volume =
            phantom::makePhantom(glm::ivec3(1 + n % 9, 1 + n % 5, 1 + n % 11), volume::ScalarType::Int16,
                                 [&](glm::dvec3) { return values[std::size_t(std::min(which(random), 3))]; });
        const Landmarks found = landmarksOf(volume);
        EXPECT_LE(found.air, found.tissue) << n;
        EXPECT_LE(found.tissue, found.darker) << n;
        EXPECT_LE(found.darker, found.brighter) << n;
        EXPECT_LE(found.brighter, found.top) << n;
        EXPECT_TRUE(std::isfinite(found.top)) << n;
    }
}

// Air at -1000 HU, fat, muscle and bone, in the numbers that scanners and their prepared scans have.
volume::Volume body(double valueOfAir, double perHu, double least, volume::ScalarType type) {
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0, 12);
    return phantom::makePhantom({64, 64, 64}, type, [&](glm::dvec3 p) {
        const double r = glm::distance(p, glm::dvec3(31.5));
        const double hu = r < 6 ? 700 : r < 20 ? 40 : r < 24 ? -100 : -1000;
        return std::max(least, valueOfAir + perHu * (hu + 1000 + noise(random)));
    });
}

TEST_F(LandmarksTest, HounsfieldUnitsAreToldWhateverAScansNumbersAre) {
    using volume::ScalarType;
    struct Case {
        const char* name;
        double air;
        double perHu;
        double least;
        ScalarType type;
        Range expected;
    };
    for (const Case& c : {Case{"as they are", -1000, 1, -1100, ScalarType::Int16, {-1000, 0}},
                          Case{"moved up", 24, 1, 0, ScalarType::Int16, {24, 1024}},
                          Case{"eight bits", 10, 0.06, 0, ScalarType::UInt8, {10, 70}},
                          Case{"without air", -1000, 1, 0, ScalarType::Int16, {-1000, 0}}}) {
        const auto volume = body(c.air, c.perHu, c.least, c.type);
        const Range found = findAirAndWater(landmarksOf(volume), volume.range);
        EXPECT_NEAR(found.lo, c.expected.lo, 25 * c.perHu) << c.name;
        EXPECT_NEAR(found.hi, c.expected.hi, 25 * c.perHu) << c.name;
    }
}

struct RealScan {
    const char* file;
    Range darker;
    Range brighter;
};

// Grey and white matter as the scans' own label maps and histograms have them, fat and muscle of a CT.
TEST_F(LandmarksTest, AreFoundInScansOfPeople) {
    const auto folder = test::dataFolder();
    int missing = 0;
    for (const RealScan& scan : {RealScan{"colin27_t1_head.nii.gz", {70, 95}, {100, 118}},
                                 RealScan{"colin27_t1_brain.nii.gz", {70, 95}, {100, 118}},
                                 RealScan{"mri_head_t1_256.nii.gz", {85, 108}, {118, 138}},
                                 RealScan{"ct_chest_512.nrrd", {-140, -60}, {20, 80}}}) {
        if (!std::filesystem::exists(folder / scan.file)) {
            ++missing;
            continue;
        }
        const Landmarks found = landmarksOf(volume::readVolume(folder / scan.file).volume);
        EXPECT_TRUE(scan.darker.contains(found.darker)) << scan.file << ' ' << found.darker;
        EXPECT_TRUE(scan.brighter.contains(found.brighter)) << scan.file << ' ' << found.brighter;
    }
    if (missing > 0) {
        GTEST_SKIP() << missing << " scans are not in " << folder;
    }
}

} // namespace
} // namespace vs::field
