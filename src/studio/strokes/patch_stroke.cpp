// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/patch_stroke.h"

#include "base/error.h"
#include "base/progress.h"
#include "studio/operations/sketch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

namespace vs::studio {

namespace {

constexpr double kRingSteps = 4;     // of surface around the outline that the patch goes on from, at least,
constexpr double kRingPart = 0.08;   // and at least this part of the outline's width
constexpr double kLeastSteps = 0.75; // below the surface: shallower dents beside the hole are none of it
constexpr double kMostLooks = 90000; // pixels
constexpr double kMostRing = 256;    // pixels
constexpr std::size_t kMostVoxels = std::size_t(1) << 27; // in and about a hole
constexpr double kAdherence = 2; // steps that the filling reaches into the hole's walls

// The energy of a plane's radiation so many steps behind it.
double energyBehind(double steps, int radius) {
    const double sigma = radius / 3.0;
    return 0.5 * std::erfc(-steps / (sigma * std::sqrt(2.0)));
}

// Calls visit(number of the first voxel, distance between voxels, count) for each line of a box along an
// axis.
template <typename Visit>
void forEachLine(glm::ivec3 size, int axis, const Visit& visit) {
    const std::array<std::size_t, 3> strides{1, std::size_t(size.x),
                                             std::size_t(size.x) * std::size_t(size.y)};
    glm::ivec3 ends = size;
    ends[axis] = 1;
    forEachVoxel({glm::ivec3(0), ends}, [&](glm::ivec3 v, std::size_t) {
        visit(std::size_t(v.x) * strides[0] + std::size_t(v.y) * strides[1] + std::size_t(v.z) * strides[2],
              strides[std::size_t(axis)], size[axis]);
    });
}

// The greatest value within `reach` voxels along an axis.
void spread(std::vector<float>& values, glm::ivec3 size, int axis, int reach) {
    std::vector<float> line;
    forEachLine(size, axis, [&](std::size_t first, std::size_t stride, int count) {
        line.resize(std::size_t(count));
        for (int i = 0; i < count; ++i) {
            line[std::size_t(i)] = values[first + std::size_t(i) * stride];
        }
        for (int i = 0; i < count; ++i) {
            const auto begin = line.begin() + std::max(i - reach, 0);
            const auto end = line.begin() + std::min(i + reach + 1, count);
            values[first + std::size_t(i) * stride] = *std::max_element(begin, end);
        }
    });
}

// Weights 1, 2, 1 along an axis.
void soften(std::vector<float>& values, glm::ivec3 size, int axis) {
    forEachLine(size, axis, [&](std::size_t first, std::size_t stride, int count) {
        float before = values[first];
        for (int i = 0; i < count; ++i) {
            const std::size_t n = first + std::size_t(i) * stride;
            const float here = values[n];
            const float after = i + 1 < count ? values[n + stride] : here;
            values[n] = 0.25F * (before + 2 * here + after);
            before = here;
        }
    });
}

// How far within an outline (pixels) a place of the picture lies.
double insideOf(const sculpt::OutlineDistances& outline, glm::dvec2 pixel) {
    const glm::ivec2 texel(glm::round(glm::clamp(pixel - outline.origin, -1.0, 1e6)));
    const bool isOn = texel.x >= 0 && texel.y >= 0 && texel.x < outline.size.x && texel.y < outline.size.y;
    return isOn ? double(outline.values[std::size_t(texel.y) * std::size_t(outline.size.x) +
                                        std::size_t(texel.x)])
                : -outline.band;
}

} // namespace

PatchStroke::PatchStroke(Cutter& cutter, const MakeFrame& makeFrame, const volume::Volume& volume,
                         const FillHole& operation)
    : CutStroke(cutter, operation, false), frame_(makeFrame()), volume_(&volume) {}

PatchStroke::Seen PatchStroke::look(const sculpt::OutlineDistances& outline, double ringPixels) const {
    const double count = double(outline.size.x) * outline.size.y;
    const int stride = std::max(1, int(std::ceil(std::sqrt(count / kMostLooks))));
    std::vector<glm::vec2> pixels;
    std::vector<bool> areInside;
    for (int y = 0; y < outline.size.y; y += stride) {
        for (int x = 0; x < outline.size.x; x += stride) {
            const double inside =
                outline.values[std::size_t(y) * std::size_t(outline.size.x) + std::size_t(x)];
            if (inside > -ringPixels) {
                pixels.emplace_back(outline.origin + glm::dvec2(x, y));
                areInside.push_back(inside >= 0);
            }
        }
    }
    const auto points = cutter_->pick(frame_, pixels);
    Seen seen;
    for (std::size_t n = 0; n < points.size(); ++n) {
        const glm::dvec3 world(cutter_->geometry->worldFromVoxel *
                               glm::dvec4(glm::dvec3(points[n].voxel), 1.0));
        if (points[n].voxel.w > 0.5F) {
            (areInside[n] ? seen.inside : seen.around).push_back(world);
        } else if (areInside[n]) {
            seen.through.emplace_back(pixels[n]);
        }
    }
    return seen;
}

std::vector<glm::dvec3> PatchStroke::seedsOf(const Seen& seen, const sculpt::PatchSurface& surface,
                                             double depthMm) const {
    const double step = cutter_->geometry->stepMm();
    std::vector<glm::dvec3> seeds;
    // Above the floor, and no deeper than is filled.
    const auto add = [&](const glm::dvec3& floor, const glm::dvec3& direction, double depth) {
        const double least = (kLeastSteps + 0.5) * step; // whichever voxel is the nearest
        const double wanted = std::clamp(depth - step, least, std::max(depthMm - step, least));
        const double cosine = std::max(-glm::dot(direction, surface.normal()), 0.2);
        seeds.push_back(floor - direction * (depth - wanted) / cosine);
    };
    for (const glm::dvec3& place : seen.inside) {
        if (const double depth = surface.depthOf(place); depth > step) {
            add(place, frame_.rays.through(frame_.rays.project(place)).direction, depth);
        }
    }
    for (const glm::dvec2 pixel : seen.through) {
        const auto ray = frame_.rays.through(pixel);
        const double t = glm::dot(surface.origin() - ray.origin, surface.normal()) /
                         std::min(glm::dot(ray.direction, surface.normal()), -0.2);
        const glm::dvec3 place = ray.origin + t * ray.direction;
        add(place, ray.direction, surface.depthOf(place));
    }
    return seeds;
}

std::vector<std::uint8_t> PatchStroke::emptyIn(const Box3& box) const {
    const Range seen =
        frame_.scene.showsAbove ? Range{frame_.scene.displayedRange.lo, 1e300} : frame_.scene.displayedRange;
    const std::vector<float> cut =
        frame_.scene.sculpture != nullptr ? cutter_->sculpture->values(box) : std::vector<float>();
    const field::Fill& fill = **cutter_->fill;
    std::vector<std::uint8_t> empty;
    empty.reserve(box.volume());
    forEachVoxel(box, [&](glm::ivec3 v, std::size_t n) {
        const bool isCut = !cut.empty() && cut[n] >= 0.5F && frame_.scene.view == field::SculptureView::Cut;
        const bool isSeen = !isCut && seen.contains(volume_->at(v));
        empty.push_back(isSeen || fill.at(v).filled >= 0.5F ? 0 : 1);
    });
    return empty;
}

PatchStroke::Hole PatchStroke::find(const std::vector<glm::dvec3>& seeds, const sculpt::PatchSurface& surface,
                                    const sculpt::OutlineDistances& outline, double depthMm) const {
    const volume::GridGeometry& geometry = *cutter_->geometry;
    const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
    const auto voxelOf = [&](const glm::dvec3& world) {
        return glm::ivec3(glm::round(glm::dvec3(voxelFromWorld * glm::dvec4(world, 1.0))));
    };
    // As wide as the hole and as deep as is filled, and a little more.
    const double step = geometry.stepMm();
    Hole hole;
    for (const glm::dvec3& seed : seeds) {
        const double depth = surface.depthOf(seed);
        for (const double to : {-4 * step, std::min(2 * depth, depthMm) + 4 * step}) {
            const glm::ivec3 voxel = voxelOf(seed + (depth - to) * surface.normal());
            hole.box = unite(hole.box, {voxel, voxel + 1});
        }
    }
    const glm::ivec3 margin(glm::ceil((kAdherence + 4) * step / geometry.spacing()));
    hole.box = intersect({hole.box.lo - 2 * margin, hole.box.hi + 2 * margin}, geometry.box());
    if (hole.box.isEmpty()) {
        return hole;
    }
    if (hole.box.volume() > kMostVoxels) {
        throw Error(
            "outline: the hole is {} voxels wide and deep, and may be {}: draw around less, or say how "
            "deep it is to be filled",
            hole.box.volume(), kMostVoxels);
    }
    hole.depths.resize(hole.box.volume());
    std::vector<std::uint8_t> mayBeIn = emptyIn(hole.box);
    forEachVoxel(hole.box, [&](glm::ivec3 v, std::size_t n) {
        const glm::dvec3 world(geometry.worldFromVoxel * glm::dvec4(glm::dvec3(v), 1.0));
        if (v.x == hole.box.lo.x && v.y == hole.box.lo.y) {
            reportProgress(0.5 + 0.3 * double(n) / double(hole.depths.size()));
        }
        const double depth = surface.depthOf(world);
        hole.depths[n] = float(depth);
        const bool isWithin = depth >= kLeastSteps * step && depth <= depthMm &&
                              insideOf(outline, frame_.rays.project(world)) >= 0;
        mayBeIn[n] = isWithin ? mayBeIn[n] : 0;
    });
    hole.isIn.assign(mayBeIn.size(), 0);
    std::deque<glm::ivec3> front;
    const auto enter = [&](glm::ivec3 v) {
        if (!intersect({v, v + 1}, hole.box).isEmpty()) {
            const std::size_t n = hole.indexOf(v);
            if (mayBeIn[n] != 0 && hole.isIn[n] == 0) {
                hole.isIn[n] = 1;
                front.push_back(v);
            }
        }
    };
    for (const glm::dvec3& seed : seeds) {
        enter(voxelOf(seed));
    }
    while (!front.empty()) {
        const glm::ivec3 v = front.front();
        front.pop_front();
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 beside(0);
            beside[axis] = 1;
            enter(v + beside);
            enter(v - beside);
        }
    }
    return hole;
}

