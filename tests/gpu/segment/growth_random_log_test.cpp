// SPDX-License-Identifier: Apache-2.0
// Any log of calls gives what a plain queue gives that replays it, and undo takes each call back to the byte.
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"
#include "property.h"
#include "segment/growth/growth_undo.h"

#include <fmt/format.h>

#include <functional>

namespace vs::segment {
namespace {

using GrowthRandomLogTest = GrowthCase;
using test::below;

const glm::ivec3 kDims(45, 35, 40);

// The same growth on the device and in the reference.
struct LoggedPair {
    explicit LoggedPair(const volume::Volume& values, const field::Field& field)
        : volume(values), growth(field, GrowthRandomLogTest::GetParam()), queue(values.geometry.dims) {}

    void setRules(const Constraints& constraints, GrowthUndo* undo) {
        growth.setConstraints(constraints, undo);
        queue.setRules(admits(volume, constraints), constraints.connectivity == Connectivity::TwentySix,
                       admitsFrom(volume, constraints));
    }
    void expectSame() const {
        RC_ASSERT(growth.playhead() == queue.playhead());
        RC_ASSERT(growth.extent() == queue.extent());
        RC_ASSERT((growth.generations(false) == queue.generations()));
    }

    const volume::Volume& volume;
    Growth growth;
    reference::QueueGrowth queue;
};

// A call of both, recorded in the undo, and how a counterexample shows it.
struct Call {
    std::string text;
    std::function<void(LoggedPair&, GrowthUndo&)> run;
};

void showValue(const Call& call, std::ostream& out) { out << call.text; }

glm::ivec3 drawVoxel() { return {*below(kDims.x), *below(kDims.y), *below(kDims.z)}; }

std::string text(glm::ivec3 v) { return fmt::format("({} {} {})", v.x, v.y, v.z); }

Call drawRules() {
    Constraints constraints;
    constraints.range = {double(*below(30)), double(40 + *below(60))};
    constraints.connectivity = *test::coin() ? Connectivity::TwentySix : Connectivity::Six;
    if (*below(3) == 0) {
        constraints.difference = {-double(*below(40)), double(*below(40))};
    }
    if (*below(4) == 0) {
        constraints.gradient = {double(*below(10)), double(30 + *below(40))};
    }
    if (*below(4) == 0) {
        constraints.gradientDifference = {-double(*below(30)), double(*below(30))};
    }
    const auto shown = [](const std::optional<Range>& range) {
        return range ? fmt::format("{} to {}", range->lo, range->hi) : std::string("none");
    };
    return {fmt::format("rules: range {}, {} neighbours, difference {}, gradient {}, gradient difference {}",
                        shown(constraints.range), constraints.connectivity == Connectivity::Six ? 6 : 26,
                        shown(constraints.difference), shown(constraints.gradient),
                        shown(constraints.gradientDifference)),
            [constraints](LoggedPair& pair, GrowthUndo& undo) { pair.setRules(constraints, &undo); }};
}

Call drawLive() {
    const bool isLive = *test::coin();
    return {isLive ? "live" : "not live", [isLive](LoggedPair& pair, GrowthUndo& undo) {
                pair.growth.setLive(isLive, &undo);
                pair.queue.setLive(isLive);
            }};
}

Call drawAbsorption() {
    const std::vector<glm::ivec3> stroke{{20, 20, 20}, drawVoxel()};
    const int expansions = *below(6);
    return {fmt::format("absorb from {} by {}", text(stroke[1]), expansions),
            [stroke, expansions](LoggedPair& pair, GrowthUndo& undo) {
                RC_ASSERT(pair.growth.absorb(stroke, expansions, &undo) ==
                          pair.queue.absorb(stroke, expansions));
            }};
}

// An edit that turns an eighth of the voxels over.
Call drawReplacement() {
    const int seed = *below(1000);
    return {fmt::format("replace with noise {}", seed), [seed](LoggedPair& pair, GrowthUndo& undo) {
                std::mt19937 random{std::mt19937::result_type(seed)};
                std::vector<std::uint8_t> inside = pair.growth.labels();
                for (std::uint8_t& value : inside) {
                    value = random() % 8 == 0 ? 1 - value : value;
                }
                pair.growth.replace(pair.volume.geometry.box(), inside, &undo);
                pair.queue.replace(inside);
            }};
}

Call drawSeeds() {
    std::vector<glm::ivec3> seeds;
    std::string shown = "seeds";
    for (int left = 1 + *below(5); left > 0; --left) {
        seeds.push_back(drawVoxel());
        shown += fmt::format(" {}", text(seeds.back()));
    }
    return {shown, [seeds](LoggedPair& pair, GrowthUndo& undo) {
                pair.growth.addSeeds(seeds, &undo);
                pair.queue.addSeeds(seeds);
            }};
}

Call drawStepBack() {
    const int back = *below(6);
    return {fmt::format("step back by {}", back), [back](LoggedPair& pair, GrowthUndo& undo) {
                pair.growth.takeBack(back, &undo);
                pair.queue.takeBack(back);
            }};
}

Call drawPlayhead() {
    const int to = *below(12);
    return {fmt::format("playhead to {}", to), [to](LoggedPair& pair, GrowthUndo& undo) {
                pair.growth.setPlayhead(to, &undo);
                pair.queue.setPlayhead(to);
            }};
}

Call drawReset() {
    return {"reset", [](LoggedPair& pair, GrowthUndo& undo) {
                pair.growth.reset(&undo);
                pair.queue.reset();
            }};
}

Call drawAdvance() {
    const int forward = 1 + *below(4);
    return {fmt::format("advance by {}", forward), [forward](LoggedPair& pair, GrowthUndo& undo) {
                RC_ASSERT(pair.growth.advance(forward, &undo) == pair.queue.advance(forward));
            }};
}

rc::Gen<Call> anyCall() {
    using Draw = Call (*)();
    const auto draw = rc::gen::weightedElement<Draw>({{16, &drawAdvance},
                                                      {11, &drawSeeds},
                                                      {8, &drawRules},
                                                      {4, &drawLive},
                                                      {4, &drawAbsorption},
                                                      {4, &drawStepBack},
                                                      {4, &drawPlayhead},
                                                      {1, &drawReplacement},
                                                      {1, &drawReset}});
    return rc::gen::exec([draw] { return (*draw)(); });
}

struct Moment {
    GrowthState state;
    std::vector<std::uint32_t> map;
    GrowthUndo undo;
};

TEST_P(GrowthRandomLogTest, RandomLogsEqualTheQueueAndUndoRestoresEveryByte) {
    const auto volume = randomVolume(kDims, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    test::checkProperty(12, [&] {
        LoggedPair pair(volume, field);
        Constraints first;
        first.range = {0, 60};
        pair.setRules(first, nullptr);
        std::vector<Moment> moments;
        for (const Call& call : *test::upTo(80, anyCall())) {
            moments.push_back({pair.growth.state(), pair.growth.generations(false), {}});
            call.run(pair, moments.back().undo);
            pair.expectSame();
        }
        for (; !moments.empty(); moments.pop_back()) {
            moments.back().undo.undo(pair.growth);
            RC_ASSERT((pair.growth.generations(false) == moments.back().map));
            RC_ASSERT((pair.growth.state() == moments.back().state));
        }
    });
}

INSTANTIATE_TEST_SUITE_P(OnDeviceAndHost, GrowthRandomLogTest, kEngines, nameOfEngine);

} // namespace
} // namespace vs::segment
