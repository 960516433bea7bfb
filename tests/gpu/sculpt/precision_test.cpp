// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/layered_cut.h"
#include "tool_fixture.h"

#include <algorithm>

namespace vs::sculpt {
namespace {

const glm::ivec3 kPrecisionDims(72, 68, 48);
const MaskRaster kPrecisionDisc = rasterize(circleOutline({36, 34}, 14), 0.5);

// Each precision of the sculpture.
class PrecisionTest : public test::GlTest, public testing::WithParamInterface<Precision> {
protected:
    // Half a step of what is stored, near 1.
    static float rounding() {
        return GetParam() == Precision::Bits8    ? 0.5F / 255
               : GetParam() == Precision::Bits16 ? 1.0F / 4096
                                                 : 0;
    }
};

TEST_P(PrecisionTest, CutsAreTheRadiationRoundedToWhatIsStored) {
    test::Workpiece piece(kPrecisionDims, glm::dvec3(1), GetParam());
    EXPECT_EQ(piece.sculpture.precision(), GetParam());
    EXPECT_EQ(piece.sculpture.texels().format(), formatOf(GetParam()));
    const Box3 box = piece.cut(test::slabUnder(kPrecisionDisc, 15.3), kPrecisionDisc, test::drill(9));
    const auto energies = piece.cutter.radiator().download(box);
    const auto values = piece.sculpture.values(box);
    float worst = 0;
    std::size_t changed = 0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        const float wanted = std::clamp(energies[n], 0.0F, 1.0F);
        changed += values[n] != 0 ? 1 : 0;
        worst = std::max(worst, std::abs(values[n] - (values[n] == 0 ? 0 : wanted)));
        ASSERT_TRUE(values[n] != 0 || wanted <= 0.5F / 255) << wanted;
    }
    EXPECT_LE(worst, rounding() * 1.01F);
    EXPECT_EQ(piece.sculpture.changedVoxels(), changed);
    EXPECT_GT(changed, 5000U);
}

TEST_P(PrecisionTest, AgainChangesNothingAndRestoringLeavesNothingCut) {
    test::Workpiece piece(kPrecisionDims, glm::dvec3(1), GetParam());
    const auto surface = test::slabUnder(kPrecisionDisc, 15.3);
    auto how = test::drill(9);
    piece.cut(surface, kPrecisionDisc, how);
    const auto once = piece.bytes();
    piece.cut(surface, kPrecisionDisc, how);
    EXPECT_EQ(piece.sculpture.changedVoxels(), 0U);
    EXPECT_TRUE(piece.bytes() == once);
    how.how = Combine::Restore;
    piece.cut(surface, kPrecisionDisc, how);
    const auto values = piece.values();
    const float most = *std::max_element(values.begin(), values.end());
    EXPECT_LE(most, justVisible(GetParam()));
    EXPECT_GT(most, 0.4F) << "half-way values remain, just visible";
    EXPECT_LT(justVisible(GetParam()), 0.5F);
}

TEST_P(PrecisionTest, UndoAndLayersAreExactToTheLastByte) {
    test::Workpiece piece(kPrecisionDims, glm::dvec3(1), GetParam());
    piece.cut(test::slabUnder(kPrecisionDisc, 12), kPrecisionDisc, test::drill(4));
    gl::Texture earlier(kPrecisionDims, formatOf(GetParam()), gl::Filter::Nearest, "earlier");
    earlier.copyFrom(piece.sculpture.texels(), piece.geometry.box(), glm::ivec3(0));
    const auto before = piece.bytes();
    const auto mask = rasterize(circleOutline({40, 30}, 15), 0.5);
    const auto surface = test::sphereUnder(mask, {36, 34, 50}, 40);
    BrickBackup backup(piece.sculpture.texels());
    const auto peel = [&](std::initializer_list<double> depths) {
        LayeredCut cut(surface, mask, test::peel(1).sweep, piece.geometry, &earlier);
        for (const double depth : depths) {
            cut.cutTo(depth, piece.cutter.radiator(), piece.cutter.generator(), piece.sculpture, &backup);
        }
        return piece.bytes();
    };
    const auto peeled = peel({2.2, 10, 5.5});
    BrickDelta delta = backup.finish();
    EXPECT_GT(delta.changedVoxels(), 1000U);
    piece.sculpture.swap(delta);
    EXPECT_TRUE(piece.bytes() == before);
    EXPECT_TRUE(peel({5.5}) == peeled);
    backup.restore();
    backup.finish();
    piece.sculpture.swap(delta);
    EXPECT_TRUE(piece.bytes() == peeled);
}

std::string nameOf(const testing::TestParamInfo<Precision>& of) {
    return of.param == Precision::Bits8 ? "Bits8" : of.param == Precision::Bits16 ? "Bits16" : "Bits32";
}

INSTANTIATE_TEST_SUITE_P(Each, PrecisionTest,
                         testing::Values(Precision::Bits8, Precision::Bits16, Precision::Bits32), nameOf);

} // namespace
} // namespace vs::sculpt
