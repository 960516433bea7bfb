// SPDX-License-Identifier: Apache-2.0
// How slices and pictures show segments and cuts of a finer level than the one that is worked on.
#include "gpu/gl_test.h"
#include "gpu/studio/head_in_bricks.h"
#include "image/compare.h"
#include "phantom/phantom.h"
#include "render/slices/slice_renderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::studio {
namespace {

using FinerSegmentsTest = test::GlTest;

// A disc, and a ring around another place that is thinner than a voxel of the level that is worked on: alike
// in all layers, so that a layer of the finest level looks like what lies between two of them.
volume::Volume discAndRing() {
    return phantom::makePhantom({64, 64, 32}, volume::ScalarType::UInt8, [](glm::dvec3 p) {
        const double fromDisc = glm::length(glm::dvec2(p) - glm::dvec2(20.3, 28.8));
        const double fromRing = glm::length(glm::dvec2(p) - glm::dvec2(44.2, 36.1));
        return fromDisc <= 11.3 ? 100 : fromRing >= 8.2 && fromRing <= 9.9 ? 200 : 10;
    });
}

Seed seedOn(Range range, std::vector<glm::ivec3> voxels) {
    Seed seed;
    seed.range = range;
    seed.voxels = std::move(voxels);
    seed.canvas = testCanvas({50, 255});
    return seed;
}

// Both have grown in a scan of which all is there, and in bricks.
class DiscAndRing {
public:
    DiscAndRing() : whole_(discAndRing()) {
        whole_.showView(testCanvas({50, 255}).view);
        applySeed(seedOn({90, 110}, {{20, 28, 15}}));
        applyToAll(Grow{});
        applyToAll(UseSegment{"Ring"});
        applySeed(seedOn({150, 255}, {{53, 36, 15}}));
        applyToAll(Grow{});
    }

