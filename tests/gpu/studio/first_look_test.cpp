// SPDX-License-Identifier: Apache-2.0
// How scans are shown to a person who opens them: all of the head and nothing of the air.
#include "gpu/gl_test.h"
#include "gpu/studio/test_head.h"
#include "image/compare.h"
#include "phantom/head_phantom.h"
#include "phantom/phantom.h"
#include "studio/document/document.h"
#include "studio/document/document_facts.h"
#include "studio/document/document_state.h"

#include <cstring>
#include <random>

namespace vs::studio {
namespace {

using FirstLookTest = test::GlTest;

struct WeakScan {
    volume::Volume volume;
    std::vector<std::uint8_t> labels;
};

// A head of which the coil receives the lower half ever more weakly, down to `weakest` at the chin; with the
// noise of magnitudes, in values (white matter has about 200).
WeakScan headFarFromCoil(double noise, double weakest) {
    phantom::HeadPhantomOptions options;
    options.dims = {91, 109, 91};
    auto head = phantom::makeHeadPhantom(options);
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0, 1);
    const glm::ivec3 dims = head.volume.geometry.dims;
    std::vector<std::int16_t> values(head.labels.size());
    forEachVoxel({glm::ivec3(0), dims}, [&](glm::ivec3 v, std::size_t n) {
        const double down = std::clamp(1 - 2.0 * v.z / dims.z, 0.0, 1.0);
        const double signal = head.volume.at(v) * (1 - (1 - weakest) * down);
        values[n] =
            std::int16_t(std::lround(std::hypot(signal + noise * normal(random), noise * normal(random))));
    });
    head.volume.type = volume::ScalarType::Int16;
    const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
    head.volume.bytes.assign(bytes, bytes + values.size() * sizeof(values[0]));
    volume::computeRange(head.volume);
    head.volume.details.modality = "MR";
    return {std::move(head.volume), std::move(head.labels)};
}

bool isHeadNear(const WeakScan& scan, glm::ivec3 voxel) {
    const glm::ivec3 dims = scan.volume.geometry.dims;
    bool isNear = false;
    forEachVoxel(intersect({voxel - 2, voxel + 3}, {glm::ivec3(0), dims}), [&](glm::ivec3 v, std::size_t) {
        isNear = isNear || scan.labels[std::size_t(v.x + dims.x * (v.y + dims.y * v.z))] != 0;
    });
    return isNear;
}

// As a viewer in front of the face sees it: the part of the head's silhouette where the surface of a range is
// the head's own, to two voxels; and the part of the picture that shows something more than two voxels off
// it.
struct Silhouette {
    double solid = 0;
    double specks = 0;
};
Silhouette silhouetteOf(const WeakScan& scan, double lo) {
    const glm::ivec3 dims = scan.volume.geometry.dims;
    const bool isFromFront = scan.volume.geometry.worldFromVoxel[1].y > 0; // y runs to the back
    double heads = 0;
    Silhouette seen;
    for (int z = 0; z < dims.z; ++z) {
        for (int x = 0; x < dims.x; ++x) {
            int met = -1; // the first of the range
            int head = -1;
            for (int n = dims.y - 1; n >= 0; --n) {
                const glm::ivec3 v{x, isFromFront ? n : dims.y - 1 - n, z};
                met = scan.volume.at(v) >= lo ? n : met;
                head = scan.labels[std::size_t(v.x + dims.x * (v.y + dims.y * v.z))] != 0 ? n : head;
            }
            heads += head >= 0 ? 1 : 0;
            seen.solid += head >= 0 && met >= 0 && met <= head + 2 ? 1 : 0;
            seen.specks +=
                met >= 0 && !isHeadNear(scan, {x, isFromFront ? met : dims.y - 1 - met, z}) ? 1 : 0;
        }
    }
    return {seen.solid / heads, seen.specks / double(dims.x * dims.z)};
}

TEST_F(FirstLookTest, AHeadIsSolidFarFromTheCoilAndTheAirIsEmpty) {
    for (const double noise : {0.0, 2.0, 5.0, 9.0}) {
        for (const double weakest : {1.0, 0.5, 0.35}) {
            const WeakScan scan = headFarFromCoil(noise, weakest);
            Document document(scan.volume);
            const FirstLook look = document.facts()->firstLook;
            const Silhouette seen = silhouetteOf(scan, look.range.lo);
            const Silhouette before = silhouetteOf(scan, document.view().range.lo);
            EXPECT_EQ(look.mode, render::Mode::Surface);
            EXPECT_EQ(look.range.hi, scan.volume.range.hi);
            EXPECT_GE(seen.solid, before.solid) << noise << ", " << weakest;
            EXPECT_GT(seen.solid, 0.99) << "noise " << noise << ", signal " << weakest << ", from "
                                        << look.range.lo << ", Otsu from " << document.view().range.lo;
            EXPECT_LT(seen.specks, 0.0005)
                << "noise " << noise << ", signal " << weakest << ", from " << look.range.lo;
        }
    }
}

// What begins nowhere near air: all of its values are the object's.
TEST_F(FirstLookTest, NeverBeginsAboveTheObject) {
    for (const double inside : {3.0, 100.0, 20000.0}) {
        auto volume =
            phantom::makeBall({40, 40, 40}, {20, 20, 20}, 15, inside, 0, 0, volume::ScalarType::Int16);
        volume.details.modality = "MR";
        Document document(volume);
        const Range look = document.facts()->firstLook.range;
        EXPECT_GT(look.lo, 0);
        EXPECT_LE(look.lo, document.view().range.lo);
        EXPECT_EQ(look.hi, inside);
    }
}

TEST_F(FirstLookTest, WhatIsNotMrBeginsWhereItAlwaysDid) {
    for (const double air : {-1000.0, 0.0}) {
        auto volume =
            phantom::makeBall({40, 40, 40}, {20, 20, 20}, 15, 60, air, 2, volume::ScalarType::Int16);
        for (const auto& [modality, path, isMr] : {std::tuple{"CT", "", false},
                                                   {"", "a.nrrd", false},
                                                   {"CT", "a.nii", false},
                                                   {"", "A.NII.gz", true}}) {
            volume.details.modality = modality;
            volume.path = path;
            Document document(volume);
            EXPECT_EQ(!(document.facts()->firstLook.range == document.view().range), isMr && air == 0)
                << modality << path << air;
        }
    }
}

image::Image seenIn(Document& document, const Range& range) {
    View view = document.view();
    view.range = range;
    document.showView(view);
    render::RayCaster caster;
    caster.render(document.frame({200, 160}));
    return caster.readPicture();
}

// One value that stands for "not measured", or that a broken pixel gave, does not decide how all others are
// seen.
TEST_F(FirstLookTest, ExtremeValuesChangeNothingOfTheRest) {
    const auto ball =
        phantom::makeBall({40, 40, 40}, {20, 20, 20}, 15, 180, 0, 3, volume::ScalarType::Float32);
    Document whole(ball);
    const Range suggested = whole.view().range;
    const Range wanted{100, 200};
    const image::Image picture = seenIn(whole, wanted);
    for (const float extreme : {1e30F, -1e29F, 3e38F, 1e7F, -1e7F}) {
        volume::Volume filled = ball;
        std::memcpy(filled.bytes.data(), &extreme, sizeof extreme); // the first voxel, in a corner
        volume::computeRange(filled);
        EXPECT_EQ(extreme > 0 ? filled.range.hi : filled.range.lo, double(extreme)); // as it is
        Document document(filled);
        EXPECT_NEAR(document.view().range.lo, suggested.lo, 1e-6) << extreme;
        EXPECT_NEAR(document.view().range.hi, suggested.hi, 1e-6) << extreme;
        EXPECT_NEAR(document.facts()->firstLook.range.lo, whole.facts()->firstLook.range.lo, 1e-6);
        for (std::size_t bin = 1; bin < whole.histogram().size(); ++bin) { // but where the voxel was
            EXPECT_NEAR(double(document.histogram()[bin]), double(whole.histogram()[bin]), 1) << extreme;
        }
        // The ball and not the grid's box; a speck about the corner, where values pass through the range.
        EXPECT_LT(image::compare(picture, seenIn(document, wanted)).changedFraction, 0.002) << extreme;
    }
    // Many of a fill value, and vessels of a few bright voxels, which are no extremes.
    volume::Volume masked = ball;
    const float fill = 1e20F;
    for (std::size_t i = 0; i < 20000; ++i) {
        std::memcpy(masked.bytes.data() + i * sizeof fill, &fill, sizeof fill);
    }
    volume::computeRange(masked);
    EXPECT_EQ(masked.usual.hi, ball.range.hi);
    volume::Volume bright = ball;
    const float vessel = 2000;
    std::memcpy(bright.bytes.data(), &vessel, sizeof vessel);
    volume::computeRange(bright);
    EXPECT_EQ(bright.usual.hi, 2000);
}

TEST_F(FirstLookTest, LookingTakesNoRoomForCutting) {
    Document document(
        phantom::makeBall({40, 40, 40}, {20, 20, 20}, 15, 180, 0, 3, volume::ScalarType::UInt8));
    for (const render::Mode mode : {render::Mode::Surface, render::Mode::Volume, render::Mode::Mip}) {
        View view = document.view();
        view.mode = mode;
        document.showView(view);
        seenIn(document, {100, 200});
        EXPECT_FALSE(document.sculpture().takesRoom()) << int(mode);
    }
    const Document again(document.volume(), document.state()); // nor does saving it, or opening it again
    EXPECT_FALSE(document.sculpture().takesRoom());
    EXPECT_FALSE(again.sculpture().takesRoom());
    Peel peel;
    peel.mask = test::ellipseAt(100, 80, 20, 20);
    peel.canvas = Canvas{document.view(), {200, 160}};
    peel.layers = 3;
    document.apply(peel);
    EXPECT_TRUE(document.sculpture().takesRoom());
}

TEST_F(FirstLookTest, EmissionScansAndAngiographiesAreProjected) {
    auto volume = phantom::makePhantom({48, 48, 48}, volume::ScalarType::Int16, [](glm::dvec3 p) {
        const double r = glm::length(p - glm::dvec3(23.5));
        return r < 1.5 ? 30000 : r < 18 ? 900 : 0; // a hot bladder in a body
    });
    const auto lookOf = [&] { return Document(volume).facts()->firstLook; };
    EXPECT_EQ(lookOf().mode, render::Mode::Surface);
    for (const char* modality : {"PT", "NM"}) {
        volume.details.modality = modality;
        const FirstLook look = lookOf();
        EXPECT_EQ(look.mode, render::Mode::Mip) << modality;
        EXPECT_LT(look.range.lo, 900) << "the body is seen";
        EXPECT_LT(look.range.hi, 30000) << "and is not black beside what is hot";
        EXPECT_GE(look.range.hi, 900);
    }
    volume.details.modality = "MR";
    volume.details.isAngiography = true;
    EXPECT_EQ(lookOf().mode, render::Mode::Mip);
}

} // namespace
} // namespace vs::studio
