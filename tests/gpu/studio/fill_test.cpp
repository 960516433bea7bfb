// SPDX-License-Identifier: Apache-2.0
// Material that is added: it lies where it was put, later things win, it is seen and met like tissue, and is
// undone, saved and written alone.
#include "field/fill/fill_labels.h"
#include "gpu/gl_test.h"
#include "gpu/studio/test_head.h"
#include "gpu/studio/test_tools.h"
#include "image/compare.h"
#include "mesh/fill_surface.h"
#include "mesh/mesh.h"
#include "phantom/phantom.h"
#include "property.h"
#include "reference/boundary.h"
#include "reference/solids.h"
#include "render/rays/picker.h"
#include "sculpt/mask/outline.h"
#include "studio/document/document_content.h"
#include "studio/document/document_facts.h"
#include "studio/document/document_state.h"
#include "studio/document/live_stroke.h"
#include "studio/json/operation_json.h"
#include "studio/state/region.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vs::studio {
namespace {

constexpr glm::ivec2 kPicture{400, 300};

class FillTest : public test::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        caster_.emplace();
        picker_.emplace();
    }
    void TearDown() override {
        caster_.reset();
        picker_.reset();
        GlTest::TearDown();
    }
    image::Image picture(Document& document, const View& view) {
        document.showView(view);
        render::Frame frame = document.frame(kPicture);
        frame.samples = 1;
        caster_->render(frame);
        return caster_->readPicture();
    }
    std::vector<field::SurfacePoint> pick(Document& document, const View& view,
                                          std::span<const glm::vec2> pixels) {
        document.showView(view);
        return picker_->pickPoints(document.frame(kPicture), pixels);
    }

    std::optional<render::RayCaster> caster_;
    std::optional<render::Picker> picker_;
};

volume::Volume evenly(glm::ivec3 dims, double value) {
    return phantom::makePhantom(dims, volume::ScalarType::UInt16, [value](glm::dvec3) { return value; });
}

SetMaterial materialOf(int number, double value) {
    SetMaterial material;
    material.number = number;
    material.value = value;
    return material;
}

Clip boxOf(glm::dvec3 lo, glm::dvec3 hi) {
    Clip clip;
    clip.box = Clip::Box{lo, hi};
    clip.cutsInside = true;
    return clip;
}

View viewOf(render::Mode mode, Range range, double azimuth = 0, double elevation = 0) {
    View view;
    view.mode = mode;
    view.range = range;
    view.camera.azimuthDegrees = azimuth;
    view.camera.elevationDegrees = elevation;
    view.camera.projection = render::Projection::Orthographic;
    return view;
}

std::vector<float> filledOf(const Document& document) {
    const field::Fill& fill = *document.filled().fill;
    std::vector<float> values;
    forEachVoxel({glm::ivec3(0), document.volume().geometry.dims},
                 [&](glm::ivec3 v, std::size_t) { values.push_back(fill.at(v).filled); });
    return values;
}

const std::uint8_t* pixelOf(const image::Image& picture, int x, int y) {
    return &picture.rgba[4 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x))];
}

// --- exactness

TEST_F(FillTest, ASweptEllipseIsTheSolid) {
    const glm::ivec3 dims(112, 112, 96);
    const std::vector<glm::dvec3> ends{{34, 30, 22}, {76, 80, 74}};
    const glm::dvec2 radii(16, 10);
    Document document(evenly(dims, 0));
    document.apply(materialOf(1, 1000));
    Fill fill;
    Sweep sweep;
    sweep.mask = {Shape::Ellipse, {-radii, radii}};
    sweep.path.kind = SweepPath::Kind::Polyline;
    sweep.path.points = ends;
    fill.stroke = sweep;
    ASSERT_GT(document.apply(fill).voxelsTouched, 10000U);
    const reference::SweptCurve curve([&](double t) { return glm::mix(ends[0], ends[1], t); },
                                      reference::SweptCurve::Turning::Least);
    const auto exact = reference::ellipse(radii);
    const auto boundary = [&](const glm::dvec3& p) -> std::optional<reference::Deviation> {
        const auto place = curve.locate(p);
        if (place.fromStart < 4 || place.toEnd < 4) { // the ends' rims are rounded
            return std::nullopt;
        }
        const auto off = reference::distanceTo(exact, place.element);
        return reference::Deviation{off.distance, off.normal.x * place.x + off.normal.y * place.y};
    };
    const auto found = reference::boundaryErrors(filledOf(document), dims, glm::dvec3(1), boundary);
    EXPECT_GT(found.count, 1000);
    EXPECT_LT(found.rms, 0.1);
    EXPECT_LT(found.max, 0.35);
    // What cutting does with the same stroke.
    document.apply(sweep);
    const std::vector<float> cut = sculptureOf(document);
    EXPECT_EQ(document.filled().fill->voxels(), 0U);
    document.apply(Undo{});
    const std::vector<float> filled = filledOf(document);
    float most = 0;
    for (std::size_t i = 0; i < cut.size(); ++i) {
        most = std::max(most, std::abs(cut[i] - filled[i]));
    }
    EXPECT_LE(most, 0.51F / 65535) << "rounded to 16 bits once more";
}

