// SPDX-License-Identifier: Apache-2.0
#include "render/rays/occlusion.h"

#include "field/cell_ranges.h"
#include "gpu/gl_test.h"
#include "phantom/phantom.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

namespace vs::render {
namespace {

struct Query {
    glm::vec4 voxel;
    glm::vec4 normal;
};

struct Answer {
    float ambient;
    float key;
    float cheapKey;
    float cheapAmbient;
};

// Signed distance in mm, positive inside, from a place in mm.
using Shape = std::function<double(glm::dvec3)>;

// A volume whose values change by 40 a millimetre across the shape's surface, which is at 100.
volume::Volume makeShape(glm::ivec3 dims, const Shape& shape, glm::dvec3 spacing = glm::dvec3(1)) {
    return phantom::makePhantom(
        dims, volume::ScalarType::UInt8,
        [&](glm::dvec3 p) { return std::clamp(100 + 40 * shape(p * spacing), 0.0, 200.0); }, spacing);
}

double box(glm::dvec3 p, glm::dvec3 lo, glm::dvec3 hi) {
    const glm::dvec3 inside = glm::min(p - lo, hi - p);
    return std::min({inside.x, inside.y, inside.z});
}

double ball(glm::dvec3 p, glm::dvec3 centre, double radius) { return radius - glm::length(p - centre); }

// A shape and its occlusion volume.
struct Stage {
    explicit Stage(const volume::Volume& volume) : field(field::uploadVolume(volume)) {
        cells = field::computeCellRanges(field);
        input.scene.data = &field;
        input.scene.displayedRange = {100, 255};
        input.macrocells = &macrocells;
        rebuild();
    }
    Stage(glm::ivec3 dims, const Shape& shape, glm::dvec3 spacing = glm::dvec3(1))
        : Stage(makeShape(dims, shape, spacing)) {}

    void rebuildMacrocells() {
        Macrocells::Input in;
        in.dataCells = &cells.cells;
        in.visibleRange = input.scene.displayedRange;
        in.view = input.scene.view;
        if (input.scene.sculpture != nullptr) {
            sculptureCells = gl::Texture(cells.cells.size(), gl::Format::RG32F, gl::Filter::Nearest, "cells");
            field::CellRangeUpdater().update(*input.scene.sculpture, field.geometry.box(), sculptureCells);
            in.sculptureCells = &sculptureCells;
        }
        macrocells.rebuild(in);
    }

    void rebuild() {
        rebuildMacrocells();
        occlusion.rebuild(input);
    }

    // Places and normals in mm.
    std::vector<Answer> ask(const std::vector<std::pair<glm::dvec3, glm::dvec3>>& places,
                            const Light& light = {}) {
        std::vector<Query> queries;
        for (const auto& [place, normal] : places) {
            queries.push_back(
                {glm::vec4(place / field.geometry.spacing(), 0), glm::vec4(glm::normalize(normal), 0)});
        }
        setenv("VOLUME_STUDIO_SHADER_DIR", VS_TEST_SHADERS, 1);
        static thread_local gl::Program program("look_up_light.comp");
        unsetenv("VOLUME_STUDIO_SHADER_DIR");
        gl::Buffer in(queries.size() * sizeof(Query), "queries");
        gl::Buffer out(queries.size() * sizeof(Answer), "answers");
        in.write(std::span<const Query>(queries));
        in.bindStorage(0);
        out.bindStorage(1);
        occlusion.bind(light);
        program.set("count", int(queries.size()));
        program.dispatchOver({int(queries.size()), 1, 1}, gl::Barrier::Storage);
        return out.read<Answer>(queries.size());
    }
    Answer ask(glm::dvec3 place, glm::dvec3 normal, const Light& light = {}) {
        return ask({{place, normal}}, light).front();
    }

    // Voxels that level 0 says are filled.
    double filledVoxels() {
        double sum = 0;
        for (const auto texel : occlusion.texels().downloadAll<std::uint8_t>()) {
            sum += texel / 255.0;
        }
        const glm::ivec3 block = OcclusionVolume::blockSize(field.geometry);
        return sum * block.x * block.y * block.z;
    }

