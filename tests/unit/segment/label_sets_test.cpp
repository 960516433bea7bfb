// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/label_sets.h"

#include "property.h"

#include <gtest/gtest.h>

namespace vs::segment {
namespace {

TEST(LabelSets, HoldEachLabelInItsTightBox) {
    const glm::ivec3 dims(13, 9, 7);
    const int count = dims.x * dims.y * dims.z;
    test::checkProperty(5, [&] {
        std::vector<std::uint8_t> labels(std::size_t(count), 0);
        const auto label = rc::gen::element<std::uint8_t>(100, 200, 1, 3);
        for (const auto& [place, value] : *test::upTo(count / 4, rc::gen::pair(test::below(count), label))) {
            labels[std::size_t(place)] = value;
        }
        labels.back() = 255; // alone, in the grid's last corner
        const auto boxes = labelBoxes(labels, dims);
        for (int one = 1; one < 256; ++one) {
            VoxelSet expected = emptySet({glm::ivec3(0), dims});
            for (std::size_t i = 0; i < labels.size(); ++i) {
                expected.inside[i] = labels[i] == one ? 1 : 0;
            }
            const Box3& box = boxes[std::size_t(one)];
            RC_ASSERT(box == expected.tightBox());
            RC_ASSERT(setOf(labels, dims, std::uint8_t(one), box) == expected);
        }
    });
}

} // namespace
} // namespace vs::segment