std::vector<float> PatchStroke::energiesOf(const Hole& hole, double depthMm, int radius) const {
    const glm::dvec3 spacing = cutter_->geometry->spacing();
    const double step = cutter_->geometry->stepMm();
    std::vector<float> energies(hole.isIn.begin(), hole.isIn.end());
    const glm::ivec3 size = hole.box.size();
    for (int axis = 0; axis < 3; ++axis) {
        spread(energies, size, axis, std::max(1, int(std::lround(kAdherence * step / spacing[axis]))));
    }
    for (int turn = 0; turn < 2; ++turn) {
        for (int axis = 0; axis < 3; ++axis) {
            soften(energies, size, axis);
        }
    }
    for (std::size_t n = 0; n < energies.size(); ++n) {
        const double depth = hole.depths[n];
        const double between =
            std::min(energyBehind(depth / step, radius), energyBehind((depthMm - depth) / step, radius));
        energies[n] = std::min(energies[n], float(between));
    }
    return energies;
}

double PatchStroke::stepPixels(const sculpt::Outline& outline) const {
    const volume::GridGeometry& geometry = *cutter_->geometry;
    std::vector<glm::vec2> pixels;
    const std::size_t stride = outline.size() / 64 + 1;
    for (std::size_t n = 0; n < outline.size(); n += stride) {
        pixels.emplace_back(outline[n]);
    }
    const auto points = cutter_->pick(frame_, pixels);
    double sum = 0;
    int count = 0;
    for (const field::SurfacePoint& point : points) {
        if (point.voxel.w > 0.5F) {
            const glm::dvec3 world(geometry.worldFromVoxel * glm::dvec4(glm::dvec3(point.voxel), 1.0));
            sum += geometry.stepMm() / frame_.rays.pixelMm(world);
            ++count;
        }
    }
    return count > 0 ? sum / count : 1;
}

