// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "render/marks/background.h"

#include <gtest/gtest.h>

namespace vs::render {
namespace {

TEST(Background, NamesAreReadBack) {
    for (const std::string text : {"studio", "white", "black", "transparent", "#12AB00", "#FF0000:#0000FF"}) {
        EXPECT_EQ(name(backgroundFromName(text)), text);
    }
    EXPECT_EQ(name(Background{}), "studio");
    EXPECT_EQ(name(backgroundFromName("#ffffff")), "white");
    EXPECT_EQ(name(backgroundFromName("#12ab00:#12AB00")), "#12AB00");
}

TEST(Background, ColoursAreTopAndBottom) {
    const Background background = backgroundFromName("#FF0000:#000080");
    EXPECT_EQ(background.top, glm::vec3(1, 0, 0));
    EXPECT_NEAR(background.bottom.z, 128 / 255.0, 1e-6);
    EXPECT_NEAR(linearBottom(background).z, 0.2159, 1e-4); // by the sRGB standard
    EXPECT_NEAR(linearTop(background).x, 1, 1e-6);
    EXPECT_TRUE(backgroundFromName("transparent").isTransparent);
}

TEST(Background, AnythingElseIsRefusedByName) {
    for (const std::string text : {"", "White", "grey", "#", "#12345", "#1234567", "#12345G", "#+12345",
                                   "#123456:", ":#123456", "#123456:#123456:#123456", "#123456 "}) {
        try {
            backgroundFromName(text);
            FAIL() << text;
        } catch (const UsageError& error) {
            EXPECT_NE(std::string(error.what()).find("'" + text + "'"), std::string::npos);
        }
    }
}

} // namespace
} // namespace vs::render
