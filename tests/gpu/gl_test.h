// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "gl/context.h"
#include "gl/limits.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace vs::test {

// Whether a test that cannot run for want of a device has failed.
inline bool isDeviceRequired() {
    return std::getenv("CI") != nullptr || std::getenv("VOLUME_STUDIO_REQUIRE_GL") != nullptr;
}

// Fixture of every test that needs a device: one headless context for the process, and after each test no GL
// error, and no barrier that was missing (gl/hazards.h). Without a device the test skips; where one is
// required that is a failure.
// By how much of the difference between two neighbouring texels a device's filter may be off: hardware knows
// 256 places between them, software all that floats have.
inline double filterError() {
    const int steps = gl::pretendedFilterSteps();
    return gl::Context::isSoftware() ? (steps > 0 ? 0.5 / steps : 0.0) : 0.5 / 256;
}

class GlTest : public ::testing::Test {
protected:
    void SetUp() override {
        if (!context() && isDeviceRequired()) {
            FAIL() << "no OpenGL 4.5 device, and CI or VOLUME_STUDIO_REQUIRE_GL is set";
        }
        if (!context()) {
            GTEST_SKIP() << "no OpenGL 4.5 device here";
        }
        errorsBefore_ = context()->errorCount();
    }
    void TearDown() override {
        if (context()) {
            for (const std::string& hazard : context()->takeHazards()) {
                ADD_FAILURE() << "hazard: " << hazard;
            }
            EXPECT_EQ(context()->errorCount(), errorsBefore_) << "the test caused GL errors";
        }
    }

    static gl::Context* context() {
        static const std::unique_ptr<gl::Context> shared = [] {
            try {
                auto made = std::make_unique<gl::Context>(gl::Context::createHeadless());
                made->watchHazards();
                return made;
            } catch (const Error&) {
                return std::unique_ptr<gl::Context>();
            }
        }();
        return shared.get();
    }

private:
    int errorsBefore_ = 0;
};

} // namespace vs::test
