// SPDX-License-Identifier: Apache-2.0
// Any history of segments and sculpture, undone, redone and replayed.
#include "gpu/gl_test.h"
#include "gpu/studio/test_labels.h"
#include "gpu/studio/test_segments.h"
#include "property.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_growth.h"
#include "studio/json/operation_json.h"

#include <nlohmann/json.hpp>

namespace vs::studio {
namespace {

using SegmentToolsTest = test::GlTest;
using test::editOf;
using test::seedAt;
using test::somePeel;
using test::stateOf;
using test::strokes;
using test::testCanvas;
using test::testHead;

Operation drawOperation(const std::filesystem::path& labels) {
    const auto below = [](int n) { return *test::below(n); };
    const std::string names[] = {"Segment 1", "B", "C"};
    const std::string& who = names[below(3)];
    const auto brainVoxel = [&] { return glm::ivec3(30 + below(12), 16 + below(6), 24 + below(12)); };
    const auto trail = [&] {
        Trail way{{brainVoxel(), brainVoxel()}, 0.5 * below(9)};
        if (below(2) == 0) {
            way.axis = below(3);
        }
        return way;
    };
    switch (below(17)) {
    case 0: {
        UseSegment use{who};
        use.isLocked = below(4) == 0;
        use.opacity = 0.25 * (1 + below(4));
        use.goesToWork = below(2) == 0;
        return use;
    }
    case 1:
        return UseSegment{who};
    case 2:
    case 3:
        return seedAt(brainVoxel());
    case 4:
    case 5:
        return Grow{1 + below(6)};
    case 6:
        return Rewind{below(5)};
    case 7:
        return ShowGeneration{below(12)};
    case 8: {
        SetGrowthRules rules;
        rules.isLive = below(2) == 0;
        rules.range = below(2) == 0 ? Range{80, 120} : Range{30, 255};
        rules.connectivity = below(2) == 0 ? 6 : 26;
        return rules;
    }
    case 9: {
        Absorb absorb;
        absorb.voxels = {brainVoxel()};
        absorb.expansions = 1 + below(4);
        absorb.canvas = testCanvas();
        return absorb;
    }
    case 10:
        return below(3) == 0   ? Operation(RemoveSegment{who})
               : below(4) == 0 ? Operation(below(2) == 0 ? ShowSegments{} : ShowSegments{who})
               : below(4) == 0 ? (below(3) == 0 ? Operation(PutBack{who})
                                                : Operation(PullOut{who, {{10.0 * below(9), 0, 0}}}))
                               : Operation(somePeel(1 + below(4)));
    case 11: {
        EditSegment edit = editOf(EditSegment::Kind(below(13)), 0.5 + below(3), who);
        edit.voxel = brainVoxel();
        return edit;
    }
    case 12: {
        Seed seed;
        seed.trails = {trail(), trail()};
        seed.range = Range{80, 120};
        seed.canvas = testCanvas();
        return seed;
    }
    case 13: {
        PaintSegment paint{below(3) > 0, trail()};
        if (below(2) == 0) {
            paint.range = Range{80, 120};
        }
        return paint;
    }
    case 14:
        return BrushSegment{below(2) == 0, strokes()[std::size_t(below(4))]};
    case 15:
        return below(3) == 0 ? Operation(LoadLabels{labels}) : Operation(Grow{1 + below(6)});
    default:
        return below(8) == 0 ? Operation(ReSeed{}) : Operation(CutSegment{below(3) == 0, double(below(3))});
    }
}

// An operation and what is undone and redone after it.
struct Move {
    Operation operation;
    bool growsAsTheWindow; // in slices of time, if it is growth
    std::vector<bool> isBack;
};

void showValue(const Move& move, std::ostream& out) {
    out << toJson(move.operation).dump() << (move.growsAsTheWindow ? ", as the window if it grows" : "");
    for (const bool isBack : move.isBack) {
        out << (isBack ? ", undo" : ", redo");
    }
}

rc::Gen<Move> anyMove(const std::filesystem::path& labels) {
    return rc::gen::exec([labels] {
        const Operation operation = drawOperation(labels);
        return Move{operation, *test::below(3) == 0, *test::upTo(2, test::coin())};
    });
}

// A document and all the states that undo and redo lead to.
class Traveller {
public:
    Traveller() : document_(testHead()), states_{stateOf(document_)} {}

    [[nodiscard]] const Document& document() const { return document_; }

    // Whatever is refused leaves no trace. Returns whether it was not.
    bool apply(const Move& move) {
        bool isDone = true;
        try {
            perform(move);
        } catch (const Error&) {
            isDone = false;
        }
        const auto now = stateOf(document_);
        if (!document_.facts()->canRedo() &&
            document_.history().statistics().steps == at_ + 1) { // a step was made
            states_.resize(++at_);
            states_.push_back(now);
        } else {
            RC_ASSERT((now == states_[at_]));
        }
        return isDone;
    }
    // Returns whether there was anything to undo or redo.
    bool travel(bool isBack) {
        if (isBack ? !document_.facts()->canUndo() : !document_.facts()->canRedo()) {
            return false;
        }
        document_.apply(isBack ? Operation(Undo{}) : Operation(Redo{}));
        at_ += isBack ? std::size_t(-1) : 1;
        const auto state = stateOf(document_);
        RC_ASSERT((state.segments == states_[at_].segments));
        RC_ASSERT((state.sculpture == states_[at_].sculpture));
        RC_ASSERT((state.labelMap == states_[at_].labelMap));
        RC_ASSERT((state.generations == states_[at_].generations));
        return true;
    }

private:
    void perform(const Move& move) {
        if (std::holds_alternative<Grow>(move.operation) && move.growsAsTheWindow) {
            document_.growing().begin();
            document_.growing().growFor(1, 4);
            document_.growing().end();
        } else {
            document_.apply(move.operation);
        }
    }

    Document document_;
    std::vector<test::DocumentState> states_;
    std::size_t at_ = 0;
};

// Undo and redo bring back every state, and the log, written and read again, does it all once more.
TEST_F(SegmentToolsTest, UndoRedoAndReplayOfAnything) {
    const test::LabelFile labels;
    int moves = 0;
    int refused = 0;
    int travels = 0;
    test::checkProperty(6, [&] {
        Traveller traveller;
        for (const Move& move : *test::upTo(60, anyMove(labels.path()))) {
            ++moves;
            refused += traveller.apply(move) ? 0 : 1;
            for (const bool isBack : move.isBack) {
                travels += traveller.travel(isBack) ? 1 : 0;
            }
        }
        Document replayed(testHead());
        for (const Operation& operation : traveller.document().log()) {
            replayed.apply(operationFromJson(toJson(operation), "log"));
        }
        RC_ASSERT((stateOf(replayed) == stateOf(traveller.document())));
        while (traveller.travel(true)) {
            ++travels;
        }
    });
    EXPECT_GT(moves, 60) << "there must be something to undo";
    EXPECT_LT(refused, 0.67 * moves);
    EXPECT_GT(travels, 0.25 * moves);
}

} // namespace
} // namespace vs::studio