// A list of solids, each of which fills, cuts, restores, takes away or un-cuts, evaluated in order at each
// voxel, is what the document has, to the tolerance of one voxel at boundaries.
TEST_F(FillTest, AListOfSolidsIsEvaluatedInOrder) {
    const glm::ivec3 dims(40, 36, 32);
    test::checkProperty(3, [&] {
        Document document(evenly(dims, 500));
        document.apply(materialOf(1, 1000));
        document.apply(materialOf(2, 800));
        struct State {
            bool isCut = false;
            std::uint8_t material = 0;
            bool operator==(const State&) const = default;
        };
        std::vector<State> model(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z));
        const auto indexOf = [&](glm::ivec3 v) {
            return (std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
                   std::size_t(v.x);
        };
        for (int n = 0; n < 50; ++n) {
            const int kind = *test::below(11);
            glm::dvec3 lo;
            glm::dvec3 hi;
            for (int axis = 0; axis < 3; ++axis) { // faces halfway between voxels, as wide as edges are
                lo[axis] = *test::below(dims[axis] - 8) - 0.5;
                hi[axis] = lo[axis] + 7 + *test::below(14);
            }
            const auto isInside = [&](glm::dvec3 v) {
                return glm::all(glm::greaterThan(v, lo)) && glm::all(glm::lessThan(v, hi));
            };
            Clip clip = boxOf(lo, hi);
            clip.radius = 2;
            if (kind < 4) {
                document.apply(Fill{1 + kind % 2, clip});
            } else if (kind < 7) {
                document.apply(clip);
            } else if (kind == 7) {
                document.apply(Unfill{clip});
            } else if (kind == 8 && *test::below(4) == 0) {
                document.apply(UnCut{});
            } else {
                clip.restores = true;
                document.apply(clip);
            }
            forEachVoxel({glm::ivec3(0), dims}, [&](glm::ivec3 v, std::size_t i) {
                State& state = model[i];
                const bool isIn = isInside(glm::dvec3(v));
                const bool isAllUncut = kind == 8 && document.sculpture().isEmpty();
                if (kind < 4 && isIn) {
                    state.material = std::uint8_t(1 + kind % 2);
                } else if (kind < 7 && kind >= 4 && isIn) {
                    state = {true, 0};
                } else if (kind == 7 && isIn) {
                    state.material = 0;
                } else if (isAllUncut || (kind >= 8 && isIn)) {
                    state.isCut = false;
                }
            });
        }
        const std::vector<float> cut = sculptureOf(document);
        const field::Fill& fill = *document.filled().fill;
        int wrong = 0;
        int exact = 0;
        forEachVoxel({glm::ivec3(0), dims}, [&](glm::ivec3 v, std::size_t i) {
            const auto voxel = fill.at(v);
            const State is{cut[i] >= 0.5F, voxel.filled >= 0.5F ? voxel.material : std::uint8_t(0)};
            bool isNear = false;
            forEachVoxel(
                intersect({v - 1, v + 2}, {glm::ivec3(0), dims}),
                [&](glm::ivec3 other, std::size_t) { isNear = isNear || model[indexOf(other)] == is; });
            wrong += isNear ? 0 : 1;
            exact += model[i] == is ? 1 : 0;
        });
        RC_ASSERT(wrong == 0);
        RC_ASSERT(exact > int(model.size()) * 97 / 100);
    });
}

