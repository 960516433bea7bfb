// SPDX-License-Identifier: Apache-2.0
#include "sculpt/solids/solid_cut.h"

#include "base/check.h"
#include "base/progress.h"
#include "field/field.h"
#include "gl/pass.h"
#include "sculpt/shaders/bindings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <vector>

namespace vs::sculpt {

namespace {

constexpr double kMostBand = 256; // pixels
constexpr double kLeaning = 0.9;  // cosine of the steepest ray to the picture's middle

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

bool isNearer(glm::vec2 a, glm::vec2 b) { return a.x >= 0 && (b.x < 0 || a.x < b.x); }

// Each of `count` spans, `stride` apart, becomes the nearest among those within `reach`, by a queue of those
// that may still be the nearest (Lemire 2006, "Streaming maximum-minimum filter"): the cost does not depend
// on reach.
void takeNearest(glm::vec2* spans, int count, std::ptrdiff_t stride, int reach) {
    std::vector<glm::vec2> source(std::size_t(count), glm::vec2(0));
    for (int n = 0; n < count; ++n) {
        source[std::size_t(n)] = spans[n * stride];
    }
    std::deque<int> candidates;
    for (int n = 0; n < count + reach; ++n) {
        if (n < count) {
            while (!candidates.empty() &&
                   !isNearer(source[std::size_t(candidates.back())], source[std::size_t(n)])) {
                candidates.pop_back();
            }
            candidates.push_back(n);
        }
        const int centre = n - reach;
        if (centre >= 0) {
            while (candidates.front() < centre - reach) {
                candidates.pop_front();
            }
            spans[centre * stride] = source[std::size_t(candidates.front())];
        }
    }
}

// The span that begins nearest to the eye among those within `reach` pixels: what a surface in front covers,
// and a little more, so that it is cut up to its silhouette and beyond.
std::vector<glm::vec2> nearestAround(std::vector<glm::vec2> spans, glm::ivec2 size, int reach) {
    for (int y = 0; y < size.y; ++y) {
        takeNearest(&spans[std::size_t(y) * std::size_t(size.x)], size.x, 1, std::min(reach, size.x));
    }
    for (int x = 0; x < size.x; ++x) {
        takeNearest(&spans[std::size_t(x)], size.y, size.x, std::min(reach, size.y));
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

// How far (mm) a place lies inside the outline's cone of rays; near the eye, where the picture tells little,
// it may be on either side.
double depthInOutline(const OutlineDistances& outline, const Projector& view, const glm::dvec3& world,
                      double nearMm) {
    const glm::dvec4 p = view.pixelFromWorld * glm::dvec4(world, 1.0);
    if (!view.isOrthographic && p.w < 0.05 * nearMm) {
        return p.w < -0.05 * nearMm ? -1e30 : 0;
    }
    const glm::ivec2 texel(glm::round(glm::clamp(glm::dvec2(p) / p.w - outline.origin, -1.0, 1e6)));
    const bool isInside =
        texel.x >= 0 && texel.y >= 0 && texel.x < outline.size.x && texel.y < outline.size.y;
    const double pixels =
        isInside
            ? double(
                  outline.values[std::size_t(texel.y) * std::size_t(outline.size.x) + std::size_t(texel.x)])
            : -outline.band;
    // Half a pixel of rounding, and rays lean: distances across them are a little shorter than in the
    // picture.
    const double mm = (std::abs(pixels) - 1) * view.pixelMm * p.w * kLeaning;
    return std::copysign(std::max(mm, 0.0), pixels);
}

} // namespace

// Farther than this (mm) from the centre of a tile, a boundary leaves all its voxels whole, or takes them
// whole.
double SolidCutter::tileReach(int radius) const {
    constexpr double kSigmas = 4;
    return kSigmas * radius / 3.0 * geometry_.stepMm() + 0.5 * kTile * glm::length(geometry_.spacing());
}

SolidCutter::Tiles SolidCutter::find(const Box3& box, int radius, const DepthOfTile& depth) const {
    Tiles tiles;
    const double reach = tileReach(radius);
    const glm::ivec3 grid = divideUp(geometry_.dims, kTile);
    const Box3 range{box.lo / kTile, divideUp(box.hi, kTile)};
    for (int z = range.lo.z; z < range.hi.z; ++z) {
        for (int y = range.lo.y; y < range.hi.y; ++y) {
            for (int x = range.lo.x; x < range.hi.x; ++x) {
                const glm::dvec3 centre = double(kTile) * glm::dvec3(x, y, z) + 0.5 * (kTile - 1);
                const double d = depth(glm::dvec3(geometry_.worldFromVoxel * glm::dvec4(centre, 1.0)));
                const auto number = std::uint32_t((z * grid.y + y) * grid.x + x);
                if (d > reach) {
                    tiles.wholly.push_back(number);
                } else if (d > -reach) {
                    tiles.partly.push_back(number);
                }
            }
        }
    }
    return tiles;
}

Box3 SolidCutter::boxOf(std::uint32_t tile) const {
    const glm::ivec3 grid = divideUp(geometry_.dims, kTile);
    const int n = int(tile);
    const glm::ivec3 lo = kTile * glm::ivec3(n % grid.x, n / grid.x % grid.y, n / (grid.x * grid.y));
    return intersect({lo, lo + kTile}, geometry_.box());
}

// Bricks all of whose tiles are cut whole need no program.
void SolidCutter::fillBricks(Tiles& tiles, CutTarget& target, Combine how) const {
    const glm::ivec3 grid = divideUp(geometry_.dims, field::kBrick);
    const auto brickOf = [&](std::uint32_t tile) {
        const glm::ivec3 at = boxOf(tile).lo / field::kBrick;
        return (at.z * grid.y + at.y) * grid.x + at.x;
    };
    std::vector<std::uint8_t> whole(Box3{glm::ivec3(0), grid}.volume()); // tiles of each brick
    for (const std::uint32_t tile : tiles.wholly) {
        ++whole[std::size_t(brickOf(tile))];
    }
    std::vector<bool> isFilled(whole.size());
    for (std::size_t n = 0; n < whole.size(); ++n) {
        const int brick = int(n);
        const glm::ivec3 lo =
            field::kBrick * glm::ivec3(brick % grid.x, brick / grid.x % grid.y, brick / grid.x / grid.y);
        const Box3 box = intersect({lo, lo + field::kBrick}, geometry_.box());
        const glm::ivec3 size = divideUp(box.size(), kTile);
        isFilled[n] = whole[n] > 0 && whole[n] == size.x * size.y * size.z && target.fill(box, how);
    }
    std::erase_if(tiles.wholly, [&](std::uint32_t tile) { return isFilled[std::size_t(brickOf(tile))]; });
}

Box3 SolidCutter::run(const Prepare& prepare, Tiles tiles, CutTarget& target, int radius, Combine how) {
    if (how == Combine::Restore && target.isEmpty()) {
        return {};
    }
    Box3 all;
    std::map<std::array<int, 3>, Tiles> parts; // by the cell of the target's grid of parts
    const auto add = [&](std::vector<std::uint32_t> Tiles::*list) {
        for (const std::uint32_t tile : tiles.*list) {
            const Box3 box = boxOf(tile);
            const glm::ivec3 cell = target.side() == 0 ? glm::ivec3(0) : box.lo / target.side();
            (parts[{cell.z, cell.y, cell.x}].*list).push_back(tile);
            all = unite(all, box);
        }
    };
    if (target.side() != 0) {
        for (const std::uint32_t tile : tiles.wholly) {
            all = unite(all, boxOf(tile));
        }
        fillBricks(tiles, target, how);
    }
    add(&Tiles::partly);
    add(&Tiles::wholly);
    const gl::Pass pass("cut solid");
    for (const auto& part : parts) {
        const Tiles& some = part.second;
        reportProgress();
        Box3 box;
        for (const auto* list : {&some.partly, &some.wholly}) {
            for (const std::uint32_t tile : *list) {
                box = unite(box, boxOf(tile));
            }
        }
        target.cutIn(box,
                     [&](const CutTarget::Part& where) { return runIn(where, prepare, some, radius, how); });
    }
    target.finish();
    return all;
}

Box3 SolidCutter::runIn(const CutTarget::Part& part, const Prepare& prepare, const Tiles& all, int radius,
                        Combine how) {
    Tiles tiles = all;
    Box3 box;
    for (auto* list : {&tiles.partly, &tiles.wholly}) {
        std::erase_if(*list,
                      [&](std::uint32_t number) { return intersect(boxOf(number), part.within).isEmpty(); });
        for (const std::uint32_t number : *list) {
            const Box3 tile = boxOf(number);
            if (part.backup != nullptr) {
                part.backup->protect(tile);
            }
            box = unite(box, tile);
        }
    }
    Sculpture& sculpture = *part.sculpture;
    sculpture.texels().bindImage(kSolidSculptureImage, gl::Access::ReadWrite);
    gl::Program& program = prepare(part);
    gl::Program& fill = fill_.with(sculpture.defines());
    sculpture.bindLimits(program);
    sculpture.bindLimits(fill);
    dispatch(program, tiles.partly, sculpture.origin(), radius, how);
    dispatch(fill, tiles.wholly, sculpture.origin(), radius, how);
    sculpture.refresh(box);
    return box;
}

void SolidCutter::dispatch(gl::Program& program, const std::vector<std::uint32_t>& tiles,
                           glm::ivec3 firstVoxel, int radius, Combine how) {
    constexpr std::size_t row = 32768; // as in tiles.glsl
    if (tiles.empty()) {
        return;
    }
    std::vector<std::uint32_t> list{0, 0, 1, std::uint32_t(tiles.size())};
    list.insert(list.end(), tiles.begin(), tiles.end());
    list_.reserve(list.size() * sizeof(std::uint32_t));
    list_.write(std::span<const std::uint32_t>(list));
    list_.bindStorage(kTileListStorage);
    program.set("tileDims", divideUp(geometry_.dims, kTile))
        .set("firstVoxel", firstVoxel)
        .set("dims", geometry_.dims)
        .set("isRestore", how == Combine::Restore ? 1 : 0)
        .set("worldFromVoxel", glm::mat4(geometry_.worldFromVoxel))
        .set("sigma", float(radius / 3.0 * geometry_.stepMm()));
    const std::size_t rows = (tiles.size() + row - 1) / row;
    program.dispatch({int(std::min(tiles.size(), row)), int(rows), 1}, gl::Barrier::Texture);
}

Box3 SolidCutter::extrude(CutTarget& target, const Extrusion& solid, Combine how) {
    const Projector& view = solid.projector;
    const double step = geometry_.stepMm();
    // As wide as the edge is where the volume is nearest to the eye, about.
    const double distance = view.isOrthographic ? 1.0
                                                : glm::dot(geometry_.centreWorld() - view.eye, view.forward) -
                                                      geometry_.diagonalMm() / 2;
    const double pixelMm = view.pixelMm * std::max(distance, 1.0);
    // Wide enough to tell tiles that are cut whole, or not at all.
    const double band = std::clamp(tileReach(solid.radius) / (pixelMm * kLeaning) + 2, 3.0, kMostBand);
    const OutlineDistances distances = outlineDistances(solid.outline, band);
    if (distances.values.empty()) {
        return {};
    }
    const auto outline = asTexture(distances.size, std::span<const float>(distances.values), gl::Format::R32F,
                                   gl::Filter::Linear, "outline distances");
    const bool hasDepth = !solid.beginMm.empty();
    gl::Texture own;
    gl::Texture front;
    if (hasDepth) {
        VS_CHECK_EQ(solid.beginMm.size(), std::size_t(view.viewport.x) * std::size_t(view.viewport.y));
        VS_CHECK_EQ(solid.beginMm.size(), solid.endMm.size());
        const auto spans = spansOf(solid);
        const auto nearest = nearestAround(
            spans, view.viewport, int(std::min(std::ceil(solid.radius * step / pixelMm), kMostBand)));
        const auto upload = [&](const std::vector<glm::vec2>& values, const char* label) {
            return asTexture(view.viewport, std::span<const glm::vec2>(values), gl::Format::RG32F,
                             gl::Filter::Nearest, label);
        };
        own = upload(spans, "depths under pixels");
        front = upload(nearest, "depths in front");
    }
    const auto prepare = [&](const CutTarget::Part& part) -> gl::Program& {
        outline.bindTexture(kOutlineDistancesTexture);
        if (hasDepth) {
            own.bindTexture(kOwnDepthsTexture);
            front.bindTexture(kFrontDepthsTexture);
        }
        gl::Program& program = extrude_.with(part.sculpture->defines());
        program.set("pixelFromVoxel", glm::mat4(view.pixelFromWorld * geometry_.worldFromVoxel))
            .set("outlinePlace", glm::vec4(distances.origin, band, view.pixelMm))
            .set("eye", glm::vec4(view.eye, view.isOrthographic ? 1.0 : 0.0))
            .set("forward", glm::vec3(view.forward))
            .set("kind", glm::vec3(solid.cutsOutside ? 1.0 : 0.0, hasDepth ? 1.0 : 0.0, solid.radius * step));
        return program;
    };
    const Box3 box = solid.cutsOutside ? geometry_.box() : boxSeenThrough(distances, view, geometry_);
    Tiles tiles = find(box, solid.radius, [&](const glm::dvec3& centre) {
        const double depth = depthInOutline(distances, view, centre, geometry_.diagonalMm());
        return solid.cutsOutside ? -depth : depth;
    });
    if (hasDepth) { // then no tile is known to be cut whole
        tiles.partly.insert(tiles.partly.end(), tiles.wholly.begin(), tiles.wholly.end());
        tiles.wholly.clear();
    }
    return run(prepare, std::move(tiles), target, solid.radius, how);
}

Box3 SolidCutter::clip(CutTarget& target, const HalfSpaces& solid, Combine how) {
    if (solid.planes.empty()) {
        return {};
    }
    VS_CHECK(solid.planes.size() <= kMaxPlanes);
    const auto prepare = [&](const CutTarget::Part& part) -> gl::Program& {
        gl::Defines defines = part.sculpture->defines();
        defines.emplace_back("MAX_PLANES", std::to_string(kMaxPlanes));
        gl::Program& program = clip_.with(defines);
        const std::vector<glm::vec4> planes(solid.planes.begin(), solid.planes.end());
        program.set("kind", glm::ivec2(int(solid.planes.size()), solid.cutsInside ? 1 : 0))
            .set("planes", planes);
        return program;
    };
    Tiles tiles = find(geometry_.box(), solid.radius, [&](const glm::dvec3& centre) {
        double outside = -1e30;
        for (const glm::dvec4& plane : solid.planes) {
            outside = std::max(outside, glm::dot(plane, glm::dvec4(centre, 1.0)));
        }
        return solid.cutsInside ? -outside : outside;
    });
    return run(prepare, std::move(tiles), target, solid.radius, how);
}

Box3 SolidCutter::cutValues(CutTarget& target, std::span<const float> energies, Combine how) {
    const Box3 grid = geometry_.box();
    VS_CHECK_EQ(energies.size(), grid.volume());
    gl::Texture texels;
    const auto prepare = [&](const CutTarget::Part& part) -> gl::Program& {
        const Box3 box{part.sculpture->origin(), part.within.hi};
        const glm::ivec3 size = box.size();
        std::vector<float> own;
        if (box != grid) {
            own.reserve(box.volume());
            forEachVoxel(box, [&](glm::ivec3 v, std::size_t) {
                own.push_back(energies[(std::size_t(v.z) * std::size_t(grid.hi.y) + std::size_t(v.y)) *
                                           std::size_t(grid.hi.x) +
                                       std::size_t(v.x)]);
            });
        }
        texels = gl::Texture(size, gl::Format::R32F, gl::Filter::Nearest, "energies");
        texels.upload({glm::ivec3(0), size},
                      own.empty() ? std::as_bytes(energies) : std::as_bytes(std::span(own)));
        texels.bindImage(kEnergiesImage, gl::Access::Read);
        return cutValues_.with(part.sculpture->defines());
    };
    return run(prepare, find(grid, 3, [](const glm::dvec3&) { return 0.0; }), target, 3, how);
}

} // namespace vs::sculpt
