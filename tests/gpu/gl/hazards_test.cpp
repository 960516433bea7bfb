// SPDX-License-Identifier: Apache-2.0
#include "gl/hazards.h"

#include "gl/hazard_watch.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "gl/texel_buffer.h"
#include "gl/texture.h"
#include "gpu/gl_test.h"

#include <epoxy/gl.h>

#include <array>
#include <cstdlib>
#include <optional>

namespace vs::gl {
namespace {

using Texts = std::vector<std::string>;

// A pass "fill" writes a number, a pass "take" reads it, with barriers that the tests choose.
class HazardsTest : public test::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) {
            return;
        }
        setenv("VOLUME_STUDIO_SHADER_DIR", VS_TEST_SHADERS, 1);
        texture_ = Texture(glm::ivec3(2), Format::R32UI, Filter::Nearest, "the texture");
        row_ = TexelBuffer(16, Format::R32UI, "the row");
        answers_ = Buffer(64, "the answers");
        fillImage_ = Program("fill_values.comp", {{"TO_IMAGE", "1"}});
        fillStorage_ = Program("fill_values.comp");
        texture_.bindImage(0, Access::ReadWrite);
        texture_.bindTexture(0);
        row_.buffer().bindStorage(0);
        row_.buffer().bindStorage(1);
        answers_.bindStorage(2);
    }
    void TearDown() override {
        unsetenv("VOLUME_STUDIO_SHADER_DIR");
        if (hazards() != nullptr) {
            hazards()->ignoreBarriers(0);
        }
        GlTest::TearDown();
    }

    void fillImage(Barrier after) { run("fill", fillImage_, after); }
    void fillStorage(Barrier after) { run("fill", fillStorage_, after); }
    static void take(int from, Barrier after = Barrier::All) {
        Program program("take_values.comp", {{"FROM", std::to_string(from)}});
        run("take", program, after);
    }
    static void run(const char* passName, Program& program, Barrier after) {
        const Pass pass(passName);
        program.dispatch({1, 1, 1}, after);
    }

    // Expects one hazard, which names these things.
    static void expectHazard(const Texts& named) {
        const Texts found = context()->takeHazards();
        ASSERT_EQ(found.size(), 1U);
        for (const std::string& name : named) {
            EXPECT_NE(found[0].find(name), std::string::npos) << found[0] << "\nlacks " << name;
        }
        EXPECT_EQ(found[0].find('\n'), std::string::npos);
    }
    static void expectHazardOfTaking(const std::string& label, const std::string& bit) {
        expectHazard({"'" + label + "'", "fill_values.comp (pass 'fill') writes it",
                      "take_values.comp (pass 'take') reads it", bit});
    }
    static void expectNone() { EXPECT_EQ(context()->takeHazards(), Texts()); }

    Texture texture_;
    TexelBuffer row_;
    Buffer answers_;
    Program fillImage_;
    Program fillStorage_;
};

constexpr int kFromImage = 0;
constexpr int kFromTexture = 1;
constexpr int kFromStorage = 2;
constexpr int kFromRow = 3;
constexpr int kFromUniform = 4;
constexpr int kFromNothing = 5;
constexpr int kFromAnyImage = 6; // whose declaration does not say that it is read alone

TEST_F(HazardsTest, AnImageThatIsReadAsAnImageNeedsTheBarrierForImages) {
    fillImage(Barrier::Image);
    take(kFromImage);
    expectNone();
    fillImage(Barrier::Storage);
    take(kFromImage);
    expectHazardOfTaking("the texture", "GL_SHADER_IMAGE_ACCESS_BARRIER_BIT");
}

TEST_F(HazardsTest, AnImageThatIsReadAsATextureNeedsTheBarrierForTextures) {
    fillImage(Barrier::Texture);
    take(kFromTexture);
    expectNone();
    fillImage(Barrier::Image);
    take(kFromTexture);
    expectHazardOfTaking("the texture", "GL_TEXTURE_FETCH_BARRIER_BIT");
}

TEST_F(HazardsTest, StorageThatIsReadAsStorageNeedsTheBarrierForStorage) {
    fillStorage(Barrier::Storage);
    take(kFromStorage);
    expectNone();
    fillStorage(Barrier::Texture);
    take(kFromStorage);
    expectHazardOfTaking("the row", "GL_SHADER_STORAGE_BARRIER_BIT");
}

TEST_F(HazardsTest, ARowOfTexelsIsTheMemoryOfItsBuffer) {
    row_.bindTexture(0);
    fillStorage(Barrier::Texture);
    take(kFromRow);
    expectNone();
    fillStorage(Barrier::All);
    fillStorage(Barrier::Storage);
    take(kFromRow);
    expectHazardOfTaking("the row", "GL_TEXTURE_FETCH_BARRIER_BIT");
}

