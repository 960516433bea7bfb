// SPDX-License-Identifier: Apache-2.0
#include "gl/shader_reload.h"

#include "gl/buffer.h"
#include "gl/program.h"
#include "gpu/gl_test.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace vs::gl {
namespace {

// A folder of shaders that the tests edit.
class ShaderReloadTest : public test::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder_ =
            std::filesystem::temp_directory_path() / ("volume-studio-shaders-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        setenv("VOLUME_STUDIO_SHADER_DIR", folder_.c_str(), 1);
        static_cast<void>(takeShaderFault());
    }
    void TearDown() override {
        unsetenv("VOLUME_STUDIO_SHADER_DIR");
        std::filesystem::remove_all(folder_);
        EXPECT_EQ(takeShaderFault(), std::nullopt) << "a fault that the test did not expect";
        GlTest::TearDown();
    }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    // A shader whose invocations each write a float that is computed so.
    void writeAnswer(const std::string& answer, int localSize = 1) const {
        write("answer.comp",
              "layout(local_size_x = " + std::to_string(localSize) +
                  ") in;\n"
                  "layout(std430, binding = 0) writeonly buffer Answers { float answers[]; };\n"
                  "#include \"values.glsl\"\n"
                  "void main() { answers[gl_GlobalInvocationID.x] = " +
                  answer + "; }\n");
    }

    static std::vector<float> run(Program& program, int count = 1) {
        Buffer answers(std::size_t(count) * sizeof(float), "answers");
        answers.bindStorage(0);
        program.dispatchOver({count, 1, 1}, Barrier::Storage);
        return answers.read<float>(std::size_t(count));
    }

private:
    std::filesystem::path folder_;
};

TEST_F(ShaderReloadTest, AnEditedShaderIsUsedOnceShadersAreReloaded) {
    write("values.glsl", "uniform float offset;\n");
    writeAnswer("1.0 + offset");
    Program program("answer.comp");
    program.set("offset", 10.0F);
    EXPECT_EQ(run(program), std::vector<float>({11}));
    writeAnswer("2.0 + offset", 4);
    EXPECT_EQ(run(program), std::vector<float>({11}));
    reloadShaders();
    EXPECT_EQ(run(program, 8), std::vector<float>(8, 12)); // with its new size and the value that was set
    EXPECT_EQ(run(program.set("offset", 20.0F)), std::vector<float>({22}));
}

TEST_F(ShaderReloadTest, WhatAShaderIncludesAndItsVariantsAreReloadedToo) {
    write("values.glsl", "const float kValue = 1.0;\n");
    writeAnswer("kValue + float(PART)");
    ProgramVariants variants("answer.comp");
    const auto answersOf = [&](const char* part) { return run(variants.with({{"PART", part}})); };
    EXPECT_EQ(answersOf("10"), std::vector<float>({11}));
    EXPECT_EQ(answersOf("20"), std::vector<float>({21}));
    write("values.glsl", "const float kValue = 3.0;\n");
    reloadShaders();
    EXPECT_EQ(answersOf("10"), std::vector<float>({13}));
    EXPECT_EQ(answersOf("20"), std::vector<float>({23}));
}

TEST_F(ShaderReloadTest, AShaderThatDoesNotCompileLeavesTheProgramAsItWas) {
    write("values.glsl", "uniform float offset;\n");
    writeAnswer("1.0 + offset");
    Program program("answer.comp");
    program.set("offset", 10.0F);
    write("values.glsl", "uniform float offset;\nfloat broken() { return undeclared; }\n");
    writeAnswer("2.0 + offset");
    reloadShaders();
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(program), std::vector<float>({11}));
    const std::string logged = testing::internal::GetCapturedStderr();
    const auto fault = takeShaderFault();
    ASSERT_TRUE(fault);
    EXPECT_NE(fault->find("answer.comp does not compile"), std::string::npos) << *fault;
    EXPECT_NE(fault->find("values.glsl:2"), std::string::npos) << *fault;
    EXPECT_NE(logged.find(*fault), std::string::npos) << logged;
    program.set("offset", 20.0F);
    EXPECT_EQ(run(program), std::vector<float>({21}));
    EXPECT_EQ(takeShaderFault(), std::nullopt) << "it is tried once";
    write("values.glsl", "uniform float offset;\n");
    reloadShaders();
    EXPECT_EQ(run(program), std::vector<float>({22}));
}

TEST_F(ShaderReloadTest, AShaderThatIsGoneLeavesTheProgramAsItWas) {
    write("values.glsl", "");
    writeAnswer("1.0");
    Program program("answer.comp");
    write("answer.comp", "#include \"gone.glsl\"\n");
    reloadShaders();
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(program), std::vector<float>({1}));
    testing::internal::GetCapturedStderr();
    EXPECT_EQ(takeShaderFault(), "shader gone.glsl not found (included from answer.comp:1)");
}

TEST_F(ShaderReloadTest, UniformsOfEveryTypeKeepTheirValues) {
    write("values.glsl",
          "uniform int i; uniform ivec2 i2; uniform ivec3 i3; uniform uint u;\n"
          "uniform float f; uniform vec2 f2; uniform vec3 f3; uniform vec4 f4; uniform mat4 m;\n"
          "uniform float taps[3]; uniform vec4 planes[2];\n"
          "float all() {\n"
          "    return float(i + i2.y + i3.z) + float(u) + f + f2.y + f3.z + f4.w + m[3][1] + taps[2] + "
          "planes[1].z;\n"
          "}\n");
    writeAnswer("all()");
    Program program("answer.comp");
    const std::array<float, 3> taps{0, 0, 512};
    const std::array<glm::vec4, 2> planes{glm::vec4(0), glm::vec4(0, 0, 1024, 0)};
    glm::mat4 matrix(0);
    matrix[3][1] = 256;
    program.set("i", 1).set("i2", glm::ivec2(0, 2)).set("i3", glm::ivec3(0, 0, 4)).set("u", 8U);
    program.set("f", 16.0F).set("f2", glm::vec2(0, 32)).set("f3", glm::vec3(0, 0, 64));
    program.set("f4", glm::vec4(0, 0, 0, 128)).set("m", matrix).set("taps", taps).set("planes", planes);
    EXPECT_EQ(run(program), std::vector<float>({2047}));
    writeAnswer("all() + 0.5");
    reloadShaders();
    EXPECT_EQ(run(program), std::vector<float>({2047.5F}));
}

TEST_F(ShaderReloadTest, AUniformOfAnotherTypeBeginsAnew) {
    write("values.glsl", "uniform float offset;\n");
    writeAnswer("1.0 + offset");
    Program program("answer.comp");
    program.set("offset", 10.0F);
    write("values.glsl", "uniform int offset;\n");
    writeAnswer("1.0 + float(offset)");
    reloadShaders();
    EXPECT_EQ(run(program), std::vector<float>({1}));
    EXPECT_THROW(program.set("offset", 10.0F), GlError);
    EXPECT_EQ(run(program.set("offset", 3)), std::vector<float>({4}));
}

} // namespace
} // namespace vs::gl