    void applyToAll(const Operation& operation) {
        whole_.apply(operation);
        inBricks_.document->apply(operation);
    }
    void applySeed(Seed seed) {
        whole_.apply(seed);
        seed.finest = std::exchange(seed.voxels, {});
        inBricks_.document->apply(seed);
    }
    [[nodiscard]] std::vector<std::uint8_t> labels() const { return inBricks_.labels(); }
    [[nodiscard]] std::vector<std::uint8_t> wholeLabels() { return whole_.region().labelMap(); }
    [[nodiscard]] const volume::GridGeometry& geometry() const { return whole_.volume().geometry; }
    void expectSame(const char* what) {
        for (const bool isSmooth : {true, false}) {
            const auto difference =
                image::compare(sliceOf(whole_, 16, isSmooth), sliceOf(*inBricks_.document, 8, isSmooth));
            EXPECT_LT(difference.mean, 0.02) << what << isSmooth;
            EXPECT_LT(difference.changedFraction, 0.002) << what << isSmooth;
        }
    }

private:
    image::Image sliceOf(Document& document, int index, bool isSmooth) {
        render::SliceView view;
        view.index = index;
        view.pixelMm = 0.2; // five pixels a voxel of the finest level
        view.size = {320, 320};
        render::SliceFrame frame = document.slice(view);
        frame.window = {0, 255};
        frame.isSmooth = isSmooth;
        slices_.render(frame);
        EXPECT_FALSE(slices_.missesBricks());
        return slices_.readPicture();
    }
    InBricks inBricks_{16, 400, discAndRing()};
    Document whole_;
    render::SliceRenderer slices_;
};

TEST_F(FinerSegmentsTest, SlicesShowSegmentsInTheirColoursAndCutsAsTheyAre) {
    DiscAndRing both;
    const auto labels = both.labels();
    ASSERT_EQ(labels, both.wholeLabels());
    ASSERT_GT(std::count(labels.begin(), labels.end(), 2), 1000);
    both.expectSame("grown");
    UseSegment look;
    look.segment = kFirstSegment;
    look.opacity = 0.4;
    both.applyToAll(look);
    both.expectSame("translucent");
    look.isVisible = false;
    both.applyToAll(look);
    both.expectSame("hidden");
    look.isVisible = true;
    look.opacity = 1;
    both.applyToAll(look);
    Clip clip;
    const glm::dvec3 middle(both.geometry().worldFromVoxel * glm::dvec4(20, 28, 16, 1));
    clip.planes = {{middle, glm::normalize(glm::dvec3(0.3, 1, 0))}};
    both.applyToAll(clip);
    both.expectSame("cut");
}

// A sheet of one or two layers is neither lost between the layers that a slice runs between, nor at the end
// of a scan whose levels do not divide evenly.
TEST_F(FinerSegmentsTest, SlicesShowSheetsAsThinAsAVoxel) {
    constexpr double kRadius = 15.3;
    struct Sheet {
        int first;
        int last;
    };
    render::SliceRenderer slices;
    for (const Sheet sheet : {Sheet{15, 15}, Sheet{16, 16}, Sheet{15, 16}, Sheet{16, 17}, Sheet{32, 32}}) {
        InBricks inBricks(
            16, 400, phantom::makePhantom({64, 64, 33}, volume::ScalarType::UInt8, [&](glm::dvec3 p) {
                const bool isInside = glm::length(glm::dvec2(p) - glm::dvec2(30.4, 32.8)) <= kRadius;
                return isInside && p.z >= sheet.first && p.z <= sheet.last ? 200 : 10;
            }));
        Document& document = *inBricks.document;
        for (const bool isSmooth : {true, false}) {
            const auto pictureOf = [&](int layer) {
                render::SliceView view;
                view.index = layer / 2;
                view.pixelMm = 0.2;
                view.size = {320, 320};
                render::SliceFrame frame = document.slice(view);
                frame.window = {0, 255};
                frame.isSmooth = isSmooth;
                slices.render(frame);
                return slices.readPicture();
            };
            const auto without = pictureOf(sheet.last);
            Seed seed = seedOn({150, 255}, {});
            seed.finest = {{30, 32, sheet.last}};
            document.apply(seed);
            document.apply(Grow{});
            const auto with = pictureOf(sheet.last);
            const double pixels = image::compare(without, with).changedFraction * 320 * 320;
            const double disc = 3.14159 * kRadius * kRadius * 25;
            // Where voxels are areas the slice shows the second of the two layers that it runs between.
            const int shown = std::min(sheet.last / 2 * 2 + 1, 32);
            const bool isSeen = isSmooth || (shown >= sheet.first && shown <= sheet.last);
            EXPECT_NEAR(pixels / disc, isSeen ? 1 : 0, 0.1)
                << sheet.first << " to " << sheet.last << ", smooth " << isSmooth;
            document.apply(Undo{});
            document.apply(Undo{});
        }
    }
}

// Stripes a voxel wide in the surface of another segment, which has most of each voxel of the scene there.
TEST_F(FinerSegmentsTest, ThinSegmentsInOthersHaveTheirOwnColour) {
    const auto scan = [] {
        return phantom::makePhantom({64, 64, 64}, volume::ScalarType::UInt8, [](glm::dvec3 p) {
            const bool isBody = p.x >= 12 && p.x <= 52 && p.y >= 12 && p.y <= 52 && p.z <= 40;
            const bool isStripe = p.z >= 39.5 && std::lround(p.x) % 4 == 0;
            return isBody && isStripe ? 200 : isBody ? 100 : 10;
        });
    };
    InBricks inBricks(16, 400, scan());
    Document whole(scan());
    std::vector<glm::ivec3> stripes;
    for (int x = 12; x <= 52; x += 4) {
        stripes.emplace_back(x, 30, 40);
    }
    const auto applyTo = [&](Document& document, bool hasFiner) {
        View view = testCanvas({50, 255}).view;
        view.mode = render::Mode::Segment;
        view.camera.elevationDegrees = 60;
        document.showView(view);
        const auto seeded = [&](Seed seed) {
            if (hasFiner) {
                seed.finest = std::exchange(seed.voxels, {});
            }
            document.apply(seed);
            document.apply(Grow{});
        };
        seeded(seedOn({90, 110}, {{30, 30, 20}}));
        document.apply(UseSegment{"Stripes"});
        seeded(seedOn({150, 255}, stripes));
        document.showView(view);
    };
    applyTo(*inBricks.document, true);
    applyTo(whole, false);
    const auto labels = inBricks.labels();
    ASSERT_EQ(labels, whole.region().labelMap());
    ASSERT_GT(std::count(labels.begin(), labels.end(), 2), 400);
    render::RayCaster caster;
    const auto pictureOf = [&](Document& document) {
        render::Frame frame = document.frame({400, 300});
        frame.scene.greyWindow = {0, 255};
        frame.samples = 1;
        caster.render(frame);
        return caster.readPicture();
    };
    const auto difference = image::compare(pictureOf(whole), pictureOf(*inBricks.document));
    EXPECT_LT(difference.mean, 0.1);
    EXPECT_LT(difference.changedFraction, 0.005);
}

} // namespace
} // namespace vs::studio
