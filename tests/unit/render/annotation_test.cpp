// SPDX-License-Identifier: Apache-2.0
#include "image/drawing.h"
#include "render/marks/draw_annotations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace vs::render {
namespace {

struct Case {
    ViewRays rays;
    volume::GridGeometry geometry;
};

// Many cameras, volumes from nanometres to metres, sizes and both projections.
std::vector<Case> cases() {
    std::vector<Case> all;
    for (const double spacing : {1e-6, 0.004, 0.9, 30.0}) {
        const auto geometry = volume::makeGeometry({100, 120, 80}, {spacing, spacing, 1.7 * spacing});
        for (const glm::ivec2 size : {glm::ivec2{1230, 870}, {400, 300}, {3000, 2000}, {333, 900}}) {
            for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
                for (const double azimuth : {0.0, 37.0, -140.0, 90.0}) {
                    for (const double elevation : {0.0, 16.0, -55.0, 90.0}) {
                        Camera camera{azimuth,
                                      elevation,
                                      1 + azimuth * azimuth / 3000,
                                      {3 * spacing, 5 * spacing},
                                      projection};
                        all.push_back({viewRays(camera, geometry, size), geometry});
                    }
                }
            }
        }
    }
    return all;
}

// Whether a pixel has the ink's own colour, and not its border's.
bool isInk(const image::Image& picture, int x, int y) {
    return picture.pixel(x, y)[0] > 240 && picture.pixel(x, y)[3] == 255;
}

int columnsOfInk(const image::Image& picture, int row) {
    int first = picture.width;
    int last = -1;
    for (int x = 0; x < picture.width; ++x) {
        if (isInk(picture, x, row)) {
            first = std::min(first, x);
            last = x;
        }
    }
    return last + 1 - first;
}

bool hasClearRim(const image::Image& picture) {
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const bool isRim = x == 0 || y == 0 || x == picture.width - 1 || y == picture.height - 1;
            if (isRim && picture.pixel(x, y)[3] > 0) {
                return false;
            }
        }
    }
    return true;
}

TEST(ScaleBar, ItsPixelsAreItsLengthToHalfAPixel) {
    for (const auto& [rays, geometry] : cases()) {
        const ScaleBar bar = scaleBar(rays, geometry);
        const double expected = bar.lengthMm / rays.pixelMm(geometry.centreWorld());
        EXPECT_NEAR(bar.right.x - bar.left.x, expected, 0.5 + 1e-9);
        const Annotation drawn = drawScaleBar(bar, rays.size, Ink::Light);
        // Its lowest row of pixels, from end to end.
        EXPECT_EQ(columnsOfInk(drawn.image, int(bar.left.y) - 1 - drawn.corner.y),
                  int(bar.right.x - bar.left.x));
    }
}

TEST(ScaleBar, ItsEndsAreThatFarApartInTheWorld) {
    for (const auto& [rays, geometry] : cases()) {
        const ScaleBar bar = scaleBar(rays, geometry);
        const glm::dvec3 centre = geometry.centreWorld();
        const glm::dvec3 along = glm::normalize(rays.right) * bar.lengthMm;
        const glm::dvec2 apart = rays.project(centre + along) - rays.project(centre);
        EXPECT_NEAR(apart.x, bar.right.x - bar.left.x, 0.5 + 1e-6);
        EXPECT_NEAR(apart.y, 0, 1e-6);
    }
}

TEST(ScaleBar, IsARoundNumberThatTakesATenthToAQuarterOfTheWidth) {
    for (const auto& [rays, geometry] : cases()) {
        const ScaleBar bar = scaleBar(rays, geometry);
        const double digits = bar.lengthMm / std::pow(10.0, std::floor(std::log10(bar.lengthMm) + 1e-9));
        EXPECT_TRUE(std::abs(digits - 1) < 1e-6 || std::abs(digits - 2) < 1e-6 || std::abs(digits - 5) < 1e-6)
            << bar.lengthMm;
        EXPECT_LE(bar.right.x - bar.left.x, 0.25 * rays.size.x + 0.5);
        EXPECT_GE(bar.right.x - bar.left.x, 0.10 * rays.size.x - 0.5);
    }
}

