// SPDX-License-Identifier: Apache-2.0
#include "phantom/body_phantom.h"
#include "phantom/head_phantom.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace vs::phantom {
namespace {

constexpr auto kCsf = std::uint8_t(HeadTissue::Csf);
constexpr auto kGrey = std::uint8_t(HeadTissue::Grey);
constexpr auto kWhite = std::uint8_t(HeadTissue::White);
constexpr auto kVentricle = std::uint8_t(HeadTissue::Ventricle);

constexpr glm::ivec3 kCoarse(91, 109, 91); // 2 mm

// The clean head at 1 mm, made once.
const LabelledVolume& head() {
    static const LabelledVolume made = makeHeadPhantom({});
    return made;
}

std::uint8_t byteAt(const LabelledVolume& made, std::size_t n) { return std::uint8_t(made.volume.bytes[n]); }

std::size_t indexOf(glm::ivec3 dims, glm::ivec3 v) {
    return (std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
           std::size_t(v.x);
}

double millilitres(const LabelledVolume& made, std::uint8_t label) {
    return double(std::count(made.labels.begin(), made.labels.end(), label)) *
           made.volume.geometry.voxelMm3() / 1000;
}

// Whether all voxels within `reach` of a place have one label.
bool isWithin(const LabelledVolume& made, glm::ivec3 v, int reach, std::uint8_t label) {
    const glm::ivec3 dims = made.volume.geometry.dims;
    for (int z = v.z - reach; z <= v.z + reach; ++z) {
        for (int y = v.y - reach; y <= v.y + reach; ++y) {
            for (int x = v.x - reach; x <= v.x + reach; ++x) {
                const glm::ivec3 there(x, y, z);
                if (glm::any(glm::lessThan(there, glm::ivec3(0))) ||
                    glm::any(glm::greaterThanEqual(there, dims)) ||
                    made.labels[indexOf(dims, there)] != label) {
                    return false;
                }
            }
        }
    }
    return true;
}

// Voxels of one label that no border is within `reach` of.
std::vector<std::size_t> inside(const LabelledVolume& made, std::uint8_t label, int reach) {
    std::vector<std::size_t> found;
    const glm::ivec3 dims = made.volume.geometry.dims;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const std::size_t n = indexOf(dims, {x, y, z});
                if (made.labels[n] == label && isWithin(made, {x, y, z}, reach, label)) {
                    found.push_back(n);
                }
            }
        }
    }
    return found;
}

// What grows across faces from one voxel.
struct Region {
    std::size_t voxels = 0;
    std::vector<std::uint8_t> isIn;
};
Region regionFrom(const LabelledVolume& made, std::size_t start,
                  const std::function<bool(std::size_t)>& enters) {
    const glm::ivec3 dims = made.volume.geometry.dims;
    Region region{1, std::vector<std::uint8_t>(made.labels.size())};
    std::vector<std::size_t> queue{start};
    region.isIn[start] = 1;
    while (!queue.empty()) {
        const std::size_t n = queue.back();
        queue.pop_back();
        const std::size_t slice = std::size_t(dims.x) * std::size_t(dims.y);
        const glm::ivec3 v(int(n % std::size_t(dims.x)), int(n / std::size_t(dims.x) % std::size_t(dims.y)),
                           int(n / slice));
        for (int axis = 0; axis < 3; ++axis) {
            for (const int step : {-1, 1}) {
                glm::ivec3 next = v;
                next[axis] += step;
                if (next[axis] < 0 || next[axis] >= dims[axis]) {
                    continue;
                }
                const std::size_t m = indexOf(dims, next);
                if (region.isIn[m] == 0 && enters(m)) {
                    region.isIn[m] = 1;
                    ++region.voxels;
                    queue.push_back(m);
                }
            }
        }
    }
    return region;
}

// Deep in the white matter of the left hemisphere.
std::size_t whitePlace() { return indexOf(head().volume.geometry.dims, {118, 112, 118}); }

TEST(HeadPhantom, TissuesHaveTheVolumesOfAnAdult) {
    const auto& made = head();
    EXPECT_EQ(made.volume.geometry.spacing(), glm::dvec3(1));
    // Ranges of healthy adults (Luders et al. 2002; Colin27's labels lie in them); CSF with the fluid that a
    // T1 picture cannot tell from meninges.
    const auto expectBetween = [&](HeadTissue tissue, double lo, double hi) {
        const double ml = millilitres(made, std::uint8_t(tissue));
        EXPECT_GT(ml, lo) << int(tissue);
        EXPECT_LT(ml, hi) << int(tissue);
    };
    expectBetween(HeadTissue::Grey, 500, 900);
    expectBetween(HeadTissue::White, 400, 700);
    expectBetween(HeadTissue::Csf, 200, 550);
    expectBetween(HeadTissue::Ventricle, 10, 45);
    expectBetween(HeadTissue::Skull, 350, 800);
}

TEST(HeadPhantom, IsTheSameHeadAtOtherResolutions) {
    const auto coarse = makeHeadPhantom({.dims = kCoarse});
    for (std::uint8_t label = 1; label <= kVentricle; ++label) {
        const double ml = millilitres(head(), label);
        // Sulci are narrower than a coarse voxel: a label that goes to the larger share loses some of them.
        EXPECT_NEAR(millilitres(coarse, label), ml, 0.08 * ml + 1) << int(label);
    }
}

