// SPDX-License-Identifier: Apache-2.0
// How much belongs to segments, found brick by brick at any level, is what Segmentation is for all of a
// level.
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"
#include "property.h"
#include "segment/finer/fine_growth.h"
#include "segment/membership/fine_membership.h"
#include "segment/membership/membership.h"
#include "volume/grid/reduced.h"

#include <fmt/format.h>

#include <cstdlib>
#include <map>

namespace vs::segment {
namespace {

using FineMembershipTest = test::GlTest;
using test::below;

constexpr int kSide = 16;
const glm::ivec3 kSize(53, 37, 46);

// A scan of which only the grid counts, growth at its finest level, and growth on all of that.
struct Grown {
    explicit Grown(const glm::dvec3& spacing = glm::dvec3(1))
        : volume(makeVolume(spacing)), field(field::uploadVolume(volume)), whole(field, GrowthEngine::Host),
          finest(
              std::make_unique<FineValues>(std::make_shared<volume::VolumeBricks>(volume, volume.geometry),
                                           field, volume.geometry, std::size_t(1) << 20),
              [] { return FineFence(); }, 0) {}

    static volume::Volume makeVolume(const glm::dvec3& spacing) {
        volume::Volume volume = randomVolume(kSize, volume::ScalarType::UInt8, 0, 100);
        for (int axis = 0; axis < 3; ++axis) {
            volume.geometry.worldFromVoxel[axis] *= spacing[axis] / volume.geometry.spacing()[axis];
        }
        return volume;
    }

    // What is `isIn` becomes the segment's, or is taken away.
    template <typename IsIn>
    void edit(std::uint8_t label, bool isToAdd, const IsIn& isIn) {
        whole.activate(label);
        finest.activate(label);
        std::map<std::uint32_t, FineGrowth::BrickEdit> edits;
        std::vector<std::uint8_t> inside;
        forEachVoxel(volume.geometry.box(), [&](glm::ivec3 v, std::size_t) {
            inside.push_back(isIn(v) ? 1 : 0);
            if (inside.back() != 0) {
                FineGrowth::BrickEdit& edit = edits[finest.brickOf(v)];
                edit.brick = finest.brickOf(v);
                set(isToAdd ? edit.given : edit.taken, cellOf(v & (field::kBrick - 1)));
            }
        });
        whole.paint(volume.geometry.box(), inside, isToAdd);
        std::vector<FineGrowth::BrickEdit> all;
        for (const auto& [brick, edit] : edits) {
            all.push_back(edit);
        }
        finest.edit(all);
    }
    void editAnything() {
        const auto label = std::uint8_t(1 + *below(3));
        const bool isToAdd = *below(4) != 0;
        const glm::dvec3 middle(*below(kSize.x), *below(kSize.y), *below(kSize.z));
        const double radius = 0.5 + *below(14);
        const glm::dvec3 flat(1, 1, 1 + *below(6)); // thin ones, too
        edit(label, isToAdd,
             [&](glm::ivec3 v) { return glm::length((glm::dvec3(v) - middle) * flat) <= radius; });
    }