    field::Field field;
    field::CellRanges cells;
    Macrocells macrocells;
    gl::Texture sculptureCells;
    OcclusionVolume::Input input;
    OcclusionVolume occlusion;
};

using OcclusionTest = test::GlTest;

TEST_F(OcclusionTest, CoverageIsTheVolumeFraction) {
    const double radius = 17.3;
    Stage ballStage({61, 58, 64}, [&](glm::dvec3 p) { return ball(p, {30.2, 28.9, 31.4}, radius); });
    EXPECT_NEAR(ballStage.filledVoxels() / (4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3)), 1, 0.01);
    const glm::dvec3 lo{10.3, 12.6, 9.1};
    const glm::dvec3 hi{44.9, 31.2, 50.7};
    Stage boxStage({61, 58, 64}, [&](glm::dvec3 p) { return box(p, lo, hi); });
    const glm::dvec3 size = hi - lo;
    EXPECT_NEAR(boxStage.filledVoxels() / (size.x * size.y * size.z), 1, 0.01);
}

TEST_F(OcclusionTest, AFullGridIsFullToItsBordersAndNotBeyond) {
    Stage stage({33, 31, 35}, [](glm::dvec3) { return 10.0; });
    EXPECT_NEAR(stage.filledVoxels(), 33 * 31 * 35, 0.002 * 33 * 31 * 35) << "texels hold 255 steps";
}

TEST_F(OcclusionTest, TexelsAreAboutAsLongAsWide) {
    EXPECT_EQ(OcclusionVolume::blockSize(volume::makeGeometry({256, 256, 256})), glm::ivec3(2));
    EXPECT_EQ(OcclusionVolume::blockSize(volume::makeGeometry({512, 512, 512})), glm::ivec3(4));
    EXPECT_EQ(OcclusionVolume::blockSize(volume::makeGeometry({256, 256, 60}, {1, 1, 4})),
              glm::ivec3(4, 4, 1));
}

TEST_F(OcclusionTest, AnUpdateOfWhatWasCutGivesTheSameBytesAsRebuilding) {
    Stage stage({70, 61, 53}, [](glm::dvec3 p) { return ball(p, {33, 31, 26}, 24); });
    const glm::ivec3 dims = stage.field.geometry.dims;
    gl::Texture sculpture(dims, gl::Format::R16F, gl::Filter::Linear, "sculpture");
    stage.input.scene.sculpture = &sculpture;
    stage.rebuild();
    std::mt19937 random(7);
    const auto upTo = [&](int n) { return int(random() % unsigned(n)); };
    for (int cut = 0; cut < 12; ++cut) {
        const glm::ivec3 lo{upTo(dims.x), upTo(dims.y), upTo(dims.z)};
        const Box3 box = intersect({lo, lo + 1 + glm::ivec3(upTo(20), upTo(20), upTo(20))}, {{}, dims});
        std::vector<std::uint16_t> halves(box.volume());
        for (auto& half : halves) {
            half = std::uint16_t(upTo(0x3c01)); // 0 to 1
        }
        sculpture.upload(box, std::as_bytes(std::span(halves)));
        stage.rebuildMacrocells();
        stage.occlusion.update(stage.input, box);
        OcclusionVolume fresh;
        fresh.rebuild(stage.input);
        for (int level = 0; level < OcclusionVolume::kLevels; ++level) {
            const Box3 all{glm::ivec3(0), fresh.texels().size(level)};
            EXPECT_EQ(stage.occlusion.texels().download(all, level), fresh.texels().download(all, level))
                << "level " << level << " after cut " << cut;
        }
    }
}

TEST_F(OcclusionTest, MacrocellsOnlySaveTime) {
    Stage stage({64, 50, 60}, [](glm::dvec3 p) { return ball(p, {30, 25, 30}, 17); });
    const auto skipping = stage.occlusion.texels().downloadAll<std::uint8_t>();
    stage.input.macrocells = nullptr;
    stage.occlusion.rebuild(stage.input);
    EXPECT_EQ(stage.occlusion.texels().downloadAll<std::uint8_t>(), skipping);
}

TEST_F(OcclusionTest, WithNothingInTheWayAllLightArrives) {
    Stage stage({96, 96, 96}, [](glm::dvec3 p) { return ball(p, {48, 48, 20}, 6); });
    for (const glm::dvec3 normal : {glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 1), glm::dvec3(-0.3, 0.8, 0.1)}) {
        const Answer answer = stage.ask(glm::dvec3(48, 48, 20) + 6.0 * glm::normalize(normal), normal,
                                        {.towardsKey = normal + glm::dvec3(0.2, 0.1, 0)});
        EXPECT_EQ(answer.ambient, 1.0F);
        EXPECT_EQ(answer.key, 1.0F);
        EXPECT_GT(answer.cheapAmbient, 0.97F);
    }
    const Answer strengthless = stage.ask({48, 48, 20}, {0, 0, 1}, {{0, 0, 1}, 0, 0});
    EXPECT_EQ(strengthless.ambient, 1.0F) << "inside the ball, but nothing of it is to be seen";
    EXPECT_EQ(strengthless.key, 1.0F);
}