TEST(ScaleBar, LabelsAreShortAndExact) {
    EXPECT_EQ(lengthLabel(2e-7), "0.2 nm");
    EXPECT_EQ(lengthLabel(1e-6), "1 nm");
    EXPECT_EQ(lengthLabel(5e-4), "500 nm");
    EXPECT_EQ(lengthLabel(1e-3), "1 µm");
    EXPECT_EQ(lengthLabel(0.02), "20 µm");
    EXPECT_EQ(lengthLabel(0.5), "500 µm");
    EXPECT_EQ(lengthLabel(1), "1 mm");
    EXPECT_EQ(lengthLabel(5), "5 mm");
    EXPECT_EQ(lengthLabel(10), "1 cm");
    EXPECT_EQ(lengthLabel(50), "5 cm");
    EXPECT_EQ(lengthLabel(500), "50 cm");
    EXPECT_EQ(lengthLabel(2000), "2 m");
    // As scale bars make them: products of powers.
    EXPECT_EQ(lengthLabel(5 * std::pow(10.0, -3)), "5 µm");
    EXPECT_EQ(lengthLabel(1 * std::pow(10.0, -6)), "1 nm");
}

TEST(ScaleBar, AHeadIsMeasuredInCentimetres) {
    const auto geometry = volume::makeGeometry({181, 217, 181});
    EXPECT_EQ(scaleBar(viewRays({}, geometry, {1230, 870}), geometry).label, "5 cm");
}

TEST(OrientationMarker, LettersLieWhereTheirDirectionsPoint) {
    for (const auto& [rays, geometry] : cases()) {
        const OrientationMarker marker = orientationMarker(rays);
        // By the camera's own projection, made orthographic: the marker has no perspective.
        ViewRays flat = rays;
        flat.isOrthographic = true;
        flat.right = glm::normalize(rays.right) * (rays.size.x / 2.0);
        flat.up = glm::normalize(rays.up) * (rays.size.y / 2.0);
        for (const auto& letter : marker.letters) {
            const glm::dvec2 expected = flat.project(rays.eye + letter.world) - flat.project(rays.eye);
            const glm::dvec2 offset = letter.place - marker.centre;
            if (glm::length(expected) > 1e-6) {
                EXPECT_NEAR(glm::dot(glm::normalize(expected), offset), glm::length(offset),
                            1e-6 * marker.radius)
                    << letter.letter;
            }
            const double towards = -glm::dot(letter.world, rays.forward);
            EXPECT_GT(towards, -0.34) << letter.letter << " points away";
            EXPECT_TRUE(!letter.isOnFace || towards > 0.26)
                << letter.letter << " is on a face that is not seen";
        }
    }
}

TEST(OrientationMarker, EachDirectionThatIsNotAwayHasOneLetter) {
    const std::map<char, glm::dvec3> directions{{'L', {1, 0, 0}},  {'R', {-1, 0, 0}}, {'P', {0, 1, 0}},
                                                {'A', {0, -1, 0}}, {'S', {0, 0, 1}},  {'I', {0, 0, -1}}};
    for (const auto& [rays, geometry] : cases()) {
        std::map<char, double> opacities; // of one that goes over from beside the cube to its face, both
        for (const auto& letter : orientationMarker(rays).letters) {
            ASSERT_EQ(directions.count(letter.letter), 1U) << letter.letter;
            EXPECT_EQ(letter.world, directions.at(letter.letter)) << letter.letter;
            opacities[letter.letter] += letter.opacity;
        }
        for (const auto& [letter, world] : directions) {
            const bool isAway = glm::dot(world, glm::normalize(rays.forward)) > 1e-9;
            EXPECT_LE(opacities[letter], 1 + 1e-9) << letter;
            EXPECT_TRUE(isAway || opacities[letter] > 1 - 1e-9) << letter << " " << opacities[letter];
        }
    }
}

