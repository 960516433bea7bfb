// SPDX-License-Identifier: Apache-2.0
// Measurements are operations: undone and redone, saved, corrected with the grid, drawn on pictures.
#include "gpu/gl_test.h"
#include "gpu/studio/test_head.h"
#include "gpu/studio/test_segments.h"
#include "gpu/studio/test_tools.h"
#include "image/compare.h"
#include "studio/document/document_facts.h"
#include "studio/editing/measurement_marks.h"
#include "studio/json/operation_json.h"

#include <nlohmann/json.hpp>

namespace vs::studio {
namespace {

using Kind = Measure::Kind;

class MeasurementsTest : public test::GlTest {};

std::vector<double> valuesOf(const Document& document) {
    std::vector<double> values;
    for (const Measured& measured : *document.facts()->measured) {
        values.push_back(measured.value);
    }
    return values;
}

std::vector<Measure> someMeasurements() {
    return {{Kind::Distance, {{10, 20, 30}, {13, 24, 30}}, {}},
            {Kind::Angle, {{10, 0, 0}, {0, 0, 0}, {0, 0, 10}}, {}},
            {Kind::Path, {{0, 0, 0}, {0, 0, 10}, {0, 5, 10}}, {}},
            {Kind::Area, {{30, 35, 29}, {40, 35, 29}, {40, 45, 29}, {30, 45, 29}}, {}}};
}

TEST_F(MeasurementsTest, AreWhatTheScanSaysUndoneRedoneAndRemoved) {
    Document document(test::testHead()); // voxels of 1 x 1 x 1.2 mm
    for (Measure measure : someMeasurements()) {
        document.apply(measure);
    }
    const std::vector<double> all{5, 90, 17, 100};
    const auto expectAre = [&](const std::vector<double>& expected) {
        const auto values = valuesOf(document);
        ASSERT_EQ(values.size(), expected.size());
        for (std::size_t n = 0; n < values.size(); ++n) {
            EXPECT_NEAR(values[n], expected[n], 1e-9);
        }
    };
    expectAre(all);
    const auto& under = document.facts()->measured->back().under;
    EXPECT_EQ(under.voxels, 100U);
    EXPECT_EQ(under.mean, 40) << "the dark core";
    EXPECT_EQ(under.deviation, 0);
    document.apply(RemoveMeasurement{1});
    expectAre({5, 17, 100});
    document.apply(Undo{});
    expectAre(all);
    document.apply(RemoveMeasurement{});
    expectAre({});
    EXPECT_THROW(document.apply(RemoveMeasurement{}), Error);
    EXPECT_THROW(document.apply(RemoveMeasurement{0}), Error);
    document.apply(Undo{});
    for (std::size_t left = all.size(); left > 0; --left) {
        document.apply(Undo{});
        expectAre({all.begin(), all.begin() + std::ptrdiff_t(left) - 1});
    }
    for (std::size_t n = 0; n < all.size(); ++n) {
        document.apply(Redo{});
    }
    expectAre(all);
    // What the log says, read again from its text, comes to the same.
    Document again(test::testHead());
    for (const Operation& operation : document.log()) {
        again.apply(operationFromJson(nlohmann::ordered_json::parse(toJson(operation).dump()), "test"));
    }
    EXPECT_EQ(valuesOf(again), valuesOf(document));
}

TEST_F(MeasurementsTest, StayOnTheirVoxelsWhenTheGridIsCorrected) {
    Document document(test::testHead());
    for (Measure measure : someMeasurements()) {
        document.apply(measure);
    }
    document.apply(CorrectGeometry{.spacing = glm::dvec3(2, 2, 3), .orientation = "RAS"});
    const auto values = valuesOf(document);
    EXPECT_NEAR(values.at(0), 10, 1e-9);
    EXPECT_NEAR(values.at(1), 90, 1e-9);
    EXPECT_NEAR(values.at(2), 40, 1e-9);
    EXPECT_NEAR(values.at(3), 400, 1e-9);
    document.apply(Undo{});
    EXPECT_NEAR(valuesOf(document).at(3), 100, 1e-9);
}

TEST_F(MeasurementsTest, FactsShareWhatHasNotChanged) {
    Document document(test::testHead());
    document.apply(Measure(someMeasurements().front()));
    const auto before = document.facts()->measured;
    document.apply(Note{"nothing to do with it"});
    EXPECT_EQ(document.facts()->measured, before);
}

TEST_F(MeasurementsTest, ACutIsMeasuredAsItIsThen) {
    Head document;
    EXPECT_THROW(document.apply(Measure{Kind::Cut, {}, {}}), Error) << "nothing is cut";
    document.apply(scissorsAt(170, 130, 15));
    const auto sculpture = sculptureOf(document);
    const auto voxels = std::count_if(sculpture.begin(), sculpture.end(), [](float v) { return v >= 0.5F; });
    document.apply(Measure{Kind::Cut, {}, 77.0}); // what is said is not believed
    const double millilitres = double(voxels) * document.volume().geometry.voxelMm3() / 1000;
    EXPECT_GT(voxels, 100);
    EXPECT_DOUBLE_EQ(valuesOf(document).at(0), millilitres);
    document.apply(UnCut{});
    EXPECT_DOUBLE_EQ(valuesOf(document).at(0), millilitres) << "as it was";
    document.apply(CorrectGeometry{.spacing = glm::dvec3(2, 2, 2.4)});
    EXPECT_DOUBLE_EQ(valuesOf(document).at(0), 8 * millilitres);
}

TEST_F(MeasurementsTest, WhatMakesNoSenseIsRefusedAndLeavesNothing) {
    Document document(test::testHead());
    const auto refuse = [&](Measure measure, const std::string& mentions) {
        try {
            document.apply(measure);
            ADD_FAILURE() << mentions;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(mentions), std::string::npos) << error.what();
        }
    };
    refuse({Kind::Distance, {{1, 2, 3}}, {}}, "two points");
    refuse({Kind::Angle, {{1, 2, 3}, {4, 5, 6}}, {}}, "three points");
    refuse({Kind::Path, {{1, 2, 3}}, {}}, "two points");
    refuse({Kind::Area, {{1, 2, 3}, {4, 5, 6}}, {}}, "three points");
    refuse({Kind::Area, {{1, 2, 3}, {4, 5, 6}, {7, 7, 7}}, {}}, "one slice");
    refuse({Kind::Cut, {{1, 2, 3}}, {}}, "without points");
    refuse({Kind::Distance, {{1, 2, 3}, {1, 2, 3}}, {}}, "upon one another");
    EXPECT_TRUE(valuesOf(document).empty());
    EXPECT_FALSE(document.facts()->canUndo());
}

TEST_F(MeasurementsTest, LabelsHaveTheDigitsThatFitTheGrid) {
    const auto labelAt = [](double spacing, const Measure& measure) {
        volume::Volume volume = test::testHead();
        volume.geometry = volume::makeGeometry(volume.geometry.dims, glm::dvec3(spacing));
        return labelOf(measured(measure, volume), volume.geometry);
    };
    const auto all = someMeasurements();
    EXPECT_EQ(labelAt(1, all[0]), "5.0 mm");
    EXPECT_EQ(labelAt(3, all[0]), "15.0 mm");
    EXPECT_EQ(labelAt(0.3, all[0]), "1.50 mm");
    EXPECT_EQ(labelAt(0.01, all[0]), "50 µm");
    EXPECT_EQ(labelAt(0.0004, all[0]), "2.00 µm");
    EXPECT_EQ(labelAt(1, all[1]), "90.0°");
    EXPECT_EQ(labelAt(1, all[3]), "100 mm²");
    EXPECT_EQ(labelAt(0.1, all[3]), "1.00 mm²");
}

// Where they are, in the picture's own pixels, and nowhere else.
TEST_F(MeasurementsTest, AnnotatedPicturesHaveThem) {
    Document document(test::testHead());
    View view = test::testCanvas().view;
    document.showView(view);
    const auto rays = document.frame({400, 300}).rays;
    image::Image blank(400, 300);
    std::fill(blank.rgba.begin(), blank.rgba.end(), std::uint8_t(255));
    for (const Measure& measure : someMeasurements()) {
        const Measured found = measured(measure, document.volume());
        image::Image marked = blank;
        markMeasurements(marked, std::vector{found}, rays, document.volume().geometry);
        EXPECT_GT(image::compare(blank, marked).changedFraction, 0.001);
        for (const glm::dvec3& place : found.world) {
            const glm::ivec2 at(rays.project(place));
            const auto* pixel = marked.pixel(at.x, at.y);
            EXPECT_NE(pixel[0], 255) << nameOf(measure.kind);
        }
    }
    image::Image none = blank;
    markMeasurements(none, {}, rays, document.volume().geometry);
    EXPECT_EQ(none.rgba, blank.rgba);
}

} // namespace
} // namespace vs::studio
