// SPDX-License-Identifier: Apache-2.0
#include "gl/pass.h"

#include "base/log.h"
#include "gl/texture.h"
#include "gpu/gl_test.h"

#include <epoxy/gl.h>

#include <cstdlib>

namespace vs::gl {
namespace {

// The level is chosen when something is logged first: before the tests begin.
const bool kIsLevelSet = setenv("VOLUME_STUDIO_LOG", "performance", 1) == 0;

class PassTest : public test::GlTest {
protected:
    void TearDown() override {
        Pass::enableTiming(false);
        Pass::resetTimes();
        GlTest::TearDown();
    }

    static void clearTexture() {
        Texture texture(glm::ivec3(64), Format::R32F, Filter::Nearest, "test");
        texture.clear({glm::ivec3(0), glm::ivec3(64)});
    }
};

TEST_F(PassTest, TimesAddUpByNameOnBothClocks) {
    Pass::enableTiming(true);
    PassTimes once;
    {
        const Pass pass("clear");
        clearTexture();
    }
    once = Pass::times().at("clear");
    EXPECT_EQ(once.count, 1);
    EXPECT_GT(once.milliseconds, 0);
    EXPECT_GT(once.deviceMilliseconds, 0);
    // The device's stamps lie within the wall clock's, but for what submitting them takes.
    EXPECT_LT(once.deviceMilliseconds, once.milliseconds + 5);
    {
        const Pass pass("clear");
        clearTexture();
    }
    EXPECT_EQ(Pass::times().at("clear").count, 2);
    EXPECT_GT(Pass::times().at("clear").deviceMilliseconds, once.deviceMilliseconds);
}

TEST_F(PassTest, APassWithinAnotherIsTimedOnItsOwn) {
    Pass::enableTiming(true);
    {
        const Pass outer("outer");
        const Pass inner("inner");
        clearTexture();
    }
    EXPECT_EQ(Pass::times().at("outer").count, 1);
    EXPECT_EQ(Pass::times().at("inner").count, 1);
    EXPECT_GE(Pass::times().at("outer").deviceMilliseconds, Pass::times().at("inner").deviceMilliseconds);
}

TEST_F(PassTest, NothingIsNotedWhileTimingIsOff) {
    {
        const Pass pass("clear");
        clearTexture();
        Pass::enableTiming(true); // too late for the pass that is open
    }
    EXPECT_TRUE(Pass::times().empty());
}

TEST_F(PassTest, WhatTheDriverSaysIsLoggedByItsLevel) {
    ASSERT_TRUE(kIsLevelSet && isLogged(LogLevel::Performance) && !isLogged(LogLevel::Debug));
    testing::internal::CaptureStderr();
    const auto say = [](GLenum type, const char* message) {
        glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, type, 1, GL_DEBUG_SEVERITY_MEDIUM, -1, message);
    };
    say(GL_DEBUG_TYPE_PERFORMANCE, "a copy through the processor");
    say(GL_DEBUG_TYPE_OTHER, "idle talk");
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("performance: OpenGL: a copy through the processor\n"), std::string::npos) << said;
    EXPECT_EQ(said.find("idle talk"), std::string::npos) << said;
}

} // namespace
} // namespace vs::gl
