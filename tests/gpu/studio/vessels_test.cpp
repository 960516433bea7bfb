// SPDX-License-Identifier: Apache-2.0
// Vessels are measured along segments that were grown in them: lengths, diameters, where they are narrow.
#include "base/error.h"
#include "gpu/gl_test.h"
#include "image/compare.h"
#include "phantom/phantom.h"
#include "studio/document/document.h"
#include "studio/document/document_facts.h"
#include "studio/json/operation_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vs::studio {
namespace {

class VesselsTest : public test::GlTest {};

constexpr double kBendMm = 40; // radius of the bend
constexpr double kTubeMm = 5;  // radius of the tube

// A tube bent by a quarter of a turn about the grid's first corner, in the plane z = 20 mm; half as wide
// where it is narrow. At its wall values change over a step, on thick slices too, which are as thin as steps.
volume::Volume bentTube(glm::dvec3 spacing, bool isNarrow) {
    const glm::ivec3 dims(glm::ceil(glm::dvec3(56, 56, 40) / spacing));
    const double step = std::min({spacing.x, spacing.y, spacing.z});
    return phantom::makePhantom(
        dims, volume::ScalarType::UInt8,
        [=](glm::dvec3 voxel) {
            const glm::dvec3 mm = voxel * spacing;
            const double along = kBendMm * std::atan2(mm.y, mm.x);
            const double away = std::hypot(std::hypot(mm.x, mm.y) - kBendMm, mm.z - 20);
            const double narrow = isNarrow ? 0.5 * std::exp(-std::pow((along - 30) / 4, 2)) : 0;
            return 200 * std::clamp(0.5 + (kTubeMm * (1 - narrow) - away) / step, 0.0, 1.0);
        },
        spacing);
}

glm::dvec3 voxelAt(double radians, glm::dvec3 spacing) {
    return glm::dvec3(kBendMm * std::cos(radians), kBendMm * std::sin(radians), 20) / spacing;
}

// Where the axis is nearest to the voxel that is clicked there.
double angleAt(double radians, glm::dvec3 spacing) {
    const glm::dvec3 mm = glm::round(voxelAt(radians, spacing)) * spacing;
    return std::atan2(mm.y, mm.x);
}

// The tube as a segment, and a radian of it measured.
std::unique_ptr<Document> measuredTube(glm::dvec3 spacing, bool isNarrow) {
    auto document = std::make_unique<Document>(bentTube(spacing, isNarrow));
    Seed seed;
    seed.voxels = {glm::ivec3(glm::round(voxelAt(0.4, spacing)))};
    seed.range = Range{100, 255};
    document->apply(seed);
    document->apply(Grow{});
    document->apply(Measure{Measure::Kind::Vessel, {voxelAt(0.3, spacing), voxelAt(1.3, spacing)}});
    return document;
}

TEST_F(VesselsTest, HaveTheLengthAndTheDiametersOfTheTube) {
    for (const glm::dvec3 spacing :
         {glm::dvec3(1), glm::dvec3(1, 1, 3), glm::dvec3(0.6, 0.8, 0.7), glm::dvec3(0.5, 0.5, 1.5)}) {
        const auto document = measuredTube(spacing, false);
        const Measured& vessel = document->facts()->measured->front();
        const double step = std::min({spacing.x, spacing.y, spacing.z});
        const double length = kBendMm * (angleAt(1.3, spacing) - angleAt(0.3, spacing));
        EXPECT_NEAR(vessel.value, length, 0.2 * step) << spacing.z;
        for (std::size_t n = 0; n < vessel.diametersMm.size(); ++n) {
            EXPECT_NEAR(vessel.diametersMm[n], 2 * kTubeMm, 0.2 * step) << vessel.alongMm[n];
        }
        const double mean = std::accumulate(vessel.diametersMm.begin(), vessel.diametersMm.end(), 0.0) /
                            double(vessel.diametersMm.size());
        EXPECT_NEAR(mean, 2 * kTubeMm, 0.02 * kTubeMm) << "1 % of the diameter";
        EXPECT_FALSE(vessel.isNarrowed());
        EXPECT_EQ(vessel.measure.segment, "Segment 1");
    }
}

TEST_F(VesselsTest, AreNarrowWhereTheyAre) {
    const auto document = measuredTube(glm::dvec3(1), true);
    const Measured& vessel = document->facts()->measured->front();
    ASSERT_TRUE(vessel.isNarrowed());
    EXPECT_NEAR(vessel.narrowest->stenosisPercent, 50, 3);
    EXPECT_NEAR(vessel.narrowest->referenceDiameterMm, 2 * kTubeMm, 0.2);
    EXPECT_NEAR(vessel.alongMm[vessel.narrowest->index], 30 - 0.3 * kBendMm, 1);
    EXPECT_NE(vesselsCsvOf(*document->facts()->measured).find("0,Segment 1,"), std::string::npos);
}

TEST_F(VesselsTest, AreUndoneSavedAndStayWhatWasMeasured) {
    const auto document = measuredTube(glm::dvec3(1), true);
    const Measure made = document->facts()->measurements->front();
    document->apply(Undo{});
    EXPECT_TRUE(document->facts()->measurements->empty());
    document->apply(Redo{});
    EXPECT_EQ(document->facts()->measurements->front(), made);
    Document replayed(bentTube(glm::dvec3(1), true));
    for (const Operation& operation : document->log()) {
        replayed.apply(operationFromJson(toJson(operation), "log"));
    }
    EXPECT_EQ(replayed.facts()->measurements->front(), made);
    // The segment is emptied: what was measured is still what it was.
    document->apply(ReSeed{});
    EXPECT_EQ(document->facts()->measurements->front(), made);
}

TEST_F(VesselsTest, AreRefusedWhereThereIsNone) {
    const auto document = measuredTube(glm::dvec3(1), false);
    const auto refused = [&](const Measure& measure, const std::string& wanted) {
        try {
            document->apply(measure);
            ADD_FAILURE() << "not refused: " << wanted;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << error.what();
        }
        EXPECT_EQ(document->facts()->measurements->size(), 1U);
    };
    refused({Measure::Kind::Vessel, {{2, 2, 2}, voxelAt(1, glm::dvec3(1))}}, "vessel");
    refused({Measure::Kind::Vessel, {{2, 2, 2}}}, "two points");
    Measure other{Measure::Kind::Vessel, {voxelAt(0.5, glm::dvec3(1)), voxelAt(1, glm::dvec3(1))}};
    other.segment = "nobody";
    refused(other, "nobody");
}

} // namespace
} // namespace vs::studio
