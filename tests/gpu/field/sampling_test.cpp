// SPDX-License-Identifier: Apache-2.0
#include "field/scene.h"
#include "gl/program.h"
#include "gpu/gl_test.h"
#include "phantom/phantom.h"
#include "reference/bspline.h"

#include <cmath>
#include <cstdlib>
#include <random>

namespace vs::field {
namespace {

class SamplingTest : public test::GlTest {
protected:
    // Gradients (xyz) and values (w) at places of the volume.
    static std::vector<glm::vec4> sample(const volume::Volume& volume, const std::vector<glm::vec4>& places,
                                         Sampling sampling = Sampling::Tricubic) {
        return sample(uploadVolume(volume), places, sampling, false);
    }

    static std::vector<glm::vec4> sample(const Field& field, const std::vector<glm::vec4>& places,
                                         Sampling sampling, bool fromQuads) {
        SceneBinding binding;
        binding.bind({.data = &field, .displayedRange = field.range, .greyWindow = field.range});
        setenv("VOLUME_STUDIO_SHADER_DIR", VS_TEST_SHADERS, 1);
        gl::Defines defines;
        if (sampling == Sampling::Tricubic) {
            defines.emplace_back("TRICUBIC", "1");
        }
        if (fromQuads) {
            defines.emplace_back("QUADS", "1");
        }
        gl::Program program("sample_data.comp", defines);
        unsetenv("VOLUME_STUDIO_SHADER_DIR");
        gl::Buffer in(places.size() * sizeof(glm::vec4), "places");
        gl::Buffer out(places.size() * sizeof(glm::vec4), "answers");
        in.write(std::span<const glm::vec4>(places));
        in.bindStorage(0);
        out.bindStorage(1);
        program.set("count", int(places.size()));
        program.dispatchOver({int(places.size()), 1, 1}, gl::Barrier::Storage);
        return out.read<glm::vec4>(places.size());
    }

    // Anywhere in the grid's box, which reaches half a voxel beyond the outermost centres.
    std::vector<glm::vec4> placesIn(glm::ivec3 dims, int count) {
        std::uniform_real_distribution<float> part(0, 1);
        std::vector<glm::vec4> places;
        for (int i = 0; i < count; ++i) {
            const glm::vec3 p(part(random_), part(random_), part(random_));
            places.emplace_back(p * glm::vec3(dims) - 0.5F, 0);
        }
        return places;
    }

    // What the device's filter makes of a step of height 1: hardware has only 8 bits for the place between
    // two texels, software all of them.
    double filterError() {
        const auto step =
            phantom::makePhantom({2, 1, 1}, volume::ScalarType::Float32, [](glm::dvec3 p) { return p.x; });
        double worst = 0;
        std::vector<glm::vec4> places;
        for (int i = 0; i < 1000; ++i) {
            places.emplace_back(float(i) / 1000, 0, 0, 0);
        }
        const auto values = sample(step, places, Sampling::Trilinear);
        for (std::size_t i = 0; i < places.size(); ++i) {
            worst = std::max(worst, double(std::abs(values[i].w - places[i].x)));
        }
        return worst;
    }

    std::mt19937 random_{3};
};

// Noise that uses the type's whole range, on an oblique grid with three different spacings.
volume::Volume makeNoise(volume::ScalarType type, double lo, double hi, glm::ivec3 dims = {23, 17, 11}) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(lo, hi);
    auto volume = phantom::makePhantom(dims, type, [&](glm::dvec3) { return value(random); });
    volume.geometry.worldFromVoxel =
        glm::dmat4({0.6, 0.3, 0, 0}, {-0.4, 0.9, 0.1, 0}, {0.2, 0, 2.5, 0}, {10, -20, 30, 1});
    return volume;
}

TEST_F(SamplingTest, QuadsGiveWhatTheFilterGives) {
    using enum volume::ScalarType;
    int compared = 0;
    for (const auto type : {UInt8, Int8, UInt16, Int16, Int32, Float32}) {
        for (const glm::ivec3 dims : {glm::ivec3(23, 17, 11), glm::ivec3(1, 5, 9), glm::ivec3(7, 1, 1)}) {
            const Field field = uploadVolume(makeNoise(type, -100, 100, dims));
            if (!field.quads) {
                GTEST_SKIP() << "this device has a texture unit";
            }
            auto places = placesIn(dims, 2000);
            for (const Sampling sampling : {Sampling::Trilinear, Sampling::Tricubic}) {
                const auto filtered = sample(field, places, sampling, false);
                const auto fromQuads = sample(field, places, sampling, true);
                for (std::size_t i = 0; i < places.size(); ++i) {
                    // Single precision, on the way from 0 to valueScale.
                    const double hair = 2e-6 * std::max(100.0, double(field.valueScale));
                    EXPECT_NEAR(fromQuads[i].w, filtered[i].w, hair);
                    ++compared;
                }
            }
        }
    }
    EXPECT_EQ(compared, 6 * 3 * 2 * 2000);
}

TEST_F(SamplingTest, LargeVolumesHaveNoQuads) {
    EXPECT_FALSE(makeQuads({2048, 2048, 16}, gl::Format::R16));
    EXPECT_FALSE(makeQuads({2048, 2048, 5}, gl::Format::R32F));
}

TEST_F(SamplingTest, TricubicEqualsTheBSplineOnTheCpu) {
    using enum volume::ScalarType;
    struct Case {
        volume::ScalarType type;
        Range range;
    };
    const double filter = filterError();
    for (const auto& [type, range] :
         {Case{UInt8, {0, 255}}, Case{Int8, {-128, 127}}, Case{UInt16, {0, 65535}},
          Case{Int16, {-32768, 32767}}, Case{Float32, {-3, 5}}}) {
        const auto volume = makeNoise(type, range.lo, range.hi);
        const auto places = placesIn(volume.geometry.dims, 4000);
        const auto samples = sample(volume, places);
        double worst = 0;
        double worstGradient = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto expected = reference::bsplineAt(volume, glm::dvec3(places[i]));
            worst = std::max(worst, std::abs(double(samples[i].w) - expected.value));
            worstGradient = std::max(worstGradient, glm::length(glm::dvec3(samples[i]) - expected.gradient));
        }
        RecordProperty(std::string(name(type)) + "_value", std::to_string(worst / range.width()));
        RecordProperty(std::string(name(type)) + "_gradient", std::to_string(worstGradient / range.width()));
        // A filter's error counts once along each axis; a voxel is 0.67 mm wide at the least.
        EXPECT_LT(worst, (1e-5 + 3 * filter) * range.width()) << name(type);
        EXPECT_LT(worstGradient, (1e-4 + 10 * filter) * range.width()) << name(type);
    }
}

