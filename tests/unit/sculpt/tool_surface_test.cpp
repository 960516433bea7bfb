// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/tool_surface.h"

#include <gtest/gtest.h>

#include <random>

namespace vs::sculpt {
namespace {

constexpr glm::ivec3 kDims(128);

// A rough surface under a raster of 40 x 40 elements that does not reach the raster's rim by `margin`, with
// holes and steps in it, and a mask that is not zero anywhere over it.
struct Relief {
    explicit Relief(int margin) {
        constexpr int kSide = 40;
        mask.size = glm::ivec2(kSide + 2 * margin);
        mask.pitch = 0.5;
        const std::size_t count = std::size_t(mask.size.x) * std::size_t(mask.size.y);
        mask.values.assign(count, 0);
        points.resize(count);
        std::mt19937 random(7);
        std::uniform_real_distribution<float> any(0, 1);
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const std::size_t n =
                    std::size_t(j + margin) * std::size_t(mask.size.x) + std::size_t(i + margin);
                const float z = 40 + (any(random) < 0.2F ? 20.0F : any(random));
                const bool isHit = any(random) < 0.8F;
                mask.values[n] = 0.2F + 0.8F * any(random);
                points[n].voxel = isHit ? glm::vec4(40 + 0.5 * i, 40 + 0.5 * j, z, 1) : glm::vec4(0);
                points[n].normal = glm::vec4(0, 0, -1, 40);
            }
        }
    }

    [[nodiscard]] SweptPatches swept(const ToolSweep& sweep) const {
        return sweepSurface(points, mask, volume::makeGeometry(kDims), sweep);
    }

    MaskRaster mask;
    std::vector<field::SurfacePoint> points;
};

// A long cut is swept in parts of its raster, at whose rims the mask goes on. What lies beyond a rim counts
// as a margin where nothing is, not as what memory holds there: AddressSanitizer fails this on any look at
// it.
TEST(ToolSurface, AMaskUpToTheRimSweepsAsWithAMarginAroundIt) {
    const Relief tight(0);
    const Relief wide(kMaxBlock);
    const auto swept = [](const Relief& relief) {
        const std::vector<glm::vec3> ahead(relief.points.size(), {0, 0, 1}); // not smoothed over the mask
        ToolSweep sweep;
        sweep.direction = ToolDirection::OwnNormal;
        sweep.directions = ahead;
        return relief.swept(sweep);
    };
    EXPECT_GT(swept(tight).pointCount(), 1000U);
    EXPECT_EQ(swept(tight).pointCount(), swept(wide).pointCount());
    EXPECT_EQ(swept(tight).patches().size(), swept(wide).patches().size());
}

// Where all move the same way, what is in front goes on beyond its silhouettes, and ends at the rim.
TEST(ToolSurface, AMaskUpToTheRimMayHaveSkirts) { EXPECT_GT(Relief(0).swept({}).pointCount(), 1000U); }

} // namespace
} // namespace vs::sculpt
