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

TEST(ShaderSource, UniformsAreThoseDeclaredOutsideOfBlocks) {
    const auto names =
        declaredUniforms("uniform float offset;\n"
                         "layout(binding = 3) uniform sampler3D volume; uniform vec4 taps [7];\n"
                         "layout(std140, binding = 0) uniform Block { float inBlock; };\n"
                         "uniform\n    ivec3\tdims\n;\n"
                         "float nonuniform = 1.0; float uniformity;\n");
    EXPECT_EQ(names, (std::vector<std::string>{"offset", "volume", "taps", "dims"}));
}

TEST(ShaderSource, UniformsInCommentsAreNone) {
    const auto names =
        declaredUniforms("// A uniform float gone; was here.\n"
                         "uniform float /* not uniform int other; */ kept; // uniform int late;\n"
                         "/* uniform float a;\n   uniform float b; // */ uniform int after;\n"
                         "uniform vec2 // in pixels; x right\n    split;\n"
                         "// uniform float last;");
    EXPECT_EQ(names, (std::vector<std::string>{"kept", "after", "split"}));
    EXPECT_TRUE(declaredUniforms("/* uniform float open;").empty());
}

TEST(ShaderSource, DriverLogsNameFiles) {
    ExpandedSource source;
    source.files = {"a.comp", "b.glsl"};
    EXPECT_EQ(readableLog("1:17(5): error: x", source), "b.glsl:17(5): error: x");
    EXPECT_EQ(readableLog("0(3) : error C1008", source), "a.comp:3 : error C1008");
}

} // namespace
} // namespace vs::gl
