// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "gpu/gl_test.h"
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_head.h"
#include "property.h"
#include "sculpt/surface/tool_cut.h"
#include "studio/document/document_content.h"
#include "studio/document/document_facts.h"
#include "studio/document/document_state.h"
#include "studio/state/history.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

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

// Where the sculpture is what it was, growth that is done again goes on as it did, and does not take it for
// another fence, at which it would try once more what it had refused.
TEST_F(UndoTest, GrowthKnowsItsFenceAgain) {
    for (const bool isOpenedBetween : {false, true}) {
        auto document = std::make_unique<Document>(testHead());
        Clip box;
        box.box = Clip::Box{{13, 10, 5}, {50, 67, 50}};
        document->apply(box);
        document->apply(test::brainSeed());
        document->apply(Grow{4});
        document->apply(UnCut{});
        const DocumentContent cleared = contentOf(*document);
        document->apply(Undo{});
        const DocumentContent grown = contentOf(*document);
        document->apply(Undo{});
        if (isOpenedBetween) {
            document = std::make_unique<Document>(testHead(), document->state());
        }
        document->apply(Redo{});
        EXPECT_EQ(differences(grown, contentOf(*document), "a", "b"), std::vector<std::string>());
        document->apply(Redo{});
        EXPECT_EQ(differences(cleared, contentOf(*document), "a", "b"), std::vector<std::string>());
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
    history.push({shared(Drill{}), backup.finish(), {}});
    EXPECT_GT(history.statistics().bytesInMemory, 10U);
    EXPECT_EQ(history.statistics().bytesInFile, 0U);
    history.toUndo().cut->swap(texture);
    history.tookBack();
    EXPECT_EQ(texture.download({glm::ivec3(0), glm::ivec3(40)}), before);
}

// A cut or a restoring by a round mask, and what is undone and redone after it.
struct Stamp {
    glm::ivec2 centre;
    int radius;
    int height; // of the surface under the mask
    int depth;
    bool restores;
    std::vector<bool> isBack;
};

void showValue(const Stamp& stamp, std::ostream& out) {
    out << (stamp.restores ? "restore" : "cut") << " at " << stamp.centre.x << ' ' << stamp.centre.y
        << " with radius " << stamp.radius << ", from " << stamp.height << " by " << stamp.depth;
    for (const bool isBack : stamp.isBack) {
        out << (isBack ? ", undo" : ", redo");
    }
}

rc::Gen<Stamp> anyStamp() {
    return rc::gen::exec([] {
        return Stamp{{8 + *test::below(32), 8 + *test::below(32)},
                     2 + *test::below(5),
                     4 + *test::below(3),
                     3 + *test::below(30),
                     *test::below(4) == 0,
                     *test::upTo(3, test::coin())};
    });
}

// A sculpture with its history, and plain copies of it, one a state.
class Stamped {
public:
    Stamped() : cutter_(volume::makeGeometry(kDims)), sculpture_(kDims) {
        history_.setMemoryLimit(kLimit);
        states_.push_back(content());
    }

    [[nodiscard]] std::size_t states() const { return states_.size(); }
    [[nodiscard]] const History& history() const { return history_; }
    [[nodiscard]] bool isUntouched() const { return sculpture_.isEmpty(); }

    void apply(const Stamp& stamp) {
        const auto mask =
            sculpt::rasterize(sculpt::circleOutline(glm::dvec2(stamp.centre), stamp.radius), 0.7);
        std::vector<field::SurfacePoint> surface(mask.values.size());
        for (std::size_t n = 0; n < surface.size(); ++n) {
            const glm::dvec2 place = mask.origin + mask.pitch * glm::dvec2(n % std::size_t(mask.size.x),
                                                                           n / std::size_t(mask.size.x));
            surface[n].voxel = glm::vec4(place, stamp.height, 1);
            surface[n].normal = glm::vec4(0, 0, -1, 0);
        }
        sculpt::ToolCut cut;
        cut.sweep.depthSteps = stamp.depth;
        cut.how = stamp.restores ? sculpt::Combine::Restore : sculpt::Combine::Cut;
        sculpt::BrickBackup backup(sculpture_.texels());
        cutter_.cut(sculpture_, surface, mask, cut, &backup);
        history_.push({shared(Drill{}), backup.finish(), {}});
        states_.resize(++at_);
        states_.push_back(content());
        RC_ASSERT(history_.statistics().bytesInMemory <= kLimit);
    }
    // Returns whether there was anything to undo or redo.
    bool travel(bool isBack) {
        if (isBack ? !history_.canUndo() : !history_.canRedo()) {
            return false;
        }
        Edit& edit = isBack ? history_.toUndo() : history_.toRedo();
        sculpture_.swap(*edit.cut);
        isBack ? history_.tookBack() : history_.appliedAgain();
        at_ += isBack ? std::size_t(-1) : 1;
        RC_ASSERT((content() == states_[at_]));
        return true;
    }

private:
    static constexpr glm::ivec3 kDims{48, 48, 48};
    static constexpr std::size_t kLimit = 30000; // so that some of it is in the file

    [[nodiscard]] Bytes content() const { return sculpture_.download({glm::ivec3(0), kDims}); }

    sculpt::ToolCutter cutter_;
    sculpt::Sculpture sculpture_;
    History history_;
    std::vector<Bytes> states_;
    std::size_t at_ = 0;
};

TEST_F(UndoTest, AThousandStampsWithUndoAndRedoAtRandom) {
    std::size_t mostStates = 0;
    std::size_t mostInFile = 0;
    test::checkProperty(5, [&] {
        Stamped stamped;
        for (const Stamp& stamp : *test::upTo(400, anyStamp())) {
            stamped.apply(stamp);
            for (const bool isBack : stamp.isBack) {
                stamped.travel(isBack);
            }
        }
        mostStates = std::max(mostStates, stamped.states());
        mostInFile = std::max(mostInFile, std::size_t(stamped.history().statistics().bytesInFile));
        while (stamped.travel(true)) {
        }
        RC_ASSERT(stamped.isUntouched());
    });
    EXPECT_GT(mostStates, 100U);
    EXPECT_GT(mostInFile, 0U);
}

TEST_F(UndoTest, StepsAreListedInTheirOrderWhateverOfThemHolds) {
    Document document(testHead());
    document.apply(somePeel(2));
    document.apply(drillAt(160, 120, 14));
    document.apply(somePeel(3));
    const auto names = [&document] {
        std::vector<std::string> result;
        for (const auto& operation : document.facts()->edits->operations) {
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
