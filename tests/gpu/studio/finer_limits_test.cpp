// SPDX-License-Identifier: Apache-2.0
// Segments of the finest level cut and spare what they would in a scan that is worked on at that level.
#include "gpu/gl_test.h"
#include "gpu/studio/head_in_bricks.h"
#include "gpu/studio/test_segments.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace vs::studio {
namespace {

using FinerLimitsTest = test::GlTest;
using Treatment = SegmentInfo::Treatment;

// A ball, and a bent sheet beside it that is thinner than a voxel of the level that is worked on. The grid
// does not divide evenly.
volume::Volume ballAndSheet() {
    return phantom::makePhantom({75, 62, 51}, volume::ScalarType::UInt8, [](glm::dvec3 p) {
        const double fromBall = glm::length(p - glm::dvec3(30.3, 30.8, 24.1));
        const double fromAxis = glm::length(glm::dvec2(p) - glm::dvec2(30.3, 30.8));
        const bool isSheet = fromAxis >= 17.2 && fromAxis <= 18.9 && p.z >= 8 && p.z <= 40;
        return fromBall <= 14.3 ? 100 : isSheet ? 200 : 10;
    });
}

// Both have grown in a scan of which all is there, and in bricks of a level below.
class BallAndSheet {
public:
    explicit BallAndSheet(Treatment ofSheet = Treatment::Take) : whole_(ballAndSheet()) {
        whole_.showView(testCanvas({50, 255}).view);
        inBricks_.document->showView(testCanvas({50, 255}).view);
        seed({90, 110}, {30, 30, 24});
        UseSegment sheet{"Sheet"};
        apply(sheet);
        seed({150, 255}, {48, 31, 24});
        sheet.treatment = ofSheet;
        apply(sheet);
    }

    void apply(const Operation& operation) {
        whole_.apply(operation);
        inBricks_.document->apply(operation);
    }
    void workOn(const std::string& name) { apply(UseSegment{name}); }
    Document& whole() { return whole_; }
    Document& inBricks() { return *inBricks_.document; }
    [[nodiscard]] std::vector<float> wanted() const { return sculptureOf(whole_); }
    [[nodiscard]] std::vector<float> cuts() const { return inBricks_.cuts(); }
    [[nodiscard]] std::vector<std::uint8_t> labels() const { return inBricks_.labels(); }

    // Memberships are rounded to 8 bits, by one at the most otherwise than on the device.
    void expectSame(const std::string& what) const {
        const auto a = wanted();
        const auto b = cuts();
        ASSERT_EQ(a.size(), b.size());
        float most = 0;
        std::size_t otherwise = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            most = std::max(most, std::abs(a[i] - b[i]));
            otherwise += (a[i] >= 0.5F) != (b[i] >= 0.5F) ? 1 : 0;
        }
        EXPECT_LT(most, 1.1 / 255) << what;
        EXPECT_EQ(otherwise, 0U) << what;
    }

private:
    void seed(Range range, glm::ivec3 voxel) {
        Seed seed;
        seed.range = range;
        seed.canvas = testCanvas({50, 255});
        Seed finest = seed;
        seed.voxels = {voxel};
        finest.finest = {voxel};
        whole_.apply(seed);
        inBricks_.document->apply(finest);
        apply(Grow{});
    }

    Document whole_;
    InBricks inBricks_{16, 400, ballAndSheet()};
};

// Voxels of a segment that are cut.
std::size_t cutOf(const BallAndSheet& both, std::uint8_t label) {
    const auto values = both.cuts();
    const auto labels = both.labels();
    std::size_t cut = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        cut += labels[i] == label && values[i] >= 0.5F ? 1 : 0;
    }
    return cut;
}

