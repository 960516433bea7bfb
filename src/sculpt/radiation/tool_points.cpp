// SPDX-License-Identifier: Apache-2.0
#include "sculpt/radiation/tool_points.h"

#include "gl/pass.h"
#include "sculpt/radiation/radiation.h"
#include "sculpt/shaders/bindings.h"

namespace vs::sculpt {

static_assert(SweptPatches::kMaxPatchPoints <= Radiator::kMaxPoints);

PointGenerator::PointGenerator()
    : program_("sculpt/shaders/generate_tool_points.comp"), corners_(4, "tool corners"),
      patches_(4, "tool patches"), points_(4, "tool points") {}

void PointGenerator::generate(const SweptPatches& swept, const Consume& consume) {
    generate(swept, swept.patches(), swept.pointCount(), consume);
}

void PointGenerator::generateIn(const Box3& voxels, const SweptPatches& swept, const Consume& consume) {
    const Box3 points = swept.pointBox();
    if (intersect(points, voxels) == points) {
        generate(swept, consume);
        return;
    }
    const SweptPatches::Some some = swept.patchesIn(voxels);
    generate(swept, some.patches, some.pointCount, consume);
}

void PointGenerator::generate(const SweptPatches& swept, const std::vector<SweptPatch>& all,
                              std::size_t pointCount, const Consume& consume) {
    if (all.empty()) {
        return;
    }
    corners_.reserve(swept.corners().size() * sizeof(SweptCorner));
    corners_.write(std::span(swept.corners()));
    patches_.reserve(all.size() * sizeof(SweptPatch));
    patches_.write(std::span(all));
    points_.reserve(std::min(pointCount, Radiator::kMaxPoints) * sizeof(glm::vec4));
    const auto endOf = [&](std::size_t n) { return n < all.size() ? all[n].firstPoint : pointCount; };
    for (std::size_t first = 0; first < all.size();) {
        const std::size_t base = endOf(first);
        std::size_t last = first + 1;
        while (last < all.size() && endOf(last + 1) - base <= Radiator::kMaxPoints) {
            ++last;
        }
        {
            const gl::Pass pass("generate tool points");
            corners_.bindStorage(kCornersStorage);
            patches_.bindStorage(kPatchesStorage);
            points_.bindStorage(kToolPointsStorage);
            program_.set("firstPatch", int(first))
                .set("patchCount", int(last - first))
                .set("basePoint", static_cast<unsigned int>(base))
                .set("depths", glm::vec2(swept.depthLo(), swept.depthHi()))
                .set("orientation", float(swept.orientation()));
            program_.dispatchOver({int(last - first), 1, 1}, gl::Barrier::Storage);
        }
        consume(points_, endOf(last) - base);
        first = last;
    }
}

} // namespace vs::sculpt