TEST_F(SamplingTest, TheSoftwareRenderersFilterIsExactEnough) {
    if (test::filterError() > 0) {
        GTEST_SKIP() << "hardware filters with 8 bits between texels";
    }
    EXPECT_LT(filterError(), 1e-6);
}

TEST_F(SamplingTest, ARampIsReproducedAwayFromTheBorder) {
    const glm::dvec3 slopes(3, -2, 5);
    auto volume = phantom::makePhantom({20, 20, 20}, volume::ScalarType::Int16,
                                       [&](glm::dvec3 p) { return 40 + glm::dot(p, slopes); });
    auto places = placesIn({17, 17, 17}, 2000);
    for (auto& p : places) {
        p += glm::vec4(1.5F, 1.5F, 1.5F, 0); // 1 to 18: the four voxels along each axis are in the grid
    }
    // The slope is a difference of values, each off by as much along each axis (3 + 2 + 5 from voxel to
    // voxel), divided by the one voxel that is between their places at the least. Hardware adds 16-bit
    // numbers up with about two bits more.
    const double perTexel = 65535 * (test::filterError() > 0 ? 8e-6 : 2e-6);
    const double tolerance = perTexel + 10 * 12 * filterError();
    const auto samples = sample(volume, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_NEAR(samples[i].w, 40 + glm::dot(glm::dvec3(places[i]), slopes), tolerance);
        EXPECT_LT(glm::length(glm::dvec3(samples[i]) - slopes), tolerance);
    }
}

TEST_F(SamplingTest, AConstantStaysOneUpToTheBorder) {
    const auto volume =
        phantom::makePhantom({9, 9, 9}, volume::ScalarType::UInt8, [](glm::dvec3) { return 77; });
    for (const auto& s : sample(volume, placesIn({9, 9, 9}, 1000))) {
        EXPECT_NEAR(s.w, 77, toleranceAt(77, uploadVolume(volume)));
        EXPECT_LT(glm::length(glm::vec3(s)), 1e-3);
    }
}

TEST_F(SamplingTest, WhereANonFiniteVoxelCountsNothingIsInside) {
    auto volume = makeNoise(volume::ScalarType::Float32, 1, 2, {12, 12, 12});
    reinterpret_cast<float*>(volume.bytes.data())[(6 * 12 + 6) * 12 + 6] = std::nanf("");
    volume::computeRange(volume);
    const auto places = placesIn({12, 12, 12}, 4000);
    const auto samples = sample(volume, places);
    // Of two neighbours that are joined in one fetch, the part that the one d voxels away has. A fetch gives
    // the voxel the product of the three; where that is about as little as a coarse filter's step, none of
    // it.
    const auto weight = [](double d) {
        return d > 1 ? std::pow(std::max(2 - d, 0.0), 3) / 6 : 2.0 / 3 - 0.5 * d * d * (2 - d);
    };
    const auto part = [&](double d) { return d > 1 ? weight(d) / (weight(d) + weight(d - 1)) : 0.5; };
    const double seen = std::max(4 * test::filterError(), 1e-7);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec3 away = glm::abs(glm::dvec3(places[i]) - 6.0);
        if (part(away.x) * part(away.y) * part(away.z) > seen) {
            EXPECT_LT(samples[i].w, 0.9F) << "a voxel of no value reaches two voxels far, as at " << away.x
                                          << ' ' << away.y << ' ' << away.z;
        } else if (std::max({away.x, away.y, away.z}) > 2.01) {
            EXPECT_GT(samples[i].w, 0.9F);
        }
    }
}

} // namespace
} // namespace vs::field
