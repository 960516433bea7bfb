// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl_test.h"
#include "phantom/phantom.h"
#include "render/colours/classification.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

namespace vs::render {
namespace {

struct Answer {
    glm::vec4 colour;
    glm::vec4 mayBeVisible;
    glm::vec4 span;
};

class ClassificationTest : public test::GlTest {
protected:
    // Values from -1000 to 3000, half a millimetre apart.
    static field::Field makeField() {
        return field::uploadVolume(phantom::makePhantom(
            {17, 16, 16}, volume::ScalarType::Int16, [](glm::dvec3 p) { return -1000 + 250 * p.x; },
            glm::dvec3(0.5, 0.75, 1)));
    }

    static std::vector<Answer> ask(const Classification& classification,
                                   const std::vector<glm::vec2>& queries) {
        setenv("VOLUME_STUDIO_SHADER_DIR", VS_TEST_SHADERS, 1);
        gl::Defines defines;
        classification.addDefines(defines);
        gl::Program program("classify_values.comp", defines);
        unsetenv("VOLUME_STUDIO_SHADER_DIR");
        gl::Buffer in(queries.size() * sizeof(glm::vec2), "queries");
        gl::Buffer out(queries.size() * sizeof(Answer), "answers");
        in.write(std::span<const glm::vec2>(queries));
        in.bindStorage(0);
        out.bindStorage(1);
        classification.bind();
        program.set("count", int(queries.size()));
        program.dispatchOver({int(queries.size()), 1, 1}, gl::Barrier::Storage);
        return out.read<Answer>(queries.size());
    }

    std::vector<glm::vec2> pairs(int count, double lo, double hi, double lo2, double hi2) {
        std::vector<glm::vec2> out;
        std::uniform_real_distribution<double> x(lo, hi);
        std::uniform_real_distribution<double> y(lo2, hi2);
        for (int i = 0; i < count; ++i) {
            out.emplace_back(x(random_), y(random_));
        }
        return out;
    }

    // From any value to one at most `widest` away, more often near; with `direction` -1 either way, with 0
    // upwards.
    std::vector<glm::vec2> spans(int count, double direction, float widest) {
        auto out = pairs(count, -1000, 3000, direction, 1);
        for (glm::vec2& q : out) {
            q.y = q.x + widest * q.y * q.y * q.y;
        }
        return out;
    }

    TransferFunction randomCurve(FunctionKind kind, double lo, double hi) {
        std::uniform_real_distribution<double> position(lo, hi);
        std::uniform_int_distribution<int> byte(0, 255);
        TransferFunction f;
        f.kind = kind;
        for (int i = 0; i < 6; ++i) {
            f.points.push_back({position(random_), i % 3 == 0 ? byte(random_) / 255.0 : 0,
                                Colour(byte(random_), byte(random_), byte(random_))});
        }
        std::sort(f.points.begin(), f.points.end(),
                  [](const auto& a, const auto& b) { return a.position < b.position; });
        return f;
    }