TEST_F(FillTest, LaterThingsWin) {
    Document document(evenly(glm::ivec3(32), 500));
    document.apply(materialOf(1, 1000));
    const auto cutAt = [&](glm::ivec3 v) { return document.sculpture().values({v, v + 1}).front() >= 0.5F; };
    const auto materialAt = [&](glm::ivec3 v) {
        return int(document.filled().fill->materialAt(glm::dvec3(v)));
    };
    const glm::ivec3 middle(16);
    document.apply(boxOf({8, 8, 8}, {24, 24, 24}));
    document.apply(Fill{1, boxOf({10, 10, 10}, {22, 22, 22})});
    EXPECT_TRUE(cutAt(middle));
    EXPECT_EQ(materialAt(middle), 1);
    document.apply(boxOf({12, 12, 12}, {20, 20, 20})); // cuts the fill
    EXPECT_EQ(materialAt(middle), 0);
    EXPECT_EQ(materialAt({11, 11, 11}), 1);
    document.apply(UnCut{}); // brings the scan back, and not what was cut of the fill
    EXPECT_FALSE(cutAt(middle));
    EXPECT_EQ(materialAt(middle), 0);
    EXPECT_EQ(materialAt({11, 11, 11}), 1);
    document.apply(Undo{});
    document.apply(Undo{});
    EXPECT_EQ(materialAt(middle), 1);
    document.apply(Unfill{boxOf({8, 8, 8}, {24, 24, 24})}); // leaves the hole
    EXPECT_TRUE(cutAt(middle));
    EXPECT_TRUE(document.filled().fill->voxels() == 0);
    document.apply(Undo{});
    document.apply(RemoveFill{});
    EXPECT_TRUE(document.filled().fill->isEmpty());
    EXPECT_TRUE(cutAt(middle));
}

// A pen fills outward as high as it would cut deep.
TEST_F(FillTest, APenFillsAsHighAsItCutsDeep) {
    for (const bool isLaser : {false, true}) {
        for (const bool isCutBefore : {false, true}) {
            volume::Volume slab =
                phantom::makePhantom({72, 72, 72}, volume::ScalarType::UInt16, [](glm::dvec3 p) {
                    return std::clamp(20000 + 3000 * (p.y - 40), 0.0, 60000.0);
                });
            Document document(std::move(slab));
            const View view = viewOf(render::Mode::Surface, {20000, 65000});
            document.showView(view);
            document.apply(materialOf(1, 30000));
            if (isCutBefore) {
                document.apply(boxOf({-10, 40, -10}, {90, 50, 90}));
            }
            const std::vector<glm::vec2> places{{190, 150}, {200, 145}, {210, 155}};
            const auto before = pick(document, view, places);
            Drill drill = penAt<Drill>(200, 150, 30);
            Laser laser = penAt<Laser>(200, 150, 30);
            drill.canvas = laser.canvas = Canvas{view, kPicture};
            Fill fill;
            if (isLaser) {
                fill.stroke = laser;
            } else {
                fill.stroke = drill;
            }
            ASSERT_GT(document.apply(fill).voxelsTouched, 1000U);
            const auto after = pick(document, view, places);
            for (std::size_t i = 0; i < places.size(); ++i) {
                ASSERT_GT(after[i].voxel.w, 0.5F);
                EXPECT_NEAR(before[i].voxel.y - after[i].voxel.y, 9, 0.15) << isLaser << isCutBefore;
                EXPECT_NEAR(after[i].normal.y, -1, 0.01);
            }
        }
    }
}

// A coat is as thick as layers were asked for, on a ball.
TEST_F(FillTest, APeelLaysACoat) {
    Document document(phantom::makeBall(glm::ivec3(88), glm::dvec3(43.5), 30));
    const View view = viewOf(render::Mode::Surface, {100, 255});
    document.showView(view);
    document.apply(materialOf(1, 200));
    Peel peel = test::somePeel(5);
    peel.mask = test::ellipseAt(200, 150, 50, 50);
    peel.canvas = Canvas{view, kPicture};
    document.apply(Fill{1, peel});
    const std::vector<glm::vec2> places{{200, 150}, {190, 160}, {215, 140}, {200, 120}};
    for (const auto& point : pick(document, view, places)) {
        EXPECT_NEAR(glm::distance(glm::dvec3(point.voxel), glm::dvec3(43.5)), 35, 0.25);
    }
}

// --- holes