TEST(HeadPhantom, ValuesAwayFromBordersAreThoseOfTheirTissue) {
    const auto& made = head();
    const std::array<std::pair<std::uint8_t, double>, 4> tissues{
        {{0, t1::air}, {kCsf, t1::fluid}, {kWhite, t1::white}, {kVentricle, t1::fluid}}};
    for (const auto& [label, value] : tissues) {
        const auto voxels = inside(made, label, 2);
        EXPECT_GT(voxels.size(), 1000U) << int(label);
        const auto exact = std::count_if(voxels.begin(), voxels.end(), [&, expected = value](std::size_t n) {
            return byteAt(made, n) == expected;
        });
        // What is thinner than half a voxel changes values without a label of its own.
        EXPECT_GT(double(exact), 0.99 * double(voxels.size())) << int(label);
    }
    // The cortex is too thin for that; deep nuclei are a little brighter than it.
    double sum = 0;
    const auto grey = inside(made, kGrey, 1);
    for (const std::size_t n : grey) {
        sum += byteAt(made, n);
    }
    EXPECT_NEAR(sum / double(grey.size()), t1::grey, 0.06 * t1::grey);
}

TEST(HeadPhantom, BrainIsOnePieceAndRunsIntoTheScalpByThresholdAlone) {
    const auto& made = head();
    const auto isBrain = [&](std::size_t n) { return made.labels[n] == kGrey || made.labels[n] == kWhite; };
    const auto brain = regionFrom(made, whitePlace(), isBrain);
    std::size_t all = 0;
    for (std::size_t n = 0; n < made.labels.size(); ++n) {
        all += isBrain(n) ? 1 : 0;
    }
    // What sulci on all sides cut off from a gyrus' crown are a few voxels each.
    EXPECT_GT(double(brain.voxels), 0.995 * double(all));
    const auto byThreshold = regionFrom(
        made, whitePlace(), [&](std::size_t n) { return byteAt(made, n) >= 75 && byteAt(made, n) <= 160; });
    std::size_t scalp = 0;
    for (std::size_t n = 0; n < made.labels.size(); ++n) {
        scalp += byThreshold.isIn[n] != 0 && made.labels[n] == std::uint8_t(HeadTissue::Scalp) ? 1 : 0;
    }
    EXPECT_GT(scalp, 50000U);
}

TEST(HeadPhantom, NoiseIsAsAskedForAndTheSameForOneSeed) {
    const HeadPhantomOptions options{.dims = kCoarse, .noisePercent = 3, .seed = 7};
    const auto noisy = makeHeadPhantom(options);
    EXPECT_EQ(noisy.labels, makeHeadPhantom({.dims = kCoarse}).labels);
    EXPECT_EQ(noisy.volume.bytes, makeHeadPhantom(options).volume.bytes);
    EXPECT_NE(noisy.volume.bytes,
              makeHeadPhantom({.dims = kCoarse, .noisePercent = 3, .seed = 8}).volume.bytes);
    double sum = 0;
    double squares = 0;
    const auto white = inside(noisy, kWhite, 2);
    for (const std::size_t n : white) {
        sum += byteAt(noisy, n);
        squares += double(byteAt(noisy, n)) * byteAt(noisy, n);
    }
    const double mean = sum / double(white.size());
    EXPECT_NEAR(mean, t1::white, 0.5);
    // Far above the noise Rician noise is Gaussian to sigma^2 / (2 value^2), and rounding adds 1 / 12 to the
    // variance: together below half a percent here.
    EXPECT_NEAR(std::sqrt(squares / double(white.size()) - mean * mean), 0.03 * t1::white,
                0.05 * 0.03 * t1::white);
    // Air holds the magnitude of noise alone: sqrt(pi / 2) sigma on average.
    double air = 0;
    const auto around = inside(noisy, 0, 2);
    for (const std::size_t n : around) {
        air += byteAt(noisy, n);
    }
    EXPECT_NEAR(air / double(around.size()), std::sqrt(std::numbers::pi / 2) * 0.03 * t1::white, 0.1);
}

TEST(HeadPhantom, BiasVariesByAsMuchAsAskedForOverTheBrain) {
    const auto biased = makeHeadPhantom({.biasPercent = 40});
    EXPECT_EQ(biased.labels, head().labels);
    double lo = 10;
    double hi = 0;
    for (const std::uint8_t label : {kCsf, kGrey, kWhite}) {
        for (const std::size_t n : inside(head(), label, 1)) {
            const double ratio = double(byteAt(biased, n)) / byteAt(head(), n);
            lo = std::min(lo, ratio);
            hi = std::max(hi, ratio);
        }
    }
    // Half a value of rounding on 40 (fluid), and voxels beside borders are left out.
    EXPECT_NEAR(lo, 0.8, 0.03);
    EXPECT_NEAR(hi, 1.2, 0.03);
}

TEST(BodyPhantom, AirAroundItIsOneRegionThatLungsDoNotTouch) {
    const auto made = makeBodyPhantom({.dims = glm::ivec3(128)});
    ASSERT_EQ(made.volume.type, volume::ScalarType::Int16);
    const auto* values = reinterpret_cast<const std::int16_t*>(made.volume.bytes.data());
    const auto isAir = [&](std::size_t n) { return values[n] < -500; };
    const auto air = regionFrom(made, 0, isAir);
    const auto labelled = std::size_t(std::count(made.labels.begin(), made.labels.end(), 0));
    // The level -500 lies a little on the air's side of the skin's surface.
    EXPECT_NEAR(double(air.voxels), double(labelled), 0.01 * double(labelled));
    EXPECT_GT(air.voxels, made.labels.size() / 2);
    for (std::size_t n = 0; n < made.labels.size(); ++n) {
        ASSERT_FALSE(air.isIn[n] != 0 && made.labels[n] == std::uint8_t(BodyTissue::Lung)) << n;
    }
    EXPECT_EQ(made.volume.bytes, makeBodyPhantom({.dims = glm::ivec3(128)}).volume.bytes);
}

} // namespace
} // namespace vs::phantom
