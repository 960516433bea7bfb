// SPDX-License-Identifier: Apache-2.0
#include "gl/pass.h"

#include "gl/texture.h"
#include "gpu/gl_test.h"

namespace vs::gl {
namespace {

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

} // namespace
} // namespace vs::gl
