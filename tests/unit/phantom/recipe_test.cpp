// SPDX-License-Identifier: Apache-2.0
#include "phantom/recipe.h"

#include "base/error.h"
#include "base/names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace vs::phantom {
namespace {

// What can be made in a moment: a quarter of the usual voxels along each axis.
Recipe coarse(Kind kind) {
    Recipe recipe;
    recipe.kind = kind;
    recipe.dims = glm::max(about(kind).dims / 4, glm::ivec3(kLeastVoxels));
    return recipe;
}

class EveryKind : public testing::TestWithParam<Kind> {};

TEST_P(EveryKind, HasAValueAndAKnownLabelAtEachVoxel) {
    const Recipe recipe = coarse(GetParam());
    const LabelledVolume made = make(recipe);
    EXPECT_EQ(made.volume.geometry.dims, *recipe.dims);
    EXPECT_EQ(made.labels.size(), made.volume.geometry.voxelCount());
    EXPECT_EQ(made.volume.bytes.size(), made.labels.size() * volume::sizeOf(made.volume.type));
    EXPECT_LT(*std::max_element(made.labels.begin(), made.labels.end()), about(GetParam()).tissues.size());
    EXPECT_LT(made.volume.range.lo, made.volume.range.hi);
}

TEST_P(EveryKind, IsTheSameEachTime) {
    Recipe recipe = coarse(GetParam());
    recipe.noisePercent = 3;
    const LabelledVolume once = make(recipe);
    const LabelledVolume again = make(recipe);
    EXPECT_EQ(once.labels, again.labels);
    EXPECT_EQ(once.volume.bytes, again.volume.bytes);
}

TEST_P(EveryKind, NoiseChangesValuesAndNotWhatIsTrue) {
    Recipe recipe = coarse(GetParam());
    const LabelledVolume clean = make(recipe);
    recipe.noisePercent = 5;
    const LabelledVolume noisy = make(recipe);
    recipe.seed = 2;
    const LabelledVolume other = make(recipe);
    EXPECT_EQ(clean.labels, noisy.labels);
    EXPECT_NE(clean.volume.bytes, noisy.volume.bytes);
    EXPECT_NE(noisy.volume.bytes, other.volume.bytes);
}

// The same place has the same tissue at any resolution, but at borders.
TEST_P(EveryKind, CoversTheSameMillimetresAtAnyResolution) {
    const LabelledVolume coarseOne = make(coarse(GetParam()));
    Recipe fine = coarse(GetParam());
    *fine.dims *= 2;
    const LabelledVolume fineOne = make(fine);
    const auto& a = coarseOne.volume.geometry;
    const auto& b = fineOne.volume.geometry;
    EXPECT_NEAR(double(a.voxelCount()) * a.voxelMm3(), double(b.voxelCount()) * b.voxelMm3(),
                1e-6 * double(a.voxelCount()) * a.voxelMm3());
    const auto millilitres = [](const LabelledVolume& made) {
        const auto inside = std::count_if(made.labels.begin(), made.labels.end(),
                                          [](std::uint8_t label) { return label != 0; });
        return double(inside) * made.volume.geometry.voxelMm3() / 1000;
    };
    EXPECT_NEAR(millilitres(coarseOne), millilitres(fineOne), 0.02 * millilitres(fineOne));
}

INSTANTIATE_TEST_SUITE_P(Phantoms, EveryKind,
                         testing::Values(Kind::Head, Kind::Vessels, Kind::Abdomen, Kind::Skull),
                         [](const auto& kind) { return std::string(nameOf(kind.param)); });

TEST(Recipe, IsRefusedABiasWhereThereIsNone) {
    Recipe recipe = coarse(Kind::Vessels);
    recipe.biasPercent = 20;
    EXPECT_THROW(make(recipe), UsageError);
}

// What the experiments count on: each tissue is there at the usual resolution.
TEST(Recipe, MakesArteriesOfOnePieceThatAreBrighterThanTheirSurroundings) {
    Recipe recipe;
    recipe.kind = Kind::Vessels;
    const LabelledVolume made = make(recipe);
    std::array<double, 5> sum{};
    std::array<double, 5> count{};
    for (std::size_t i = 0; i < made.labels.size(); ++i) {
        sum.at(made.labels[i]) += double(std::uint8_t(made.volume.bytes[i]));
        count.at(made.labels[i]) += 1;
    }
    for (const double voxels : count) {
        EXPECT_GT(voxels, 1000);
    }
    EXPECT_GT(sum[3] / count[3], 2 * sum[2] / count[2]);
}

} // namespace
} // namespace vs::phantom