volume::Volume pitted(double pitRadius) {
    const glm::dvec3 middle(66);
    const glm::dvec3 pit(66, 66 - 60, 66); // about a place of the surface that faces the viewer
    const auto inside = [](double depth) { return std::clamp(0.5 + depth, 0.0, 1.0); };
    return phantom::makePhantom(glm::ivec3(133), volume::ScalarType::UInt8, [=](glm::dvec3 p) {
        const double body = inside(60 - glm::distance(p, middle));
        const double hole = inside(pitRadius - glm::distance(p, pit));
        return 200 * std::min(body, 1 - hole);
    });
}

// A spherical pit in a ball is filled up to the ball's own surface.
TEST_F(FillTest, AFilledPitLeavesTheBallsOwnSurface) {
    for (const bool isCut : {false, true}) {
        for (const double azimuth : {0.0, 25.0}) {
            Document document(pitted(isCut ? 0 : 12));
            View view = viewOf(render::Mode::Surface, {100, 255}, azimuth, azimuth / 3);
            document.showView(view);
            document.apply(materialOf(1, 180));
            // The pit's middle in the picture, and a circle around it.
            const auto rays = document.frame(kPicture).rays;
            const auto pixelOfVoxel = [&](glm::dvec3 voxel) {
                return rays.project(
                    glm::dvec3(document.volume().geometry.worldFromVoxel * glm::dvec4(voxel, 1)));
            };
            const glm::dvec2 middle = pixelOfVoxel({66, 6, 66});
            const double perVoxel = glm::distance(middle, pixelOfVoxel({66, 6, 67}));
            if (isCut) {
                Drill drill = penAt<Drill>(middle.x, middle.y, 12 * perVoxel);
                drill.canvas = Canvas{view, kPicture};
                document.apply(drill);
            }
            FillHole hole;
            hole.outline = ellipseAt(middle.x, middle.y, 15 * perVoxel, 15 * perVoxel);
            hole.canvas = Canvas{view, kPicture};
            ASSERT_GT(document.apply(hole).voxelsTouched, 500U);
            std::vector<glm::vec2> places;
            for (double y = -17; y <= 17; y += 0.5) {
                for (double x = -17; x <= 17; x += 0.5) {
                    if (x * x + y * y < 17 * 17) {
                        places.emplace_back(middle + perVoxel * glm::dvec2(x, y));
                    }
                }
            }
            double squares = 0;
            double worst = 0;
            int onFill = 0;
            int aslant = 0; // where a seam is seen between the filling and the hole's rim
            for (const auto& point : pick(document, view, places)) {
                ASSERT_GT(point.voxel.w, 0.5F);
                const double off = glm::distance(glm::dvec3(point.voxel), glm::dvec3(66)) - 60;
                squares += off * off / double(places.size());
                worst = std::max(worst, std::abs(off));
                const glm::dvec3 outward = glm::normalize(glm::dvec3(point.voxel) - 66.0);
                aslant += glm::dot(glm::dvec3(point.normal), outward) < 0.95 ? 1 : 0;
                const glm::dvec3 behind = glm::dvec3(point.voxel) - 0.7 * glm::dvec3(point.normal);
                onFill += document.filled().fill->materialAt(behind) == 1 ? 1 : 0;
            }
            EXPECT_LT(std::sqrt(squares), 0.3) << isCut << azimuth;
            EXPECT_LT(worst, 0.75) << isCut << azimuth;
            EXPECT_GT(onFill, int(places.size()) / 3);
            EXPECT_LT(aslant, int(places.size()) / 30) << isCut << azimuth;
            RecordProperty("rms of a filled pit", std::to_string(std::sqrt(squares)));
            // Nothing is left empty below.
            for (int depth = 1; depth < 11; ++depth) {
                EXPECT_EQ(document.filled().fill->materialAt({66, 6 + depth, 66}), 1) << depth << isCut;
            }
        }
    }
}