TEST_F(OcclusionTest, AFlatWallDoesNotShadeItself) {
    for (const glm::dvec3 direction :
         {glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 0), glm::dvec3(1, 1, 1), glm::dvec3(0.3, -0.5, 0.9)}) {
        const glm::dvec3 normal = glm::normalize(direction);
        const glm::dvec3 along = glm::normalize(glm::cross(normal, glm::dvec3(0.4, 0.9, 0.2)));
        Stage stage({128, 128, 128}, [&](glm::dvec3 p) { return -glm::dot(p - 63.5, normal); });
        for (const double grazing : {1.0, 0.5, 0.1}) {
            Light light;
            light.towardsKey = grazing * normal + along * std::sqrt(1 - grazing * grazing);
            std::vector<std::pair<glm::dvec3, glm::dvec3>> places;
            for (int i = -40; i < 40; ++i) {
                places.emplace_back(63.5 + 0.37 * i * along, normal);
            }
            for (const Answer& answer : stage.ask(places, light)) {
                EXPECT_GT(answer.ambient, 0.97F) << direction.x << " " << direction.y;
                EXPECT_GT(answer.key, 0.97F) << direction.x << " " << direction.y << " light at " << grazing;
            }
        }
    }
}

TEST_F(OcclusionTest, AnInnerCornerIsDarkerThanItsWalls) {
    for (const double turn : {0.0, 0.4, 0.785}) { // about y
        const glm::dvec3 floorNormal(-std::sin(turn), 0, std::cos(turn));
        const glm::dvec3 wallNormal(std::cos(turn), 0, std::sin(turn));
        Stage stage({128, 128, 128}, [&](glm::dvec3 p) {
            return std::max(-glm::dot(p - 63.5, floorNormal), -glm::dot(p - 63.5, wallNormal));
        });
        const auto ambient = [&](double mm) {
            return stage.ask(63.5 + mm * wallNormal, floorNormal).ambient;
        };
        EXPECT_GT(ambient(1), 0.4F) << turn;
        EXPECT_LT(ambient(1), 0.7F) << turn;
        EXPECT_LT(ambient(1), ambient(6)) << turn;
        EXPECT_LT(ambient(6), ambient(20)) << turn;
        EXPECT_GT(ambient(45), 0.8F) << turn;
    }
}

TEST_F(OcclusionTest, ADeepHoleIsDark) {
    // 8 mm wide and 40 mm deep.
    Stage stage({96, 96, 96}, [](glm::dvec3 p) {
        const double beside = glm::length(glm::dvec2(p) - 47.5) - 4;
        return std::max(std::min(60 - p.z, beside), 20 - p.z);
    });
    const Answer bottom = stage.ask({47.5, 47.5, 20}, {0, 0, 1}, {.towardsKey = {0.5, 0, 0.85}});
    EXPECT_LT(bottom.ambient, 0.2F);
    EXPECT_LT(bottom.cheapAmbient, 0.5F);
    EXPECT_LT(bottom.key, 0.1F);
    EXPECT_GT(stage.ask({20, 47.5, 60}, {0, 0, 1}).ambient, 0.9F) << "beside it, on top";
}

// Shadow along x on a floor at z = 20.
std::vector<double> shadowAcross(Stage& stage, double y, glm::dvec3 towardsKey) {
    std::vector<std::pair<glm::dvec3, glm::dvec3>> places;
    for (int x = 0; x < 128; ++x) {
        places.emplace_back(glm::dvec3(x, y, 20), glm::dvec3(0, 0, 1));
    }
    std::vector<double> shadow;
    for (const Answer& answer : stage.ask(places, {.towardsKey = towardsKey})) {
        shadow.push_back(1 - double(answer.key));
    }
    return shadow;
}

TEST_F(OcclusionTest, ABallsShadowLiesWhereTheLightPutsIt) {
    for (const double height : {14.0, 28.0, 50.0}) {
        const glm::dvec3 centre(80, 64, 20 + height);
        const glm::dvec3 towardsKey = glm::normalize(glm::dvec3(0.6, 0, 1));
        Stage stage({128, 128, 128}, [&](glm::dvec3 p) { return std::max(20 - p.z, ball(p, centre, 11)); });
        const auto shadow = shadowAcross(stage, 64, towardsKey);
        double sum = 0;
        double moment = 0;
        for (int x = 0; x < 128; ++x) {
            sum += shadow[x];
            moment += x * shadow[x];
        }
        EXPECT_NEAR(moment / sum, 80 - 0.6 * height, 2) << "a texel is 2 mm; height " << height;
        EXPECT_GT(*std::max_element(shadow.begin(), shadow.end()), height < 20 ? 0.9 : 0.5);
        EXPECT_NEAR(shadow[125], 0, 0.02);
    }
}

