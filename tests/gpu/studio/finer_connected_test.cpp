// SPDX-License-Identifier: Apache-2.0
// What is kept because it is connected at the finest level of a scan that is worked on at a coarser one.
#include "gpu/gl_test.h"
#include "gpu/studio/cut_difference.h"
#include "gpu/studio/head_in_bricks.h"
#include "gpu/studio/test_segments.h"

#include <random>
#include <utility>

namespace vs::studio {
namespace {

using FinerConnectedTest = test::GlTest;

// Blobs and what joins them, some of it a voxel thin, with noise; the grid does not divide evenly.
volume::Volume blobs(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<glm::dvec4> balls;
    for (int n = 0; n < 14; ++n) {
        balls.emplace_back(random() % 71U, random() % 58U, random() % 49U, 2.5 + double(random() % 60U) / 10);
    }
    return phantom::makePhantom({71, 58, 49}, volume::ScalarType::UInt8, [=](glm::dvec3 p) {
        const auto noise = unsigned(p.x * 73 + p.y * 179 + p.z * 283 + seed) * 2654435761U >> 24U;
        for (std::size_t n = 0; n < balls.size(); ++n) {
            const glm::dvec3 a(balls[n]);
            const glm::dvec3 b(balls[(n + 1) % balls.size()]);
            const double along = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            const bool isThread = n % 3 == 0 && glm::length(p - glm::mix(a, b, along)) < 0.8;
            if (glm::length(p - a) < balls[n].w || isThread) {
                return 120.0 + noise % 20U;
            }
        }
        return noise > 250 ? 140.0 : 30.0;
    });
}

TEST_F(FinerConnectedTest, IsThatOfTheFinestLevel) {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        const volume::Volume scan = blobs(seed);
        Document whole(blobs(seed));
        InBricks inBricks(16, 400, blobs(seed));
        glm::ivec3 voxel(0);
        forEachVoxel(scan.geometry.box(), [&](glm::ivec3 v, std::size_t) {
            const bool isInside =
                scan.at(v) > 100 && scan.at(v + glm::min(glm::ivec3(1), scan.geometry.dims - 1 - v)) > 100;
            voxel = isInside && v.z < 25 ? v : voxel;
        });
        for (const bool isCutBefore : {false, true}) {
            const std::string what = std::to_string(seed) + (isCutBefore ? " cut" : "");
            if (isCutBefore) {
                Clip clip;
                clip.planes = {
                    {scan.geometry.worldFromVoxel * glm::dvec4(glm::dvec3(voxel) + glm::dvec3(4, 0, 0), 1),
                     glm::normalize(glm::dvec3(1, 0.3, 0.2))}};
                whole.apply(clip);
                inBricks.document->apply(clip);
            }
            KeepConnected keep;
            keep.canvas = testCanvas({100, 255});
            keep.connectivity = seed % 2 == 0 ? 6 : 26;
            keep.voxel = voxel;
            const auto before = inBricks.cuts();
            const std::size_t wanted = whole.apply(keep).voxelsTouched;
            keep.finest = std::exchange(keep.voxel, std::nullopt);
            const std::size_t cut = inBricks.document->apply(keep).voxelsTouched;
            EXPECT_GT(wanted, 1000U) << what;
            const auto difference = differenceOf(sculptureOf(whole), inBricks.cuts());
            EXPECT_LE(difference.largeFraction, isCutBefore ? 0.003 : 0) << what;
            if (!isCutBefore) {
                EXPECT_EQ(cut, wanted) << what;
                EXPECT_EQ(difference.most, 0) << what;
            }
            whole.apply(Undo{});
            inBricks.document->apply(Undo{});
            EXPECT_EQ(before, inBricks.cuts()) << what;
        }
    }
}

// As it is picked: what was found is remembered and found again, also where all of the finest level is there.
TEST_F(FinerConnectedTest, IsRememberedByItsFinestVoxel) {
    InBricks inBricks;
    KeepConnected keep;
    keep.pixel = {200, 130};
    keep.canvas = testCanvas();
    inBricks.document->apply(keep);
    const auto made = std::get<KeepConnected>(inBricks.document->log().back());
    ASSERT_TRUE(made.finest);
    InBricks again;
    again.document->apply(made);
    EXPECT_EQ(inBricks.cuts(), again.cuts());
    KeepConnected lost = keep;
    lost.finest = glm::ivec3(0);
    EXPECT_NE(test::refusal(*again.document, lost).find("voxel 0, 0, 0 is not in the displayed range"),
              std::string::npos);
}

} // namespace
} // namespace vs::studio