TEST(OrientationMarker, TheFaceLooksAtTheViewerWithItsRightOnTheLeft) {
    const auto geometry = volume::makeGeometry({100, 100, 100});
    const OrientationMarker marker = orientationMarker(viewRays({}, geometry, {870, 870}));
    std::map<char, DirectionLetter> letters;
    for (const auto& letter : marker.letters) {
        letters[letter.letter] = letter;
    }
    ASSERT_EQ(letters.size(), 5U);
    EXPECT_EQ(letters.count('P'), 0U);
    EXPECT_TRUE(letters['A'].isOnFace);
    EXPECT_LT(glm::distance(letters['A'].place, marker.centre), 1e-9);
    EXPECT_LT(letters['R'].place.x, marker.centre.x - 20);
    EXPECT_GT(letters['L'].place.x, marker.centre.x + 20);
    EXPECT_LT(letters['S'].place.y, marker.centre.y - 20);
    EXPECT_GT(letters['I'].place.y, marker.centre.y + 20);
    for (const char letter : {'R', 'L', 'S', 'I'}) {
        EXPECT_FALSE(letters[letter].isOnFace);
    }
}

TEST(OrientationMarker, LettersAreUprightAndNotMirrored) {
    for (const auto& [rays, geometry] : cases()) {
        for (const auto& letter : orientationMarker(rays).letters) {
            EXPECT_NEAR(letter.axes[1].x, 0, 1e-9) << "its stem is vertical";
            EXPECT_GT(letter.axes[1].y, 0.2) << "its foot is below";
            EXPECT_GT(letter.axes[0].x, 0.2) << "it reads to the right";
        }
    }
}

TEST(OrientationMarker, EveryZoneOfTheCubeIsFoundWhereItIsSeen) {
    for (const auto& [rays, geometry] : cases()) {
        const OrientationMarker marker = orientationMarker(rays);
        const glm::dvec3 right = glm::normalize(rays.right);
        const glm::dvec3 up = glm::normalize(rays.up);
        for (int n = 0; n < 27; ++n) {
            const glm::dvec3 signs(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
            if (n == 13 || glm::dot(glm::normalize(signs), -rays.forward) < 0.3) {
                continue; // no direction, or on the other side
            }
            const glm::dvec3 onCube = 0.9 * signs; // of the cube from -1 to 1, just inside
            const glm::dvec2 place =
                marker.centre + marker.halfEdge * glm::dvec2(glm::dot(onCube, right), -glm::dot(onCube, up));
            const auto zone = zoneAt(rays, place);
            ASSERT_TRUE(zone.has_value());
            EXPECT_LT(glm::distance(*zone, glm::normalize(signs)), 1e-9);
        }
        for (const glm::dvec2 beside : {glm::dvec2(1.8, 0), glm::dvec2(0, -1.8), glm::dvec2(-8, -3)}) {
            EXPECT_FALSE(zoneAt(rays, marker.centre + marker.halfEdge * beside).has_value());
        }
    }
}

// What is lit is seen where the zone is, and nowhere else.
TEST(OrientationMarker, WhatIsPointedAtIsLit) {
    const auto inside = [](const std::vector<glm::dvec2>& piece, glm::dvec2 place) {
        int left = 0;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const glm::dvec2 a = piece[i];
            const glm::dvec2 b = piece[(i + 1) % piece.size()];
            left += (b.x - a.x) * (place.y - a.y) - (b.y - a.y) * (place.x - a.x) > 0 ? 1 : 0;
        }
        return left == 0 || left == int(piece.size());
    };
    const auto geometry = volume::makeGeometry({100, 100, 100});
    const ViewRays rays = viewRays({30, 25, 1, {}}, geometry, {870, 870});
    const OrientationMarker plain = orientationMarker(rays);
    constexpr double near = 0.08;
    const std::array<glm::dvec2, 4> around{{{near, 0}, {-near, 0}, {0, near}, {0, -near}}};
    EXPECT_TRUE(plain.lit.empty());
    for (int y = -12; y <= 12; ++y) {
        for (int x = -12; x <= 12; ++x) {
            const glm::dvec2 place = plain.centre + 0.101 * plain.halfEdge * glm::dvec2(x, y);
            const auto zone = zoneAt(rays, place);
            const bool isOnFacet =
                std::any_of(plain.facets.begin(), plain.facets.end(),
                            [&](const auto& facet) { return inside(facet.corners, place); });
            // Zones begin on the cube's bevels a little beside where they do on a cube without.
            const bool isAtBorder = std::any_of(around.begin(), around.end(), [&](glm::dvec2 step) {
                return zoneAt(rays, place + plain.halfEdge * step) != zone;
            });
            if (!isOnFacet || isAtBorder) {
                continue;
            }
            for (const glm::dvec3 other :
                 {*zone, glm::normalize(glm::dvec3(1, -1, 1)), glm::dvec3(0, -1, 0)}) {
                const auto lit = orientationMarker(rays, 1, other).lit;
                const bool isLit = std::any_of(lit.begin(), lit.end(),
                                               [&](const auto& piece) { return inside(piece, place); });
                EXPECT_EQ(isLit, other == *zone) << x << ", " << y;
            }
        }
    }
}

