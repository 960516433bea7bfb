// SPDX-License-Identifier: Apache-2.0
// Growth at the finest level is growth on all of that level, voxel by voxel and generation by generation.
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"
#include "property.h"
#include "segment/finer/scene_view.h"
#include "segment/growth/growth_undo.h"
#include "volume/grid/reduced.h"

#include <fmt/format.h>

#include <functional>
#include <map>

namespace vs::segment {
namespace {

using FineGrowthTest = test::GlTest;
using test::below;

const glm::ivec3 kDims(75, 41, 66);

// A fence that lies along a slanted plane, with holes.
float cutAt(glm::ivec3 v, int seed) {
    return (v.x + v.y / 2 + seed) % 40 < 9 && (v.z + seed) % 13 != 0 ? 1.0F : 0.0F;
}

// Growth on a volume in one texture, and the same on what is read of it as growth gets there.
struct Both {
    Both(const volume::Volume& values, const field::Field& field, std::size_t frontBytes)
        : volume(values), whole(field, GrowthEngine::Host),
          finest(
              std::make_unique<FineValues>(std::make_shared<volume::VolumeBricks>(values, values.geometry),
                                           field, values.geometry, std::size_t(1) << 20),
              [this] {
                  return [seed = fence](const Box3& box) {
                      std::vector<float> cuts;
                      forEachVoxel(box, [&](glm::ivec3 v, std::size_t) { cuts.push_back(cutAt(v, seed)); });
                      return cuts;
                  };
              },
              frontBytes) {}

    void layFence(int seed) {
        fence = seed;
        std::vector<std::uint8_t> cuts;
        forEachVoxel(volume.geometry.box(),
                     [&](glm::ivec3 v, std::size_t) { cuts.push_back(cutAt(v, seed) > 0 ? 255 : 0); });
        sculpture = gl::Texture(kDims, gl::Format::R8, gl::Filter::Linear, "fence");
        sculpture.upload(volume.geometry.box(),
                         {reinterpret_cast<const std::byte*>(cuts.data()),
                          reinterpret_cast<const std::byte*>(cuts.data()) + cuts.size()});
    }
    void expectSame() const {
        RC_ASSERT(whole.activeLabel() == finest.label());
        RC_ASSERT(whole.playhead() == finest.state().playhead);
        RC_ASSERT(whole.extent() == finest.state().extent);
        RC_ASSERT(whole.isFinished() == finest.isFinished());
        RC_ASSERT(whole.state().voxels == finest.state().voxels);
        RC_ASSERT((whole.generations(false) == finest.generations(volume.geometry.box())));
        RC_ASSERT((whole.labelMap() == finest.labelMap(volume.geometry.box())));
    }

