// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "gl/context.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

namespace vs::test {

// Fixture of every test that needs a device: one headless context for the process, and after each test no GL
// error. Without a device the test skips; with VOLUME_STUDIO_REQUIRE_GL set (CI) that is a failure.
class GlTest : public ::testing::Test {
protected:
    void SetUp() override {
        if (!context() && std::getenv("VOLUME_STUDIO_REQUIRE_GL") != nullptr) {
            FAIL() << "no OpenGL 4.5 device, and VOLUME_STUDIO_REQUIRE_GL is set";
        }
        if (!context()) {
            GTEST_SKIP() << "no OpenGL 4.5 device here";
        }
        errorsBefore_ = context()->errorCount();
    }
    void TearDown() override {
        if (context()) {
            EXPECT_EQ(context()->errorCount(), errorsBefore_) << "the test caused GL errors";
        }
    }

    static gl::Context* context() {
        static const std::unique_ptr<gl::Context> shared = [] {
            try {
                return std::make_unique<gl::Context>(gl::Context::createHeadless());
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
