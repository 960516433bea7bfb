// SPDX-License-Identifier: Apache-2.0
// Growth on the host and on the device: any log of calls leaves the same bytes in the seed map.
#include "gpu/segment/growth_cases.h"
#include "property.h"
#include "segment/growth/growth_snapshot.h"
#include "segment/growth/growth_undo.h"
#include "segment/growth/saved_brick.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <functional>

namespace vs::segment {
namespace {

using GrowthEnginesTest = test::GlTest;
using test::below;

const glm::ivec3 kGrid(70, 41, 66);

// A sculpture of which a random half is cut away, in clumps.
gl::Texture clumps() {
    gl::Texture sculpture(kGrid, gl::Format::R16F, gl::Filter::Nearest, "sculpture");
    std::mt19937 random(3);
    std::vector<float> noise(512);
    std::generate(noise.begin(), noise.end(), [&] { return float(random() % 257) / 256.0F; });
    std::vector<std::uint16_t> texels;
    forEachVoxel({glm::ivec3(0), kGrid}, [&](glm::ivec3 v, std::size_t) {
        const glm::ivec3 clump = v / 11;
        texels.push_back(
            glm::packHalf1x16(noise[std::size_t(clump.x * 49 + clump.y * 7 + clump.z) % noise.size()]));
    });
    sculpture.upload({glm::ivec3(0), kGrid}, std::as_bytes(std::span(texels)));
    return sculpture;
}

// Both at once; what each says must be equal.
class Both {
public:
    explicit Both(const field::Field& field)
        : host_(field, GrowthEngine::Host), device_(field, GrowthEngine::Device) {}

    template <typename Call>
    void call(const Call& call) {
        undos_.emplace_back();
        RC_ASSERT(call(host_, &undos_.back()[0]) == call(device_, &undos_.back()[1]));
    }
    void undo() {
        if (!undos_.empty()) {
            undos_.back()[0].undo(host_);
            undos_.back()[1].undo(device_);
            undos_.pop_back();
        }
    }

    void expectSame() const {
        GrowthState state = host_.state();
        RC_ASSERT((*state.seeds == *device_.state().seeds));
        state.seeds = device_.state().seeds;
        RC_ASSERT(state == device_.state());
        const BrickTable& bricks = host_.seedMap().bricks();
        RC_ASSERT(bricks.occupied() == device_.seedMap().bricks().occupied());
        for (std::uint32_t brick = 0; brick < bricks.count(); ++brick) {
            RC_ASSERT(bricks.span(brick) == device_.seedMap().bricks().span(brick));
            RC_ASSERT((host_.seedMap().saveBrick(brick) == device_.seedMap().saveBrick(brick)));
        }
        RC_ASSERT((host_.labelMap() == device_.labelMap()));
    }

private:
    Growth host_;
    Growth device_;
    std::vector<std::array<GrowthUndo, 2>> undos_;
};

glm::ivec3 anyVoxel() { return {*below(kGrid.x), *below(kGrid.y), *below(kGrid.z)}; }

std::vector<glm::ivec3> anyVoxels(int most) {
    std::vector<glm::ivec3> voxels;
    for (int left = 1 + *below(most); left > 0; --left) {
        voxels.push_back(anyVoxel());
    }
    return voxels;
}

Constraints anyRules(const gl::Texture& sculpture) {
    Constraints rules;
    rules.range = {double(*below(30)), double(45 + *below(60))};
    rules.connectivity = *test::coin() ? Connectivity::TwentySix : Connectivity::Six;
    if (*below(4) == 0) {
        rules.difference = {-double(*below(40)), double(*below(40))};
    }
    if (*below(4) == 0) {
        rules.gradient = {double(*below(10)), double(30 + *below(40))};
    }
    if (*below(5) == 0) {
        rules.gradientDifference = {-double(*below(30)), double(*below(30))};
    }
    if (*below(3) == 0) {
        rules.sculpture = &sculpture;
        rules.sculptureVersion = 1;
        rules.view = *test::coin() ? field::SculptureView::Cut : field::SculptureView::Probe;
    }
    return rules;
}

// Makes a box of a few bricks, filled by noise.
void paintNoise(Both& both) {
    const glm::ivec3 a = anyVoxel();
    const Box3 box{a, glm::min(a + 1 + glm::ivec3(*below(20), *below(20), *below(20)), kGrid)};
    std::mt19937 random{std::mt19937::result_type(*below(1000))};
    std::vector<std::uint8_t> inside(box.volume());
    std::generate(inside.begin(), inside.end(), [&] { return std::uint8_t(random() % 3 != 0); });
    const bool isToAdd = *test::coin();
    both.call([&](Growth& growth, GrowthUndo* undo) {
        growth.paint(box, inside, isToAdd, undo);
        return 0;
    });
}

void doSomething(Both& both, const gl::Texture& sculpture) {
    const auto call = [&](auto&& change) {
        both.call([&](Growth& growth, GrowthUndo* undo) {
            change(growth, undo);
            return 0;
        });
    };
    switch (*below(12)) {
    case 0: {
        const Constraints rules = anyRules(sculpture);
        return call([&](Growth& g, GrowthUndo* undo) { g.setConstraints(rules, undo); });
    }
    case 1: {
        const bool isLive = *test::coin();
        return call([&](Growth& g, GrowthUndo* undo) { g.setLive(isLive, undo); });
    }
    case 2: {
        const auto voxels = anyVoxels(3);
        const int expansions = *below(8);
        return both.call([&](Growth& g, GrowthUndo* undo) { return g.absorb(voxels, expansions, undo); });
    }
    case 3: {
        const auto label = std::uint8_t(1 + *below(3));
        return call([&](Growth& g, GrowthUndo* undo) { g.activate(label, undo); });
    }
    case 4:
        return paintNoise(both);
    case 5: {
        const int generation = *below(40);
        return call([&](Growth& g, GrowthUndo* undo) { g.setPlayhead(generation, undo); });
    }
    case 6:
        return both.undo();
    case 7:
    case 8: {
        const auto voxels = anyVoxels(400);
        return both.call([&](Growth& g, GrowthUndo* undo) {
            const SeedCounts counts = g.addSeeds(voxels, undo);
            return std::array{counts.added, counts.present, counts.refused};
        });
    }
    default: {
        const int generations = 1 + *below(30);
        return both.call([&](Growth& g, GrowthUndo* undo) { return g.advance(generations, undo); });
    }
    }
}

TEST_F(GrowthEnginesTest, AnyLogLeavesTheSameBytes) {
    using enum volume::ScalarType;
    const gl::Texture sculpture = clumps();
    for (const auto type : {UInt8, Int16, Float32}) {
        const auto volume = randomVolume(kGrid, type, 0, 100, 11);
        const field::Field field = field::uploadVolume(volume);
        test::checkProperty(5, [&] {
            Both both(field);
            both.call([&](Growth& growth, GrowthUndo* undo) {
                growth.setConstraints({.range = {0, 70}}, undo);
                return 0;
            });
            for (int calls = 10 + *below(30); calls > 0; --calls) {
                doSomething(both, sculpture);
                both.expectSame();
            }
        });
    }
}

} // namespace
} // namespace vs::segment