    volume::Volume volume;
    field::Field field;
    Growth whole;
    FineGrowth finest;
};

field::BrickGrid gridOf(const volume::GridGeometry& level, const volume::GridGeometry& scene) {
    return *field::brickGrid(level, scene, kSide);
}

Looks anyLooks() {
    Looks looks = allOpaque();
    for (std::uint8_t label = 1; label <= 3; ++label) {
        looks[label] = Look(*below(3));
    }
    return looks;
}

// Calls visit(voxel, channel, texel) with each voxel of a level.
template <typename Visit>
void forEachTexel(const field::BrickOverlay& overlay, const field::BrickGrid& level, const Visit& visit) {
    const auto channels = int(gl::bytesPerTexel(overlay.format()));
    const int kinds = overlay.format() == gl::Format::RGBA8 ? 2 : 1;
    forEachVoxel(Box3{glm::ivec3(0), level.counts()}, [&](glm::ivec3 brick, std::size_t) {
        const auto texels = overlay.texelsOf(level, brick);
        const glm::ivec3 lo = brick * level.side;
        forEachVoxel(Box3{lo, lo + level.texels()}, [&](glm::ivec3 v, std::size_t i) {
            for (int channel = 0; channel < 2; ++channel) {
                const bool isThere = !texels.empty() && channel < kinds;
                visit(glm::min(v, level.dims - 1), channel,
                      isThere ? int(texels[i * std::size_t(channels) + std::size_t(channel)]) : 0);
            }
        });
    });
}

// Calls visit(voxel, label) with each voxel of a level.
template <typename Visit>
void forEachLabel(const field::BrickOverlay& overlay, const field::BrickGrid& level, const Visit& visit) {
    const std::size_t channels = gl::bytesPerTexel(overlay.format());
    const std::size_t kinds = overlay.format() == gl::Format::RGBA8 ? 2 : 1;
    forEachVoxel(Box3{glm::ivec3(0), level.counts()}, [&](glm::ivec3 brick, std::size_t) {
        const auto texels = overlay.texelsOf(level, brick);
        const glm::ivec3 lo = brick * level.side;
        forEachVoxel(Box3{lo, lo + level.texels()}, [&](glm::ivec3 v, std::size_t i) {
            visit(glm::min(v, level.dims - 1),
                  texels.empty() ? std::uint8_t(0) : std::uint8_t(texels[i * channels + kinds]));
        });
    });
}

TEST_F(FineMembershipTest, LabelsAreThoseOfTheVoxelsThatAreShown) {
    test::checkProperty(8, [] {
        Grown grown;
        for (int edits = 1 + *below(8); edits > 0; --edits) {
            grown.editAnything();
        }
        const auto labels = grown.finest.labelMap(grown.volume.geometry.box());
        FineShown shown;
        shown.looks = anyLooks();
        shown.hasTranslucent = *test::coin();
        const glm::ivec3 by = *test::coin() ? glm::ivec3(1) : glm::ivec3(4, 3, 2);
        const auto coarse = volume::reduced(grown.volume, by, volume::Reducing::Mean);
        const auto& scene = coarse.geometry;
        const auto overlay = fineMembership(grown.finest, gridOf(grown.volume.geometry, scene), shown);
        // How many voxels of each segment that is shown lie in each of the level.
        std::vector<std::array<int, 4>> counts(scene.box().volume());
        const auto indexOf = [&](glm::ivec3 v) {
            return (std::size_t(v.z) * std::size_t(scene.dims.y) + std::size_t(v.y)) *
                       std::size_t(scene.dims.x) +
                   std::size_t(v.x);
        };
        forEachVoxel(grown.volume.geometry.box(), [&](glm::ivec3 v, std::size_t i) {
            const bool isShown = labels[i] != 0 && shown.looks[labels[i]] != Look::Hidden;
            ++counts[indexOf(glm::min(v / by, scene.dims - 1))][isShown ? labels[i] : 0];
        });
        forEachLabel(*overlay, gridOf(scene, scene), [&](glm::ivec3 v, std::uint8_t label) {
            const auto& of = counts[indexOf(v)];
            const int all = of[0] + of[1] + of[2] + of[3];
            RC_ASSERT(label <= 3);
            RC_ASSERT(label == 0 || of[label] > 0);
            for (std::uint8_t one = 1; one <= 3; ++one) {
                RC_ASSERT(2 * of[one] <= all || label == one);
            }
            RC_ASSERT(by != glm::ivec3(1) || label == 0 || of[label] == 1);
        });
    });
}

TEST_F(FineMembershipTest, AtTheFinestLevelItIsTheSegmentation) {
    test::checkProperty(8, [] {
        Grown grown(*test::coin() ? glm::dvec3(1) : glm::dvec3(1, 1.5, 3));
        for (int edits = 1 + *below(8); edits > 0; --edits) {
            grown.editAnything();
        }
        FineShown shown;
        shown.looks = anyLooks();
        shown.hasTranslucent = true;
        shown.sceneSpacing = grown.volume.geometry.spacing();
        shown.smoothing = *test::coin() ? Smoothing::Smooth : Smoothing::Plain;
        const field::BrickGrid grid = gridOf(grown.volume.geometry, grown.volume.geometry);
        const auto overlay = fineMembership(grown.finest, grid, shown);
        Segmentation segmentation(grown.volume.geometry);
        segmentation.update(grown.whole, shown.smoothing, shown.looks);
        const auto texels = segmentation.texels().downloadAll<std::uint8_t>();
        const std::size_t channels = segmentation.texels().format() == gl::Format::RG8 ? 2 : 1;
        forEachTexel(*overlay, grid, [&](glm::ivec3 v, int channel, int texel) {
            const std::size_t i =
                (std::size_t(v.z) * std::size_t(kSize.y) + std::size_t(v.y)) * std::size_t(kSize.x) +
                std::size_t(v.x);
            const int wanted = channel < int(channels) ? texels[i * channels + std::size_t(channel)] : 0;
            // One may be rounded up where the other is rounded down.
            RC_ASSERT(std::abs(wanted - texel) <= 1);
            RC_ASSERT((wanted > 127) == (texel > 127));
        });
    });
}

// Members of a coarser level, by what is said of them: half of a voxel's finest ones, or any where it is
// thin.
std::vector<std::uint8_t> coarseMembers(const Grown& grown, const field::BrickGrid& level, glm::ivec3 by) {
    const auto labels = grown.finest.labelMap(grown.volume.geometry.box());
    const auto all = std::size_t(level.dims.x) * std::size_t(level.dims.y) * std::size_t(level.dims.z);
    std::vector<std::size_t> has(all);
    std::vector<std::size_t> size(all);
    const auto indexOf = [&](glm::ivec3 v) {
        return (std::size_t(v.z) * std::size_t(level.dims.y) + std::size_t(v.y)) * std::size_t(level.dims.x) +
               std::size_t(v.x);
    };
    forEachVoxel(grown.volume.geometry.box(), [&](glm::ivec3 v, std::size_t i) {
        const std::size_t in = indexOf(glm::min(v / by, level.dims - 1));
        ++size[in];
        has[in] += labels[i] != 0 ? 1 : 0;
    });
    std::vector<std::uint8_t> members(all);
    const Box3 box{glm::ivec3(0), level.dims};
    forEachVoxel(box, [&](glm::ivec3 v, std::size_t i) {
        bool isThin = has[i] > 0;
        forEachVoxel(intersect(grow(Box3{v, v + 1}, 1), box), [&](glm::ivec3 near, std::size_t) {
            isThin = isThin && 2 * has[indexOf(near)] < size[indexOf(near)];
        });
        members[i] = (2 * has[i] >= size[i] && has[i] > 0) || isThin ? 1 : 0;
    });
    return members;
}

TEST_F(FineMembershipTest, AtCoarserLevelsItIsThatOfTheirMembers) {
    test::checkProperty(8, [] {
        Grown grown;
        for (int edits = 1 + *below(6); edits > 0; --edits) {
            grown.editAnything();
        }
        const glm::ivec3 by = *test::coin() ? glm::ivec3(2) : glm::ivec3(4, 3, 2);
        const auto coarse = volume::reduced(grown.volume, by, volume::Reducing::Mean);
        const field::BrickGrid finest = gridOf(grown.volume.geometry, coarse.geometry);
        const field::BrickGrid level = gridOf(coarse.geometry, coarse.geometry);
        FineShown shown;
        shown.sceneSpacing = coarse.geometry.spacing();
        const auto overlay = fineMembership(grown.finest, finest, shown);
        const auto members = coarseMembers(grown, level, by);
        const Membership wanted(members, coarse.geometry, 1);
        forEachTexel(*overlay, level, [&](glm::ivec3 v, int channel, int texel) {
            const double exact = channel == 0 ? 255 * wanted.at(v) : 0;
            RC_ASSERT(std::abs(exact - texel) <= 1.01);
        });
    });
}

TEST_F(FineMembershipTest, WhatIsSaidToBeAlikeIs) {
    test::checkProperty(6, [] {
        Grown grown;
        const field::BrickGrid grid = gridOf(grown.volume.geometry, grown.volume.geometry);
        FineShown shown;
        shown.hasTranslucent = true;
        auto before = fineMembership(grown.finest, grid, shown);
        int alike = 0;
        for (int steps = 2 + *below(6); steps > 0; --steps) {
            grown.editAnything();
            if (*below(4) == 0) {
                shown.looks = anyLooks();
            }
            const auto now = fineMembership(grown.finest, grid, shown);
            const auto again = fineMembership(grown.finest, grid, shown);
            forEachVoxel(Box3{glm::ivec3(0), grid.counts()}, [&](glm::ivec3 brick, std::size_t) {
                RC_ASSERT(again->isAlike(*now, grid, brick));
                const bool isAlike = now->isAlike(*before, grid, brick);
                alike += isAlike ? 1 : 0;
                RC_ASSERT(!isAlike || (now->texelsOf(grid, brick) == before->texelsOf(grid, brick)));
            });
            // And what is outside of the box in which they differ.
            const Box3 changed = grow(changedBetween(*before, *now), 8);
            forEachVoxel(Box3{glm::ivec3(0), grid.counts()}, [&](glm::ivec3 brick, std::size_t) {
                const Box3 box{brick * kSide, (brick + 1) * kSide + 1};
                if (intersect(box, changed).isEmpty()) {
                    RC_ASSERT((now->texelsOf(grid, brick) == before->texelsOf(grid, brick)));
                }
            });
            before = now;
        }
        RC_CLASSIFY(alike > 0);
    });
}

// A rod that ends at a cut: on the face it is as wide as everywhere else, and what belongs to it is right.
TEST_F(FineMembershipTest, SegmentsGoOnBehindTheCutThatEndsThem) {
    Grown grown;
    const int end = 23;
    const auto isRod = [](glm::ivec3 v) {
        return glm::length(glm::dvec2(v.x - 20.3, v.y - 17.8)) < 7 && v.z > 3;
    };
    grown.edit(1, true, [&](glm::ivec3 v) { return isRod(v) && v.z < end; });
    const field::BrickGrid grid = gridOf(grown.volume.geometry, grown.volume.geometry);
    FineShown shown;
    shown.view = field::SculptureView::Cut;
    shown.fence = [&](const Box3& box) {
        std::vector<float> cuts;
        forEachVoxel(box, [&](glm::ivec3 v, std::size_t) { cuts.push_back(v.z >= end ? 1.0F : 0.0F); });
        return cuts;
    };
    std::map<std::array<int, 3>, int> texels;
    forEachTexel(*fineMembership(grown.finest, grid, shown), grid, [&](glm::ivec3 v, int channel, int texel) {
        if (channel == 0) {
            texels[{v.x, v.y, v.z}] = texel;
        }
    });
    int members = 0;
    forEachVoxel(Box3{{8, 6, 0}, {33, 30, end + 1}}, [&](glm::ivec3 v, std::size_t) {
        const int texel = texels.at({v.x, v.y, v.z});
        if (v.z > 10) { // far from the other end
            EXPECT_EQ(texel, texels.at({v.x, v.y, 11})) << v.x << " " << v.y << " " << v.z;
        }
        if (v.z < end) {
            EXPECT_EQ(texel > 127, isRod(v)) << v.x << " " << v.y << " " << v.z;
            members += texel > 127 ? 1 : 0;
        }
    });
    EXPECT_GT(members, 2000);
}

} // namespace
} // namespace vs::segment