    std::mt19937 random_{11};
};

double worstDifference(const glm::vec4& onDevice, const glm::dvec4& expected) {
    const glm::dvec4 d = glm::abs(glm::dvec4(onDevice) - expected);
    return std::max({d.x, d.y, d.z, d.w});
}

TEST_F(ClassificationTest, CurvesOnTheDeviceEqualTheFunction) {
    const field::Field field = makeField();
    for (const auto kind : {FunctionKind::Intensity, FunctionKind::Gradient}) {
        TransferFunction f;
        f.kind = kind;
        f.points = {{-500, 0, {10, 20, 30}},
                    {-100, 0.1, {200, 20, 30}},
                    {300, 0, {90, 220, 30}},
                    {900, 0.9, {0, 20, 230}},
                    {1500, 1, {255, 255, 255}}};
        Classification classification;
        EXPECT_TRUE(classification.update(f, field));
        const FunctionSampler sampler(f);
        const auto queries = pairs(2000, -1000, 3000, -1000, 3000);
        const auto answers = ask(classification, queries);
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const auto expected = sampler.at(double(queries[i].x), double(queries[i].y));
            // Half a texel, where the function is steepest.
            EXPECT_LE(worstDifference(answers[i].colour, expected), 2e-3) << queries[i].x;
        }
    }
}

TEST_F(ClassificationTest, ShapesOnTheDeviceEqualTheFunction) {
    const field::Field field = makeField();
    TransferFunction f;
    f.kind = FunctionKind::TwoD;
    f.shapes = {{Trapezoid{{0, 1000}, {300, 700}, {100, 900}, {1, 1}}, {255, 0, 0}, 0.8},
                {Trapezoid{{500, 2000}, {500, 2000}, {-200, 600}, {1, 1}}, {255, 0, 0}, 0.4}};
    Classification classification;
    classification.update(f, field);
    const FunctionSampler sampler(f);
    const auto queries = pairs(4000, -1000, 3000, 0, 2000);
    const auto answers = ask(classification, queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const auto expected = sampler.at(double(queries[i].x), double(queries[i].y));
        // Asked for at 512 x 256 places, between which the soft edges bend.
        EXPECT_LE(worstDifference(answers[i].colour, expected), 0.01) << queries[i].x << ' ' << queries[i].y;
    }
}

TEST_F(ClassificationTest, AStepAtTheEndIsAStep) {
    const field::Field field = makeField();
    TransferFunction f;
    f.points = {{500, 0}, {500, 0.8}, {1500, 0.8}, {1500, 0.1}};
    Classification classification;
    classification.update(f, field);
    const auto answers =
        ask(classification, {{-200, 0}, {498, 0}, {502, 0}, {1498, 0}, {1502, 0}, {2900, 0}});
    constexpr float expected[] = {0, 0, 0.8F, 0.8F, 0.1F, 0.1F};
    for (std::size_t i = 0; i < answers.size(); ++i) {
        EXPECT_NEAR(answers[i].colour.w, expected[i], 1e-5) << i;
    }
}

// What is seen with some gradient magnitude may be where magnitudes go up to that, and what the function has
// only with steeper ones is skipped.
TEST_F(ClassificationTest, SteepnessTellsWhatCannotBeSeen) {
    const field::Field field = makeField();
    for (const auto kind : {FunctionKind::TwoD, FunctionKind::Gradient}) {
        TransferFunction f;
        f.kind = kind;
        f.shapes = {{Trapezoid{{0, 1000}, {300, 700}, {400, 900}, {0, 0}}, {255, 0, 0}, 0.8}};
        f.points = {{400, 0}, {400, 0.5}, {900, 0.5}};
        Classification classification;
        classification.update(f, field);
        const FunctionSampler sampler(f);
        const auto queries = pairs(4000, -1000, 3000, 0, 2000);
        const auto answers = ask(classification, queries);
        int skipped = 0;
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const bool isSeen = sampler.at(double(queries[i].x), double(queries[i].y)).w > 0;
            EXPECT_TRUE(!isSeen || answers[i].mayBeVisible.y > 0) << queries[i].x << ' ' << queries[i].y;
            const bool isFlat = queries[i].y < 380;
            EXPECT_TRUE(!isFlat || answers[i].mayBeVisible.y == 0) << queries[i].x << ' ' << queries[i].y;
            skipped += answers[i].mayBeVisible.y > 0 ? 0 : 1;
        }
        EXPECT_GT(skipped, 500);
    }
}

// A piece of a ray along which the value goes from one to another shows a mean of the function between them.
TEST_F(ClassificationTest, SpansShowWhatLiesBetweenTheirEndsAndNothingElse) {
    const field::Field field = makeField();
    int empty = 0;
    for (int i = 0; i < 20; ++i) {
        const auto f = randomCurve(FunctionKind::Intensity, -1200, 3200);
        const FunctionSampler sampler(f);
        Classification classification;
        classification.update(f, field);
        const auto queries = spans(400, -1, 1500);
        const auto answers = ask(classification, queries);
        for (std::size_t q = 0; q < queries.size(); ++q) {
            double least = 1;
            double greatest = 0;
            const double column = 4400.0 / 4089; // at the most: places are rounded to whole ones
            const double lo = std::min(double(queries[q].x), double(queries[q].y)) - column;
            const double hi = std::max(double(queries[q].x), double(queries[q].y)) + column;
            for (int k = 0; k <= 500; ++k) {
                const double value = glm::mix(lo, hi, k / 500.0);
                const double opacity = opacityOver(sampler.at(value, 0).w, 0.5);
                least = std::min(least, opacity);
                greatest = std::max(greatest, opacity);
            }
            const double opacity = double(answers[q].span.w);
            const double hair = 1e-3;
            EXPECT_GE(opacity, least - hair) << queries[q].x << ' ' << queries[q].y;
            EXPECT_LE(opacity, greatest + hair) << queries[q].x << ' ' << queries[q].y;
            if (answers[q].mayBeVisible.x == 0 && queries[q].x < queries[q].y) {
                EXPECT_EQ(opacity, 0) << "or skipping it would change the picture";
                ++empty;
            }
        }
    }
    EXPECT_GT(empty, 200);
}

