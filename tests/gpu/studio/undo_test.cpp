// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "gpu/gl_test.h"
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_head.h"
#include "sculpt/surface/tool_cut.h"
#include "studio/document/document_facts.h"
#include "studio/state/history.h"

#include <random>

namespace vs::studio {
namespace {

using UndoTest = test::GlTest;
using Bytes = std::vector<std::byte>;
using test::ellipseAt;
using test::somePeel;
using test::testCanvas;
using test::testHead;

Drill drillAt(double x, double y, double radius) {
    Drill drill;
    drill.mask = ellipseAt(x, y, radius, radius);
    drill.canvas = testCanvas();
    return drill;
}

TEST_F(UndoTest, UnderATinyLimitDeltasGoToAFileAndComeBack) {
    Document document(testHead());
    constexpr std::size_t limit = 8000;
    document.setUndoMemory(limit);
    std::vector<Bytes> states{test::sculptureBytes(document)};
    for (int n = 0; n < 12; ++n) {
        const Operation operation =
            n % 3 == 0 ? Operation(somePeel(2 + n)) : Operation(drillAt(160 + 8 * n, 120 + 5 * n, 14));
        document.apply(operation);
        states.push_back(test::sculptureBytes(document));
        EXPECT_LE(document.history().statistics().bytesInMemory, limit);
    }
    EXPECT_GT(document.history().statistics().bytesInFile, 0U);
    for (int round = 0; round < 2; ++round) {
        for (std::size_t at = states.size() - 1; at-- > 0;) {
            document.apply(Undo{});
            ASSERT_TRUE(test::sculptureBytes(document) == states[at]) << at;
            ASSERT_LE(document.history().statistics().bytesInMemory, limit);
        }
        // Held results are the larger ones.
        EXPECT_GT(document.history().statistics().bytesInFile, 4 * limit);
        for (std::size_t at = 1; at < states.size(); ++at) {
            document.apply(Redo{});
            ASSERT_TRUE(test::sculptureBytes(document) == states[at]) << at;
            ASSERT_LE(document.history().statistics().bytesInMemory, limit);
        }
    }
}

TEST_F(UndoTest, TheFileShrinksWhenWhatCouldBeRedoneIsForgotten) {
    Document document(testHead());
    document.setUndoMemory(0);
    for (int n = 0; n < 6; ++n) {
        document.apply(drillAt(160 + 12 * n, 150, 15));
    }
    for (int n = 0; n < 6; ++n) {
        document.apply(Undo{});
    }
    const auto full = document.history().statistics();
    EXPECT_EQ(full.steps, 6U);
    EXPECT_GT(full.fileBytes, 10000U);
    document.apply(drillAt(40, 40, 3)); // meets nothing: forgets nothing
    EXPECT_EQ(document.history().statistics().steps, 6U);
    document.apply(drillAt(200, 150, 5));
    const auto rest = document.history().statistics();
    EXPECT_EQ(rest.steps, 1U);
    EXPECT_LT(rest.fileBytes, full.fileBytes / 4);
}

TEST_F(UndoTest, WithoutAFileEverythingStaysInMemory) {
    gl::Texture texture(glm::ivec3(40), gl::Format::R16F, gl::Filter::Nearest, "texture");
    History history("/nowhere/at/all");
    history.setMemoryLimit(10);
    const Bytes before = texture.download({glm::ivec3(0), glm::ivec3(40)});
    sculpt::BrickBackup backup(texture);
    backup.protect({glm::ivec3(0), glm::ivec3(40)});
    texture.upload({glm::ivec3(3), glm::ivec3(5)}, Bytes(16, std::byte(0x3b)));
    history.push({Drill{}, backup.finish(), {}});
    EXPECT_GT(history.statistics().bytesInMemory, 10U);
    EXPECT_EQ(history.statistics().bytesInFile, 0U);
    history.toUndo().cut->swap(texture);
    history.tookBack();
    EXPECT_EQ(texture.download({glm::ivec3(0), glm::ivec3(40)}), before);
}

// Against plain copies of the whole sculpture, one a state.
TEST_F(UndoTest, AThousandStampsWithUndoAndRedoAtRandom) {
    const glm::ivec3 dims(48);
    const Box3 whole{glm::ivec3(0), dims};
    const auto geometry = volume::makeGeometry(dims);
    sculpt::Sculpture sculpture(dims);
    sculpt::ToolCutter cutter(geometry);
    History history;
    history.setMemoryLimit(30000); // so that some of it is in the file
    std::vector<Bytes> states{sculpture.download(whole)};
    std::size_t at = 0;
    std::mt19937 random(11);
    const auto travel = [&](bool back) {
        Step& step = back ? history.toUndo() : history.toRedo();
        sculpture.swap(*step.cut);
        back ? history.tookBack() : history.appliedAgain();
        at += back ? std::size_t(-1) : 1;
    };
    for (int stamp = 0; stamp < 1000; ++stamp) {
        const glm::dvec2 centre(8 + int(random() % 32), 8 + int(random() % 32));
        const auto mask = sculpt::rasterize(sculpt::circleOutline(centre, 2 + random() % 5), 0.7);
        std::vector<field::SurfacePoint> surface(mask.values.size());
        for (std::size_t n = 0; n < surface.size(); ++n) {
            const glm::dvec2 place = mask.origin + mask.pitch * glm::dvec2(n % std::size_t(mask.size.x),
                                                                           n / std::size_t(mask.size.x));
            surface[n].voxel = glm::vec4(place, 4 + random() % 3, 1);
            surface[n].normal = glm::vec4(0, 0, -1, 0);
        }
        sculpt::ToolCut cut;
        cut.sweep.depthSteps = 3 + random() % 30;
        cut.how = random() % 4 == 0 ? sculpt::Combine::Restore : sculpt::Combine::Cut;
        sculpt::BrickBackup backup(sculpture.texels());
        cutter.cut(sculpture, surface, mask, cut, &backup);
        history.push({Drill{}, backup.finish(), {}});
        states.resize(++at);
        states.push_back(sculpture.download(whole));
        for (unsigned moves = random() % 4; moves > 0; --moves) {
            const bool back = random() % 2 == 0;
            if (back ? history.canUndo() : history.canRedo()) {
                travel(back);
                ASSERT_TRUE(sculpture.download(whole) == states[at]) << "stamp " << stamp;
            }
        }
    }
    EXPECT_GT(states.size(), 100U);
    EXPECT_GT(history.statistics().bytesInFile, 0U);
    EXPECT_LE(history.statistics().bytesInMemory, 30000U);
    while (history.canUndo()) {
        travel(true);
        ASSERT_TRUE(sculpture.download(whole) == states[at]) << "back at " << at;
    }
    EXPECT_TRUE(sculpture.isEmpty());
}

TEST_F(UndoTest, StepsAreListedInTheirOrderWhateverOfThemHolds) {
    Document document(testHead());
    document.apply(somePeel(2));
    document.apply(drillAt(160, 120, 14));
    document.apply(somePeel(3));
    const auto names = [&document] {
        std::vector<std::string> result;
        for (const Operation* operation : document.facts()->edits->operations) {
            result.emplace_back(name(*operation));
        }
        return result;
    };
    const std::vector<std::string> all{"peel", "drill", "peel"};
    for (std::size_t undone = 0; undone <= all.size(); ++undone) {
        EXPECT_EQ(names(), all);
        EXPECT_EQ(document.facts()->edits->done, all.size() - undone);
        if (document.facts()->canUndo()) {
            document.apply(Undo{});
        }
    }
    document.apply(Redo{});
    document.apply(drillAt(170, 130, 10)); // what could be redone is gone
    EXPECT_EQ(names(), (std::vector<std::string>{"peel", "drill"}));
    EXPECT_EQ(document.facts()->edits->done, 2U);
}

TEST_F(UndoTest, ANoteIsAStepThatChangesNothing) {
    Document document(testHead());
    document.apply(somePeel(2));
    const Bytes cut = test::sculptureBytes(document);
    const Outcome outcome = document.apply(Note{"the left side is for the second opinion"});
    EXPECT_EQ(outcome.message.english(), "the left side is for the second opinion");
    EXPECT_EQ(document.facts()->edits->done, 2U);
    EXPECT_TRUE(test::sculptureBytes(document) == cut);
    document.apply(Undo{});
    EXPECT_STREQ(name(*document.facts()->lastEdit()), "peel");
    EXPECT_TRUE(test::sculptureBytes(document) == cut) << "only the note was taken back";
    document.apply(Redo{});
    EXPECT_EQ(details(*document.facts()->lastEdit()).front().english(),
              "the left side is for the second opinion");
    EXPECT_TRUE(test::sculptureBytes(document) == cut);
}

TEST_F(UndoTest, BytesAChangedVoxelStayBelowTheLimitBothWays) {
    Document document(testHead());
    for (int n = 0; n < 5; ++n) {
        document.apply(drillAt(160 + 12 * n, 120 + 10 * n, 14));
        document.apply(somePeel(1 + 2 * n));
    }
    const auto undo = document.history().statistics();
    EXPECT_GT(undo.changedVoxels, 5000U);
    EXPECT_LT(undo.bytesPerChangedVoxel(), 1.6);
    while (document.facts()->canUndo()) {
        document.apply(Undo{});
    }
    const auto redo = document.history().statistics();
    EXPECT_EQ(redo.changedVoxels, undo.changedVoxels);
    EXPECT_LT(redo.bytesPerChangedVoxel(), 1.9) << "stamps as small as these are nearly all edge";
}

} // namespace
} // namespace vs::studio