    const volume::Volume& volume;
    int fence = 0;
    gl::Texture sculpture;
    std::uint64_t fences = 0;
    Growth whole;
    FineGrowth finest;
};

struct Undos {
    GrowthUndo whole;
    FineUndo finest;
};

struct Call {
    std::string text;
    std::function<void(Both&, Undos&)> run;
};
void showValue(const Call& call, std::ostream& out) { out << call.text; }

glm::ivec3 drawVoxel() { return {*below(kDims.x), *below(kDims.y), *below(kDims.z)}; }

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
    const int fence = *below(3) == 0 ? 1 + *below(5) : 0;
    const bool keepsCutPart = *test::coin();
    return {fmt::format("rules {} to {}, {} {} {}, {} neighbours, fence {}", constraints.range.lo,
                        constraints.range.hi, constraints.difference.has_value(),
                        constraints.gradient.has_value(), constraints.gradientDifference.has_value(),
                        constraints.connectivity == Connectivity::Six ? 6 : 26, fence),
            [constraints, fence, keepsCutPart](Both& both, Undos& undos) {
                Constraints changed = constraints;
                if (fence > 0) {
                    both.layFence(fence);
                    changed.sculpture = &both.sculpture;
                    changed.sculptureVersion = ++both.fences;
                    changed.view = keepsCutPart ? field::SculptureView::Probe : field::SculptureView::Cut;
                }
                both.whole.setConstraints(changed, &undos.whole);
                both.finest.setConstraints(changed, &undos.finest);
            }};
}

Call drawLive() {
    const bool isLive = *test::coin();
    return {isLive ? "live" : "not live", [isLive](Both& both, Undos& undos) {
                both.whole.setLive(isLive, &undos.whole);
                both.finest.setLive(isLive, &undos.finest);
            }};
}

Call drawSeeds() {
    std::vector<glm::ivec3> seeds;
    std::string shown = "seeds";
    for (int left = 1 + *below(5); left > 0; --left) {
        seeds.push_back(drawVoxel() - (*below(20) == 0 ? 80 : 0));
        shown += fmt::format(" ({} {} {})", seeds.back().x, seeds.back().y, seeds.back().z);
    }
    return {shown, [seeds](Both& both, Undos& undos) {
                const SeedCounts whole = both.whole.addSeeds(seeds, &undos.whole);
                const SeedCounts finest = both.finest.addSeeds(seeds, &undos.finest);
                RC_ASSERT(whole.added == finest.added);
                RC_ASSERT(whole.present == finest.present);
                RC_ASSERT(whole.refused == finest.refused);
            }};
}

Call drawAdvance() {
    const int forward = *below(5) == 0 ? 1000 : 1 + *below(6);
    const std::uint64_t most = *below(3) == 0 ? std::uint64_t(*below(4000)) : Growth::kAnyNumber;
    return {fmt::format("advance by {} to {}", forward, most), [forward, most](Both& both, Undos& undos) {
                constexpr double kEver = 1e9;
                RC_ASSERT(both.whole.advanceFor(kEver, forward, &undos.whole, most) ==
                          both.finest.advanceFor(kEver, forward, &undos.finest, most));
            }};
}

Call drawPlayhead() {
    const int to = *below(14);
    return {fmt::format("playhead to {}", to), [to](Both& both, Undos& undos) {
                both.whole.setPlayhead(to, &undos.whole);
                both.finest.setPlayhead(to, &undos.finest);
            }};
}

Call drawAbsorption() {
    const std::vector<glm::ivec3> stroke{drawVoxel(), drawVoxel(), {20, 20, 20}};
    const int expansions = *below(6);
    return {fmt::format("absorb {}", expansions), [stroke, expansions](Both& both, Undos& undos) {
                RC_ASSERT(both.whole.absorb(stroke, expansions, &undos.whole) ==
                          both.finest.absorb(stroke, expansions, &undos.finest));
            }};
}

Call drawReset() {
    return {"reset", [](Both& both, Undos& undos) {
                both.whole.reset(&undos.whole);
                both.finest.reset(&undos.finest);
            }};
}

Call drawSegment() {
    const auto label = std::uint8_t(1 + *below(3));
    return {fmt::format("segment {}", label), [label](Both& both, Undos& undos) {
                both.whole.activate(label, &undos.whole);
                both.finest.activate(label, &undos.finest);
            }};
}

FineSet setOfBox(const Box3& box) {
    FineSet set(kDims);
    set.add(box, box, std::vector<std::uint8_t>(box.volume(), 1));
    return set;
}

// Makes the segment at work a box.
Call drawReplacing() {
    const glm::ivec3 lo = drawVoxel();
    const Box3 box = vs::intersect({lo, lo + 1 + *below(20)}, {glm::ivec3(0), kDims});
    return {fmt::format("replace by ({} {} {})", lo.x, lo.y, lo.z), [box](Both& both, Undos& undos) {
                both.whole.replace(box, std::vector<std::uint8_t>(box.volume(), 1), &undos.whole);
                both.finest.replace(setOfBox(box), &undos.finest);
            }};
}

// Paints a box, or takes it away.
Call drawPainting() {
    const glm::ivec3 lo = drawVoxel();
    const Box3 box = vs::intersect({lo, lo + 1 + *below(20)}, {glm::ivec3(0), kDims});
    const bool isToAdd = *test::coin();
    return {fmt::format("paint at ({} {} {}) {}", lo.x, lo.y, lo.z, isToAdd),
            [box, isToAdd](Both& both, Undos& undos) {
                both.whole.paint(box, std::vector<std::uint8_t>(box.volume(), 1), isToAdd, &undos.whole);
                both.finest.paint(setOfBox(box), isToAdd, &undos.finest);
            }};
}

rc::Gen<Call> anyCall() {
    using Draw = Call (*)();
    const auto draw = rc::gen::weightedElement<Draw>({{16, &drawAdvance},
                                                      {11, &drawSeeds},
                                                      {8, &drawRules},
                                                      {4, &drawLive},
                                                      {4, &drawAbsorption},
                                                      {4, &drawPlayhead},
                                                      {4, &drawSegment},
                                                      {2, &drawPainting},
                                                      {1, &drawReplacing},
                                                      {1, &drawReset}});
    return rc::gen::exec([draw] { return (*draw)(); });
}

// A volume of half the resolution, or of other ratios, and growth in it that shows the finest's.
struct Scene {
    Scene(const volume::Volume& finest, glm::ivec3 by)
        : volume(volume::reduced(finest, by, volume::Reducing::Mean)), field(field::uploadVolume(volume)),
          growth(field, GrowthEngine::Host), grid(*field::brickGrid(finest.geometry, volume.geometry, 32)),
          view(grid, volume.geometry.dims) {}

