// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "gl/shader_source.h"

#include <gtest/gtest.h>

#include <map>

namespace vs::gl {
namespace {

SourceLookup lookupIn(std::map<std::string, std::string> files) {
    return [files = std::move(files)](const std::string& path) -> std::optional<std::string> {
        const auto it = files.find(path);
        return it == files.end() ? std::nullopt : std::optional(it->second);
    };
}

TEST(ShaderSource, IncludesEachFileOnceAndKeepsLineNumbers) {
    const auto lookup = lookupIn({{"a.comp", "one\n#include \"b.glsl\"\n#include \"c.glsl\"\nfour\n"},
                                  {"b.glsl", "bee\n#include \"c.glsl\"\n"},
                                  {"c.glsl", "sea\n"}});
    const auto source = expandSource("a.comp", {{"N", "3"}}, lookup);
    EXPECT_EQ(source.text,
              "#version 450 core\n#define N 3\n#line 1 0\none\n#line 1 1\nbee\n#line 1 2\nsea\n#line 3 1\n"
              "#line 3 0\n#line 4 0\nfour\n");
    EXPECT_EQ(source.files, (std::vector<std::string>{"a.comp", "b.glsl", "c.glsl"}));
}

TEST(ShaderSource, AMissingFileIsNamedWithThePlaceThatWantsIt) {
    try {
        expandSource("a.comp", {}, lookupIn({{"a.comp", "\n#include \"gone.glsl\"\n"}}));
        FAIL();
    } catch (const GlError& error) {
        EXPECT_STREQ(error.what(), "shader gone.glsl not found (included from a.comp:2)");
    }
}

TEST(ShaderSource, DriverLogsNameFiles) {
    ExpandedSource source;
    source.files = {"a.comp", "b.glsl"};
    EXPECT_EQ(readableLog("1:17(5): error: x", source), "b.glsl:17(5): error: x");
    EXPECT_EQ(readableLog("0(3) : error C1008", source), "a.comp:3 : error C1008");
}

} // namespace
} // namespace vs::gl
