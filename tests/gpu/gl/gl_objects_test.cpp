// SPDX-License-Identifier: Apache-2.0
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/shaders/bindings.h"
#include "gl/texel_buffer.h"
#include "gl/texture.h"
#include "gpu/gl_test.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <optional>
#include <random>

namespace vs::gl {
namespace {

using GlObjectsTest = test::GlTest;

TEST_F(GlObjectsTest, TexturesGiveBackTheirBytes) {
    for (const Format format : {Format::R8, Format::R16, Format::R16F, Format::R32F, Format::R32UI}) {
        Texture texture(glm::ivec3(7, 5, 3), format, Filter::Nearest, "test");
        const Box3 box{{1, 1, 0}, {6, 4, 2}};
        std::vector<std::byte> bytes(box.volume() * bytesPerTexel(format));
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            bytes[i] = std::byte(i % 59); // no NaN patterns in half floats
        }
        texture.upload(box, bytes);
        EXPECT_EQ(texture.download(box), bytes);
        texture.clear({{1, 1, 0}, {6, 4, 1}});
        const auto after = texture.download(box);
        EXPECT_TRUE(std::all_of(after.begin(), after.begin() + std::ptrdiff_t(after.size() / 2),
                                [](std::byte b) { return b == std::byte(0); }));
        EXPECT_TRUE(std::equal(after.begin() + std::ptrdiff_t(after.size() / 2), after.end(),
                               bytes.begin() + std::ptrdiff_t(bytes.size() / 2)));
    }
}

TEST_F(GlObjectsTest, EightBitTexturesAreFilteredInFloatingPoint) {
    // On llvmpipe plain edge clamping would give 8-bit steps here; see gl/texture.cpp.
    Texture texture(glm::ivec3(2, 1, 1), Format::R8, Filter::Linear, "test");
    const std::uint8_t values[] = {100, 101};
    texture.upload({glm::ivec3(0), {2, 1, 1}}, std::as_bytes(std::span(values)));
    Texture cells(glm::ivec3(1), Format::RG32F, Filter::Nearest, "sum");
    Buffer out(64 * sizeof(float), "samples");
    setenv("VOLUME_STUDIO_SHADER_DIR", VS_TEST_SHADERS, 1);
    Program program("sample_row.comp");
    unsetenv("VOLUME_STUDIO_SHADER_DIR");
    texture.bindTexture(0);
    out.bindStorage(0);
    program.dispatch({1, 1, 1}, Barrier::Storage);
    const auto samples = out.read<float>(64);
    for (std::size_t i = 0; i < 64; ++i) {
        EXPECT_NEAR(samples[i] * 255, 100 + (double(i) + 0.5) / 64, 0.02) << i;
    }
}

TEST_F(GlObjectsTest, BuffersStartAsZerosAndGiveBackTheirBytes) {
    Buffer buffer(64, "test");
    EXPECT_EQ(buffer.read<std::uint32_t>(16), std::vector<std::uint32_t>(16, 0));
    std::vector<std::uint32_t> values(8);
    std::iota(values.begin(), values.end(), 3U);
    buffer.write(std::span<const std::uint32_t>(values), 16);
    EXPECT_EQ(buffer.read<std::uint32_t>(8, 16), values);
    buffer.clear(16, 8);
    EXPECT_EQ(buffer.readValue<std::uint32_t>(20), 0U);
    EXPECT_EQ(buffer.readValue<std::uint32_t>(24), 5U);
}

// As buffers are on hardware (gl/staging.h).
TEST_F(GlObjectsTest, BuffersThatOnlyTheDeviceReachesGiveBackTheirBytes) {
    setenv("VOLUME_STUDIO_TRANSFERS", "staged", 1);
    const std::size_t size = (std::size_t(65) << 20) / sizeof(std::uint32_t); // more than is copied at once
    Buffer buffer(size * sizeof(std::uint32_t), "test");
    unsetenv("VOLUME_STUDIO_TRANSFERS");
    EXPECT_EQ(buffer.read<std::uint32_t>(size), std::vector<std::uint32_t>(size, 0));
    std::vector<std::uint32_t> values(size - 3);
    std::iota(values.begin(), values.end(), 3U);
    buffer.write(std::span<const std::uint32_t>(values), 8);
    EXPECT_EQ(buffer.read<std::uint32_t>(size - 3, 8), values);
    buffer.clear(16, 4000);
    EXPECT_EQ(buffer.readValue<std::uint32_t>(12), 4U);
    EXPECT_EQ(buffer.read<std::uint32_t>(1000, 16), std::vector<std::uint32_t>(1000, 0));
    EXPECT_EQ(buffer.readValue<std::uint32_t>(4016), 1005U);
    EXPECT_EQ(buffer.readValue<std::uint32_t>((size - 1) * sizeof(std::uint32_t)), 0U);
}

// Parts of slices, whole slices and several of them, to and from anywhere in a texture.
TEST_F(GlObjectsTest, TexturesThatOnlyTheDeviceReachesGiveBackTheirTexels) {
    setenv("VOLUME_STUDIO_TRANSFERS", "staged", 1);
    Texture texture(glm::ivec3(1500, 1500, 5), Format::R32UI, Filter::Nearest, "test"); // slices of 9 MB
    Texture picture(glm::ivec2(700, 300), Format::R32F, Filter::Nearest, "test");
    unsetenv("VOLUME_STUDIO_TRANSFERS");
    std::mt19937 random(5);
    for (const Box3& box : {Box3{{0, 0, 0}, {1500, 1500, 5}}, Box3{{7, 3, 1}, {1400, 1401, 4}},
                            Box3{{700, 20, 0}, {900, 70, 5}}, Box3{{1499, 1499, 4}, {1500, 1500, 5}}}) {
        std::vector<std::uint32_t> values(box.volume());
        std::generate(values.begin(), values.end(), std::ref(random));
        const auto bytes = std::as_bytes(std::span(values));
        texture.upload(box, bytes);
        const auto back = texture.download(box);
        EXPECT_TRUE(std::equal(back.begin(), back.end(), bytes.begin(), bytes.end()));
    }
    std::vector<float> values(std::size_t(700) * 300);
    std::iota(values.begin(), values.end(), 1.0F);
    picture.upload({{0, 0, 0}, {700, 300, 1}}, std::as_bytes(std::span(values)));
    EXPECT_EQ(picture.downloadAll<float>(), values);
}

// Growth, for one, clears a plane between two dispatches that use the same bindings.
TEST_F(GlObjectsTest, ClearingLeavesBindingsAsTheyWere) {
    setenv("VOLUME_STUDIO_TRANSFERS", "staged", 1);
    Buffer cleared(64, "test");
    Buffer filled(64, "test");
    unsetenv("VOLUME_STUDIO_TRANSFERS");
    Program fill("gl/shaders/fill_words.comp");
    fill.set("firstWord", 2U).set("wordCount", 3U).set("value", 7U);
    filled.bindStorage(kWordsStorage);
    cleared.clear();
    fill.dispatch({1, 1, 1}, Barrier::Storage);
    EXPECT_EQ(filled.read<std::uint32_t>(6), (std::vector<std::uint32_t>{0, 0, 7, 7, 7, 0}));
    EXPECT_EQ(cleared.read<std::uint32_t>(16), std::vector<std::uint32_t>(16, 0));
}

TEST_F(GlObjectsTest, ATextureBeyondTheLimitIsRefusedWithItsSize) {
    try {
        Texture texture(glm::ivec3(100000, 2, 2), Format::R8, Filter::Linear, "data of big.nii");
        FAIL();
    } catch (const GlError& error) {
        EXPECT_NE(std::string(error.what()).find("data of big.nii: 100000x2x2"), std::string::npos)
            << error.what();
    }
}

// What an attempt is refused with.
std::string refusalOf(const std::function<void()>& attempt) {
    try {
        attempt();
    } catch (const GlError& error) {
        return error.what();
    }
    return "nothing";
}

TEST_F(GlObjectsTest, ABufferBeyondTheLimitIsRefusedWithItsSize) {
    const std::string text = refusalOf([] { Buffer buffer(std::size_t(1) << 60, "dream"); }); // an exbibyte
    EXPECT_EQ(text.find("dream: 1099511627776 MiB are more than this device's limit of"), 0U) << text;
}

TEST_F(GlObjectsTest, WhatIsBeyondTheLeastDeviceIsRefusedThereInOneLine) {
    setenv("VOLUME_STUDIO_LIMITS", "guaranteed", 1);
    const Texture volume(glm::ivec3(2048, 1, 1), Format::R8, Filter::Linear, "volume");
    const Texture picture(glm::ivec2(16384, 1), Format::R8, Filter::Linear, "picture");
    const TexelBuffer row(65536, Format::R8, "row");
    const Buffer block(std::size_t(1) << 27, "block");
    const std::vector<std::string> found{
        refusalOf([] { Texture(glm::ivec3(2049, 1, 1), Format::R8, Filter::Linear, "volume"); }),
        refusalOf([] { Texture(glm::ivec2(1, 16385), Format::R8, Filter::Linear, "picture"); }),
        refusalOf([] { TexelBuffer(65537, Format::R8, "row"); }),
        refusalOf([] { Buffer((std::size_t(1) << 27) + (1U << 20U), "block"); })};
    unsetenv("VOLUME_STUDIO_LIMITS");
    const std::string remedy = "; use a smaller volume, as vstudio reduce makes, or another device";
    EXPECT_EQ(found[0],
              "volume: 2049x1x1 texels are more than this device's limit of 2048 along an axis" + remedy);
    EXPECT_EQ(found[1],
              "picture: 1x16385x1 texels are more than this device's limit of 16384 along an axis; use "
              "a smaller picture");
    EXPECT_EQ(found[2], "row: 65537 texels are more than this device's limit of 65536" + remedy);
    EXPECT_EQ(found[3],
              "block: 129 MiB are more than this device's limit of 128 MiB for a storage block" + remedy);
}

TEST_F(GlObjectsTest, UniformsAreKnownByTheirNamesAndTypes) {
    setenv("VOLUME_STUDIO_SHADER_DIR", VS_TEST_SHADERS, 1);
    Program program("name_uniforms.comp");
    unsetenv("VOLUME_STUDIO_SHADER_DIR");
    Buffer answers(4 * sizeof(float), "answers");
    answers.bindStorage(0);
    const std::array<float, 3> taps{1, 2, 4};
    program.set("offset", 10.0F).set("taps", taps).set("unused", 3);
    program.dispatch({1, 1, 1}, Barrier::Storage);
    EXPECT_EQ(answers.read<float>(3), (std::vector<float>{11, 12, 14}));
    EXPECT_THROW(program.set("offest", 1.0F), GlError);
    EXPECT_THROW(program.set("offset", 1), GlError); // it is a float
    EXPECT_THROW(program.set("Block", 1), GlError);  // which is no uniform but holds some
}

TEST_F(GlObjectsTest, AListLongerThanOneRowOfGroupsIsWorkedOnOnce) {
    setenv("VOLUME_STUDIO_SHADER_DIR", VS_TEST_SHADERS, 1);
    Program program("count_items.comp");
    unsetenv("VOLUME_STUDIO_SHADER_DIR");
    for (const std::size_t count : {1, 64, 65535 * 64, 65535 * 64 + 1, 5000000}) {
        Buffer visits((count + 100) * sizeof(std::uint32_t), "visits");
        visits.bindStorage(0);
        program.set("count", int(count));
        program.dispatchOverList(count, Barrier::Storage);
        const auto times = visits.read<std::uint32_t>(count + 100);
        EXPECT_EQ(std::count(times.begin(), times.begin() + std::ptrdiff_t(count), 1U), count);
        EXPECT_EQ(std::count(times.end() - 100, times.end(), 0U), 100) << "beyond the end of " << count;
    }
}

// A context of its own, since errors are what is counted here.
TEST(GlErrors, ADriverErrorIsCountedOnceAndFailsTheRun) {
    std::optional<Context> context;
    try {
        context.emplace(Context::createHeadless());
    } catch (const GlError& error) {
        ASSERT_FALSE(test::isDeviceRequired()) << error.what();
        GTEST_SKIP() << "no OpenGL 4.5 device here";
    }
    EXPECT_EQ(context->errorCount(), 0);
    context->requireNoErrors();
    Buffer buffer(64, "test");
    buffer.bindStorage(100000); // no such binding
    Context::finish();
    EXPECT_EQ(context->errorCount(), 1);
    EXPECT_EQ(context->errorCount(), 1);
    EXPECT_THROW(context->requireNoErrors(), GlError);
}

TEST(GlErrors, ADeviceThatIsNoNumberIsNamed) {
    setenv("VOLUME_STUDIO_DEVICE", "abc", 1);
    try {
        Context::createHeadless();
        ADD_FAILURE() << "must be refused";
    } catch (const GlError& error) {
        EXPECT_NE(std::string(error.what()).find("VOLUME_STUDIO_DEVICE=abc"), std::string::npos)
            << error.what();
    }
    unsetenv("VOLUME_STUDIO_DEVICE");
}

TEST_F(GlObjectsTest, AShaderErrorNamesFileAndLine) {
    setenv("VOLUME_STUDIO_SHADER_DIR", VS_TEST_SHADERS, 1);
    try {
        Program program("broken.comp");
        ADD_FAILURE() << "must not compile";
    } catch (const GlError& error) {
        EXPECT_NE(std::string(error.what()).find("broken.comp:4"), std::string::npos) << error.what();
    }
    unsetenv("VOLUME_STUDIO_SHADER_DIR");
}

} // namespace
} // namespace vs::gl
