// SPDX-License-Identifier: Apache-2.0
// Volumes and places in units that suit scans from a nanometre to a metre a voxel.
#include "model/texts/quantities.h"

#include <gtest/gtest.h>

namespace vs::desktop {
namespace {

TEST(Quantities, VolumesHaveTheirUnit) {
    EXPECT_EQ(volumeText(0), "0.00 ml");
    EXPECT_EQ(volumeText(123.45), "123.5 ml");
    EXPECT_EQ(volumeText(0.05), "0.05 ml");
    EXPECT_EQ(volumeText(0.005), QString::fromUtf8("5.00 µl"));
    EXPECT_EQ(volumeText(96839e-15), "96.8 fl") << "96,839 voxels of 1e-4 mm";
    EXPECT_EQ(volumeText(2.5e5), "250 l");
}

TEST(Quantities, PlacesHaveTheDigitsThatSuitTheVoxels) {
    const auto place = [](double mm, double stepMm) {
        return (placeText(mm, stepMm) + " " + placeUnit(stepMm)).toStdString();
    };
    EXPECT_EQ(place(-12.34, 1), "12.3 mm");
    EXPECT_EQ(place(12.34, 0.45), "12.3 mm");
    EXPECT_EQ(place(0.0123, 1e-4), "12.3 µm");
    EXPECT_EQ(place(1.23e-5, 1e-6), "12.3 nm");
    EXPECT_EQ(place(32000, 500), "32.0 m");
}

} // namespace
} // namespace vs::desktop
