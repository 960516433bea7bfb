// SPDX-License-Identifier: Apache-2.0
// Where a pasted part is put: beside what remains and beside other parts, and in the picture.
#include "mouse.h"
#include "tools/placement_by_hand.h"
#include "tools/scissors_tool.h"

#include "field/cell_ranges.h"
#include "studio/document/part_queries.h"

#include <gtest/gtest.h>

namespace vs::desktop {
namespace {

using studio::Shape;

class Pasting : public testing::Test {
protected:
    void SetUp() override {
        w.window().resize(1100, 760);
        w.open();
    }
    void TearDown() override {
        w.studio().hand().setShape(Shape::FreeForm);
        EXPECT_EQ(w.studio().host().gl().errorCount(), 0);
    }
    studio::Document& document() { return *w.studio().host().document(); }

    void cut(QPointF from, QPointF to) {
        w.studio().hand().take(w.tools().get<ScissorsTool>());
        w.studio().hand().setShape(Shape::Ellipse);
        w.settle();
        mouse.drag({from, 0.5 * (from + to), to});
        w.settle();
    }
    void paste() {
        const std::size_t before = document().parts().count();
        ASSERT_TRUE(w.studio().editor().paste()) << w.studio().host().message().toStdString();
        ASSERT_EQ(document().parts().count(), before + 1);
        w.settle();
    }
    // Middles of macrocells of a part, where it was pasted; in mm.
    std::vector<glm::dvec3> placed(std::size_t part) {
        const auto& geometry = *w.studio().host().geometry();
        const glm::dmat4 world = render::worldFromPart(w.studio().view().shown().pasted.at(part), geometry) *
                                 geometry.worldFromVoxel;
        std::vector<glm::dvec3> places;
        for (const glm::dvec3 cell : document().parts().cells(part)) {
            places.emplace_back(world * glm::dvec4(cell, 1.0));
        }
        return places;
    }
    std::vector<glm::dvec3> remaining() {
        std::vector<glm::dvec3> places;
        for (const glm::dvec3 cell : document().parts().remainingCells()) {
            places.emplace_back(w.studio().host().geometry()->worldFromVoxel * glm::dvec4(cell, 1.0));
        }
        return places;
    }
    // How many of the first lie within a macrocell of one of the second.
    static std::size_t within(const std::vector<glm::dvec3>& some, const std::vector<glm::dvec3>& others,
                              double mm) {
        return std::size_t(std::count_if(some.begin(), some.end(), [&](glm::dvec3 place) {
            return std::any_of(others.begin(), others.end(),
                               [&](glm::dvec3 other) { return glm::distance(place, other) < mm; });
        }));
    }
    double cellMm() { return field::kCell * w.studio().host().geometry()->stepMm(); }
    QRectF seen(const std::vector<glm::dvec3>& places) {
        QRectF box;
        for (const glm::dvec3 place : places) {
            const QPointF at = w.studio().view().seenAt(place);
            box = box.isNull() ? QRectF(at, QSizeF(1e-3, 1e-3)) : box.united(QRectF(at, QSizeF(1e-3, 1e-3)));
        }
        return box;
    }
    void expectFree(std::size_t part) {
        const auto places = placed(part);
        ASSERT_FALSE(places.empty());
        EXPECT_EQ(within(places, remaining(), cellMm()), 0U) << "of part " << part << " in what remains";
        EXPECT_FALSE(seen(places).intersects(seen(remaining()))) << "part " << part << " hides what remains";
        for (std::size_t other = 0; other < part; ++other) {
            EXPECT_EQ(within(places, placed(other), cellMm()), 0U) << part << " in " << other;
        }
        EXPECT_TRUE(QRectF(w.view().rect()).contains(seen(places)))
            << "part " << part << " is not in the picture";
    }

    StudioWindow& w = StudioWindow::instance();
    Mouse mouse{w};
};

TEST_F(Pasting, ASmallPartStandsToTheRight) {
    w.window().resize(1700, 760);
    auto view = w.studio().view().shown();
    view.camera.zoom = 0.9; // with room beside the head
    w.studio().view().showView(view);
    w.settle();
    cut({0.46, 0.3}, {0.54, 0.4});
    const auto camera = w.studio().view().shown().camera;
    paste();
    expectFree(0);
    EXPECT_EQ(w.studio().view().shown().camera, camera) << "there was room in the picture";
    EXPECT_GT(seen(placed(0)).left(), seen(remaining()).right());
    w.photograph(w.view(), "paste_small");
}

TEST_F(Pasting, HalfAHeadStandsBesideTheOtherHalf) {
    cut({0.05, 0.02}, {0.95, 0.5});
    paste();
    expectFree(0);
    w.photograph(w.view(), "paste_half");
}

TEST_F(Pasting, SeveralPartsStandBesideOneAnother) {
    for (int n = 0; n < 4; ++n) {
        const double y = 0.3 + 0.11 * n;
        cut({0.42, y}, {0.58, y + 0.1});
        paste();
        expectFree(std::size_t(n));
    }
    w.photograph(w.view(), "paste_four");
}

TEST_F(Pasting, FromEverySideAndNearTheViewStepsBack) {
    for (const auto& [azimuth, elevation, roll, zoom] :
         {std::array{60.0, 30.0, 0.0, 1.0}, std::array{0.0, 80.0, 90.0, 1.0},
          std::array{20.0, 10.0, 0.0, 4.0}}) {
        w.open();
        auto view = w.studio().view().shown();
        view.camera.azimuthDegrees = azimuth;
        view.camera.elevationDegrees = elevation;
        view.camera.rollDegrees = roll;
        view.camera.zoom = zoom;
        w.studio().view().showView(view);
        w.settle();
        cut({0.4, 0.4}, {0.6, 0.6});
        paste();
        expectFree(0);
        if (zoom > 1) {
            EXPECT_LT(w.studio().view().shown().camera.zoom, zoom);
        }
    }
}

TEST_F(Pasting, TheOperationSaysWhere) {
    cut({0.46, 0.3}, {0.54, 0.4});
    paste();
    const auto& log = document().log();
    const auto found = std::find_if(log.rbegin(), log.rend(), [](const studio::Operation& operation) {
        return std::holds_alternative<studio::Paste>(operation);
    });
    ASSERT_NE(found, log.rend());
    EXPECT_EQ(std::get<studio::Paste>(*found).place, w.studio().view().shown().pasted.front());
}

} // namespace
} // namespace vs::desktop
