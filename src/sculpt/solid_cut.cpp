// SPDX-License-Identifier: Apache-2.0
#include "sculpt/solid_cut.h"

#include "base/check.h"
#include "field/field.h"
#include "gl/pass.h"

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

constexpr double kMostBand = 256; // pixels: beyond it an edge is as sharp as a pixel can show

template <typename T>
gl::Texture asTexture(glm::ivec2 size, std::span<const T> values, gl::Format format, gl::Filter filter,
                      const char* label) {
    gl::Texture texture(size, format, filter, label);
    texture.upload({glm::ivec3(0), glm::ivec3(size, 1)}, std::as_bytes(values));
    return texture;
}

// Beginning and end along the ray of each pixel.
std::vector<glm::vec2> spansOf(const Extrusion& solid) {
    std::vector<glm::vec2> spans;
    spans.reserve(solid.beginMm.size());
    for (std::size_t n = 0; n < solid.beginMm.size(); ++n) {
        spans.emplace_back(solid.beginMm[n], solid.endMm[n]);
    }
    return spans;
}

// The span that begins nearest to the eye among those within `reach` pixels: what a surface in front covers,
// and a little more, so that it is cut up to its silhouette and beyond.
std::vector<glm::vec2> nearestAround(std::vector<glm::vec2> spans, glm::ivec2 size, int reach) {
    const auto isNearer = [](glm::vec2 a, glm::vec2 b) { return a.x >= 0 && (b.x < 0 || a.x < b.x); };
    std::vector<glm::vec2> source;
    for (const glm::ivec2 axis : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
        source = spans;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                glm::vec2& nearest = spans[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
                for (int n = -reach; n <= reach; ++n) {
                    const glm::ivec2 e = glm::clamp(glm::ivec2(x, y) + n * axis, glm::ivec2(0), size - 1);
                    const glm::vec2 other = source[std::size_t(e.y) * std::size_t(size.x) + std::size_t(e.x)];
                    nearest = isNearer(other, nearest) ? other : nearest;
                }
            }
        }
    }
    return spans;
}

// Whole bricks that may be seen through the outline's raster.
Box3 boxSeenThrough(const OutlineDistances& outline, const Projector& view,
                    const volume::GridGeometry& geometry) {
    const glm::dmat4 pixelFromVoxel = view.pixelFromWorld * geometry.worldFromVoxel;
    const glm::dvec2 last = outline.origin + glm::dvec2(outline.size);
    const glm::ivec3 grid = divideUp(geometry.dims, field::kBrick);
    Box3 all;
    for (int number = 0; number < grid.x * grid.y * grid.z; ++number) {
        const glm::ivec3 lo =
            field::kBrick * glm::ivec3(number % grid.x, number / grid.x % grid.y, number / (grid.x * grid.y));
        glm::dvec2 seenLo(1e30);
        glm::dvec2 seenHi(-1e30);
        for (int n = 0; n < 8; ++n) {
            const glm::ivec3 corner = lo + field::kBrick * glm::ivec3(n & 1, (n >> 1) & 1, n >> 2);
            const glm::dvec4 p = pixelFromVoxel * glm::dvec4(glm::dvec3(corner) - 0.5, 1.0);
            const bool isBehind = p.w <= 1e-3; // its place in the picture is nowhere: anywhere
            seenLo = isBehind ? glm::dvec2(-1e30) : glm::min(seenLo, glm::dvec2(p) / p.w);
            seenHi = isBehind ? glm::dvec2(1e30) : glm::max(seenHi, glm::dvec2(p) / p.w);
        }
        if (glm::all(glm::lessThan(seenLo, last)) && glm::all(glm::greaterThan(seenHi, outline.origin))) {
            all = unite(all, {lo, lo + field::kBrick});
        }
    }
    return intersect(all, geometry.box());
}

} // namespace

Box3 SolidCutter::run(gl::Program& program, Sculpture& sculpture, const Box3& box, int radius, Combine how,
                      BrickBackup& backup) {
    if (box.isEmpty() || (how == Combine::Restore && sculpture.isEmpty())) {
        return {};
    }
    backup.protect(box);
    const gl::Pass pass("cut solid");
    sculpture.texels().bindImage(0, gl::Access::ReadWrite);
    program.set(0, box.lo)
        .set(1, sculpture.dims())
        .set(2, how == Combine::Restore ? 1 : 0)
        .set(3, glm::mat4(geometry_.worldFromVoxel))
        .set(4, float(radius / 3.0 * geometry_.stepMm()));
    const glm::ivec3 size = box.size();
    program.dispatch({divideUp(size.x, 8), divideUp(size.y, 8), divideUp(size.z, 8)}, gl::Barrier::Texture);
    sculpture.refresh(box);
    return box;
}

