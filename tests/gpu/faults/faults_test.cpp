// SPDX-License-Identifier: Apache-2.0
// No memory in the midst of an operation. Some allocations of each are tried; VS_FAULTS chooses how many, or
// "all", VS_FAULTS_SEED makes others of them be tried, VS_FAULTS_IN tries them only in acts with that in
// their name ("movie"). With VS_FAULTS_TOLD each one is told before it is tried.
#include "gpu/faults/acts.h"
#include "gpu/faults/everything.h"
#include "gpu/field/two_levels.h"
#include "gpu/studio/test_labels.h"
#include "gpu/studio/test_segments.h"
#include "gpu/studio/test_tools.h"
#include "studio/document/finer_levels.h"
#include "studio/document/live_growth.h"
#include "studio/document/live_stroke.h"

#include <set>

namespace vs::studio {
namespace {

using test::Memory;

TEST_P(Faults, LeaveTheDocumentAsItWas) {
    const test::LabelFile labels;
    std::vector<Act> acts;
    for (const Operation& operation : test::everything(labels.path())) {
        acts.push_back(actOf(operation, folder()));
    }
    refuseIn(acts);
}

// --- what is seen while it goes on

void undo(Document& document) { document.apply(Undo{}); }

// A stroke, drawn on with a picture in between; dropped where it cannot be ended.
Act strokeOf(const Operation& operation, const std::function<void(LiveStroke&, int)>& goOn) {
    return {"a stroke: " + std::string(name(operation)),
            [=](Document& document) {
                document.stroke().begin(operation);
                for (int n = 0; n < 3; ++n) {
                    goOn(document.stroke(), n);
                    document.frame({80, 60});
                }
                document.stroke().commit();
            },
            undo,
            [](Document& document) {
                if (document.stroke().isOpen()) {
                    document.stroke().discard();
                }
            }};
}

TEST_P(Faults, LeaveTheDocumentAsItWasInTheMidstOfAStroke) {
    Drill drill = penAt<Drill>(200, 140, 9);
    Laser laser = penAt<Laser>(185, 130, 9);
    drill.stroke = laser.stroke = {};
    const auto draws = [](LiveStroke& stroke, int n) {
        stroke.drawAt({{190 + 8 * n, 135 + 3 * n}, n == 1 ? 0.5 : 1});
    };
    Peel peel = test::somePeel(0);
    Clip clip;
    clip.planes = {{{35, 39, 50}, {0.2, 0.1, -1}}};
    const auto clips = [clip](LiveStroke& stroke, int n) {
        Clip next = clip;
        next.planes[0].point.z -= 8.0 * n;
        stroke.clipTo(next);
    };
    refuseIn({strokeOf(drill, draws), strokeOf(laser, draws),
              strokeOf(peel, [](LiveStroke& stroke, int n) { stroke.peelTo(5 - n); }),
              strokeOf(clip, clips)});
}

TEST_P(Faults, LeaveTheDocumentAsItWasInTheMidstOfASlider) {
    const Act scrubbing{"scrubbing",
                        [](Document& document) {
                            document.growing().scrub(3);
                            document.frame({80, 60});
                            document.growing().scrub(1);
                            document.growing().endScrub();
                        },
                        undo,
                        [](Document& document) {
                            if (document.growing().isScrubbing()) {
                                document.growing().dropScrub();
                            }
                        }};
    const auto replacing = [](int generation, int before) {
        return Act{"replacing", [=](Document& document) { document.replaceLast(ShowGeneration{generation}); },
                   [=](Document& document) { document.replaceLast(ShowGeneration{before}); }};
    };
    const Act further{"rewinding further", [](Document& document) { document.rewindFurther(1); }, undo};
    refuseIn({actOf(test::brainSeed(), folder()), actOf(Grow{8}, folder()), scrubbing,
              actOf(ShowGeneration{6}, folder()), replacing(3, 6), replacing(5, 3), further});
}

// A document that could not be shown its finer levels goes on without them, and can be shown them later.
TEST_P(Faults, LeaveADocumentWithoutFinerLevelsWhole) {
    const volume::Volume fine = test::testHead();
    const auto source = std::make_shared<test::TwoLevels>(fine);
    FinerLevels levels;
    levels.source = source;
    levels.options.side = 16;
    levels.options.deviceBytes = std::size_t(1) << 22;
    const Operation cut = test::somePeel(2);
    Document untouched(source->coarse());
    untouched.apply(cut);
    untouched.apply(cut);
    const auto wanted = contentOf(untouched);
    std::size_t failed = 0;
    bool isOver = false;
    for (std::size_t number = 1; !isOver; number += GetParam() == Memory::Host ? 97 : 1) {
        Document document(source->coarse());
        document.apply(cut);
        try {
            const test::RefusedAllocation refused(GetParam(), number);
            document.showFinerLevels(levels);
            isOver = !refused.hasHappened();
        } catch (const std::bad_alloc&) {
        } catch (const GlError&) {
        }
        if (isOver) {
            continue;
        }
        if (document.detail() == nullptr) {
            ++failed;
            ASSERT_EQ(document.sculpture().finer(), nullptr) << "allocation " << number;
            document.apply(cut);
            for (const auto& difference : differences(wanted, contentOf(document), "without", "after")) {
                ADD_FAILURE() << "allocation " << number << ": " << difference;
            }
            document.showFinerLevels(levels);
        }
        document.frame({80, 60});
        document.apply(cut);
        EXPECT_FALSE(document.sculpture().finer()->isEmpty()) << "allocation " << number;
    }
    EXPECT_GT(failed, 3U);
}

// Growth in portions. Where one throws, those before it can be ended, as one step that can be done again.
TEST_P(Faults, LeaveWhatHasGrownAsItWas) {
    const auto grow = [](Document& document) {
        document.growing().begin();
        for (int n = 0; n < 3; ++n) {
            document.growing().growFor(1e9, 2);
            document.frame({80, 60});
        }
        document.growing().end();
    };
    Document document(test::testHead());
    document.apply(test::brainSeed());
    document.apply(Grow{3});
    std::size_t ended = 0;
    bool isOver = false;
    for (std::size_t number = 1; !isOver; number += GetParam() == Memory::Host ? 7 : 1) {
        const auto before = contentOf(document);
        const std::size_t steps = before.stepsDone;
        try {
            const test::RefusedAllocation refused(GetParam(), number);
            grow(document);
            isOver = !refused.hasHappened();
        } catch (const std::bad_alloc&) {
        } catch (const GlError&) {
        }
        if (document.growing().isGrowing()) {
            document.growing().end();
            ++ended;
        }
        if (document.history().done().size() > steps) {
            const auto grown = document.region().labels();
            document.apply(Undo{});
            document.apply(Redo{});
            EXPECT_EQ(document.region().labels(), grown) << "allocation " << number;
            document.apply(Undo{});
        }
        auto after = contentOf(document);
        after.stepsUndone = before.stepsUndone;
        for (const auto& difference : differences(before, after, "before", "after")) {
            ADD_FAILURE() << "allocation " << number << ": " << difference;
        }
    }
    if (GetParam() == Memory::Host) {
        EXPECT_GT(ended, 5U);
    }
}

INSTANTIATE_TEST_SUITE_P(OnHostAndDevice, Faults, ::testing::Values(Memory::Host, Memory::Device),
                         [](const auto& tried) { return tried.param == Memory::Host ? "Host" : "Device"; });

TEST(FaultsOperations, AreAllThereAre) {
    std::set<std::string> tried;
    for (const Operation& operation : test::everything("labels.nrrd")) {
        tried.insert(name(operation));
    }
    for (const char* name : operationNames()) {
        EXPECT_TRUE(tried.contains(name)) << name;
    }
}

} // namespace
} // namespace vs::studio
