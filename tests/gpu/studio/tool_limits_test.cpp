// SPDX-License-Identifier: Apache-2.0
// Segments that tools spare, and segments that alone they take.
#include "gpu/studio/test_segments.h"
#include "gpu/studio/test_tools.h"
#include "segment/membership/membership.h"
#include "studio/document/live_stroke.h"

#include <algorithm>
#include <cmath>

namespace vs::studio {
namespace {

using Treatment = SegmentInfo::Treatment;
using ToolLimitsTest = ToolsTest;

constexpr const char* kBall = "Ball";
constexpr double kStored = 1 / 255.0 + 1e-3; // memberships have 8 bits, the sculpture 16

glm::ivec3 voxelAt(const volume::GridGeometry& geometry, std::size_t index) {
    return segment::VoxelSet{geometry.box(), {}}.voxelAt(index);
}

struct BallOfVoxels {
    glm::dvec3 centre{0};
    double radius = 2.5;

    [[nodiscard]] std::shared_ptr<volume::LabelMap> on(const volume::GridGeometry& geometry) const {
        auto map = std::make_shared<volume::LabelMap>();
        map->geometry = geometry;
        map->values = {0, 1};
        map->looks[1].name = kBall;
        map->labels.resize(geometry.voxelCount());
        for (std::size_t i = 0; i < map->labels.size(); ++i) {
            map->labels[i] = glm::length(glm::dvec3(voxelAt(geometry, i)) - centre) <= radius ? 1 : 0;
        }
        return map;
    }
};

UseSegment treating(Treatment treatment) {
    UseSegment use{kBall};
    use.treatment = treatment;
    use.goesToWork = false;
    return use;
}

UseSegment locking() {
    UseSegment use{kBall};
    use.isLocked = true;
    use.goesToWork = false;
    return use;
}

struct HeadWithBall : Head {
    explicit HeadWithBall(const BallOfVoxels& ball, const UseSegment& use) {
        LoadLabels load;
        load.map = ball.on(volume().geometry);
        apply(load);
        apply(use);
    }
};

// In the middle of what an operation changed.
BallOfVoxels ballIn(const std::vector<float>& before, const std::vector<float>& after,
                    const volume::GridGeometry& geometry) {
    glm::dvec3 sum(0);
    double count = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        if ((before[i] < 0.5F) != (after[i] < 0.5F)) {
            sum += glm::dvec3(voxelAt(geometry, i));
            count += 1;
        }
    }
    EXPECT_GT(count, 20);
    return {sum / count};
}

Clip allButASlab() {
    Clip clip;
    clip.box = Clip::Box{{-1, 30, -1}, {80, 90, 70}};
    return clip;
}

KeepConnected keepTheBrain() {
    KeepConnected keep;
    keep.voxel = glm::ivec3(35, 20, 29);
    keep.canvas = testCanvas();
    return keep;
}

// Each tool, cutting, and each that can restoring after a cut of all.
struct Case {
    std::vector<Operation> before;
    Operation operation;
};

std::vector<Case> cases() {
    Clip everything;
    everything.box = Clip::Box{{100, 100, 100}, {101, 101, 101}};
    std::vector<Case> all;
    for (const Operation& tool : toolsAt(200, 120)) {
        all.push_back({{}, tool});
        all.push_back({{penAt<Drill>(200, 120, 20)}, restoring(tool)});
    }
    all.push_back({{}, allButASlab()});
    all.push_back({{everything}, restoring(allButASlab())});
    return all;
}

// What an operation comes to within limits, by what it comes to without and the reference's membership.
void expectLimited(const Case& each, const BallOfVoxels& ball) {
    Head free;
    for (const Operation& operation : each.before) {
        free.apply(operation);
    }
    const auto before = sculptureOf(free);
    free.apply(each.operation);
    const auto whole = sculptureOf(free);
    const volume::GridGeometry& geometry = free.volume().geometry;
    const auto labels = ball.on(geometry)->labels;
    const segment::Membership membership(labels, geometry, 1);
    for (const UseSegment& use : {treating(Treatment::Spare), treating(Treatment::TakeOnly), locking()}) {
        const bool takesOnly = use.treatment == Treatment::TakeOnly;
        HeadWithBall head(ball, treating(Treatment::Take));
        for (const Operation& operation : each.before) {
            head.apply(operation);
        }
        head.apply(use);
        head.apply(each.operation);
        const auto limited = sculptureOf(head);
        int kept = 0;
        for (std::size_t i = 0; i < limited.size(); ++i) {
            const auto m = float(membership.at(voxelAt(geometry, i)));
            const float most = takesOnly ? m : 1 - m;
            const float wanted = whole[i] >= before[i] ? std::max(before[i], std::min(whole[i], most))
                                                       : std::min(before[i], std::max(whole[i], 1 - most));
            ASSERT_NEAR(limited[i], wanted, kStored) << name(each.operation) << " voxel " << i;
            if ((labels[i] != 0) != takesOnly) {
                ASSERT_EQ(limited[i] < 0.5F, before[i] < 0.5F) << "no voxel of what is spared changes";
                kept += (whole[i] < 0.5F) != (before[i] < 0.5F) ? 1 : 0;
            }
        }
        EXPECT_GT(kept, 5) << name(each.operation) << ": there was something to spare";
        head.apply(Undo{});
        EXPECT_EQ(sculptureOf(head), before);
    }
}

TEST_F(ToolLimitsTest, ToolsHaveNoMoreEnergyThanSegmentsLeaveThem) {
    for (const Case& each : cases()) {
        Head head;
        for (const Operation& operation : each.before) {
            head.apply(operation);
        }
        const auto before = sculptureOf(head);
        head.apply(each.operation);
        expectLimited(each, ballIn(before, sculptureOf(head), head.volume().geometry));
    }
}

TEST_F(ToolLimitsTest, IslandsAreLimitedToo) {
    // The brain is kept; the skull is not connected to it.
    expectLimited({{}, keepTheBrain()}, {{35.5, 10.5, 29.5}, 6});
}

// Along rays from the ball's centre the cut's face lies on the ball, which is known exactly.
TEST_F(ToolLimitsTest, FacesLieOnTheSegmentsSurfaceToTheSubVoxel) {
    const BallOfVoxels ball{{35.3, 39.6, 29.4}, 11};
    for (const bool takesOnly : {false, true}) {
        HeadWithBall head(ball, treating(takesOnly ? Treatment::TakeOnly : Treatment::Spare));
        Clip all;
        all.box = Clip::Box{{100, 100, 100}, {101, 101, 101}};
        head.apply(all);
        const auto values = sculptureOf(head);
        const segment::VoxelSet grid{head.volume().geometry.box(), {}};
        const auto at = [&](glm::dvec3 p) {
            const glm::ivec3 lo(glm::floor(p));
            const glm::dvec3 f = p - glm::dvec3(lo);
            double sum = 0;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::ivec3 o(corner & 1, corner >> 1 & 1, corner >> 2);
                const glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(o));
                sum += w.x * w.y * w.z * double(values[grid.indexOf(lo + o)]);
            }
            return sum;
        };
        double worst = 0;
        double mean = 0;
        constexpr int kRays = 500;
        for (int n = 0; n < kRays; ++n) { // evenly over the sphere (Fibonacci)
            const double z = 1 - 2 * (n + 0.5) / kRays;
            const double angle = n * 2.399963229728653;
            const double r = std::sqrt(1 - z * z);
            const glm::dvec3 way(r * std::cos(angle), r * std::sin(angle), z);
            double lo = ball.radius - 2;
            double hi = ball.radius + 2;
            ASSERT_EQ(at(ball.centre + lo * way) >= 0.5, takesOnly);
            ASSERT_EQ(at(ball.centre + hi * way) >= 0.5, !takesOnly);
            for (int step = 0; step < 30; ++step) {
                const double middle = 0.5 * (lo + hi);
                ((at(ball.centre + middle * way) >= 0.5) == takesOnly ? lo : hi) = middle;
            }
            worst = std::max(worst, std::abs(lo - ball.radius));
            mean += (lo - ball.radius) / kRays;
        }
        EXPECT_LT(worst, 0.5) << "a voxel's centre says where it belongs; its surface is within half a voxel";
        EXPECT_LT(std::abs(mean), 0.1);
    }
}

