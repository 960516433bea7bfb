// SPDX-License-Identifier: Apache-2.0
// Which part of what was cut is pasted: what tools took and not what was trimmed away around it; parts that
// are named, hidden and discarded; and parts that are spread.
#include "gpu/studio/test_segments.h"
#include "gpu/studio/test_tools.h"
#include "image/compare.h"
#include "render/rays/ray_caster.h"
#include "studio/document/document_facts.h"
#include "studio/document/part_queries.h"

namespace vs::studio {
namespace {

constexpr float kRounding = 1.0F / 2048; // of a sculpture's 16 bits, twice
constexpr glm::ivec2 kPicture{200, 150};

Clip clipBelow(double z) {
    Clip clip;
    clip.planes = {{{35, 39, z}, {0.2, 0.1, -1}}};
    return clip;
}

std::vector<float> partOf(Document& document, std::size_t k) {
    return document.parts().values(k, document.volume().geometry.box());
}

image::Image pictureOf(Document& document) {
    render::RayCaster caster;
    caster.render(document.frame(kPicture));
    return caster.readPicture();
}

// A part is what the tools would have cut of what the trim left them.
void expectIsOfTools(const std::vector<float>& part, const std::vector<float>& byTools,
                     const std::vector<float>& byTrim) {
    std::size_t pasted = 0;
    for (std::size_t n = 0; n < part.size(); ++n) {
        if (byTrim[n] == 0) {
            ASSERT_EQ(part[n], byTools[n]) << n;
        } else {
            ASSERT_NEAR(part[n], std::min(std::max(byTools[n], byTrim[n]), 1 - byTrim[n]), kRounding) << n;
        }
        pasted += part[n] >= 0.5F ? 1 : 0;
    }
    EXPECT_GT(pasted, 300U);
}

// What is seen is the same; what is not seen may go on otherwise where a later trim has cut some of a voxel.
void expectSeenAlike(const std::vector<float>& part, const std::vector<float>& before) {
    for (std::size_t n = 0; n < part.size(); ++n) {
        if (before[n] >= 0.5F) {
            ASSERT_EQ(part[n], before[n]) << n;
        } else {
            ASSERT_LT(part[n], 0.5F) << n;
        }
    }
}

TEST_F(ToolsTest, APasteTakesWhatToolsCutAfterATrim) {
    Head trimmed;
    trimmed.apply(clipBelow(22.3));
    const auto byTrim = sculptureOf(trimmed);
    EXPECT_THROW(trimmed.apply(Paste{}), Error) << "tools have cut nothing";
    EXPECT_TRUE(trimmed.parts().nextCells().empty());
    EXPECT_FALSE(trimmed.parts().nextCells(true).empty());
    const Scissors scissors = scissorsAt(200, 150, 35);
    trimmed.apply(scissors);
    trimmed.apply(Paste{});
    Head whole;
    whole.apply(scissors);
    expectIsOfTools(partOf(trimmed, 0), sculptureOf(whole), byTrim);
    // What it had then it keeps, and it takes in what tools still cut, but no later trim.
    const auto before = partOf(trimmed, 0);
    trimmed.apply(clipBelow(30));
    expectSeenAlike(partOf(trimmed, 0), before);
    trimmed.apply(scissorsAt(200, 100, 15));
    EXPECT_FALSE(partOf(trimmed, 0) == before);
    // All of it, when that is wanted.
    ChangePart all{0};
    all.takesTrimmed = true;
    trimmed.apply(all);
    EXPECT_TRUE(partOf(trimmed, 0) == sculptureOf(trimmed));
    trimmed.apply(Undo{});
    trimmed.apply(Undo{});
    trimmed.apply(Undo{});
    EXPECT_TRUE(partOf(trimmed, 0) == before);
}

TEST_F(ToolsTest, ATrimTakesNothingFromWhatToolsHaveCut) {
    const Scissors scissors = scissorsAt(200, 150, 35);
    Head document;
    document.apply(scissors);
    const auto byTools = sculptureOf(document);
    document.apply(clipBelow(22.3));
    document.apply(Paste{});
    expectSeenAlike(partOf(document, 0), byTools);
}

TEST_F(ToolsTest, WhatIsRestoredAndCutAgainIsTrimmedNoMore) {
    const Scissors scissors = scissorsAt(200, 150, 35);
    Head whole;
    whole.apply(scissors);
    for (const Operation& restore : {Operation(UnCut{}), Operation(restoring(clipBelow(22.3))),
                                     Operation(restoring(scissorsAt(200, 150, 60)))}) {
        Head document;
        document.apply(clipBelow(22.3));
        document.apply(restore);
        const auto left = sculptureOf(document);
        document.apply(scissors);
        const auto cut = sculptureOf(document);
        document.apply(Paste{});
        const auto part = partOf(document, 0);
        for (std::size_t n = 0; n < part.size(); ++n) {
            if (left[n] == 0) {
                ASSERT_EQ(part[n], cut[n]) << about(restore).name << " " << n;
            }
        }
        // Back to before it was restored: trimmed again.
        document.apply(Undo{});
        document.apply(Undo{});
        document.apply(Undo{});
        EXPECT_TRUE(document.parts().nextCells().empty()) << about(restore).name;
    }
}

// Random cuts, trims and restores, undone and redone: what a paste would take is what it was.
TEST_F(ToolsTest, UndoBringsBackWhatIsTrimmed) {
    Head document;
    const std::vector<Operation> steps{clipBelow(18),
                                       scissorsAt(200, 150, 20),
                                       restoring(scissorsAt(190, 150, 20)),
                                       clipBelow(26),
                                       penAt<Drill>(210, 140, 14),
                                       restoring(clipBelow(40)),
                                       scissorsAt(170, 160, 25),
                                       UnCut{},
                                       clipBelow(30)};
    std::vector<std::vector<glm::dvec3>> next;
    for (const Operation& step : steps) {
        next.push_back(document.parts().nextCells());
        document.apply(step);
    }
    for (int round = 0; round < 2; ++round) {
        for (std::size_t n = steps.size(); n-- > 0;) {
            document.apply(Undo{});
            EXPECT_TRUE(document.parts().nextCells() == next[n]) << n;
        }
        for (std::size_t n = 0; n < steps.size(); ++n) {
            EXPECT_TRUE(document.parts().nextCells() == next[n]) << n;
            document.apply(Redo{});
        }
    }
}

TEST_F(ToolsTest, KeepAndCuttingAllButASegmentAreTrimsAndCuttingABoxOutIsNot) {
    Clip box;
    box.box = Clip::Box{{20, 20, 20}, {45, 45, 40}};
    box.cutsInside = true;
    Head cut;
    cut.apply(box);
    cut.apply(Paste{});
    EXPECT_TRUE(partOf(cut, 0) == sculptureOf(cut));
    Head segment;
    Seed seed;
    seed.voxels = {{35, 39, 30}};
    seed.range = Range{0, 255};
    segment.apply(seed);
    segment.apply(Grow{12});
    segment.apply(CutSegment{true, 0});
    EXPECT_THROW(segment.apply(Paste{}), Error);
    segment.apply(Undo{});
    segment.apply(CutSegment{false, 0});
    segment.apply(Paste{});
    EXPECT_TRUE(partOf(segment, 0) == sculptureOf(segment));
}

TEST_F(ToolsTest, PartsAreNamedHiddenAndDiscarded) {
    Head document;
    document.apply(scissorsAt(170, 130, 15));
    document.apply(Paste{{{90, 0, 0}, {}, 1}});
    document.apply(scissorsAt(230, 130, 15));
    document.apply(Paste{{{-90, 0, 0}, {}, 1}, "Right"});
    const auto second = partOf(document, 1);
    EXPECT_EQ(document.facts()->parts.at(0).name, "Part 1");
    EXPECT_EQ(document.facts()->parts.at(1).name, "Right");
    const auto both = pictureOf(document);

    ChangePart hide{0};
    hide.isVisible = false;
    document.apply(hide);
    EXPECT_EQ(document.frame(kPicture).pasted.size(), 1U);
    EXPECT_NE(pictureOf(document).rgba, both.rgba);
    document.apply(Undo{});
    EXPECT_EQ(pictureOf(document).rgba, both.rgba);
    document.apply(Redo{});
    const auto onlyRight = pictureOf(document);
    document.apply(Undo{});

    document.apply(DiscardPart{0});
    EXPECT_EQ(document.parts().count(), 1U);
    EXPECT_TRUE(partOf(document, 0) == second) << "it moves up and is what it was";
    EXPECT_EQ(pictureOf(document).rgba, onlyRight.rgba);
    ChangePart rename{0, "Flap"};
    document.apply(rename);
    EXPECT_EQ(document.facts()->parts.at(0).name, "Flap");
    EXPECT_THROW(document.apply(DiscardPart{1}), Error);
    document.apply(Undo{});
    document.apply(Undo{});
    EXPECT_EQ(pictureOf(document).rgba, both.rgba);
}

TEST_F(ToolsTest, NoLaterPasteTakesWhatWasDiscarded) {
    Head document;
    document.apply(scissorsAt(170, 130, 15));
    const auto first = sculptureOf(document);
    document.apply(Paste{});
    document.apply(DiscardPart{0});
    EXPECT_THROW(document.apply(Paste{}), Error);
    document.apply(scissorsAt(230, 130, 15));
    document.apply(Paste{});
    const auto part = partOf(document, 0);
    std::size_t pasted = 0;
    for (std::size_t n = 0; n < part.size(); ++n) {
        ASSERT_FALSE(first[n] > 0.501F && part[n] >= 0.501F) << n;
        pasted += part[n] >= 0.501F ? 1 : 0;
    }
    EXPECT_GT(pasted, 100U);
}

// Un-Cut ends what was pasted, also where no part is left that says so.
TEST_F(ToolsTest, WhatIsCutAgainAfterUnCutIsPastedWhole) {
    Head document;
    document.apply(scissorsAt(170, 130, 15));
    document.apply(Paste{});
    const auto first = partOf(document, 0);
    document.apply(DiscardPart{0});
    document.apply(UnCut{});
    document.apply(scissorsAt(170, 130, 15));
    document.apply(Paste{});
    EXPECT_EQ(partOf(document, 0), first);
}

// Spread, a part goes away from the grid's middle, wherever that is said to lie by now.
TEST_F(ToolsTest, WhatIsSpreadFollowsACorrectionOfTheGrid) {
    Head document;
    document.apply(scissorsAt(170, 130, 15));
    document.apply(Paste{});
    document.apply(test::seedAt({50, 39, 30}, {0, 255}));
    document.apply(Grow{4});
    document.apply(PullOut{});
    SetView view;
    view.spread = 0.5;
    document.apply(view);
    document.apply(CorrectGeometry{.spacing = glm::dvec3(1, 1, 3), .orientation = "RPS"});
    const auto& geometry = document.volume().geometry;
    auto& parts = document.parts();
    const auto label = document.segments().working().label;
    const auto expectSpread = [&](const render::Placement& place, const Box3& box) {
        const glm::dvec3 middle = 0.5 * (glm::dvec3(box.lo + box.hi) - 1.0);
        const glm::dvec3 away =
            glm::dvec3(geometry.worldFromVoxel * glm::dvec4(middle, 1)) - geometry.centreWorld();
        EXPECT_GT(glm::length(away), 5);
        EXPECT_LT(glm::distance(place.moveMm, 0.5 * away), 1e-9);
        EXPECT_LT(glm::length(parts.putFor(place, box).moveMm), 1e-9) << "it was put nowhere else";
    };
    expectSpread(parts.seen().at(0).place, parts.box(0));
    expectSpread(parts.seenPulledOut().at(0).place, parts.segmentBoxes()[label]);
}

TEST_F(ToolsTest, ASpreadPictureIsOneOfPartsThatWerePutThere) {
    Head document;
    document.apply(scissorsAt(170, 130, 15));
    document.apply(Paste{{{30, 0, 0}, {0, 0, 20}, 1}});
    Seed seed;
    seed.voxels = {{35, 39, 30}};
    seed.range = Range{0, 255};
    document.apply(seed);
    document.apply(Grow{6});
    document.apply(PullOut{{}, {{0, 10, 40}, {}, 1}});
    const auto together = pictureOf(document);
    SetView spread;
    spread.spread = 0.7;
    document.apply(spread);
    const auto apart = pictureOf(document);
    EXPECT_NE(apart.rgba, together.rgba);
    const auto part = document.parts().seen().at(0).place;
    const auto segment = document.parts().seenPulledOut().at(0).place;
    spread.spread = 0;
    document.apply(spread);
    EXPECT_EQ(pictureOf(document).rgba, together.rgba);
    document.apply(MovePart{0, part});
    document.apply(PullOut{document.segments().working().name, segment});
    EXPECT_EQ(pictureOf(document).rgba, apart.rgba);
}

TEST_F(ToolsTest, AllSegmentsArePulledOutAndPutBackAtOnceAndEachIsHidden) {
    Head document;
    EXPECT_THROW(document.apply(PullOut{}), Error) << "none has voxels";
    Seed seed;
    seed.range = Range{0, 255};
    for (const int x : {25, 45}) {
        document.apply(UseSegment{"at " + std::to_string(x)});
        seed.voxels = {{x, 39, 30}};
        document.apply(seed);
        document.apply(Grow{4});
    }
    document.apply(PullOut{"at 45", {{0, 0, 70}, {}, 1}});
    document.apply(PullOut{{}, {{0, 0, -70}, {}, 1}});
    EXPECT_EQ(document.segments().find("at 25")->pulledOut->place.moveMm.z, -70);
    EXPECT_EQ(document.segments().find("at 45")->pulledOut->place.moveMm.z, 70) << "it was out already";
    EXPECT_THROW(document.apply(PullOut{}), Error);
    PullOut hidden{"at 45", {{0, 0, 70}, {}, 1}, false};
    document.apply(hidden);
    EXPECT_EQ(document.frame(kPicture).pulled.size(), 1U);
    document.apply(Undo{});
    EXPECT_EQ(document.frame(kPicture).pulled.size(), 2U);
    document.apply(PutBack{});
    EXPECT_TRUE(document.frame(kPicture).pulled.empty());
    EXPECT_THROW(document.apply(PutBack{}), Error);
}

} // namespace
} // namespace vs::studio