TEST_F(HazardsTest, UniformsThatAShaderHasWrittenNeedTheBarrierForUniforms) {
    row_.buffer().bindUniform(0);
    fillStorage(Barrier::All);
    take(kFromUniform);
    expectNone();
    fillStorage(Barrier::Storage);
    take(kFromUniform);
    expectHazardOfTaking("the row", "GL_UNIFORM_BARRIER_BIT");
}

TEST_F(HazardsTest, ArgumentsThatAShaderHasWrittenNeedTheBarrierForCommands) {
    Program takeNothing("take_values.comp", {{"FROM", std::to_string(kFromNothing)}});
    const auto takeIndirectly = [&] {
        const Pass pass("take");
        takeNothing.dispatchIndirect(row_.buffer(), 16, Barrier::All);
    };
    fillStorage(Barrier::Indirect);
    takeIndirectly();
    expectNone();
    fillStorage(Barrier::Storage);
    takeIndirectly();
    expectHazardOfTaking("the row", "GL_COMMAND_BARRIER_BIT");
}

TEST_F(HazardsTest, ReadingBackNeedsTheBarriersForUpdates) {
    // Textures and buffers issue these barriers themselves; here they are taken away.
    fillStorage(Barrier::Indirect);
    EXPECT_EQ(row_.buffer().readValue<std::uint32_t>(), 7U);
    fillImage(Barrier::Image);
    EXPECT_EQ(texture_.downloadAll<std::uint32_t>()[0], 7U);
    expectNone();
    hazards()->ignoreBarriers(GL_BUFFER_UPDATE_BARRIER_BIT);
    static_cast<void>(row_.buffer().readValue<std::uint32_t>());
    expectNone(); // nothing was written since
    fillStorage(Barrier::Indirect);
    static_cast<void>(row_.buffer().readValue<std::uint32_t>());
    expectHazard({"'the row'", "fill_values.comp (pass 'fill') writes it", "Buffer::read reads it",
                  "GL_BUFFER_UPDATE_BARRIER_BIT"});
    hazards()->ignoreBarriers(GL_TEXTURE_UPDATE_BARRIER_BIT);
    fillImage(Barrier::Texture);
    static_cast<void>(texture_.downloadAll<std::uint32_t>());
    expectHazard({"'the texture'", "fill_values.comp (pass 'fill') writes it", "Texture::download reads it",
                  "GL_TEXTURE_UPDATE_BARRIER_BIT"});
}

