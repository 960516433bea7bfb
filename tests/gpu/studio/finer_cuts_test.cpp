// SPDX-License-Identifier: Apache-2.0
// What tools do to a scan that is worked on at a coarser level than its finest is what they do to that.
#include "gpu/studio/cut_difference.h"
#include "gpu/studio/head_in_bricks.h"
#include "gpu/studio/test_tools.h"
#include "image/compare.h"
#include "property.h"
#include "render/rays/ray_caster.h"
#include "studio/document/live_stroke.h"

namespace vs::studio {
namespace {

using FinerCutsTest = test::GlTest;

// An operation that counts steps of the finest level, in those of one of half the resolution.
Operation inCoarseSteps(Operation operation) {
    std::visit(
        [](auto& op) {
            using Op = std::decay_t<decltype(op)>;
            if constexpr (std::is_same_v<Op, Peel>) {
                op.layers /= 2;
            } else if constexpr (std::is_same_v<Op, Drill> || std::is_same_v<Op, Laser>) {
                op.depthMax /= 2;
            } else if constexpr (std::is_same_v<Op, Scissors>) {
                op.depth = op.depth ? std::optional(*op.depth / 2) : std::nullopt;
            } else if constexpr (std::is_same_v<Op, Sweep>) {
                if (!op.path.isDrawn()) {
                    for (glm::dvec2& point : op.mask.points) {
                        point /= 2;
                    }
                    for (glm::dvec3& point : op.path.points) {
                        point = (point - 0.5) / 2.0;
                    }
                    op.path.helixRadius /= 2;
                }
            } else if constexpr (std::is_same_v<Op, Clip>) {
                if (op.box) {
                    op.box = Clip::Box{(op.box->lo - 0.5) / 2.0, (op.box->hi - 0.5) / 2.0};
                }
            }
        },
        operation);
    return operation;
}

std::vector<Operation> allTools() {
    auto tools = toolsAt(200, 130);
    Sweep helix = sweepAcross(0, 0);
    helix.mask = {Shape::Ellipse, {{-5, -5}, {5, 5}}};
    helix.path = {SweepPath::Kind::Helix, {}, {{36, 40, 10}, {36, 40, 50}}, 14, 2};
    tools.emplace_back(helix);
    helix.path = {SweepPath::Kind::Spline, {}, {{20, 20, 40}, {36, 12, 45}, {50, 20, 40}}};
    helix.method = Sweep::Method::Projection;
    tools.emplace_back(helix);
    Clip clip;
    clip.box = Clip::Box{{10, 12, 8}, {60, 70, 44}};
    tools.emplace_back(clip);
    Drill drag = penAt<Drill>(170, 120, 9, {{{170, 120}, 0.3}, {{200, 135}, 1}, {{230, 118}, 0.6}});
    tools.emplace_back(drag);
    drag.keepsDigging = true;
    tools.emplace_back(drag);
    tools.emplace_back(penAt<Laser>(170, 120, 9, {{{170, 120}, 1}, {{225, 128}, 1}}));
    Scissors outside = scissorsAt(200, 150, 60);
    outside.cutsOutside = true;
    tools.emplace_back(outside);
    return tools;
}

TEST_F(FinerCutsTest, AreThoseOfTheFinestLevelAllOfWhichIsThere) {
    for (const Operation& tool : allTools()) {
        Head whole;
        InBricks inBricks;
        whole.apply(tool);
        const Outcome outcome = inBricks.document->apply(inCoarseSteps(tool));
        const auto difference = differenceOf(sculptureOf(whole), inBricks.cuts());
        EXPECT_GT(difference.cut, 30U) << name(tool);
        EXPECT_LT(difference.largeFraction, 0.002) << name(tool) << ' ' << difference.most;
        EXPECT_GT(outcome.voxelsTouched, difference.cut) << name(tool);
        EXPECT_TRUE(inBricks.document->detail()->failures().empty()) << name(tool);
    }
}

TEST_F(FinerCutsTest, AreRestoredUndoneAndRedone) {
    for (const Operation& tool : allTools()) {
        InBricks inBricks;
        Document& document = *inBricks.document;
        const auto coarse = [&] { return sculptureOf(document); };
        document.apply(scissorsAt(150, 180, 12));
        const auto before = inBricks.cuts();
        const auto coarseBefore = coarse();
        document.apply(inCoarseSteps(tool));
        const auto after = inBricks.cuts();
        const auto coarseAfter = coarse();
        EXPECT_NE(before, after) << name(tool);
        document.apply(Undo{});
        EXPECT_EQ(before, inBricks.cuts()) << name(tool);
        EXPECT_EQ(coarseBefore, coarse()) << name(tool);
        document.apply(Redo{});
        EXPECT_EQ(after, inBricks.cuts()) << name(tool);
        EXPECT_EQ(coarseAfter, coarse()) << name(tool);
        document.apply(UnCut{});
        EXPECT_TRUE(document.sculpture().isEmpty());
        document.apply(Undo{});
        EXPECT_EQ(after, inBricks.cuts()) << name(tool);
        if (!std::holds_alternative<Clip>(tool)) {
            document.apply(Undo{});
            document.apply(restoring(inCoarseSteps(tool)));
            EXPECT_NE(after, inBricks.cuts()) << name(tool);
        }
    }
}

// Where the scene's voxels lie, its sculpture has what lies there in the finer one, whatever was done.
TEST_F(FinerCutsTest, TheScenesSculptureIsDerivedFromThem) {
    InBricks inBricks;
    Document& document = *inBricks.document;
    const auto expectDerived = [&](const std::string& what) {
        const sculpt::FineSculpture& finer = *document.sculpture().finer();
        const Box3 box{glm::ivec3(0), document.sculpture().dims()};
        auto wanted = finer.sceneValues(box);
        sculpt::roundTo(sculpt::Precision::Bits16, wanted);
        EXPECT_EQ(sculptureOf(document), wanted) << what;
        // And its macrocells hold all that lies in them.
        const auto ranges = document.sculpture().cells().downloadAll<glm::vec2>();
        const auto fine = inBricks.cuts();
        const glm::ivec3 dims = inBricks.fine.geometry.dims;
        const glm::ivec3 cells = document.sculpture().cells().size();
        std::size_t outside = 0;
        forEachVoxel(inBricks.fine.geometry.box(), [&](glm::ivec3 v, std::size_t n) {
            const glm::ivec3 cell = glm::min(v / (2 * field::kCell), cells - 1);
            const glm::vec2 range =
                ranges[(std::size_t(cell.z) * std::size_t(cells.y) + std::size_t(cell.y)) *
                           std::size_t(cells.x) +
                       std::size_t(cell.x)];
            outside += fine[n] < range.x || fine[n] > range.y ? 1 : 0;
        });
        EXPECT_EQ(outside, 0U) << what;
        EXPECT_EQ(dims, finer.dims());
    };
    for (const Operation& tool : allTools()) {
        document.apply(inCoarseSteps(tool));
        expectDerived(std::string(name(tool)));
    }
    document.apply(Undo{});
    expectDerived("undone");
}

// A stroke in hand, step by step, becomes what the operation does that it is remembered as.
TEST_F(FinerCutsTest, AStrokeInHandBecomesItsOperation) {
    for (const bool isPeel : {false, true}) {
        InBricks inHand;
        LiveStroke& stroke = inHand.document->stroke();
        if (isPeel) {
            stroke.begin(inCoarseSteps(peelAt(200, 130, 14)));
            for (const double layers : {0.5, 3.0, 7.0, 2.25}) {
                stroke.peelTo(layers);
            }
        } else {
            stroke.begin(inCoarseSteps(penAt<Drill>(180, 120, 9)));
            for (int n = 0; n < 6; ++n) {
                stroke.drawAt({{180.0 + 9 * n, 120.0 + n}, 0.3 + 0.1 * n});
            }
        }
        stroke.commit();
        InBricks replayed;
        replayed.document->apply(inHand.document->log().back());
        const auto difference = differenceOf(inHand.cuts(), replayed.cuts());
        EXPECT_EQ(difference.most, 0) << isPeel;
        EXPECT_GT(difference.cut, 100U) << isPeel;
    }
}

// The pen, all over the head; what the scene's sculpture has in the end is kept from the moment before.
template <typename Op>
void drawOn(LiveStroke& stroke, const Operation& begun) {
    stroke.begin(begun);
    if constexpr (std::is_same_v<Op, Peel>) {
        stroke.peelTo(3);
        stroke.peelTo(5);
    } else if constexpr (std::is_same_v<Op, Clip>) {
        stroke.clipTo(std::get<Clip>(begun));
    } else {
        for (int n = 0; n < 6; ++n) {
            stroke.drawAt({{180.0 + 9 * n, 120.0 + n}, 0.3 + 0.1 * n});
        }
        stroke.setByHand();
        const auto straight = stroke.operation();
        const auto points = [](const auto& op) {
            if constexpr (requires { op.stroke.size(); }) {
                return op.stroke.size();
            }
            return std::size_t(0);
        };
        EXPECT_EQ(2U, std::visit(points, straight));
    }
}

// While it goes on, the level that is worked on has about what the finest will have; the finest has nothing
// of it, and pictures show the former.
TEST_F(FinerCutsTest, AStrokeInHandIsSeenAtOnceAndCutAtTheFinestWhenItEnds) {
    Clip clip;
    clip.box = Clip::Box{{5, 6, 4}, {30, 35, 22}};
    Drill drill = penAt<Drill>(180, 120, 9);
    Laser laser = penAt<Laser>(180, 120, 9);
    drill.stroke.clear();
    laser.stroke.clear();
    const std::vector<std::pair<Operation, void (*)(LiveStroke&, const Operation&)>> strokes = {
        {inCoarseSteps(peelAt(200, 130, 14)), drawOn<Peel>},
        {inCoarseSteps(drill), drawOn<Drill>},
        {inCoarseSteps(laser), drawOn<Laser>},
        {clip, drawOn<Clip>}};
    for (const auto& [begun, draw] : strokes) {
        const std::string what(name(begun));
        for (const bool isKept : {false, true}) {
            InBricks inHand;
            Document& document = *inHand.document;
            document.apply(scissorsAt(150, 180, 12));
            const auto before = inHand.cuts();
            const auto sceneBefore = sculptureOf(document);
            const auto cellsBefore = document.sculpture().cells().downloadAll<glm::vec2>();
            const std::uint64_t content = document.sculpture().contentVersion();
            draw(document.stroke(), begun);
            EXPECT_EQ(before, inHand.cuts()) << what;
            EXPECT_EQ(nullptr, document.frame({240, 180}).detail) << what;
            const auto rough = sculptureOf(document);
            EXPECT_NE(sceneBefore, rough) << what;
            if (!isKept) {
                document.stroke().discard();
                EXPECT_EQ(before, inHand.cuts()) << what;
                EXPECT_EQ(sceneBefore, sculptureOf(document)) << what;
                EXPECT_EQ(cellsBefore, document.sculpture().cells().downloadAll<glm::vec2>()) << what;
                EXPECT_EQ(content, document.sculpture().contentVersion()) << what;
            } else {
                const Outcome outcome = document.stroke().commit();
                EXPECT_GT(outcome.voxelsTouched, 0U) << what;
                EXPECT_NE(before, inHand.cuts()) << what;
                std::size_t cut = 0;
                std::size_t otherwise = 0;
                const auto now = sculptureOf(document);
                for (std::size_t n = 0; n < now.size(); ++n) {
                    cut += now[n] >= 0.5F ? 1 : 0;
                    otherwise += std::abs(now[n] - rough[n]) > 0.7F ? 1 : 0; // not beside a face
                }
                EXPECT_LT(double(otherwise), 0.03 * double(cut)) << what;
            }
            EXPECT_NE(nullptr, document.frame({240, 180}).detail) << what;
        }
    }
}

// A pen that was put down and drew nothing leaves nothing, though its operation would mean a stamp.
TEST_F(FinerCutsTest, APenThatDrawsNothingCutsNothing) {
    InBricks inHand;
    Drill drill = penAt<Drill>(180, 120, 9);
    drill.stroke.clear();
    inHand.document->stroke().begin(drill);
    EXPECT_EQ(0U, inHand.document->stroke().commit().voxelsTouched);
    EXPECT_TRUE(inHand.document->sculpture().isEmpty());
    EXPECT_TRUE(inHand.document->log().empty());
}

// Pictures at rest show them as pictures of the finest level would, with room for a few bricks or many.
TEST_F(FinerCutsTest, AreSeenAsTheyAre) {
    Head whole;
    InBricks roomy;
    InBricks tight(16, 40);
    render::RayCaster caster;
    const auto pictureOf = [&](Document& document) {
        View view = document.view();
        view.shadows = false; // what blocks the light is the scene
        document.showView(view);
        render::Frame frame = document.frame({240, 180});
        frame.scene.greyWindow = {0, 255}; // of its own histogram otherwise
        frame.samples = 2;
        caster.render(frame);
        return caster.readPicture();
    };
    for (const Operation& tool : allTools()) {
        whole.apply(tool);
        const auto wanted = pictureOf(whole);
        for (InBricks* inBricks : {&roomy, &tight}) {
            inBricks->document->apply(inCoarseSteps(tool));
            const auto difference = image::compare(wanted, pictureOf(*inBricks->document));
            EXPECT_LT(difference.mean, 0.1) << name(tool);
            EXPECT_LT(difference.changedFraction, 0.01) << name(tool);
        }
        whole.apply(Undo{});
        roomy.document->apply(Undo{});
        tight.document->apply(Undo{});
    }
}

} // namespace
} // namespace vs::studio
