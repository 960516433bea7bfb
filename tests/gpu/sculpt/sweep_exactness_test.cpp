// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl_test.h"
#include "reference/boundary.h"
#include "reference/solids.h"
#include "sculpt/radiation/sweep.h"

#include <algorithm>
#include <cmath>

namespace vs::sculpt {
namespace {

using reference::SweptCurve;

// Sweeps through a radiator of their own, and how far what comes out is from the solid that was meant.
class SweepExactness : public test::GlTest {
protected:
    static std::vector<float> sweep(const Outline& outline, const std::vector<PathPiece>& path,
                                    glm::ivec3 dims, glm::dvec3 spacing = glm::dvec3(1), int radius = 3,
                                    double pitch = kSweepPitch) {
        Radiator radiator;
        PointGenerator generator;
        sweepMask(radiator, generator, rasterize(outline, pitch), path, dims, sweepFootprint(radius, spacing),
                  voxelFromSteps(spacing));
        auto values = radiator.download({glm::ivec3(0), dims});
        for (float& value : values) {
            value = std::clamp(value, 0.0F, 1.0F);
        }
        return values;
    }

    // Away from the ends' rims and from the outline's corners by a little more than the footprint reaches.
    static reference::BoundaryErrors errors(const std::vector<float>& values, glm::ivec3 dims,
                                            const SweptCurve& curve, const Outline& outline,
                                            glm::dvec3 spacing = glm::dvec3(1), double away = 4) {
        const auto boundary = [&](const glm::dvec3& p) -> std::optional<reference::Deviation> {
            const auto place = curve.locate(p);
            if (place.fromStart < away || place.toEnd < away) {
                return std::nullopt;
            }
            const auto off = reference::distanceTo(outline, place.element);
            if (off.toCorner < away) {
                return std::nullopt;
            }
            return reference::Deviation{off.distance, off.normal.x * place.x + off.normal.y * place.y};
        };
        return reference::boundaryErrors(values, dims, 1.0 / voxelFromSteps(spacing), boundary);
    }

    static void expectExact(const reference::BoundaryErrors& found, const std::string& what) {
        EXPECT_GT(found.count, 1000) << what;
        EXPECT_LT(found.rms, 0.1) << what;
        EXPECT_LT(found.max, 0.35) << what;
        RecordProperty(what, std::to_string(found.mean) + " mean, " + std::to_string(found.rms) + " rms, " +
                                 std::to_string(found.max) + " max");
    }