// However wide its pieces are, a ray along which the value rises meets as much of a thin peak.
TEST_F(ClassificationTest, ThinPeaksCountWhateverTheWidthOfThePieces) {
    const field::Field field = makeField();
    TransferFunction f;
    f.points = {{-1000, 0}, {990, 0}, {1000, 0.4}, {1010, 0}, {3000, 0, {255, 255, 255}}};
    Classification classification;
    classification.update(f, field);
    const double across = -std::log(1 - 0.4) * 10 * 0.9; // about the integral of the peak's depth
    for (const double width : {3.0, 20.0, 77.0, 150.0, 400.0}) {
        std::vector<glm::vec2> queries;
        for (int phase = 0; phase < 64; ++phase) {
            for (double value = -1000 - width * phase / 64.0; value < 3000; value += width) {
                queries.emplace_back(value, value + width);
            }
        }
        double sum = 0;
        for (const Answer& answer : ask(classification, queries)) {
            sum += -2 * std::log(1 - double(answer.span.w)) * width;
        }
        EXPECT_NEAR(sum / 64 / across, 1, 0.06) << width;
    }
}

TEST_F(ClassificationTest, NothingVisibleIsEverSkipped) {
    const field::Field field = makeField();
    int skipped = 0;
    for (int i = 0; i < 40; ++i) {
        const auto f = randomCurve(FunctionKind::Intensity, -1500, 3500);
        const FunctionSampler sampler(f);
        Classification classification;
        classification.update(f, field);
        const auto queries = spans(200, 0, 200);
        const auto answers = ask(classification, queries);
        for (std::size_t q = 0; q < queries.size(); ++q) {
            bool isVisible = false;
            for (int k = 0; k <= 50; ++k) {
                const double value = glm::mix(double(queries[q].x), double(queries[q].y), k / 50.0);
                isVisible = isVisible || sampler.at(value, 0).w > 1e-9;
            }
            skipped += answers[q].mayBeVisible.x > 0 ? 0 : 1;
            EXPECT_TRUE(!isVisible || answers[q].mayBeVisible.x > 0) << queries[q].x << ' ' << queries[q].y;
        }
    }
    EXPECT_GT(skipped, 400) << "and something is";
}

TEST_F(ClassificationTest, GradientsAloneRuleOutNothingButTheEmptyFunction) {
    const field::Field field = makeField();
    TransferFunction f;
    f.kind = FunctionKind::Gradient;
    f.points = {{0, 0}, {100, 0.5}};
    Classification classification;
    classification.update(f, field);
    EXPECT_EQ(ask(classification, {{5, 6}})[0].mayBeVisible.x, 1);
    f.points[1].opacity = 0;
    classification.update(f, field);
    EXPECT_EQ(ask(classification, {{5, 6}})[0].mayBeVisible.x, 0);
}