TEST(OrientationMarker, FacetsFaceTheViewerAndCoverEachOtherNowhere) {
    const auto area = [](const std::vector<glm::dvec2>& corners) {
        double sum = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec2 a = corners[i];
            const glm::dvec2 b = corners[(i + 1) % corners.size()];
            sum += a.x * b.y - a.y * b.x;
        }
        return std::abs(sum) / 2;
    };
    // Seen from the front the cube is a square with cut corners, whatever the facets.
    const auto geometry = volume::makeGeometry({100, 100, 100});
    const OrientationMarker marker = orientationMarker(viewRays({}, geometry, {870, 870}));
    double sum = 0;
    for (const auto& facet : marker.facets) {
        EXPECT_GT(facet.normal.z, 0);
        sum += area(facet.corners);
    }
    EXPECT_EQ(marker.facets.size(), 9U); // a face, four edges, four corners
    EXPECT_NEAR(sum, 48 * 48 - 4 * 0.5 * 3.6 * 3.6, 1e-6);
}

TEST(Annotations, NothingIsCutOffAndNothingIsOutside) {
    for (const auto& [rays, geometry] : cases()) {
        for (const Ink ink : {Ink::Light, Ink::Dark}) {
            const Annotation bar = drawScaleBar(scaleBar(rays, geometry), rays.size, ink);
            const Annotation marker = drawOrientationMarker(orientationMarker(rays), rays.size, ink);
            for (const auto& drawn : {bar, marker}) {
                EXPECT_TRUE(hasClearRim(drawn.image));
                EXPECT_GE(std::min(drawn.corner.x, drawn.corner.y), 0);
                EXPECT_LE(drawn.corner.x + drawn.image.width, rays.size.x);
                EXPECT_LE(drawn.corner.y + drawn.image.height, rays.size.y);
            }
            EXPECT_LE(bar.corner.x + bar.image.width, marker.corner.x) << "they do not meet";
        }
    }
}