TEST_F(FillTest, AHoleThroughAWallIsClosedAsThickAsAsked) {
    volume::Volume wall = phantom::makePhantom({80, 60, 80}, volume::ScalarType::UInt8, [](glm::dvec3 p) {
        const double inWall = std::clamp(std::min(p.y - 19.5, 39.5 - p.y) + 0.5, 0.0, 1.0);
        const double hole = std::clamp(10.5 - glm::length(glm::dvec2(p.x, p.z) - 40.0), 0.0, 1.0);
        return 200 * std::min(inWall, 1 - hole);
    });
    Document document(std::move(wall));
    const View view = viewOf(render::Mode::Surface, {100, 255});
    document.showView(view);
    document.apply(materialOf(1, 180));
    FillHole hole;
    hole.outline = ellipseAt(200, 150, 45, 45);
    hole.depth = 6;
    hole.canvas = Canvas{view, kPicture};
    ASSERT_GT(document.apply(hole).voxelsTouched, 500U);
    const field::Fill& fill = *document.filled().fill;
    for (int y = 10; y < 50; ++y) {
        const double depth = y - 19.5;
        if (std::abs(depth) > 0.6 && std::abs(depth - 6) > 0.6) {
            EXPECT_EQ(fill.materialAt({40, y, 40}), depth > 0 && depth < 6 ? 1 : 0) << y;
        }
    }
    EXPECT_EQ(fill.materialAt({20, 22, 40}), 0) << "the wall itself stays";
    // An outline with nothing around it, in the open.
    FillHole nowhere = hole;
    nowhere.outline = ellipseAt(200, 5, 4, 4);
    EXPECT_THROW(document.apply(nowhere), Error);
}

// --- seen and met

// Material in an empty block looks, in every mode, like a scan that has those values there.
TEST_F(FillTest, LooksLikeTissueOfItsValue) {
    const glm::ivec3 dims(64);
    const glm::dvec3 lo(15.5, 19.5, 11.5);
    const glm::dvec3 hi(44.5, 40.5, 50.5);
    const auto isIn = [&](glm::dvec3 v) {
        return glm::all(glm::greaterThan(v, lo)) && glm::all(glm::lessThan(v, hi));
    };
    Document filled(evenly(dims, 100));
    SetMaterial material = materialOf(1, 900);
    filled.apply(material);
    filled.apply(Fill{1, boxOf(lo, hi)});
    Document scanned(phantom::makePhantom(dims, volume::ScalarType::UInt16,
                                          [&](glm::dvec3 v) { return isIn(v) ? 900.0 : 100.0; }));
    for (const render::Mode mode : {render::Mode::Mip, render::Mode::XRay}) {
        const View view = viewOf(mode, {500, 1000}, 30, 20);
        const auto one = picture(filled, view);
        const auto other = picture(scanned, view);
        int differing = 0;
        for (std::size_t i = 0; i < one.rgba.size(); i += 4) {
            differing += std::abs(int(one.rgba[i]) - int(other.rgba[i])) > 16 ? 1 : 0;
        }
        // The edge of a box of voxels is not where its faces are: a pixel or two about the outline.
        EXPECT_LT(differing, kPicture.x * kPicture.y / 60) << int(mode);
        EXPECT_GT(int(*pixelOf(one, 200, 150)), 60);
    }
    // The surface: met on the box's own faces.
    const View view = viewOf(render::Mode::Surface, {500, 1000}, 30, 20);
    std::vector<glm::vec2> places;
    for (int i = 0; i < 40; ++i) {
        places.emplace_back(170 + 1.5 * i, 130 + i);
    }
    double worst = 0;
    int hits = 0;
    for (const auto& point : pick(filled, view, places)) {
        if (point.voxel.w > 0.5F) {
            const glm::dvec3 p(point.voxel);
            const glm::dvec3 off = glm::max(glm::max(lo - p, p - hi), glm::dvec3(-1e9));
            const double outside = std::max({off.x, off.y, off.z});
            worst = std::max(worst, std::abs(outside));
            ++hits;
        }
    }
    EXPECT_GT(hits, 25);
    EXPECT_LT(worst, 0.3) << "edges are rounded by as much as the radiation is wide";
}