TEST_F(HazardsTest, UploadsClearsAndCopiesAfterStoresNeedTheBarriersForUpdates) {
    const std::array<std::uint32_t, 1> one{1};
    const Box3 texel{glm::ivec3(0), glm::ivec3(1)};
    Texture other(glm::ivec3(2), Format::R32UI, Filter::Nearest, "the other");
    const auto change = [&](int how) {
        switch (how) {
        case 0:
            return row_.buffer().write(std::span<const std::uint32_t>(one));
        case 1:
            return row_.buffer().clear(0, 4);
        case 2:
            return texture_.upload(texel, std::as_bytes(std::span(one)));
        case 3:
            return texture_.clear(texel);
        case 4:
            return texture_.copyFrom(other, texel, glm::ivec3(0));
        default:
            return other.copyFrom(texture_, texel, glm::ivec3(0));
        }
    };
    const Texts names{"Buffer::write",  "Buffer::clear",     "Texture::upload",
                      "Texture::clear", "Texture::copyFrom", "Texture::copyFrom"};
    for (int how = 0; how < 6; ++how) {
        hazards()->ignoreBarriers(0);
        fillStorage(Barrier::All);
        fillImage(Barrier::All);
        fillStorage(Barrier::Indirect);
        fillImage(Barrier::Image);
        change(how);
        expectNone();
        fillStorage(Barrier::All);
        fillImage(Barrier::All);
        hazards()->ignoreBarriers(GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
        fillStorage(Barrier::All);
        fillImage(Barrier::All);
        change(how);
        expectHazard({"fill_values.comp (pass 'fill') writes it", names[std::size_t(how)], "_UPDATE_"});
    }
}

TEST_F(HazardsTest, AWriteAfterAWriteNeedsABarrier) {
    fillStorage(Barrier::Storage);
    fillImage(Barrier::Image);
    fillStorage(Barrier::Texture);
    fillImage(Barrier::Storage);
    expectNone();
    fillStorage(Barrier::Storage); // whose barrier was one for storage, after the image's dispatch
    expectNone();
    fillImage(Barrier::None);
    expectHazard({"'the texture'", "fill_values.comp (pass 'fill') writes it as an image, then",
                  "GL_SHADER_IMAGE_ACCESS_BARRIER_BIT"});
    fillStorage(Barrier::Image);
    fillStorage(Barrier::All);
    expectHazard({"'the row'", "writes it as storage, then fill_values.comp (pass 'fill') writes",
                  "GL_SHADER_STORAGE_BARRIER_BIT"});
}

TEST_F(HazardsTest, AWriteAfterAReadOfAnotherDispatchNeedsABarrier) {
    take(kFromTexture, Barrier::Image);
    fillImage(Barrier::All);
    take(kFromImage, Barrier::Image);
    fillImage(Barrier::All);
    take(kFromStorage, Barrier::Storage);
    fillStorage(Barrier::All);
    expectNone();
    take(kFromTexture, Barrier::Storage);
    fillImage(Barrier::All);
    expectHazard({"'the texture'", "take_values.comp (pass 'take') reads it as a texture, then",
                  "fill_values.comp (pass 'fill') writes it", "GL_SHADER_IMAGE_ACCESS_BARRIER_BIT"});
    take(kFromStorage, Barrier::Image);
    fillStorage(Barrier::All);
    expectHazard({"'the row'", "take_values.comp (pass 'take') reads it", "GL_SHADER_STORAGE_BARRIER_BIT"});
}

TEST_F(HazardsTest, AStoreAfterACopyHasReadItsSourceNeedsABarrier) {
    Texture other(glm::ivec3(2), Format::R32UI, Filter::Nearest, "the other");
    const Box3 all{glm::ivec3(0), glm::ivec3(2)};
    other.copyFrom(texture_, all, glm::ivec3(0));
    fillImage(Barrier::All);
    expectNone(); // Texture issues the barrier, which is taken away now
    hazards()->ignoreBarriers(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    other.copyFrom(texture_, all, glm::ivec3(0));
    hazards()->ignoreBarriers(0);
    fillImage(Barrier::All);
    expectHazard({"'the texture'", "Texture::copyFrom reads it from the program, then",
                  "fill_values.comp (pass 'fill') writes it", "GL_SHADER_IMAGE_ACCESS_BARRIER_BIT"});
}

TEST_F(HazardsTest, WhatCommandsDoAfterReadsIsOrderedByOpenGL) {
    take(kFromTexture, Barrier::None);
    texture_.clear();
    fillStorage(Barrier::Storage);
    take(kFromStorage, Barrier::Storage);
    row_.buffer().clear();
    texture_.clear();
    take(kFromImage);
    expectNone();
}

TEST_F(HazardsTest, ABlockThatIsDeclaredAndNotUsedIsNotAccessed) {
    answers_.bindStorage(1); // of which fill_values.comp has a block
    take(kFromNothing, Barrier::None);
    fillStorage(Barrier::All);
    expectNone();
}

TEST_F(HazardsTest, AnImageThatIsBoundForReadingIsNotWritten) {
    texture_.bindImage(0, Access::Read);
    take(kFromAnyImage, Barrier::Storage);
    take(kFromAnyImage, Barrier::All);
    expectNone();
    texture_.bindImage(0, Access::ReadWrite);
    take(kFromAnyImage, Barrier::All);
    take(kFromAnyImage, Barrier::Storage);
    expectNone();
    take(kFromAnyImage, Barrier::Storage);
    expectHazard({"'the texture'", "reads and writes it as an image"});
}

TEST_F(HazardsTest, NewMemoryOfAnOldNameHasNoPast) {
    fillStorage(Barrier::None);
    row_ = TexelBuffer();
    row_ = TexelBuffer(16, Format::R32UI, "the row");
    row_.buffer().bindStorage(0);
    fillStorage(Barrier::All);
    expectNone();
}

TEST_F(HazardsTest, OneHazardIsToldOnce) {
    for (int n = 0; n < 3; ++n) {
        fillImage(Barrier::All);
        fillImage(Barrier::None);
        take(kFromImage);
    }
    EXPECT_EQ(context()->errorCount(), 1);
    expectHazardOfTaking("the texture", "GL_SHADER_IMAGE_ACCESS_BARRIER_BIT");
    EXPECT_EQ(context()->errorCount(), 0);
}

TEST_F(HazardsTest, AHazardFailsTheRun) {
    fillImage(Barrier::None);
    take(kFromTexture);
    try {
        context()->requireNoErrors();
        ADD_FAILURE() << "must be refused";
    } catch (const GlError& error) {
        EXPECT_EQ(std::string(error.what()).find("1 hazards were found"), 0U) << error.what();
    }
    expectHazardOfTaking("the texture", "GL_TEXTURE_FETCH_BARRIER_BIT");
}

// A context of its own, made with the variable set or not.
TEST(Hazards, TheVariableSwitchesThemOn) {
    for (const bool isOn : {false, true}) {
        setenv("VOLUME_STUDIO_HAZARDS", isOn ? "1" : "0", 1);
        std::optional<Context> own;
        try {
            own.emplace(Context::createHeadless());
        } catch (const GlError& error) {
            ASSERT_FALSE(test::isDeviceRequired()) << error.what();
            GTEST_SKIP() << "no OpenGL 4.5 device here";
        }
        EXPECT_EQ(hazards() != nullptr, isOn);
        own.reset();
        EXPECT_EQ(hazards(), nullptr);
    }
    unsetenv("VOLUME_STUDIO_HAZARDS");
}

} // namespace
} // namespace vs::gl