TEST(Annotations, LargePicturesLookLikeSmallOnes) {
    const auto geometry = volume::makeGeometry({100, 120, 80});
    const OrientationMarker small = orientationMarker(viewRays({}, geometry, {900, 600}));
    const OrientationMarker large = orientationMarker(viewRays({}, geometry, {3600, 2400}));
    EXPECT_NEAR(large.radius, 4 * small.radius, 1e-9);
    EXPECT_NEAR(glm::distance(large.centre, 4.0 * small.centre), 0, 1e-9);
    EXPECT_NEAR(large.letters[0].size, 4 * small.letters[0].size, 1e-9);
}

TEST(Annotations, DenseScreensShowThemAsLargeAsOthers) {
    const auto geometry = volume::makeGeometry({100, 120, 80});
    for (const glm::ivec2 size : {glm::ivec2{300, 360}, {900, 1200}, {120, 160}}) {
        const OrientationMarker plain = orientationMarker(viewRays({}, geometry, size));
        const OrientationMarker dense = orientationMarker(viewRays({}, geometry, 2 * size), 2);
        EXPECT_NEAR(dense.radius, 2 * plain.radius, 1e-9) << size.x;
        const ScaleBar bar = scaleBar(viewRays({}, geometry, size), geometry);
        const ScaleBar denseBar = scaleBar(viewRays({}, geometry, 2 * size), geometry, 2);
        EXPECT_NEAR(glm::distance(denseBar.left, 2.0 * bar.left), 0, 2.0) << "whole pixels";
        EXPECT_EQ(denseBar.label, bar.label);
    }
}

TEST(Annotations, TinyPicturesAreNoTrouble) {
    const auto geometry = volume::makeGeometry({10, 10, 10});
    for (const glm::ivec2 size : {glm::ivec2{1, 1}, {2, 300}, {300, 2}, {17, 9}}) {
        const ViewRays rays = viewRays({}, geometry, size);
        const ScaleBar bar = scaleBar(rays, geometry);
        EXPECT_TRUE(std::isfinite(bar.lengthMm) && bar.lengthMm > 0) << bar.lengthMm;
        const std::array<Annotation, 2> drawn{
            drawScaleBar(bar, size, Ink::Light),
            drawOrientationMarker(orientationMarker(rays), size, Ink::Light)};
        const image::Image before(size.x, size.y);
        image::Image picture = before;
        annotate(picture, rays, geometry);
        ASSERT_EQ(glm::ivec2(picture.width, picture.height), size);
        ASSERT_EQ(picture.rgba.size(), before.rgba.size());
        // What lies beside both marks stays as it was, whatever of them there is no room for.
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const bool isBeside = std::none_of(drawn.begin(), drawn.end(), [&](const Annotation& mark) {
                    return x >= mark.corner.x && x < mark.corner.x + mark.image.width && y >= mark.corner.y &&
                           y < mark.corner.y + mark.image.height;
                });
                EXPECT_TRUE(!isBeside || picture.pixel(x, y)[3] == before.pixel(x, y)[3]) << x << " " << y;
            }
        }
    }
}

TEST(Annotations, InkStandsOutFromThePicture) {
    const auto geometry = volume::makeGeometry({100, 120, 80});
    const ViewRays rays = viewRays({}, geometry, {600, 400});
    const ScaleBar bar = scaleBar(rays, geometry);
    for (const int grey : {0, 40, 127, 128, 200, 255}) {
        image::Image picture(600, 400);
        for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
            picture.rgba[i] = i % 4 == 3 ? 255 : std::uint8_t(grey);
        }
        annotate(picture, rays, geometry);
        const int ink = picture.pixel(int(bar.left.x) + 20, int(bar.left.y) - 1)[0];
        EXPECT_GT(std::abs(ink - grey), 100) << grey;
    }
    // Transparent pictures are mostly put on paper.
    image::Image clear(600, 400);
    annotate(clear, rays, geometry);
    EXPECT_LT(clear.pixel(int(bar.left.x) + 20, int(bar.left.y) - 1)[0], 50);
    EXPECT_EQ(clear.pixel(300, 200)[3], 0);
}

} // namespace
} // namespace vs::render