Box3 SolidCutter::extrude(Sculpture& sculpture, const Extrusion& solid, Combine how, BrickBackup& backup) {
    const Projector& view = solid.projector;
    const double step = geometry_.stepMm();
    // As wide as the edge is where the volume is nearest to the eye, about.
    const double distance = view.isOrthographic ? 1.0
                                                : glm::dot(geometry_.centreWorld() - view.eye, view.forward) -
                                                      geometry_.diagonalMm() / 2;
    const double pixelMm = view.pixelMm * std::max(distance, 1.0);
    const double band = std::clamp(solid.radius * step / pixelMm + 2, 3.0, kMostBand);
    const OutlineDistances distances = outlineDistances(solid.outline, band);
    if (distances.values.empty()) {
        return {};
    }
    if (!extrude_) {
        extrude_ = gl::Program("sculpt/shaders/cut_extrusion.comp");
    }
    const auto outline = asTexture(distances.size, std::span<const float>(distances.values), gl::Format::R32F,
                                   gl::Filter::Linear, "outline distances");
    outline.bindTexture(0);
    const bool hasDepth = !solid.beginMm.empty();
    gl::Texture own;
    gl::Texture front;
    if (hasDepth) {
        VS_CHECK_EQ(solid.beginMm.size(), std::size_t(view.viewport.x) * std::size_t(view.viewport.y));
        VS_CHECK_EQ(solid.beginMm.size(), solid.endMm.size());
        const auto spans = spansOf(solid);
        const auto nearest = nearestAround(spans, view.viewport, int(std::ceil(band)) - 2);
        const auto upload = [&](const std::vector<glm::vec2>& values, const char* label) {
            return asTexture(view.viewport, std::span<const glm::vec2>(values), gl::Format::RG32F,
                             gl::Filter::Nearest, label);
        };
        own = upload(spans, "depths under pixels");
        front = upload(nearest, "depths in front");
        own.bindTexture(1);
        front.bindTexture(2);
    }
    extrude_.set(5, glm::mat4(view.pixelFromWorld * geometry_.worldFromVoxel))
        .set(6, glm::vec4(distances.origin, band, view.pixelMm))
        .set(7, glm::vec4(view.eye, view.isOrthographic ? 1.0 : 0.0))
        .set(8, glm::vec3(view.forward))
        .set(9, glm::vec3(solid.cutsOutside ? 1.0 : 0.0, hasDepth ? 1.0 : 0.0, solid.radius * step));
    const Box3 box = solid.cutsOutside ? geometry_.box() : boxSeenThrough(distances, view, geometry_);
    return run(extrude_, sculpture, box, solid.radius, how, backup);
}

Box3 SolidCutter::clip(Sculpture& sculpture, const HalfSpaces& solid, Combine how, BrickBackup& backup) {
    if (solid.planes.empty()) {
        return {};
    }
    VS_CHECK(solid.planes.size() <= kMaxPlanes);
    if (!clip_) {
        clip_ =
            gl::Program("sculpt/shaders/cut_half_spaces.comp", {{"MAX_PLANES", std::to_string(kMaxPlanes)}});
    }
    clip_.set(5, glm::ivec2(int(solid.planes.size()), solid.cutsInside ? 1 : 0));
    for (std::size_t n = 0; n < solid.planes.size(); ++n) {
        clip_.set(6 + int(n), glm::vec4(solid.planes[n]));
    }
    return run(clip_, sculpture, geometry_.box(), solid.radius, how, backup);
}

Box3 SolidCutter::cutValues(Sculpture& sculpture, std::span<const float> energies, Combine how,
                            BrickBackup& backup) {
    const Box3 grid = geometry_.box();
    VS_CHECK_EQ(energies.size(), grid.volume());
    if (!cutValues_) {
        cutValues_ = gl::Program("sculpt/shaders/cut_values.comp");
    }
    gl::Texture texels(geometry_.dims, gl::Format::R32F, gl::Filter::Nearest, "energies");
    texels.upload(grid, std::as_bytes(energies));
    texels.bindImage(1, gl::Access::Read);
    return run(cutValues_, sculpture, grid, 3, how, backup);
}

} // namespace vs::sculpt