TEST_F(FillTest, IsSeenOnlyWhereItsValueIsAndWhenItIsShown) {
    Document document(evenly(glm::ivec3(48), 100));
    SetMaterial red = materialOf(1, 900);
    red.colour = glm::dvec3(0.9, 0.1, 0.1);
    document.apply(red);
    SetMaterial blue = materialOf(2, 600);
    blue.colour = glm::dvec3(0.1, 0.1, 0.9);
    document.apply(blue);
    document.apply(Fill{1, boxOf({8, 12, 8}, {24, 36, 40})});
    document.apply(Fill{2, boxOf({24, 12, 8}, {40, 36, 40})});
    const auto colourAt = [&](const View& view, int x) {
        const auto shown = picture(document, view);
        const std::uint8_t* p = pixelOf(shown, x, 150);
        return p[0] > p[2] + 30 ? 'r' : p[2] > p[0] + 30 ? 'b' : '-';
    };
    const auto both = viewOf(render::Mode::Surface, {500, 1000});
    const std::string sides{colourAt(both, 160), colourAt(both, 240)};
    ASSERT_TRUE(sides == "rb" || sides == "br") << sides;
    const int redSide = sides == "rb" ? 160 : 240;
    const int blueSide = 400 - redSide;
    const auto high = viewOf(render::Mode::Surface, {800, 1000});
    EXPECT_EQ(colourAt(high, redSide), 'r');
    EXPECT_EQ(colourAt(high, blueSide), '-');
    SetMaterial hidden;
    hidden.number = 1;
    hidden.isVisible = false;
    document.apply(hidden);
    EXPECT_EQ(colourAt(both, redSide), '-');
    EXPECT_EQ(colourAt(both, blueSide), 'b');
    const auto brightnessAt = [&](int x) {
        const auto shown = picture(document, viewOf(render::Mode::Volume, {500, 1000}));
        const std::uint8_t* p = pixelOf(shown, x, 150);
        return int(p[0]) + p[1] + p[2];
    };
    EXPECT_LT(brightnessAt(redSide), 120) << "hidden in volume mode too";
    EXPECT_GT(brightnessAt(blueSide), 200);
    document.apply(Undo{});
    EXPECT_GT(brightnessAt(redSide), 200);
    EXPECT_EQ(colourAt(both, redSide), 'r');
    // Of what was cut, nothing: material is no part of that.
    document.apply(boxOf({0, 0, 0}, {10, 10, 10}));
    View probe = both;
    probe.sculptureView = field::SculptureView::Probe;
    EXPECT_EQ(colourAt(probe, redSide), '-');
}

// The surface of the scan beside material is where it was, and hidden where material lies before it.
TEST_F(FillTest, LeavesTheScanBesideItAlone) {
    const auto head = [] { return std::make_unique<Document>(testHead()); };
    const View view = testCanvas().view;
    auto plain = head();
    auto filled = head();
    filled->showView(view);
    filled->apply(materialOf(1, 200));
    Drill drill = penAt<Drill>(200, 130, 14);
    drill.canvas = testCanvas();
    filled->apply(Fill{1, drill});
    std::vector<glm::vec2> places;
    for (int y = 80; y < 220; y += 3) {
        for (int x = 130; x < 270; x += 3) {
            places.emplace_back(x, y);
        }
    }
    const auto before = pick(*plain, view, places);
    const auto after = pick(*filled, view, places);
    const field::Fill& fill = *filled->filled().fill;
    int same = 0;
    int nearer = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool isOnFill = after[i].voxel.w > 0.5F &&
                              fill.at(glm::ivec3(glm::round(glm::vec3(after[i].voxel)))).filled > 0.05F;
        if (!isOnFill) {
            // Other programs round otherwise.
            EXPECT_LT(glm::distance(before[i].voxel, after[i].voxel), 1e-3F)
                << places[i].x << ", " << places[i].y;
            ++same;
        } else {
            EXPECT_LE(after[i].normal.w, before[i].voxel.w > 0.5F ? before[i].normal.w + 0.01F : 1e30F);
            ++nearer;
        }
    }
    EXPECT_GT(same, 1000);
    EXPECT_GT(nearer, 30);
}

// --- the document

std::vector<Operation> fillingOf(double x, double y) {
    const auto on = [&](auto pen) {
        pen.canvas = testCanvas();
        return pen;
    };
    return {materialOf(1, 200),
            Fill{1, on(penAt<Drill>(x, y, 10))},
            Fill{1, on(penAt<Laser>(x + 20, y, 10))},
            materialOf(2, 120),
            Fill{2, on(peelAt(x, y + 20, 12))},
            on(penAt<Drill>(x, y, 6)),
            Fill{2, on(sweepAcross(x, y))},
            Unfill{on(penAt<Drill>(x + 20, y, 5))},
            Unfill{on(peelAt(x, y + 20, 8))},
            UnCut{},
            on(peelAt(x, y, 15)),
            RemoveFill{2},
            RemoveFill{}};
}