TEST_F(ClassificationTest, NonFiniteVoxelsAreClear) {
    auto volume = phantom::makeBall({16, 16, 16}, glm::dvec3(8), 5, 1, 0, 2, volume::ScalarType::Float32);
    reinterpret_cast<float*>(volume.bytes.data())[3] = std::numeric_limits<float>::quiet_NaN();
    volume::computeRange(volume);
    const field::Field field = field::uploadVolume(volume);
    TransferFunction f;
    f.points = {{0, 0.5}, {1, 0.5}};
    Classification classification;
    classification.update(f, field);
    const auto answers = ask(classification, {{-1e30F, -1e30F}, {-1e27F, 0.5F}, {0, 0}});
    EXPECT_EQ(answers[0].colour.w, 0);
    EXPECT_EQ(answers[0].mayBeVisible.x, 0);
    EXPECT_EQ(answers[1].colour.w, 0);
    EXPECT_EQ(answers[1].mayBeVisible.x, 1);
    EXPECT_NEAR(answers[2].colour.w, 0.5, 1e-6);
    EXPECT_EQ(answers[0].span.w, 0);
    EXPECT_EQ(answers[1].span.w, 0);
    EXPECT_NEAR(answers[2].span.w, 1 - std::sqrt(0.5), 1e-6);
}

TEST_F(ClassificationTest, OnlyTablesAreUploadedAndOnlyWhenSomethingChanged) {
    const field::Field field = makeField();
    TransferFunction f = randomCurve(FunctionKind::Intensity, -1000, 3000);
    Classification classification;
    EXPECT_TRUE(classification.update(f, field));
    const std::size_t once = classification.uploadedBytes();
    EXPECT_LE(once, 4U << 20);
    EXPECT_FALSE(classification.update(f, field));
    EXPECT_EQ(classification.uploadedBytes(), once);
    f.points[2].opacity += 0.01;
    const int version = classification.version();
    EXPECT_TRUE(classification.update(f, field));
    EXPECT_EQ(classification.uploadedBytes(), 2 * once);
    EXPECT_NE(classification.version(), version);
    EXPECT_TRUE(classification.update(f, makeField()));
}

TEST_F(ClassificationTest, OneKindCanFollowAnother) {
    const field::Field field = makeField();
    TransferFunction curve;
    curve.points = {{0, 0.25}, {1000, 0.75}};
    TransferFunction plane;
    plane.kind = FunctionKind::TwoD;
    plane.shapes = {{Trapezoid{{0, 1000}, {0, 1000}, {-100, 100}, {0, 0}}, {255, 0, 0}, 0.5}};
    TransferFunction edges = curve;
    edges.kind = FunctionKind::Gradient;
    Classification classification;
    for (int i = 0; i < 2; ++i) {
        classification.update(curve, field);
        EXPECT_NEAR(ask(classification, {{500, 0}})[0].colour.w, 0.5, 1e-3);
        EXPECT_EQ(ask(classification, {{500, 600}})[0].mayBeVisible.x, 1);
        classification.update(plane, field);
        EXPECT_NEAR(ask(classification, {{500, 50}})[0].colour.w, 0.5, 1e-6);
        EXPECT_EQ(ask(classification, {{500, 150}})[0].colour.w, 0);
        EXPECT_EQ(ask(classification, {{-900, -200}})[0].mayBeVisible.x, 0);
        classification.update(edges, field);
        EXPECT_NEAR(ask(classification, {{-900, 500}})[0].colour.w, 0.5, 1e-3);
        EXPECT_EQ(ask(classification, {{-900, -200}})[0].mayBeVisible.x, 1);
    }
}

TEST_F(ClassificationTest, OpacityIsPerMillimetreWhenAsked) {
    const field::Field field = makeField(); // a step is 0.5 mm
    TransferFunction f;
    f.points = {{0, 0.36}};
    f.unitMm = 1;
    Classification classification;
    classification.update(f, field);
    EXPECT_NEAR(ask(classification, {{0, 0}})[0].colour.w, 0.2, 1e-5);
}

TEST_F(ClassificationTest, RelativePositionsFollowTheVolume) {
    const field::Field field = makeField();
    TransferFunction f;
    f.positions = Positions::Relative;
    f.points = {{0, 0}, {0.5, 1}, {1, 0}};
    Classification classification;
    classification.update(f, field);
    EXPECT_NEAR(classification.resolved().points[1].position, 1000, 1e-3); // of -1000 to 3000
    f.positions = Positions::Robust;
    classification.update(f, field);
    EXPECT_NEAR(classification.resolved().points[1].position, 1000, 5);
}

} // namespace
} // namespace vs::render
