// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/sweep_stroke.h"

#include "base/error.h"
#include "sculpt/radiation/projection.h"
#include "sculpt/radiation/raw_radiation.h"
#include "sculpt/radiation/sweep.h"
#include "studio/operations/sketch.h"

#include <algorithm>
#include <cmath>

namespace vs::studio {

namespace {

constexpr std::size_t kMostPreviews = 24;
constexpr std::size_t kMostProjected = std::size_t(1) << 29; // voxels, an energy each

// A sweep in the space of steps: voxel space scaled to the smallest spacing (sculpt/path/path.h).
struct Track {
    std::vector<sculpt::PathPiece> pieces;
    sculpt::Outline outline;
};

// Where a drawn stroke runs, in steps, and which way is up on it for the mask: out of the surface, or to the
// viewer.
struct DrawnPath {
    std::vector<glm::dvec3> points;
    glm::dvec3 up{0, 0, 1};
    double stepsPerPixel = 1;
};

class TrackMaker {
public:
    // The path is exact where the mask may come into `grid`.
    TrackMaker(Cutter& cutter, const render::Frame& frame, const sculpt::SweepGrid& grid)
        : cutter_(cutter), frame_(frame), geometry_(*cutter.geometry), grid_(grid),
          voxelFromSteps_(sculpt::voxelFromSteps(geometry_.spacing())) {}

    Track make(const Sweep& op) {
        if (op.path.isDrawn()) {
            return drawn(op);
        }
        Track track;
        track.outline = outlineOf(op.mask);
        for (glm::dvec2& point : track.outline) {
            point *= cutter_.toolSteps();
        }
        const sculpt::PathRegion region = grid_.region(sculpt::windowAround(track.outline));
        std::vector<glm::dvec3> points;
        for (const glm::dvec3& voxel : op.path.points) {
            points.push_back(cutter_.toolPlace(voxel) / voxelFromSteps_);
        }
        switch (op.path.kind) {
        case SweepPath::Kind::Spline:
            track.pieces = sculpt::splinePath(points, op.frame, region);
            break;
        case SweepPath::Kind::Helix:
            track.pieces = sculpt::helixPath(
                {points.at(0), points.at(1), op.path.helixRadius * cutter_.toolSteps(), op.path.turns},
                op.frame, region);
            break;
        case SweepPath::Kind::Standing: {
            const sculpt::MaskFrame frame = sculpt::frameFacing(points.at(0), points.at(1) - points.at(0));
            track.pieces = {{frame, frame}};
            break;
        }
        default:
            track.pieces = sculpt::polylinePath(points, op.frame);
        }
        return track;
    }

private:
    Track drawn(const Sweep& op) {
        const DrawnPath path = op.path.kind == SweepPath::Kind::Surface ? onSurface(op.path.stroke)
                                                                        : inViewPlane(op.path.stroke);
        auto outline = outlineOf(op.mask);
        const glm::dvec2 centre = centreOf(outline);
        for (glm::dvec2& pixel : outline) {
            pixel = path.stepsPerPixel * (pixel - centre) * glm::dvec2(1, -1);
        }
        Track track;
        track.pieces =
            sculpt::recordedPath(path.points, op.frame, grid_.region(sculpt::windowAround(outline)));
        if (track.pieces.empty()) {
            return track;
        }
        // The sketch's own up (y down in the picture) becomes the path's.
        const sculpt::MaskFrame& first = track.pieces.front().from;
        const glm::dvec2 up(glm::dot(path.up, first.x), glm::dot(path.up, first.y));
        const double angle = glm::length(up) > 1e-6 ? std::atan2(-up.x, up.y) : 0.0;
        const glm::dmat2 turn(std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle));
        for (const glm::dvec2 element : outline) {
            track.outline.push_back(turn * element);
        }
        return track;
    }

    [[nodiscard]] glm::dvec3 stepsOf(const glm::dvec3& world) const {
        return glm::dvec3(geometry_.voxelFromWorld() * glm::dvec4(world, 1.0)) / voxelFromSteps_;
    }
    [[nodiscard]] glm::dvec3 wayInSteps(const glm::dvec3& world) const {
        return glm::dmat3(geometry_.voxelFromWorld()) * world / voxelFromSteps_;
    }

    DrawnPath onSurface(const std::vector<glm::dvec2>& stroke) {
        const std::vector<glm::vec2> pixels(stroke.begin(), stroke.end());
        DrawnPath path;
        for (const auto& point : cutter_.pick(frame_, pixels)) {
            if (point.voxel.w < 0.5F) {
                continue; // beside the object the way is straight
            }
            if (path.points.empty()) {
                const glm::dvec3 world(geometry_.worldFromVoxel * glm::dvec4(glm::dvec3(point.voxel), 1.0));
                path.stepsPerPixel = frame_.rays.pixelMm(world) / geometry_.stepMm();
                path.up = wayInSteps(glm::dvec3(point.normal));
            }
            path.points.push_back(glm::dvec3(point.voxel) / voxelFromSteps_);
        }
        return path;
    }