TEST_F(FinerLimitsTest, CuttingBySegmentsIsThatOfTheFinestLevel) {
    BallAndSheet both;
    const auto labels = both.labels();
    ASSERT_GT(std::count(labels.begin(), labels.end(), 2), 3000);
    for (const char* segment : {kFirstSegment, "Sheet"}) {
        both.workOn(segment);
        const auto before = both.cuts();
        for (const double margin : {0.0, 2.6, -0.6}) {
            for (const bool keeps : {false, true}) {
                const std::string what =
                    std::string(segment) + " " + std::to_string(margin) + (keeps ? " kept" : "");
                const std::uint64_t content = both.inBricks().sculpture().contentVersion();
                both.apply(CutSegment{keeps, margin});
                both.expectSame(what);
                const auto after = both.cuts();
                EXPECT_NE(before, after) << what;
                const sculpt::FineSculpture& finer = *both.inBricks().sculpture().finer();
                auto derived = finer.sceneValues({glm::ivec3(0), both.inBricks().sculpture().dims()});
                sculpt::roundTo(sculpt::Precision::Bits16, derived);
                EXPECT_EQ(derived, sculptureOf(both.inBricks())) << what;
                both.apply(Undo{});
                EXPECT_EQ(before, both.cuts()) << what;
                EXPECT_EQ(content, both.inBricks().sculpture().contentVersion()) << what;
                both.apply(Redo{});
                EXPECT_EQ(after, both.cuts()) << what;
                both.apply(Undo{});
            }
        }
    }
}

TEST_F(FinerLimitsTest, CuttingBySegmentsSparesOthersAndTakesThemAlone) {
    for (const Treatment treatment : {Treatment::Spare, Treatment::TakeOnly}) {
        BallAndSheet both(treatment);
        both.workOn(kFirstSegment);
        const std::string what = SegmentInfo::kTreatments[std::size_t(treatment)];
        for (const bool keeps : {false, true}) {
            both.apply(CutSegment{keeps, 5});
            both.expectSame(what + (keeps ? " kept" : ""));
            both.apply(Undo{});
        }
        both.apply(CutSegment{false, 5});
        EXPECT_EQ(cutOf(both, 2) > 0, treatment == Treatment::TakeOnly) << what;
        EXPECT_EQ(cutOf(both, 1) > 0, treatment == Treatment::Spare) << what;
    }
}

// A solid that is wide enough to cut whole bricks, and a half space.
TEST_F(FinerLimitsTest, ToolsSpareFinestVoxels) {
    for (const Treatment treatment : {Treatment::Spare, Treatment::TakeOnly}) {
        BallAndSheet both(treatment);
        const std::string what = SegmentInfo::kTreatments[std::size_t(treatment)];
        Clip clip;
        const glm::dmat4& worldFromVoxel = both.whole().volume().geometry.worldFromVoxel;
        clip.planes = {{glm::dvec3(worldFromVoxel * glm::dvec4(44.4, 31, 24, 1)),
                        glm::normalize(glm::dvec3(-0.9, 0.3, 0.2))}};
        both.apply(clip);
        const auto wanted = both.wanted();
        const auto cuts = both.cuts();
        std::size_t large = 0;
        std::size_t cut = 0;
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            large += std::abs(wanted[i] - cuts[i]) > 0.05F ? 1 : 0;
            cut += wanted[i] >= 0.5F ? 1 : 0;
        }
        EXPECT_GT(cut, 500U) << what;
        EXPECT_LT(double(large), 0.01 * double(cut)) << what;
        EXPECT_EQ(cutOf(both, 2) > 0, treatment == Treatment::TakeOnly) << what;
        EXPECT_EQ(cutOf(both, 1) > 0, treatment == Treatment::Spare) << what;
    }
}

TEST_F(FinerLimitsTest, KeepConnectedSparesFinestVoxels) {
    BallAndSheet both(Treatment::Spare);
    KeepConnected keep;
    keep.canvas = testCanvas({90, 255}); // at the level that is worked on both would be one otherwise
    keep.voxel = glm::ivec3(15, 15, 12); // in the ball
    both.inBricks().apply(keep);
    EXPECT_EQ(cutOf(both, 2), 0U);
    UseSegment sheet{"Sheet"};
    sheet.treatment = Treatment::Take;
    both.inBricks().apply(sheet);
    both.inBricks().apply(keep);
    EXPECT_GT(cutOf(both, 2), 1000U);
}

} // namespace
} // namespace vs::studio
