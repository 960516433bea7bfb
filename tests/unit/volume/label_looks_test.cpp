// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/label_looks.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace vs::volume {
namespace {

LabelLooks looksIn(const std::string& fields) {
    std::istringstream header("NRRD0004\ntype: uchar\n" + fields + "\n\nSegment9_Name:=behind the header\n");
    return labelLooksIn(header);
}

TEST(LabelLooks, NamesAndColoursByValue) {
    const auto looks = looksIn("Segment0_Name:=Liver\r\nSegment0_LabelValue:=3\nSegment0_Color:=0.5 2 -1\n"
                               "Segment1_Name:=nothing says of which value");
    ASSERT_EQ(looks.size(), 1U);
    EXPECT_EQ(looks.at(3).name, "Liver");
    EXPECT_EQ(looks.at(3).colour, glm::dvec3(0.5, 1, 0));
}

// What is wrong in a store's "image-label" is passed over, and the rest of it counts.
TEST(LabelLooks, InStores) {
    const auto looksOf = [](const std::string& text) {
        return labelLooksInStore(nlohmann::ordered_json::parse(text));
    };
    const auto looks = looksOf(R"({"image-label": {"version": "0.4",
        "colors": [{"label-value": 3, "rgba": [51, 102, 300, 255]}, {"label-value": 4, "rgba": "red"},
                   {"rgba": [1, 2, 3, 4]}, 5, {"label-value": 2.5, "rgba": [1, 2, 3, 4]}],
        "properties": [{"label-value": 3, "name": "Liver"}, {"label-value": 7, "name": 8}, null]}})");
    ASSERT_EQ(looks.size(), 2U);
    EXPECT_EQ(looks.at(3).name, "Liver");
    EXPECT_EQ(looks.at(3).colour, glm::dvec3(0.2, 0.4, 1));
    EXPECT_FALSE(looks.at(4).colour);
    for (const char* none :
         {"[]", "3", "{}", R"({"image-label": 3})", R"({"image-label": {"colors": {}}})"}) {
        EXPECT_TRUE(looksOf(none).empty()) << none;
    }
}

// A segment's name stands in sessions and journals, which are UTF-8: with another name nothing could be
// saved.
TEST(LabelLooks, NamesAreUtf8WhateverTheFileHolds) {
    EXPECT_EQ(looksIn("Segment0_Name:=L\xe4nge\x1b\nSegment0_LabelValue:=1").at(1).name, "L\xef\xbf\xbdnge?");
    std::string name; // 'ä' is two bytes: one of them would be the last that fits
    for (int i = 0; i < 150; ++i) {
        name += "ä";
    }
    EXPECT_EQ(looksIn("Segment0_Name:=x" + name + "\nSegment0_LabelValue:=1").at(1).name,
              "x" + name.substr(0, LabelLook::kLongestName - 2));
}

} // namespace
} // namespace vs::volume