void PatchStroke::replay() {
    const FillHole& op = std::get<FillHole>(operation_);
    const volume::GridGeometry& geometry = *cutter_->geometry;
    const glm::dvec2 viewport(frame_.rays.size);
    const sculpt::Outline outline = sculpt::clipToBox(outlineOf(op.outline), -viewport, 2.0 * viewport);
    if (outline.size() < 3) {
        return;
    }
    const sculpt::MaskWindow window = sculpt::windowAround(outline);
    const double width = std::max(window.hi.x - window.lo.x, window.hi.y - window.lo.y);
    const double ring =
        std::clamp(std::max(kRingSteps * stepPixels(outline), kRingPart * width), 2.0, kMostRing);
    const sculpt::OutlineDistances distances = sculpt::outlineDistances(outline, ring + 2);
    if (distances.values.empty()) {
        return;
    }
    const Seen seen = look(distances, ring);
    reportProgress(0.2);
    const glm::dvec3 towards = -frame_.rays.through(0.5 * (window.lo + window.hi)).direction;
    const sculpt::PatchSurface surface(seen.around, towards, geometry.stepMm());
    reportProgress(0.5);
    const double depthMm = op.depth ? *op.depth * geometry.stepMm() : surface.widthMm();
    const Hole hole = find(seedsOf(seen, surface, depthMm), surface, distances, depthMm);
    if (std::find(hole.isIn.begin(), hole.isIn.end(), 1) == hole.isIn.end()) {
        return;
    }
    reportProgress(0.8);
    const std::vector<float> energies = energiesOf(hole, depthMm, op.radius);
    target().cutIn(hole.box, [&](const sculpt::CutTarget::Part& part) {
        std::vector<float> own;
        own.reserve(part.within.volume());
        forEachVoxel(part.within, [&](glm::ivec3 v, std::size_t) {
            const bool isKnown = !intersect({v, v + 1}, hole.box).isEmpty();
            own.push_back(isKnown ? energies[hole.indexOf(v)] : 0.0F);
        });
        return cutBy(part, own);
    });
}

} // namespace vs::studio
