// SPDX-License-Identifier: Apache-2.0
// Segments of a scan that is worked on at a coarser level than its finest grow at that one.
#include "gpu/studio/head_in_bricks.h"
#include "image/compare.h"
#include "phantom/phantom.h"
#include "render/slices/slice_renderer.h"
#include "studio/document/live_growth.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::studio {
namespace {

using FinerGrowthTest = test::GlTest;

Seed seedAt(double x, double y) {
    Seed seed;
    seed.strokes = {Sketch{Shape::Polyline, {{x, y}, {x + 12, y + 4}}}};
    seed.range = Range{20, 255};
    seed.canvas = testCanvas();
    return seed;
}

Absorb absorbAt(double x, double y) {
    Absorb absorb;
    absorb.strokes = {Sketch{Shape::Polyline, {{x, y}, {x + 5, y}}}};
    absorb.expansions = 4;
    absorb.canvas = testCanvas();
    return absorb;
}

UseSegment useSegment(const char* name) {
    UseSegment use;
    use.segment = name;
    return use;
}

EditSegment edit(EditSegment::Kind kind, double amount) {
    EditSegment edit;
    edit.kind = kind;
    edit.amount = amount;
    return edit;
}

PaintSegment paintAround(glm::dvec3 voxel) {
    PaintSegment paint;
    paint.trail.points = {voxel};
    paint.trail.radiusMm = 6;
    return paint;
}

std::vector<Operation> history() {
    SetGrowthRules rules;
    rules.range = Range{40, 200};
    rules.isLive = true;
    return {seedAt(200, 130),
            Grow{12},
            rules,
            Grow{10},
            absorbAt(203, 131),
            Rewind{3},
            edit(EditSegment::Kind::Margin, 4),
            edit(EditSegment::Kind::Margin, -3),
            useSegment("Other"),
            seedAt(150, 170),
            Grow{},
            ShowGeneration{5},
            paintAround({20, 20, 20}),
            ReSeed{}};
}

std::size_t countOf(const std::vector<std::uint8_t>& labels, std::uint8_t label) {
    return std::size_t(std::count(labels.begin(), labels.end(), label));
}

TEST_F(FinerGrowthTest, EachStepIsUndoneAndRedoneToTheByte) {
    InBricks inBricks;
    Document& document = *inBricks.document;
    std::vector<std::vector<std::uint8_t>> labels;
    std::vector<std::vector<std::uint8_t>> scene;
    for (const Operation& operation : history()) {
        labels.push_back(inBricks.labels());
        scene.push_back(document.region().labelMap());
        document.apply(operation);
        const auto& region = document.region();
        EXPECT_EQ(region.voxelCount(1), countOf(inBricks.labels(), 1)) << name(operation);
        EXPECT_EQ(region.voxelCount(2), countOf(inBricks.labels(), 2)) << name(operation);
    }
    const auto after = inBricks.labels();
    for (std::size_t n = labels.size(); n-- > 0;) {
        document.apply(Undo{});
        EXPECT_TRUE(n == 0 ? countOf(inBricks.labels(), 0) == inBricks.labels().size()
                           : inBricks.labels() == labels[n])
            << n;
        EXPECT_EQ(document.region().labelMap(), scene[n]) << n;
    }
    for (std::size_t n = 1; n < labels.size(); ++n) {
        document.apply(Redo{});
        EXPECT_EQ(inBricks.labels(), labels[n]) << n;
        EXPECT_EQ(document.region().labelMap(), scene[n]) << n;
    }
    document.apply(Redo{});
    EXPECT_EQ(inBricks.labels(), after);
}

TEST_F(FinerGrowthTest, GrowthThatIsShownIsItsOperation) {
    InBricks shown;
    InBricks atOnce;
    for (InBricks* one : {&shown, &atOnce}) {
        one->document->apply(seedAt(200, 130));
    }
    LiveGrowth& live = shown.document->growing();
    live.begin();
    int portions = 0;
    while (live.growFor(0.1, 3)) {
        ++portions;
    }
    live.end();
    EXPECT_GT(portions, 5);
    atOnce.document->apply(Grow{});
    EXPECT_EQ(shown.labels(), atOnce.labels());
    EXPECT_GT(countOf(shown.labels(), 1), 5000U);
    shown.document->apply(Undo{});
    atOnce.document->apply(Undo{});
    EXPECT_EQ(shown.labels(), atOnce.labels());
    EXPECT_GT(countOf(shown.labels(), 1), 0U);
}

TEST_F(FinerGrowthTest, ScrubbingShowsWhatThereWasThen) {
    InBricks inBricks;
    Document& document = *inBricks.document;
    document.apply(seedAt(200, 130));
    document.apply(Grow{6});
    const auto then = inBricks.labels();
    const auto sceneThen = document.region().labelMap();
    document.apply(Grow{20});
    const auto now = inBricks.labels();
    ASSERT_NE(now, then);
    document.growing().scrub(int(document.facts()->growth.generation) - 20);
    EXPECT_EQ(inBricks.labels(), then);
    document.growing().dropScrub();
    EXPECT_EQ(inBricks.labels(), now);
    EXPECT_EQ(countOf(sceneThen, 0) + countOf(sceneThen, 1), sceneThen.size());
}

TEST_F(FinerGrowthTest, WhereValuesCannotBeReadNothingIsDone) {
    InBricks inBricks;
    Document& document = *inBricks.document;
    inBricks.source->unreadable = glm::ivec3(64, 0, 0);
    document.apply(seedAt(200, 130));
    document.apply(Grow{2});
    const auto before = inBricks.labels();
    const auto logged = document.log().size();
    try {
        document.apply(Grow{});
        ADD_FAILURE() << "it grew where nothing can be read";
    } catch (const ReadError& error) {
        EXPECT_NE(std::string(error.what()).find("damaged"), std::string::npos);
    }
    EXPECT_EQ(inBricks.labels(), before);
    EXPECT_EQ(document.log().size(), logged);
    inBricks.source->unreadable.reset();
    document.apply(Grow{});
    EXPECT_GT(countOf(inBricks.labels(), 1), countOf(before, 1));
}

TEST_F(FinerGrowthTest, WhatIsCutFencesIt) {
    InBricks inBricks;
    Document& document = *inBricks.document;
    document.apply(scissorsAt(200, 130, 25));
    document.apply(seedAt(150, 170));
    document.apply(Grow{});
    const auto labels = inBricks.labels();
    const auto cuts = inBricks.cuts();
    std::size_t inside = 0;
    for (std::size_t n = 0; n < labels.size(); ++n) {
        inside += labels[n] != 0 && cuts[n] >= 0.5F ? 1 : 0;
    }
    EXPECT_EQ(inside, 0U);
    EXPECT_GT(countOf(labels, 1), 5000U);
}

TEST_F(FinerGrowthTest, EditsFollowTheScenesVoxels) {
    InBricks inBricks;
    Document& document = *inBricks.document;
    document.apply(paintAround({20, 20, 20}));
    const auto scene = document.region().labelMap();
    EXPECT_EQ(countOf(inBricks.labels(), 1), 8 * countOf(scene, 1)); // all of each voxel
    document.apply(edit(EditSegment::Kind::Margin, 4));
    const auto wider = document.region().labelMap();
    EXPECT_EQ(countOf(inBricks.labels(), 1), 8 * countOf(wider, 1));
    EXPECT_GT(countOf(wider, 1), countOf(scene, 1));
}

// Pictures at rest show segments as pictures of the finest level would, whole and cut, with room for a few
// bricks or many.
TEST_F(FinerGrowthTest, SegmentsAreSeenAsTheyAre) {
    InBricks roomy;
    InBricks tight(16, 40);
    Head whole;
    roomy.document->apply(seedAt(200, 130));
    Seed seed = std::get<Seed>(roomy.document->log().back());
    tight.document->apply(seed);
    seed.voxels = std::exchange(seed.finest, {});
    whole.apply(seed);
    render::RayCaster caster;
    const auto pictureOf = [&](Document& document, render::Mode mode) {
        View view = document.view();
        view.mode = mode;
        view.shadows = false; // what blocks the light is the scene
        view.tintsSegments = true;
        document.showView(view);
        render::Frame frame = document.frame({200, 150});
        frame.scene.greyWindow = {0, 255}; // of its own histogram otherwise
        frame.samples = 1;
        caster.render(frame);
        document.showView(testCanvas().view);
        return caster.readPicture();
    };
    const auto expectSame = [&](const char* what, bool isCut) {
        ASSERT_EQ(whole.region().labelMap(), roomy.labels()) << what;
        for (const auto mode : {render::Mode::Segment, render::Mode::Overlay, render::Mode::XRay}) {
            const auto wanted = pictureOf(whole, mode);
            for (InBricks* inBricks : {&roomy, &tight}) {
                if (inBricks == &tight && mode != render::Mode::Segment) {
                    continue;
                }
                const auto difference = image::compare(wanted, pictureOf(*inBricks->document, mode));
                // Cut faces, behind which segments go on, do so by rules of values in one and not in the
                // other.
                EXPECT_LT(difference.mean, isCut ? 0.25 : 0.1) << what << int(mode);
                EXPECT_LT(difference.changedFraction, isCut ? 0.02 : 0.01) << what << int(mode);
            }
        }
    };
    const auto applyToAll = [&](const Operation& operation) {
        whole.apply(operation);
        roomy.document->apply(operation);
        tight.document->apply(operation);
    };
    applyToAll(Grow{14});
    expectSame("grown", false);
    UseSegment look;
    look.segment = kFirstSegment;
    look.opacity = 0.4;
    applyToAll(look);
    expectSame("translucent", false);
    look.opacity = 1;
    applyToAll(look);
    applyToAll(Grow{});
    expectSame("grown to the end", false);
    applyToAll(scissorsAt(190, 120, 25));
    expectSame("cut", true);
}

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
        applyToAll(useSegment("Ring"));
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

TEST_F(FinerGrowthTest, SlicesShowSegmentsInTheirColoursAndCutsAsTheyAre) {
    DiscAndRing both;
    ASSERT_EQ(both.labels(), both.wholeLabels());
    ASSERT_GT(countOf(both.labels(), 2), 1000U);
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
TEST_F(FinerGrowthTest, SlicesShowSheetsAsThinAsAVoxel) {
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
TEST_F(FinerGrowthTest, ThinSegmentsInOthersHaveTheirOwnColour) {
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
        document.apply(useSegment("Stripes"));
        seeded(seedOn({150, 255}, stripes));
        document.showView(view);
    };
    applyTo(*inBricks.document, true);
    applyTo(whole, false);
    ASSERT_EQ(inBricks.labels(), whole.region().labelMap());
    ASSERT_GT(countOf(inBricks.labels(), 2), 400U);
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
