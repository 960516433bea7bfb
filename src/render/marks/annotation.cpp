// SPDX-License-Identifier: Apache-2.0
#include "render/marks/annotation.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace vs::render {

namespace {

// Pixels at a scale of 1.
constexpr double kBarMargin = 26;
constexpr double kMarkerMargin = 12;
constexpr double kHalfEdge = 24; // of the cube
constexpr double kLetterBeside = 15;
constexpr double kLetterOnFace = 29;
constexpr double kMarkerRadius = 54;
// Parts of the half edge.
constexpr double kBevel = 0.15;
// A direction's letter lies on its face when the cosine between it and the direction to the viewer is above
// the first, beside the cube when its magnitude is below the second.
constexpr double kOnFace = 0.33;
constexpr double kBeside = 0.27;

double smoothstep(double lo, double hi, double x) {
    const double t = std::clamp((x - lo) / (hi - lo), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// The viewer's unit axes, and what world directions look like along them.
struct Viewer {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 back;

    explicit Viewer(const ViewRays& rays)
        : right(glm::normalize(rays.right)), up(glm::normalize(rays.up)), back(-rays.forward) {}
    [[nodiscard]] glm::dvec3 seen(glm::dvec3 world) const {
        return {glm::dot(world, right), glm::dot(world, up), glm::dot(world, back)};
    }
    [[nodiscard]] glm::dvec2 onPicture(glm::dvec3 world) const {
        return {glm::dot(world, right), -glm::dot(world, up)};
    }
};

struct Direction {
    char letter;
    glm::dvec3 world;
};
constexpr std::array<Direction, 6> kDirections{{{'R', {-1, 0, 0}},
                                                {'L', {1, 0, 0}},
                                                {'A', {0, -1, 0}},
                                                {'P', {0, 1, 0}},
                                                {'S', {0, 0, 1}},
                                                {'I', {0, 0, -1}}}};

// The cube from -1 to 1 with bevelled edges and corners, all facets as corners around a normal.
std::vector<std::vector<glm::dvec3>> bevelledCube() {
    constexpr double in = 1 - kBevel;
    std::vector<std::vector<glm::dvec3>> facets;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        const auto point = [&](double a, double b, double c) {
            glm::dvec3 p{0};
            p[axis] = a;
            p[u] = b;
            p[v] = c;
            return p;
        };
        for (const double s : {-1.0, 1.0}) {
            facets.push_back({point(s, -in, -in), point(s, in, -in), point(s, in, in), point(s, -in, in)});
            for (const double t : {-1.0, 1.0}) { // the edge along `axis`
                facets.push_back({point(-in, s, t * in), point(in, s, t * in), point(in, s * in, t),
                                  point(-in, s * in, t)});
            }
        }
    }
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 s{(corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0,
                           (corner & 4) != 0 ? 1.0 : -1.0};
        facets.push_back({s * glm::dvec3(1, in, in), s * glm::dvec3(in, 1, in), s * glm::dvec3(in, in, 1)});
    }
    return facets;
}

// Outward, for a convex body around the origin.
glm::dvec3 normalOf(const std::vector<glm::dvec3>& facet) {
    const glm::dvec3 n = glm::normalize(glm::cross(facet[1] - facet[0], facet[2] - facet[0]));
    return glm::dot(n, facet[0]) < 0 ? -n : n;
}

std::vector<CubeFacet> visibleFacets(const Viewer& viewer, glm::dvec2 centre, double halfEdge) {
    std::vector<CubeFacet> visible;
    for (const auto& facet : bevelledCube()) {
        const glm::dvec3 normal = viewer.seen(normalOf(facet));
        if (normal.z <= 1e-6) {
            continue;
        }
        CubeFacet seen;
        seen.normal = normal;
        for (const auto& corner : facet) {
            seen.corners.push_back(centre + halfEdge * viewer.onPicture(corner));
        }
        visible.push_back(std::move(seen));
    }
    return visible;
}

// How far the unit cube reaches in a direction of the picture (its bevels not counted).
double reach(const Viewer& viewer, glm::dvec2 direction) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 edge{0};
        edge[axis] = 1;
        sum += std::abs(glm::dot(viewer.onPicture(edge), direction));
    }
    return sum;
}