    static float largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
        float worst = 0;
        for (std::size_t n = 0; n < a.size(); ++n) {
            worst = std::max(worst, std::abs(a[n] - b[n]));
        }
        return worst;
    }
};

struct Shape {
    std::string name;
    Outline drawn;
    Outline exact;
};
std::vector<Shape> shapes(glm::dvec2 radii = {16, 10}) {
    const Outline rectangle = rectangleOutline({-14, -9}, {14, 9});
    const Outline star = starOutline({0, 0}, 20, 9, 5);
    return {{"ellipse", ellipseOutline({0, 0}, radii), reference::ellipse(radii)},
            {"rectangle", rectangle, rectangle},
            {"star", star, star}};
}

const glm::ivec3 kSweepDims(112, 112, 96);
const std::vector<glm::dvec3> kSplinePoints{{26, 30, 26}, {48, 40, 62}, {72, 66, 66}, {86, 84, 30}};

SweptCurve::Turning turningOf(FrameKind kind) {
    return kind == FrameKind::Frenet ? SweptCurve::Turning::Normal : SweptCurve::Turning::Least;
}

TEST_F(SweepExactness, ObliqueLines) {
    const std::vector<glm::dvec3> ends{{34, 30, 22}, {76, 80, 74}};
    const SweptCurve curve([&](double t) { return glm::mix(ends[0], ends[1], t); },
                           SweptCurve::Turning::Least);
    for (const Shape& shape : shapes()) {
        expectExact(
            errors(sweep(shape.drawn, polylinePath(ends), kSweepDims), kSweepDims, curve, shape.exact),
            shape.name);
    }
}

TEST_F(SweepExactness, Helices) {
    const Helix helix{{56, 56, 30}, {56, 56, 70}, 30, 0.9};
    const SweptCurve::Turning least = SweptCurve::Turning::Least;
    for (const FrameKind kind : {FrameKind::ParallelTransport, FrameKind::Frenet}) {
        const SweptCurve curve(
            [&](double t) {
                return reference::helixAt(helix.from, helix.to, {1, 0, 0}, helix.radius, helix.turns, t);
            },
            turningOf(kind));
        for (const Shape& shape : shapes()) {
            expectExact(errors(sweep(shape.drawn, helixPath(helix, kind), kSweepDims), kSweepDims, curve,
                               shape.exact),
                        shape.name + (turningOf(kind) == least ? "_parallel" : "_frenet"));
        }
    }
}

TEST_F(SweepExactness, Splines) {
    const SweptCurve curve([&](double t) { return reference::centripetalAt(kSplinePoints, t); },
                           SweptCurve::Turning::Least);
    for (const Shape& shape : shapes()) {
        expectExact(
            errors(sweep(shape.drawn, splinePath(kSplinePoints), kSweepDims), kSweepDims, curve, shape.exact),
            shape.name);
    }
}

TEST_F(SweepExactness, WideSlicesKeepTheShapeInMillimetres) {
    // Slices three steps apart; errors in steps, which are millimetres here. Between slices pictures
    // interpolate linearly, which cuts off slice^2 / 8 of a surface's curvature: 0.18 where an ellipse of 16
    // x 10 is most curved. So the ellipse is one that such slices hold: curved at most like a circle of three
    // slices' radius.
    const glm::dvec3 spacing(1, 1, 3);
    const glm::ivec3 dims(112, 112, 32);
    const Helix helix{{56, 56, 30}, {56, 56, 70}, 30, 0.9};
    const SweptCurve onHelix(
        [&](double t) {
            return reference::helixAt(helix.from, helix.to, {1, 0, 0}, helix.radius, helix.turns, t);
        },
        SweptCurve::Turning::Least);
    const SweptCurve onSpline([&](double t) { return reference::centripetalAt(kSplinePoints, t); },
                              SweptCurve::Turning::Least);
    for (const Shape& shape : shapes({20, 14})) {
        expectExact(errors(sweep(shape.drawn, helixPath(helix), dims, spacing), dims, onHelix, shape.exact,
                           spacing, 6),
                    shape.name + "_helix");
    }
    for (const Shape& shape : shapes()) { // this path bends too sharply for the larger one
        expectExact(errors(sweep(shape.drawn, splinePath(kSplinePoints), dims, spacing), dims, onSpline,
                           shape.exact, spacing, 6),
                    shape.name + "_spline");
    }
}

TEST_F(SweepExactness, TheMasksPitchAndThePathsChordsDoNotMatter) {
    const Outline outline = ellipseOutline({0, 0}, {16, 10});
    const Helix helix{{56, 56, 30}, {56, 56, 70}, 30, 0.9};
    const auto path = helixPath(helix);
    const auto values = sweep(outline, path, kSweepDims);
    EXPECT_LT(largestDifference(values, sweep(outline, path, kSweepDims, glm::dvec3(1), 3, 0.25)), 0.02F);
    // Each piece in three.
    std::vector<PathPiece> finer;
    for (const PathPiece& piece : path) {
        MaskFrame from = piece.from;
        for (int n = 1; n <= 3; ++n) {
            const double t = n / 3.0;
            const glm::dvec3 x = glm::normalize(glm::mix(piece.from.x, piece.to.x, t));
            const glm::dvec3 y = glm::mix(piece.from.y, piece.to.y, t);
            const MaskFrame to{glm::mix(piece.from.origin, piece.to.origin, t), x,
                               glm::normalize(y - x * glm::dot(x, y))};
            finer.push_back({from, to});
            from = to;
        }
    }
    EXPECT_LT(largestDifference(values, sweep(outline, finer, kSweepDims)), 0.02F);
    // Every second place only: chords twice as long.
    std::vector<PathPiece> coarser;
    for (std::size_t n = 0; n + 1 < path.size(); n += 2) {
        coarser.push_back({path[n].from, path[n + 1].to});
    }
    if (path.size() % 2 == 1) {
        coarser.push_back(path.back());
    }
    EXPECT_LT(largestDifference(values, sweep(outline, coarser, kSweepDims)), 0.02F);
    // Inside it is 1, whatever the radius.
    for (const int radius : {2, 3, 4}) {
        const auto solid = sweep(outline, path, kSweepDims, glm::dvec3(1), radius);
        for (double t = 0.1; t < 0.95; t += 0.05) {
            const glm::ivec3 v(glm::round(helix.at(t)));
            EXPECT_NEAR(solid[(std::size_t(v.z) * 112 + std::size_t(v.y)) * 112 + std::size_t(v.x)], 1, 0.012)
                << radius;
        }
    }
}

} // namespace
} // namespace vs::sculpt
