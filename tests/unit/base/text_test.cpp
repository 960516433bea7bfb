// SPDX-License-Identifier: Apache-2.0
#include "base/cbor.h"
#include "base/error.h"
#include "base/json_reader.h"
#include "base/text.h"

#include <gtest/gtest.h>

#include <limits>

namespace vs {
namespace {

TEST(Text, ControlCharactersDoNothingToATerminal) {
    EXPECT_EQ(inOneLine("one\ntwo\r\x1b[31m\x7f."), "one?two??[31m?.");
    EXPECT_EQ(inOneLine("Größe"), "Größe");
}

TEST(Text, ANameIsUtf8AndEndsWithAWholeCharacter) {
    EXPECT_EQ(readableName("Größe", 100), "Größe");
    EXPECT_EQ(readableName("a\xff"
                           "b\xc3",
                           100),
              "a\xef\xbf\xbd"
              "b\xef\xbf\xbd");
    EXPECT_EQ(readableName("Größe", 4), "Grö");
    EXPECT_EQ(readableName("Größe", 3), "Gr");
    EXPECT_EQ(readableName("\xc3\xa4", 1), "");
}

// A file may hold any text where it should hold another.
TEST(JsonReader, AComplaintIsOneLine) {
    const auto json = JsonReader::Json::parse(R"({"op": "a\n\u001bb", "c\nd": 1})");
    const JsonReader reader(json, "a.json");
    const auto complaint = [](auto read) -> std::string {
        try {
            read();
        } catch (const SessionError& error) {
            return error.what();
        }
        return "none";
    };
    constexpr std::array<const char*, 1> names{"e"};
    EXPECT_EQ(complaint([&] { (void)reader.member("op").indexAmong(names); }),
              "a.json: op: 'a??b' is not known; choose one of e");
    EXPECT_EQ(complaint([&] { reader.allow({"op"}); }),
              "a.json: the member 'c?d' is not known here; known are op");
}

// A double rounds the largest whole number to one that is none any more.
TEST(JsonReader, WholeNumbersAreComparedAsTheyAre) {
    constexpr long most = std::numeric_limits<long>::max();
    const auto json =
        JsonReader::Json::parse("[9223372036854775807, 9223372036854775808, -9223372036854775808]");
    const JsonReader reader(json, "a.json");
    EXPECT_EQ(reader.at(0).integerBetween(0, most), most);
    EXPECT_THROW((void)reader.at(1).integerBetween(0, most), SessionError);
    EXPECT_THROW((void)reader.at(0).integerBetween(0, most - 1), SessionError);
    EXPECT_EQ(reader.at(2).integerBetween(std::numeric_limits<long>::min(), 0),
              std::numeric_limits<long>::min());
}

// The library that reads a message would call itself once a level.
TEST(Cbor, WhatIsNestedWithoutEndIsDeclined) {
    constexpr std::uint8_t listOfOne = 0x81;
    constexpr std::size_t deep = 1'000'000;
    EXPECT_THROW(fromCbor(std::vector<std::uint8_t>(deep, listOfOne)), Error);
    constexpr std::uint8_t objectOfOne = 0xa1;
    constexpr std::uint8_t emptyText = 0x60;
    std::vector<std::uint8_t> objects;
    for (std::size_t i = 0; i < deep; ++i) {
        objects.insert(objects.end(), {objectOfOne, emptyText});
    }
    EXPECT_THROW(fromCbor(objects), Error);
    EXPECT_EQ(fromCbor(std::vector<std::uint8_t>{listOfOne, emptyText}), nlohmann::json::array({""}));
}

} // namespace
} // namespace vs
