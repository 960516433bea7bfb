// SPDX-License-Identifier: Apache-2.0
#include "gl/shader_accesses.h"

#include "base/error.h"
#include "gl/shader_text.h"

#include <gtest/gtest.h>

namespace vs::gl {
namespace {

TEST(ShaderText, ConditionsAreEvaluatedAsThePreprocessorDoes) {
    const Definitions definitions{{"MODE", "3"}, {"SEGMENTS", "1"}, {"EMPTY", ""}, {"OTHER", "MODE + 1"}};
    const auto value = [&](const char* text) { return evaluate(text, definitions); };
    EXPECT_EQ(value("MODE == 3"), 1);
    EXPECT_EQ(value("MODE == 1 || (MODE == 3 && defined(SEGMENTS))"), 1);
    EXPECT_EQ(value("!defined GONE && defined(EMPTY)"), 1);
    EXPECT_EQ(value("OTHER * 2 - 1"), 7);
    EXPECT_EQ(value("(MODE <= 3) + (MODE < 3) + (MODE >= 4) + (MODE > 2)"), 2);
    EXPECT_EQ(value("1 - 2 - 3"), -4);
    EXPECT_EQ(value("7 / 2 != 3"), 0);
    EXPECT_EQ(value("GONE"), 0);
    EXPECT_EQ(value("0x10u"), 16);
    EXPECT_EQ(value("1 +"), std::nullopt);
    EXPECT_EQ(value("(1"), std::nullopt);
    EXPECT_EQ(value("EMPTY"), std::nullopt);
    EXPECT_EQ(value("4.5"), std::nullopt);
}

TEST(ShaderText, OnlyBranchesThatAreTakenAreLeft) {
    const auto active =
        activeText("#define A 2 // two\n"
                   "#if A == 1\none\n#define B\n#elif A == 2\ntwo\n#ifdef B\nB\n#else\nnot B\n"
                   "#endif\n#elif A == 2\nagain\n#else\nother\n#endif\n"
                   "#if A == 3\n#ifndef B\nhidden\n#endif\n#endif\n"
                   "#define LONG(x) \\\n  f(x)\nend /* #if\n */ last\n");
    EXPECT_EQ(active.text, "two\nnot B\nend   last\n");
    EXPECT_EQ(active.macros, (Definitions{{"A", "2"}, {"LONG", "(x)   f(x)"}}));
}

constexpr const char* kShader = R"(
layout(local_size_x = 8, local_size_y = 8) in;
const int kNone = 0;
layout(binding = kNone) uniform sampler3D values;
layout(r32f, binding = 0) uniform writeonly image3D target;
layout(r32f, binding = 1) uniform readonly image3D source;
#ifdef BOTH
layout(r8, binding = 2) uniform image2D both[2];
#endif
layout(std430, binding = 0) readonly buffer List { uint list[]; };
layout(std430, binding = 1) buffer Counts { uint count; uint others[4]; };
layout(std430, binding = 5) writeonly buffer Log { uint log[]; };
layout(std430, binding = 2) buffer Idle { uint idle[]; };
layout(std430, binding = 3) buffer ByMacro { uint byMacro[]; };
layout(std430, binding = 4) buffer Named { uint it[]; } named;
layout(std140, binding = 0) uniform Block { vec4 place; } ;
struct Hit { uint idle; };
#define FETCH(i) byMacro[i]
void nothing() {}
uint neverCalled() { return idle[0]; }
uint deeper(uint i) { return others[i]; }
uint called(uint i) { if (i > 2u) { return deeper(i); } return list[i] + named.it[0]; }
void main() { log[1] = 2u; imageStore(target, ivec3(0), vec4(called(1u)) + place); }
)";

TEST(ShaderAccesses, QualifiersAndUsesAreFound) {
    const auto found = declaredAccesses(kShader);
    const auto expect = [&](const char* name, bool reads, bool writes, bool isUsed) {
        ASSERT_TRUE(found.contains(name)) << name;
        const DeclaredAccess& access = found.find(name)->second;
        EXPECT_EQ(access.reads, reads) << name;
        EXPECT_EQ(access.writes, writes) << name;
        EXPECT_EQ(access.isUsed, isUsed) << name;
    };
    expect("values", true, false, false);
    expect("target", false, true, true);
    expect("source", true, false, false);
    expect("Log", false, true, true);
    expect("List", true, false, true);
    expect("Counts", true, false, true); // by a function that another calls
    expect("Idle", true, false, false);  // by a function that nobody calls
    expect("ByMacro", true, true, true);
    expect("Named", true, true, true);
    expect("Block", true, false, true);
    EXPECT_EQ(found.size(), 10U);
    const auto more = declaredAccesses("#define BOTH\n" + std::string(kShader));
    ASSERT_TRUE(more.contains("both"));
    EXPECT_TRUE(more.find("both")->second.reads && !more.find("both")->second.isUsed);
}

// Whether the member `m` of a block, or the image `im`, counts as written by these statements of main().
bool writes(const std::string& statements, const char* what = "B") {
    const auto found = declaredAccesses("layout(r32ui, binding = 0) uniform uimage2D im;\n"
                                        "layout(std430, binding = 0) buffer B { S m[]; uint other; };\n"
                                        "void change(int a, inout uint b) { b = 1u; }\n"
                                        "uint look(uint b) { return b; }\n"
                                        "void through(uimage2D i) { }\n"
                                        "void main() { " +
                                        statements + " }\n");
    return found.find(what)->second.writes;
}

TEST(ShaderAccesses, WhatIsOnlyReadIsToldFromWhatIsWritten) {
    for (const char* text :
         {"m[0] = 1u;", "m[i[2]].x.y += 1u;", "m[0]++;", "++m[0];", "m[0].x <<= 2;", "atomicAdd(m[0], 1u);",
          "x = max(1u, atomicMax(m[f(2)].w, y));", "change(1, m[3]);", "change(1, other);", "other |= 4u;",
          "if (a == b) { m[1].y = z; }", "atomicAdd((m[0]), 1u);"}) {
        EXPECT_TRUE(writes(text)) << text;
    }
    for (const char* text :
         {"x = m[0];", "x[m[0]] = 1u;", "if (m[0] == 1u) { x = 2u; }", "y = m[0] <= 3u;",
          "y = m[0] >= 3u || m[1] != 2u;", "atomicAdd(x, m[0]);", "atomicAdd(x[m[0]], 1u);",
          "y = look(m[0]);", "y = max(m[0], 1u) + m[1] * 2u - other;", "y = m[0] << 2;",
          "y = uint[](m[0], 1u)[0];", "for (uint i = m[0]; i < m[1]; ++i) { x = i; }"}) {
        EXPECT_FALSE(writes(text)) << text;
    }
    EXPECT_TRUE(writes("imageStore(im, ivec2(0), uvec4(1u));", "im"));
    EXPECT_TRUE(writes("x = imageAtomicAdd(im, ivec2(0), 1u);", "im"));
    EXPECT_TRUE(writes("through(im);", "im"));
    EXPECT_FALSE(writes("x = imageLoad(im, ivec2(0)).x + uint(imageSize(im).x);", "im"));
}

TEST(ShaderAccesses, SharedMemoryIsCounted) {
    EXPECT_EQ(sharedBytes("void main() {}"), 0U);
    EXPECT_EQ(sharedBytes("const int kWide = 8 * 4;\n#define N 3\n"
                          "shared uint a[32][kWide / 4];\nshared vec4 b;\nshared float c[N];\n"
                          "#if N == 2\nshared uint d[1000];\n#endif\nvoid main() { uint a[4]; }"),
              32U * 8 * 4 + 16 + 12);
    EXPECT_THROW(sharedBytes("shared Hit hits[4];"), GlError);
    EXPECT_THROW(sharedBytes("shared uint open[kUnknown];"), GlError);
}

} // namespace
} // namespace vs::gl
