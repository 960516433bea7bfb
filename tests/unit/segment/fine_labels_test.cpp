// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "phantom/phantom.h"
#include "property.h"
#include "segment/edits/fine_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vs::segment {
namespace {

using volume::ScalarType;

// A map of balls, by a function from their numbers to values, whose grid ends within blocks.
template <typename ValueOf>
volume::Volume mapOf(ScalarType type, unsigned seed, const ValueOf& valueOf) {
    return phantom::makePhantom({70, 66, 40}, type, [&](glm::dvec3 p) {
        const glm::ivec3 cell(p / 13.0);
        const unsigned n = (unsigned(cell.x) * 7 + unsigned(cell.y) * 13 + unsigned(cell.z) * 31 + seed) % 9;
        const bool isInBall = glm::length(p - (glm::dvec3(cell) + 0.5) * 13.0) < 5.7;
        return isInBall ? double(valueOf(int(n))) : 0.0;
    });
}

// A source that knows where there is nothing, and must not be asked there.
class Sparse : public volume::VolumeBricks {
public:
    Sparse(const volume::Volume& volume, int emptyFrom) : VolumeBricks(volume, volume.geometry) {
        known_.side = 8;
        known_.cells = divideUp(volume.geometry.dims, 8);
        known_.type = ScalarType::UInt8;
        forEachVoxel({glm::ivec3(0), known_.cells}, [&](glm::ivec3 cell, std::size_t) {
            known_.ranges.push_back(std::byte(0));
            known_.ranges.push_back(std::byte(cell.x * 8 >= emptyFrom ? 0 : 255));
        });
    }
    [[nodiscard]] std::optional<volume::CellExtremes> extremes() const override { return known_; }
    [[nodiscard]] std::vector<std::byte> read(int level, const Box3& box) const override {
        asked_ = unite(asked_, box);
        return VolumeBricks::read(level, box);
    }
    [[nodiscard]] Box3 asked() const { return asked_; }

private:
    volume::CellExtremes known_;
    mutable Box3 asked_; // of one block at a time: see the test
};

TEST(FineLabels, AreThoseOfTheMapHoweverItIsRead) {
    test::checkProperty(10, [] {
        const auto seed = unsigned(*test::below(1000));
        const ScalarType type = *test::below(2) == 0 ? ScalarType::Int16 : ScalarType::Float32;
        const auto valueOf = [](int n) { return n == 0 ? 0 : 40 * n - 100; };
        const volume::Volume map = mapOf(type, seed, valueOf);
        const LabelSets sets = labelSets(volume::VolumeBricks(map, map.geometry), 0, 255);
        // In memory, by the numbers of the values.
        std::vector<std::int64_t> values{0};
        for (const auto& [value, set] : sets) {
            values.push_back(value);
        }
        std::vector<std::uint8_t> labels;
        std::uint64_t count = 0;
        forEachVoxel(map.geometry.box(), [&](glm::ivec3 v, std::size_t) {
            const auto value = std::int64_t(map.at(v));
            const auto found = std::find(values.begin(), values.end(), value);
            RC_ASSERT(found != values.end());
            RC_ASSERT((value == 0 || sets.at(value).contains(v)));
            labels.push_back(std::uint8_t(found - values.begin()));
            count += value != 0 ? 1 : 0;
        });
        for (const auto& [value, set] : sets) {
            count -= set.count();
        }
        RC_ASSERT(count == 0);
        const LabelSets again = labelSets(labels, values, map.geometry.dims);
        RC_ASSERT(again == sets);
        RC_ASSERT(isOfSets(checksum(sets)));
        RC_ASSERT(checksum(again) == checksum(sets));
        LabelSets others = sets;
        others.begin()->second.addRow(0, 1, 0, 0);
        RC_ASSERT((checksum(others) != checksum(sets) || sets.begin()->second.contains({0, 0, 0})));
    });
}

TEST(FineLabels, AreNotLookedForWhereThereIsNothing) {
    const volume::Volume map = phantom::makePhantom(
        {200, 20, 20}, ScalarType::UInt8, [](glm::dvec3 p) { return p.x < 50 && p.y > 10 ? 7 : 0; });
    const Sparse known(map, 56);
    const LabelSets sets = labelSets(known, 0, 255);
    ASSERT_EQ(sets.size(), 1U);
    EXPECT_EQ(sets.at(7).count(), 50U * 9 * 20);
    EXPECT_EQ(known.asked(), (Box3{{0, 0, 0}, {64, 20, 20}}));
}

TEST(FineLabels, OfValuesThatAreNoLabelsAreRefused) {
    const auto why = [](const volume::Volume& map, std::size_t most) {
        try {
            labelSets(volume::VolumeBricks(map, map.geometry), 0, most);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(
        why(mapOf(ScalarType::Float32, 1, [](int n) { return 0.5 + n; }), 255).find("whole numbers only"),
        std::string::npos);
    const volume::Volume many = mapOf(ScalarType::UInt8, 1, [](int n) { return n + 1; });
    EXPECT_EQ(why(many, 9), "");
    EXPECT_NE(why(many, 8).find("more than 8 different values"), std::string::npos);
}

} // namespace
} // namespace vs::segment