TEST_F(FillTest, IsUndoneToTheByteAndRedone) {
    Document document(testHead());
    const View view = testCanvas().view;
    document.showView(view);
    const image::Image clean = picture(document, view);
    std::vector<DocumentContent> states{contentOf(document)};
    const auto operations = fillingOf(190, 120);
    for (const Operation& operation : operations) {
        document.apply(operation);
        states.push_back(contentOf(document));
        ASSERT_EQ(states.back().stepsDone, states.size() - 1) << name(operation) << " changed nothing";
    }
    const auto expectState = [&](std::size_t n) {
        DocumentContent now = contentOf(document);
        now.stepsDone = states[n].stepsDone;
        now.stepsUndone = states[n].stepsUndone;
        EXPECT_EQ(differences(states[n], now, "then", "now"), std::vector<std::string>{}) << n;
    };
    for (std::size_t n = operations.size(); n > 0; --n) {
        document.apply(Undo{});
        expectState(n - 1);
    }
    EXPECT_EQ(picture(document, view).rgba, clean.rgba);
    for (std::size_t n = 1; n <= operations.size(); ++n) {
        document.apply(Redo{});
        expectState(n);
    }
    // What the log says, read again from its text, comes to the same; and so does a state in the middle.
    for (int n = 0; n < 4; ++n) {
        document.apply(Undo{});
    }
    Document again(testHead());
    for (const Operation& operation : document.log()) {
        again.apply(operationFromJson(nlohmann::ordered_json::parse(toJson(operation).dump()), "test"));
    }
    EXPECT_EQ(differences(contentOf(document), contentOf(again), "one", "again"), std::vector<std::string>{});
    EXPECT_FALSE(again.filled().fill->isEmpty());
    Document opened(testHead(), document.state());
    EXPECT_EQ(differences(contentOf(document), contentOf(opened), "one", "opened"),
              std::vector<std::string>{});
    opened.apply(Undo{});
    document.apply(Undo{});
    EXPECT_TRUE(opened.filled().isAlike(document.filled()));
}

// A stroke that is seen while it is drawn is the one that its operation says.
TEST_F(FillTest, AStrokeInHandIsTheOneThatIsLogged) {
    test::checkProperty(6, [&] {
        Document document(testHead());
        const View view = testCanvas().view;
        document.showView(view);
        document.apply(materialOf(1, 200));
        document.apply(Fill{1, peelAt(200, 130, 20)});
        Drill drill = penAt<Drill>(200, 130, 8);
        drill.canvas = testCanvas();
        drill.stroke.clear();
        const int kind = *test::below(3);
        const Operation operation = kind == 0   ? Operation(Fill{1, drill})
                                    : kind == 1 ? Operation(Unfill{drill})
                                                : Operation(drill);
        document.stroke().begin(operation);
        const int count = 1 + *test::below(5);
        for (int i = 0; i < count; ++i) {
            document.stroke().drawAt(
                {{170.0 + *test::below(60), 110.0 + *test::below(40)}, 0.1 + *test::below(10) * 0.1, {}});
            static_cast<void>(picture(document, view));
        }
        if (*test::below(4) == 0) {
            const Filled before = document.filled();
            document.stroke().discard();
            document.apply(Fill{1, penAt<Drill>(150, 130, 8)});
            return;
        }
        document.stroke().commit();
        Document again(testHead());
        again.showView(view);
        for (const Operation& logged : document.log()) {
            again.apply(logged);
        }
        RC_ASSERT(differences(contentOf(document), contentOf(again), "in hand", "logged").empty());
    });
}

TEST_F(FillTest, ADiscardedStrokeLeavesNoTrace) {
    Document document(testHead());
    document.showView(testCanvas().view);
    document.apply(materialOf(1, 200));
    document.apply(Fill{1, peelAt(200, 130, 20)});
    const DocumentContent before = contentOf(document);
    for (const Operation& operation :
         {Operation(Fill{1, penAt<Drill>(200, 130, 8)}), Operation(Unfill{penAt<Laser>(200, 130, 8)}),
          Operation(penAt<Drill>(200, 130, 8)), Operation(peelAt(200, 130, 8))}) {
        document.stroke().begin(operation);
        if (std::holds_alternative<Peel>(operation)) {
            document.stroke().peelTo(4);
            document.stroke().peelTo(2);
        } else {
            document.stroke().drawAt({{200, 130}, 1, {}});
        }
        document.stroke().discard();
        EXPECT_EQ(differences(before, contentOf(document), "before", "after"), std::vector<std::string>{});
    }
}

