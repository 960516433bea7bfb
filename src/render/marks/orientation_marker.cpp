// SPDX-License-Identifier: Apache-2.0
#include "render/marks/orientation_marker.h"

#include "render/marks/annotation.h"

#include <array>
#include <cmath>

namespace vs::render {

namespace {

// Pixels at a scale of 1.
constexpr double kMarkerMargin = 12;
constexpr double kHalfEdge = 24; // of the cube
constexpr double kLetterBeside = 15;
constexpr double kLetterOnFace = 29;
constexpr double kMarkerRadius = 54;
// Parts of the half edge.
constexpr double kBevel = 0.15;
constexpr double kZone = 0.6; // edges and corners begin so far from a face's middle
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

std::vector<std::vector<glm::dvec3>> visibleFacets(const Viewer& viewer) {
    auto facets = bevelledCube();
    std::erase_if(facets, [&](const auto& facet) { return viewer.seen(normalOf(facet)).z <= 1e-6; });
    return facets;
}

// What of a flat convex piece has at least `least` along `direction`.
std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& piece, glm::dvec3 direction, double least) {
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const glm::dvec3 a = piece[i];
        const glm::dvec3 b = piece[(i + 1) % piece.size()];
        const double atA = glm::dot(a, direction) - least;
        const double atB = glm::dot(b, direction) - least;
        if (atA >= 0) {
            kept.push_back(a);
        }
        if (atA * atB < 0) {
            kept.push_back(glm::mix(a, b, atA / (atA - atB)));
        }
    }
    return kept;
}

// The part of a facet that is in the zone looked at along `zone`.
std::vector<glm::dvec3> inZone(std::vector<glm::dvec3> facet, glm::dvec3 zone) {
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 along{0};
        along[axis] = 1;
        if (zone[axis] == 0) {
            facet = clipped(clipped(facet, along, -kZone), -along, -kZone);
        } else {
            facet = clipped(facet, zone[axis] > 0 ? along : -along, kZone);
        }
    }
    return facet;
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
    // Upright on the face means: along superior on the four sides, and on the top and below as the viewer
    // stands.
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

// A marker without anything on it yet.
OrientationMarker placed(const ViewRays& rays, double scale) {
    OrientationMarker marker;
    marker.radius = kMarkerRadius * scale;
    marker.centre = glm::dvec2(rays.size) - marker.radius - kMarkerMargin * scale;
    marker.halfEdge = kHalfEdge * scale;
    return marker;
}

} // namespace

OrientationMarker orientationMarker(const ViewRays& rays, double density,
                                    const std::optional<glm::dvec3>& pointedAt) {
    const Viewer viewer(rays);
    const double scale = annotationScale(rays.size, density);
    OrientationMarker marker = placed(rays, scale);
    const auto onPicture = [&](const std::vector<glm::dvec3>& piece) {
        std::vector<glm::dvec2> corners;
        for (const glm::dvec3 corner : piece) {
            corners.push_back(marker.centre + marker.halfEdge * viewer.onPicture(corner));
        }
        return corners;
    };
    for (const auto& facet : visibleFacets(viewer)) {
        marker.facets.push_back({onPicture(facet), viewer.seen(normalOf(facet))});
        if (const auto lit = pointedAt ? inZone(facet, *pointedAt) : facet; pointedAt && !lit.empty()) {
            marker.lit.push_back(onPicture(lit));
        }
    }
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

std::optional<glm::dvec3> zoneAt(const ViewRays& rays, glm::dvec2 pixel, double density) {
    const Viewer viewer(rays);
    const OrientationMarker marker = placed(rays, annotationScale(rays.size, density));
    const glm::dvec2 place = (pixel - marker.centre) / marker.halfEdge;
    const glm::dvec3 middle = place.x * viewer.right - place.y * viewer.up;
    // The line of sight through the cube from -1 to 1: from where it has met all three pairs of faces to
    // where it leaves the first.
    double from = -1e300;
    double to = 1e300;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = viewer.back[axis];
        if (std::abs(along) < 1e-12) {
            if (std::abs(middle[axis]) > 1) {
                return std::nullopt;
            }
            continue;
        }
        const double a = (-1 - middle[axis]) / along;
        const double b = (1 - middle[axis]) / along;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    if (from > to) {
        return std::nullopt;
    }
    const glm::dvec3 met = middle + to * viewer.back; // nearest to the viewer
    glm::dvec3 zone{0};
    for (int axis = 0; axis < 3; ++axis) {
        zone[axis] = std::abs(met[axis]) < kZone ? 0 : met[axis] > 0 ? 1 : -1;
    }
    return glm::normalize(zone);
}

} // namespace vs::render