DirectionLetter letterOnFace(const Viewer& viewer, const Direction& direction, glm::dvec2 centre,
                             double scale) {
    // Upright on the face means: along superior on the four sides, away from the viewer on the top and
    // towards it below. Each is vertical in the picture, because the camera never rolls.
    const bool isSide = direction.world.z == 0;
    const glm::dvec3 up =
        isSide ? glm::dvec3(0, 0, 1)
               : glm::normalize(viewer.up - glm::dot(viewer.up, direction.world) * direction.world);
    const glm::dvec3 reading = glm::cross(up, direction.world);
    DirectionLetter letter{direction.letter, direction.world, {}, kLetterOnFace * scale, {}, true, 1};
    letter.place = centre + kHalfEdge * scale * viewer.onPicture(direction.world);
    letter.axes = glm::dmat2(viewer.onPicture(reading), -viewer.onPicture(up));
    return letter;
}

DirectionLetter letterBeside(const Viewer& viewer, const Direction& direction, glm::dvec2 centre,
                             double scale) {
    const glm::dvec2 outward = glm::normalize(viewer.onPicture(direction.world));
    DirectionLetter letter{direction.letter, direction.world, {}, kLetterBeside * scale, {}, false, 1};
    letter.axes = glm::dmat2(1.0);
    letter.place = centre + scale * (kHalfEdge * reach(viewer, outward) + 0.72 * kLetterBeside) * outward;
    return letter;
}

} // namespace

double annotationScale(glm::ivec2 size, double density) {
    const double side = std::min(size.x, size.y) / density;
    constexpr double kLegible = 0.62; // text of nine pixels
    constexpr double kRoom = 260;     // smaller pictures have none for that
    return density * std::max(side / 870, kLegible * std::min(1.0, side / kRoom));
}

std::string lengthLabel(double mm) {
    struct Unit {
        double mm;
        const char* name;
    };
    constexpr std::array<Unit, 5> kUnits{{{1e3, "m"}, {10, "cm"}, {1, "mm"}, {1e-3, "µm"}, {1e-6, "nm"}}};
    // A hair less, or a product like 1e-3 * 1000 may fall short of its unit.
    const auto* unit = std::find_if(kUnits.begin(), kUnits.end() - 1,
                                    [mm](const Unit& u) { return mm >= u.mm * (1 - 1e-9); });
    return fmt::format("{:.6g} {}", mm / unit->mm, unit->name);
}

ScaleBar scaleBar(const ViewRays& rays, const volume::GridGeometry& geometry, double density) {
    const double pixelMm = rays.pixelMm(geometry.centreWorld());
    const double most = 0.25 * rays.size.x * pixelMm;
    const double decade = std::pow(10.0, std::floor(std::log10(most)));
    const double times = most >= 5 * decade ? 5 : most >= 2 * decade ? 2 : 1;

    ScaleBar bar;
    bar.lengthMm = times * decade;
    bar.label = lengthLabel(bar.lengthMm);
    // Both ends on pixel borders, so that they are sharp: at most half a pixel off.
    const double margin = std::round(kBarMargin * annotationScale(rays.size, density));
    bar.left = {margin, rays.size.y - margin};
    bar.right = bar.left + glm::dvec2(std::round(bar.lengthMm / pixelMm), 0);
    return bar;
}

OrientationMarker orientationMarker(const ViewRays& rays, double density) {
    const Viewer viewer(rays);
    const double scale = annotationScale(rays.size, density);
    OrientationMarker marker;
    marker.radius = kMarkerRadius * scale;
    marker.centre = glm::dvec2(rays.size) - marker.radius - kMarkerMargin * scale;
    marker.facets = visibleFacets(viewer, marker.centre, kHalfEdge * scale);
    for (const auto& direction : kDirections) {
        const double towards = viewer.seen(direction.world).z;
        const double onFace = smoothstep(kBeside, kOnFace, towards);
        const double beside = 1 - smoothstep(kBeside, kOnFace, std::abs(towards));
        if (onFace > 0) {
            marker.letters.push_back(letterOnFace(viewer, direction, marker.centre, scale));
            marker.letters.back().opacity = onFace;
        }
        if (beside > 0) {
            marker.letters.push_back(letterBeside(viewer, direction, marker.centre, scale));
            marker.letters.back().opacity = beside;
        }
    }
    return marker;
}

} // namespace vs::render