// Strokes in hand keep to the limits from their first stamp on, and end as their replay does.
TEST_F(ToolLimitsTest, LiveStrokesSpareFromTheFirstStampOn) {
    const auto pen = penAt<Drill>(200, 120, 12, {{{190, 118}, 1}, {{200, 120}, 1}, {{208, 124}, 0.7}});
    Head free;
    free.apply(pen);
    const auto ball =
        ballIn(std::vector<float>(sculptureOf(free).size()), sculptureOf(free), free.volume().geometry);
    HeadWithBall live(ball, locking());
    HeadWithBall replayed(ball, locking());
    const auto labels = ball.on(live.volume().geometry)->labels;
    auto begun = pen;
    begun.stroke.clear();
    live.stroke().begin(begun);
    for (const sculpt::PenPoint& point : pen.stroke) {
        live.stroke().drawAt(point);
        const auto values = sculptureOf(live);
        for (std::size_t i = 0; i < values.size(); ++i) {
            ASSERT_TRUE(labels[i] == 0 || values[i] < 0.5F) << i;
        }
    }
    live.stroke().commit();
    replayed.apply(pen);
    EXPECT_EQ(sculptureOf(live), sculptureOf(replayed));
    // What is unlocked is cut again.
    UseSegment unlocking = locking();
    unlocking.isLocked = false;
    replayed.apply(unlocking);
    replayed.apply(pen);
    int cut = 0;
    const auto values = sculptureOf(replayed);
    for (std::size_t i = 0; i < values.size(); ++i) {
        cut += labels[i] != 0 && values[i] >= 0.5F ? 1 : 0;
    }
    EXPECT_GT(cut, 20);
}

TEST_F(ToolLimitsTest, CuttingBySegmentsKeepsToTheLimitsToo) {
    const BallOfVoxels ball{{45, 30, 29}, 5};
    HeadWithBall head(ball, treating(Treatment::Spare));
    head.apply(UseSegment{"Brain"});
    test::grownBrain(head, 40);
    head.apply(CutSegment{false, 2});
    const auto values = sculptureOf(head);
    const auto labels = head.region().labelMap();
    std::size_t brain = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        ASSERT_TRUE(labels[i] != 1 || values[i] < 0.5F) << i;
        brain += labels[i] == 2 && values[i] >= 0.5F ? 1 : 0;
    }
    EXPECT_GT(brain, 1000U);
}

TEST_F(ToolLimitsTest, TakingOnlyWhatIsEmptyIsRefused) {
    Head head;
    UseSegment use{"Vessels"};
    use.treatment = Treatment::TakeOnly;
    head.apply(use);
    const std::string why = test::refusal(head, penAt<Drill>(200, 120, 10));
    EXPECT_NE(why.find("'Vessels', which is empty"), std::string::npos) << why;
    EXPECT_THROW(head.stroke().begin(penAt<Drill>(200, 120, 10)), Error);
    use.treatment = Treatment::Take;
    head.apply(use);
    EXPECT_GT(head.apply(penAt<Drill>(200, 120, 10)).voxelsTouched, 0U);
}

} // namespace
} // namespace vs::studio
