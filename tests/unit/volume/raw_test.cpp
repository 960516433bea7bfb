// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "volume/io/decode.h"

#include "test_files.h"

namespace vs::volume {
namespace {

TEST(RawLayout, ReadsEveryPart) {
    const auto layout = parseRawLayout("256x128x64:int16:0.5,1,2.25:12");
    EXPECT_EQ(layout.dims, glm::ivec3(256, 128, 64));
    EXPECT_EQ(layout.type, ScalarType::Int16);
    EXPECT_EQ(layout.spacing, glm::dvec3(0.5, 1, 2.25));
    EXPECT_EQ(layout.offsetBytes, 12U);
    EXPECT_EQ(parseRawLayout("1x2x3:float32").spacing, glm::dvec3(1));
}

TEST(RawLayout, RefusesNonsense) {
    for (const char* text :
         {"", "2x2", "2x2:uint8", "2x2x2", "2x2x2:uint9", "0x2x2:uint8", "-2x2x2:uint8",
          "2x2x2:", "2.5x2x2:uint8", "2x2x2:uint8:0,1,1", "2x2x2:uint8:1,1", "2x2x2:uint8:nan,1,1",
          "2x2x2:uint8:1,1,1:-5", "2x2x2:uint8:1,1,1:x", "2x2x2:uint8:1,1,1:0:9", "axbxc:uint8"}) {
        EXPECT_THROW((void)parseRawLayout(text), UsageError) << text;
    }
}

TEST(RawFile, ReadsLittleEndianBehindAnOffset) {
    const TemporaryFolder folder;
    writeFile(folder / "a.raw", "head" + std::string("\1\0\xFF\xFF", 4));
    ReadOptions options;
    options.raw = parseRawLayout("2x1x1:int16:1,2,3:4");
    const auto volume = decodeVolume(folder / "a.raw", options).volume;
    EXPECT_EQ(volume.at({0, 0, 0}), 1);
    EXPECT_EQ(volume.at({1, 0, 0}), -1);
    EXPECT_EQ(volume.range, (Range{-1, 1}));
    EXPECT_EQ(volume.geometry.spacing(), glm::dvec3(1, 2, 3));
}

} // namespace
} // namespace vs::volume