TEST_F(FillTest, SaysWhatCannotBeFilled) {
    Document document(testHead());
    document.showView(testCanvas().view);
    const auto messageOf = [&](const Operation& operation) {
        try {
            document.apply(operation);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("nothing");
    };
    EXPECT_EQ(messageOf(Fill{1, peelAt(200, 130, 20)}),
              "material: 1 must be one of the materials that there are (0); `material` adds them");
    EXPECT_EQ(messageOf(materialOf(3, 10)),
              "number: there are 0 materials, so that the next one is number 1, not 3");
    document.apply(materialOf(1, 200));
    Peel restoring = peelAt(200, 130, 20);
    restoring.restores = true;
    EXPECT_EQ(messageOf(Fill{1, restoring}),
              "stroke: a stroke that restores neither fills nor takes away what is filled");
    EXPECT_EQ(messageOf(RemoveFill{}), "material: nothing is filled that could be removed");
    const auto beside = document.apply(Fill{1, penAt<Drill>(5, 5, 3)});
    EXPECT_EQ(beside.voxelsTouched, 0U);
    EXPECT_EQ(document.history().done().size(), 1U);
}

// The surface of a material is closed, and encloses what was filled.
TEST_F(FillTest, ASurfaceOfMaterialIsClosedAndAlone) {
    Document document(testHead());
    document.apply(materialOf(1, 200));
    document.apply(materialOf(2, 100));
    document.apply(Fill{1, boxOf({10.5, 10.5, 10.5}, {30.5, 26.5, 22.5})});
    document.apply(Fill{2, boxOf({20.5, 10.5, 10.5}, {40.5, 26.5, 22.5})});
    const auto& geometry = document.volume().geometry;
    for (const int material : {1, 2}) {
        const mesh::Mesh mesh = mesh::fillSurface(*document.filled().fill, std::uint8_t(material), geometry);
        EXPECT_TRUE(mesh::topologyOf(mesh).isClosed());
        const double voxels = mesh::volumeMm3(mesh) / geometry.voxelMm3();
        EXPECT_NEAR(voxels, material == 1 ? 10 * 16 * 12 : 20 * 16 * 12, 0.06 * 20 * 16 * 12) << material;
    }
    const auto labels = field::materialLabels(*document.filled().fill);
    EXPECT_EQ(std::size_t(std::count(labels.begin(), labels.end(), 1)), document.filled().fill->voxels(1));
}

TEST_F(FillTest, MaterialBecomesASegment) {
    Document document(testHead());
    document.showView(testCanvas().view);
    document.apply(materialOf(1, 200));
    EXPECT_THROW(document.apply(SegmentFill{1}), Error);
    document.apply(Fill{1, boxOf({10.5, 10.5, 10.5}, {30.5, 26.5, 22.5})});
    document.apply(SegmentFill{1});
    const std::size_t voxels = document.filled().fill->voxels(1);
    EXPECT_EQ(document.region().voxelCount(1), voxels);
    document.apply(RemoveFill{});
    EXPECT_EQ(document.region().voxelCount(1), voxels) << "the segment stays";
    document.apply(Undo{});
    document.apply(Undo{});
    EXPECT_EQ(document.region().voxelCount(1), 0U);
    document.apply(Redo{});
    EXPECT_EQ(document.region().voxelCount(1), voxels);
}

TEST_F(FillTest, NothingFilledTakesNoMemory) {
    Document document(testHead());
    EXPECT_EQ(document.filled().fill->bricks().entries().size(), 0U);
    document.apply(materialOf(1, 200));
    document.apply(Fill{1, boxOf({-5, -5, -5}, {200, 200, 200})});
    // Wholly filled bricks are one and the same.
    const auto& entries = document.filled().fill->bricks().entries();
    ASSERT_FALSE(entries.empty());
    document.apply(Unfill{boxOf({-5, -5, -5}, {200, 200, 200})});
    EXPECT_EQ(document.filled().fill->bricks().entries().size(), 0U);
}

} // namespace
} // namespace vs::studio