    volume::Volume volume;
    field::Field field;
    Growth growth;
    field::BrickGrid grid;
    SceneView view;
};

// Voxels of the scene: how many finest ones there are in each and which segments have how many of them.
void expectSeen(const Scene& scene, const FineGrowth& finest) {
    const glm::ivec3 dims = scene.volume.geometry.dims;
    const Box3 all = finest.dims() == glm::ivec3(0) ? Box3() : Box3{glm::ivec3(0), finest.dims()};
    const auto labels = finest.labelMap(all);
    const std::size_t voxels = std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z);
    std::vector<std::map<std::uint8_t, std::size_t>> shares(voxels);
    std::vector<std::size_t> sizes(voxels);
    const auto indexOf = [&](glm::ivec3 v) {
        return (std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
               std::size_t(v.x);
    };
    forEachVoxel(all, [&](glm::ivec3 v, std::size_t i) {
        const std::size_t in = indexOf(scene.view.sceneVoxelOf(v));
        ++sizes[in];
        if (labels[i] != 0) {
            ++shares[in][labels[i]];
        }
    });
    // The segment that has most of a voxel (of equal ones that with the smallest number), and whether half.
    const auto most = [&](std::size_t i) {
        std::pair<std::uint8_t, bool> found{};
        std::size_t share = 0;
        for (const auto& [label, count] : shares[i]) {
            if (count > share) {
                share = count;
                found = {label, 2 * count >= sizes[i]};
            }
        }
        return found;
    };
    // When those of the segment at work entered, of which as many count as make a half, or all.
    std::vector<std::vector<std::uint32_t>> entered(voxels);
    const auto generations = finest.generations(all);
    forEachVoxel(all, [&](glm::ivec3 v, std::size_t i) {
        if (labels[i] == finest.label()) {
            entered[indexOf(scene.view.sceneVoxelOf(v))].push_back(generations[i]);
        }
    });
    const auto seen = scene.growth.labelMap();
    const auto seenSince = scene.growth.generations(true);
    forEachVoxel(Box3{glm::ivec3(0), dims}, [&](glm::ivec3 v, std::size_t i) {
        RC_ASSERT(scene.view.finestIn(v).volume() == sizes[i]);
        const auto [label, hasHalf] = most(i);
        bool isThin = true;
        forEachVoxel(intersect(grow(Box3{v, v + 1}, 1), {glm::ivec3(0), dims}),
                     [&, own = label](glm::ivec3 near, std::size_t) {
                         isThin = isThin && most(indexOf(near)) != std::pair(own, true);
                     });
        RC_ASSERT(int(seen[i]) == int(hasHalf || isThin ? label : 0));
        if (seen[i] == finest.label()) {
            std::sort(entered[i].begin(), entered[i].end());
            RC_ASSERT(seenSince[i] == entered[i][std::min((sizes[i] + 1) / 2, entered[i].size()) - 1]);
        }
    });
}

TEST_F(FineGrowthTest, RandomLogsAreThoseOfTheWholeLevelAndUndoRestoresAll) {
    test::checkProperty(12, [] {
        const auto type = volume::kScalarTypes[std::size_t(*below(int(volume::kScalarTypes.size())))];
        const auto volume = randomVolume(kDims, type, 0, 100, unsigned(*below(100)));
        const field::Field field = field::uploadVolume(volume);
        Both both(volume, field, *test::coin() ? 0 : std::size_t(1) << 30); // lets go always, or never
        Scene scene(volume, *test::coin() ? glm::ivec3(2) : glm::ivec3(4, 3, 2));
        Constraints first;
        first.range = {0, 60};
        both.whole.setConstraints(first);
        both.finest.setConstraints(first);
        std::vector<Undos> undos;
        std::vector<std::vector<std::uint8_t>> maps;
        for (const Call& call : *test::upTo(40, anyCall())) {
            maps.push_back(both.finest.labelMap(volume.geometry.box()));
            undos.emplace_back();
            call.run(both, undos.back());
            both.expectSame();
            scene.view.update(both.finest, scene.growth);
        }
        RC_ASSERT(scene.growth.activeLabel() == both.finest.label());
        RC_ASSERT(scene.growth.voxelCount() == both.finest.voxelCount());
        expectSeen(scene, both.finest);
        for (; !undos.empty(); undos.pop_back(), maps.pop_back()) {
            undos.back().whole.undo(both.whole);
            both.finest.undo(undos.back().finest);
            both.expectSame();
            RC_ASSERT((both.finest.labelMap(volume.geometry.box()) == maps.back()));
        }
        scene.view.update(both.finest, scene.growth);
        expectSeen(scene, both.finest);
    });
}

} // namespace
} // namespace vs::segment
