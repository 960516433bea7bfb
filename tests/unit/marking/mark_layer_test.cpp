// SPDX-License-Identifier: Apache-2.0
// Ink on texels: what is laid more than once, over other ink, and taken away.
#include "marking/mark_layer.h"
#include "property.h"

#include <gtest/gtest.h>

namespace vs::marking {
namespace {

using field::MarkTexel;

const Ink kRed{{255, 0, 0}, false};
const Ink kBlue{{0, 0, 255}, false};
const Ink kEraser{{}, true};

TEST(MarkLayerTest, InkOverInkIsMixedByItsOpacity) {
    const MarkTexel red = inked({}, 255, 255, kRed);
    EXPECT_EQ(red, (MarkTexel{255, 0, 0, 255, 255}));
    EXPECT_EQ(inked(red, 255, 255, kBlue), (MarkTexel{0, 0, 255, 255, 255}));
    const MarkTexel both = inked(red, 255, 128, kBlue);
    EXPECT_NEAR(both.red, 127, 1);
    EXPECT_NEAR(both.blue, 128, 1);
    EXPECT_EQ(both.opacity, 255);
    const MarkTexel pale = inked(inked({}, 255, 128, kRed), 255, 128, kRed);
    EXPECT_NEAR(pale.opacity, 191, 1) << "two layers of half of it";
}

// What lies outside of a mark's edge keeps the colour that was there.
TEST(MarkLayerTest, ColoursEndAtEdges) {
    const MarkTexel red = inked({}, 255, 255, kRed);
    const MarkTexel beside = inked(red, 60, 255, kBlue);
    EXPECT_EQ(beside, red);
    const MarkTexel fringe = inked({}, 60, 255, kRed);
    EXPECT_EQ(inked(fringe, 255, 255, kBlue), (MarkTexel{0, 0, 255, 255, 255}));
}

TEST(MarkLayerTest, AnEraserLeavesNothingOrLessOfIt) {
    const MarkTexel red = inked({}, 255, 255, kRed);
    EXPECT_EQ(inked(red, 255, 255, kEraser), MarkTexel());
    EXPECT_EQ(inked(red, 100, 255, kEraser).coverage, 155) << "an edge where the eraser's was";
    EXPECT_NEAR(inked(red, 255, 128, kEraser).opacity, 127, 1);
    EXPECT_EQ(inked({}, 255, 255, kEraser), MarkTexel());
}

// A stroke that goes over a place twice leaves what one leaves that went there once, as hard as it was
// pressed the harder time; in whatever pieces it is shown meanwhile.
TEST(MarkLayerTest, AStrokeCountsOnceWhereverItWent) {
    test::checkProperty(30, [] {
        const field::MarkGrid grid{{20, 20, 20}, {2, 2, 2}};
        MarkLayer earlier(grid);
        for (int i = 0; i < 200; ++i) {
            earlier.cover({*test::below(40), *test::below(40), *test::below(4)}, 1, 1);
        }
        const field::Marks before = earlier.on({}, {}, kRed);
        struct Dab {
            glm::ivec3 texel;
            double coverage;
            double opacity;
        };
        std::vector<Dab> dabs;
        for (int i = 0; i < 60; ++i) {
            dabs.push_back({{*test::below(40), *test::below(40), *test::below(4)},
                            *test::below(256) / 255.0,
                            *test::below(256) / 255.0});
        }
        const Ink ink = *test::below(2) == 0 ? kBlue : kEraser;
        MarkLayer whole(grid);
        MarkLayer inPieces(grid);
        field::Marks shown = before;
        for (const int times : {1, 2}) {
            for (const Dab& dab : dabs) {
                whole.cover(dab.texel, dab.coverage, dab.opacity);
                inPieces.cover(dab.texel, dab.coverage, times == 1 ? dab.opacity / 2 : dab.opacity);
                if (*test::below(9) == 0) {
                    shown = inPieces.on(before, shown, ink);
                }
            }
        }
        shown = inPieces.on(before, shown, ink);
        RC_ASSERT(shown == whole.on(before, before, ink));
    });
}

} // namespace
} // namespace vs::marking