TEST_F(OcclusionTest, AnEdgesShadowIsInPlaceAndWidensWithItsDistance) {
    double widthBefore = 0;
    for (const double height : {10.0, 24.0, 50.0}) {
        // A roof over everything with x > 64, lit from straight above.
        Stage stage({128, 128, 128}, [&](glm::dvec3 p) {
            return std::max(20 - p.z, std::min({p.x - 64, p.z - 20 - height, 34 + height - p.z}));
        });
        const auto shadow = shadowAcross(stage, 64, {0, 0, 1});
        const auto crossing = [&](double level) {
            int x = 1;
            while (x < 127 && shadow[x] < level) {
                ++x;
            }
            return x - 1 + (level - shadow[x - 1]) / (shadow[x] - shadow[x - 1]);
        };
        EXPECT_NEAR(crossing(0.5), 64, 2 + 0.08 * height) << "a texel is 2 mm; height " << height;
        const double width = crossing(0.8) - crossing(0.2);
        EXPECT_GT(width, 1.3 * widthBefore);
        widthBefore = width;
    }
}

TEST_F(OcclusionTest, ShadingDependsOnTheShapeAndNotOnTheVoxels) {
    const Shape shape = [](glm::dvec3 p) {
        return std::max({20 - p.z, ball(p, {70, 64, 40}, 14), 24 - p.y});
    };
    Stage cubes({128, 128, 96}, shape);
    Stage slices({128, 128, 48}, shape, {1, 1, 2});
    std::vector<std::pair<glm::dvec3, glm::dvec3>> places;
    for (int x = 8; x < 120; x += 4) {
        places.emplace_back(glm::dvec3(x, 64, 20), glm::dvec3(0, 0, 1));
        places.emplace_back(glm::dvec3(x, 30, 20), glm::dvec3(0, 0, 1));
        const glm::dvec3 out = glm::normalize(glm::dvec3(x - 64, -20, 9));
        places.emplace_back(glm::dvec3(70, 64, 40) + 14.0 * out, out);
    }
    const Light light{.towardsKey = {0.5, 0.1, 0.8}};
    const auto a = cubes.ask(places, light);
    const auto b = slices.ask(places, light);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_NEAR(a[i].ambient, b[i].ambient, 0.05) << i;
        EXPECT_NEAR(a[i].key, b[i].key, 0.05) << i;
        EXPECT_NEAR(a[i].cheapAmbient, b[i].cheapAmbient, 0.05) << i;
        EXPECT_NEAR(a[i].cheapKey, b[i].cheapKey, 0.05) << i;
    }
}

TEST_F(OcclusionTest, TransparentMatterBlocksByItsOpacity) {
    const auto blocked = [](double opacity) {
        Stage stage({48, 48, 48}, [](glm::dvec3 p) { return ball(p, {24, 24, 24}, 18); });
        TransferFunction function;
        function.points = {{99, 0}, {100, opacity}, {255, opacity}};
        Classification classification;
        classification.update(function, stage.field);
        stage.input.classification = &classification;
        stage.input.macrocells = nullptr;
        stage.occlusion.rebuild(stage.input);
        return double(stage.occlusion.texels().download({{12, 12, 12}, {13, 13, 13}}).front()) / 255;
    };
    // Opacity is per step; a texel is two steps long.
    EXPECT_EQ(blocked(0), 0);
    EXPECT_NEAR(blocked(0.1), 1 - 0.9 * 0.9, 0.01);
    EXPECT_NEAR(blocked(0.5), 1 - 0.5 * 0.5, 0.01);
    EXPECT_NEAR(blocked(1), 1, 0.01);
}

TEST_F(OcclusionTest, ItTakesNothingBeforeItIsUsed) {
    EXPECT_FALSE(bool(OcclusionVolume().texels()));
    const Stage stage({16, 16, 16}, [](glm::dvec3 p) { return ball(p, {8, 8, 8}, 5); });
    EXPECT_TRUE(bool(stage.occlusion.texels()));
}

} // namespace
} // namespace vs::render
