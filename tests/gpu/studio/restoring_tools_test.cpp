// SPDX-License-Identifier: Apache-2.0
// Restoring what was cut, and strokes that dig on, follow the pen or look at the surface again.
#include "gpu/studio/sculpture_bytes.h"
#include "gpu/studio/test_tools.h"
#include "studio/document/surface_queries.h"

namespace vs::studio {
namespace {

// Nothing of a cut remains visible when the same stroke puts it back. Strokes that follow what they see see
// the cut's floor now, so they are given room to come up again.
TEST_F(ToolsTest, RestoreAfterCutLeavesNothingBehind) {
    auto tools = toolsAt(200, 130);
    Sweep across = sweepAcross(0, 0); // on a way that does not depend on what is seen
    across.mask = {Shape::Ellipse, {{-5, -5}, {5, 5}}};
    across.path = {SweepPath::Kind::Spline, {}, {{20, 20, 40}, {36, 12, 45}, {50, 20, 40}}};
    std::replace_if(
        tools.begin(), tools.end(), [](const auto& op) { return std::holds_alternative<Sweep>(op); }, across);
    for (const Operation& tool : tools) {
        Head document;
        document.apply(tool);
        const auto before = sculptureOf(document);
        Operation back = restoring(tool);
        std::visit(
            [](auto& op) {
                using Op = std::decay_t<decltype(op)>;
                if constexpr (std::is_same_v<Op, Peel>) {
                    op.layers = 40;
                    op.mask = ellipseAt(200, 130, 24, 24);
                } else if constexpr (std::is_same_v<Op, Drill> || std::is_same_v<Op, Laser>) {
                    op.depthMax = 40;
                    op.mask = ellipseAt(200, 130, 22, 22);
                } else if constexpr (std::is_same_v<Op, Scissors>) {
                    op.outline = ellipseAt(200, 130, 14, 14);
                    op.depth = op.depth ? std::optional(40.0) : std::nullopt;
                }
            },
            back);
        EXPECT_GT(document.apply(back).voxelsTouched, 100U) << name(tool);
        const auto after = sculptureOf(document);
        const auto& volume = document.volume();
        int cut = 0;
        int left = 0;
        for (std::size_t n = 0; n < after.size(); ++n) {
            const bool isObject = std::to_integer<int>(volume.bytes[n]) >= 50;
            cut += isObject && before[n] >= 0.5F ? 1 : 0;
            left += isObject && after[n] >= 0.5F ? 1 : 0;
        }
        EXPECT_GT(cut, 50) << name(tool);
        EXPECT_EQ(left, 0) << name(tool) << " of " << cut;
    }
}

TEST_F(ToolsTest, RestoreNeverPassesTheUncutSurface) {
    Head document;
    document.apply(scissorsAt(200, 130, 20)); // the air before and behind the head too
    Drill back = penAt<Drill>(200, 130, 10);
    back.restores = true;
    back.depthMax = 4000;
    back.canvas->view.range = {50, 255};
    document.apply(back);
    // Through the hole the far wall of nothing is seen: nothing to restore from.
    const auto seen = document.surface().probe({200, 130}, {400, 300});
    EXPECT_FALSE(seen.has_value());

    Head drilled;
    Drill drill = penAt<Drill>(200, 130, 14);
    drilled.apply(drill);
    const glm::dvec3 floor = drilled.surface().probe({200, 130}, {400, 300})->world;
    drill.restores = true;
    drill.depthMax = 2;
    drilled.apply(drill);
    const glm::dvec3 raised = drilled.surface().probe({200, 130}, {400, 300})->world;
    EXPECT_NEAR(glm::distance(floor, raised), 2, 0.3) << "steps of 1 mm";
    drill.depthMax = 1000;
    drilled.apply(drill);
    const glm::dvec3 whole = drilled.surface().probe({200, 130}, {400, 300})->world;
    Head untouched;
    EXPECT_LT(glm::distance(whole, untouched.surface().probe({200, 130}, {400, 300})->world), 0.05);
}

TEST_F(ToolsTest, KeepingOnDiggingGoesDeeper) {
    const auto depthOf = [](bool keepsDigging) {
        Head document;
        Drill drill = penAt<Drill>(200, 130, 12, {{{200, 130}, 0.5}, {{200, 130}, 0.6}, {{200, 130}, 0.5}});
        drill.keepsDigging = keepsDigging;
        drill.depthMax = 4;
        document.apply(drill);
        const auto place = document.surface().probe({200, 130}, {400, 300});
        Head whole;
        return glm::distance(place->world, whole.surface().probe({200, 130}, {400, 300})->world);
    };
    EXPECT_NEAR(depthOf(false), 2.4, 0.3);
    EXPECT_GT(depthOf(true), 5.5);
}

TEST_F(ToolsTest, PressureThatRisesFromZeroLooksAtTheSurfaceAgain) {
    Head once;
    once.apply(penAt<Drill>(200, 130, 12, {{{200, 130}, 0.15}, {{200, 130}, 0.15}}));
    Head twice;
    twice.apply(penAt<Drill>(200, 130, 12, {{{200, 130}, 0.15}, {{200, 130}, 0}, {{200, 130}, 0.15}}));
    const glm::dvec3 a = once.surface().probe({200, 130}, {400, 300})->world;
    const glm::dvec3 b = twice.surface().probe({200, 130}, {400, 300})->world;
    EXPECT_NEAR(glm::distance(a, b), 1.35, 0.3);
}

TEST_F(ToolsTest, TheDrillFollowsThePensTiltWhenAsked) {
    const auto cut = [](bool follows) {
        Head document;
        Drill drill = penAt<Drill>(200, 130, 8, {{{200, 130}, 1, {40, 0}}});
        drill.followsTilt = follows;
        document.apply(drill);
        return test::sculptureBytes(document);
    };
    Head upright;
    upright.apply(penAt<Drill>(200, 130, 8));
    EXPECT_TRUE(cut(false) == test::sculptureBytes(upright));
    EXPECT_FALSE(cut(true) == test::sculptureBytes(upright));
}

} // namespace
} // namespace vs::studio