    // The plane across the view through the surface at the stroke's beginning, or through the grid's centre.
    DrawnPath inViewPlane(const std::vector<glm::dvec2>& stroke) {
        DrawnPath path;
        if (stroke.empty()) {
            return path;
        }
        const glm::vec2 begin(stroke.front());
        const auto hit = cutter_.pick(frame_, std::span(&begin, 1)).front();
        const glm::dvec3 anchor =
            hit.voxel.w > 0.5F ? glm::dvec3(geometry_.worldFromVoxel * glm::dvec4(glm::dvec3(hit.voxel), 1.0))
                               : geometry_.centreWorld();
        path.stepsPerPixel = frame_.rays.pixelMm(anchor) / geometry_.stepMm();
        path.up = wayInSteps(-frame_.rays.forward);
        for (const glm::dvec2 pixel : stroke) {
            const auto ray = frame_.rays.through(pixel);
            const double t = glm::dot(anchor - ray.origin, frame_.rays.forward) /
                             glm::dot(ray.direction, frame_.rays.forward);
            path.points.push_back(stepsOf(ray.origin + t * ray.direction));
        }
        return path;
    }

    Cutter& cutter_;
    const render::Frame& frame_;
    const volume::GridGeometry& geometry_;
    const sculpt::SweepGrid& grid_;
    glm::dvec3 voxelFromSteps_;
};

// Where a mask of raw energy stands.
std::vector<sculpt::MaskFrame> framesOf(const Sweep& op, const Track& track) {
    return op.path.kind == SweepPath::Kind::Standing ? std::vector{track.pieces.front().from}
                                                     : sculpt::framesEachStep(track.pieces);
}

} // namespace

void SweepStroke::replay() {
    const Sweep& op = std::get<Sweep>(operation_);
    if (op.path.kind == SweepPath::Kind::Standing && !op.isRaw) {
        throw Error("sweep: a mask that stands still sweeps nothing; give it a path, or raw energy");
    }
    const volume::GridGeometry& geometry = *cutter_->geometry;
    const glm::dvec3 scale = sculpt::voxelFromSteps(geometry.spacing());
    const sculpt::Footprint footprint = sculpt::sweepFootprint(op.radius, geometry.spacing());
    const sculpt::SweepGrid grid = sculpt::sweepGrid(geometry.dims, footprint, scale);
    const Track track = TrackMaker(*cutter_, frame_, grid).make(op);
    const auto outline = sculpt::subdivide(track.outline, op.subdivision, op.subdivisionLevels);
    const auto mask = sculpt::rasterize(sculpt::outlineInto(grid, outline, track.pieces, op.pitch, op.filter),
                                        op.pitch, op.filter);
    if (track.pieces.empty() || mask.values.empty()) {
        return;
    }
    if (op.method == Sweep::Method::Projection) {
        if (geometry.box().volume() > kMostProjected) {
            throw Error("sweep: by projection the volume may have {} voxels at the most, and this one has {} "
                        "at its finest level; use radiation",
                        kMostProjected, geometry.box().volume());
        }
        cutter_->solids.cutValues(target(), sculpt::projectSweep(mask, track.pieces, geometry.dims, scale),
                                  how_);
        return;
    }
    sculpt::Radiator& radiator = cutter_->tools.radiator();
    std::vector<sculpt::MaskFrame> frames;
    sculpt::SweptWay way;
    if (op.isRaw) {
        frames = framesOf(op, track);
        way.points = sculpt::rawPointBox(mask, frames, scale);
    } else {
        way = sculpt::wayInto(grid, geometry.dims, mask, track.pieces);
    }
    if (way.points.isEmpty()) {
        return;
    }
    const auto cutPart = [&](const sculpt::CutTarget::Part& part) {
        const Box3 touched = op.isRaw ? sculpt::radiateRaw(radiator, mask, frames, geometry.dims, part.within,
                                                           footprint, scale)
                                      : sculpt::sweepWay(radiator, cutter_->tools.generator(), mask, way,
                                                         grid, part.within, footprint);
        if (part.backup != nullptr) {
            part.backup->protect(touched);
        }
        return part.sculpture->combine(radiator, how_);
    };
    target().cutIn(sculpt::reachOf(way.points, footprint), cutPart, [&](const Box3& box) {
        const Box3 near = sculpt::reachOf(box, footprint);
        return op.isRaw || std::any_of(way.boxes.begin(), way.boxes.end(), [&](const Box3& points) {
                   return !intersect(points, near).isEmpty();
               });
    });
}

std::vector<std::vector<glm::dvec2>> sweptOutlines(Cutter& cutter, const render::Frame& frame,
                                                   const Sweep& operation) {
    const volume::GridGeometry& geometry = *cutter.geometry;
    const glm::dvec3 voxelFromSteps = sculpt::voxelFromSteps(geometry.spacing());
    sculpt::SweepGrid nowhere; // outlines to look at need no exact chords
    nowhere.voxelFromSteps = voxelFromSteps;
    nowhere.lo = nowhere.hi;
    const Track track = TrackMaker(cutter, frame, nowhere).make(operation);
    std::vector<std::vector<glm::dvec2>> outlines;
    const std::size_t stride =
        std::max<std::size_t>(1, (track.pieces.size() + kMostPreviews - 1) / kMostPreviews);
    for (std::size_t n = 0; n <= track.pieces.size() && !track.pieces.empty(); n += stride) {
        const std::size_t last = track.pieces.size() - 1;
        const sculpt::MaskFrame& place = n > last ? track.pieces[last].to : track.pieces[n].from;
        std::vector<glm::dvec2>& outline = outlines.emplace_back();
        for (const glm::dvec2 element : track.outline) {
            const glm::dvec3 voxel = voxelFromSteps * place.place(element);
            outline.push_back(
                frame.rays.project(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0))));
        }
    }
    return outlines;
}

} // namespace vs::studio
