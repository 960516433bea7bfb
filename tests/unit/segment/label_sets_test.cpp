// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/label_sets.h"

#include <gtest/gtest.h>

#include <random>

namespace vs::segment {
namespace {

TEST(LabelSets, HoldEachLabelInItsTightBox) {
    const glm::ivec3 dims(13, 9, 7);
    std::mt19937 random(4);
    std::vector<std::uint8_t> labels(13 * 9 * 7, 0);
    for (std::uint8_t& label : labels) {
        label = random() % 5 == 0 ? std::uint8_t(random() % 3 * 100) : std::uint8_t(0);
    }
    labels.back() = 255; // alone, in the grid's last corner
    const auto boxes = labelBoxes(labels, dims);
    for (int label = 1; label < 256; ++label) {
        VoxelSet expected = emptySet({glm::ivec3(0), dims});
        for (std::size_t i = 0; i < labels.size(); ++i) {
            expected.inside[i] = labels[i] == label ? 1 : 0;
        }
        const Box3& box = boxes[std::size_t(label)];
        EXPECT_EQ(box, expected.tightBox()) << label;
        EXPECT_TRUE(setOf(labels, dims, std::uint8_t(label), box) == expected) << label;
    }
}

} // namespace
} // namespace vs::segment
