// SPDX-License-Identifier: Apache-2.0
#include "sculpt/radiation/raw_radiation.h"

#include "base/error.h"
#include "sculpt/radiation/sweep.h"

#include <algorithm>

namespace vs::sculpt {

namespace {

constexpr int kMostFrames = 4096;

} // namespace

// Those whose centres are nearest to the mask's corners in any of its frames, and all between.
Box3 rawPointBox(const MaskRaster& mask, std::span<const MaskFrame> frames,
                 const glm::dvec3& voxelFromSteps) {
    Box3 box;
    for (const MaskFrame& frame : frames) {
        for (int corner = 0; corner < 4; ++corner) {
            const glm::dvec2 element((corner & 1) != 0 ? mask.size.x : 0, corner > 1 ? mask.size.y : 0);
            const glm::dvec3 p = voxelFromSteps * frame.place(mask.origin + mask.pitch * element);
            const glm::ivec3 voxel(glm::floor(glm::clamp(p, -1e6, 1e6) + 0.5));
            box = unite(box, {voxel, voxel + 1});
        }
    }
    return box;
}

std::vector<MaskFrame> framesEachStep(std::span<const PathPiece> path) {
    double total = 0;
    for (const PathPiece& piece : path) {
        total += glm::length(piece.to.origin - piece.from.origin);
    }
    if (!(total <= kMostFrames)) {
        throw Error("a path of {:.0f} steps is too long for raw energy; {} is the most", total, kMostFrames);
    }
    std::vector<MaskFrame> frames;
    double next = 0; // from the start of the piece to the next frame
    for (const PathPiece& piece : path) {
        const double length = glm::length(piece.to.origin - piece.from.origin);
        for (; length > 0 && next <= length + 1e-9; next += 1) {
            const double t = next / length;
            const glm::dvec3 x = glm::normalize(glm::mix(piece.from.x, piece.to.x, t));
            const glm::dvec3 y = glm::mix(piece.from.y, piece.to.y, t);
            frames.push_back(
                {glm::mix(piece.from.origin, piece.to.origin, t), x, glm::normalize(y - x * glm::dot(x, y))});
        }
        next -= length;
    }
    return frames;
}

Box3 radiateRaw(Radiator& radiator, const MaskRaster& mask, std::span<const MaskFrame> frames,
                glm::ivec3 dims, const Footprint& footprint, const glm::dvec3& voxelFromSteps) {
    return radiateRaw(radiator, mask, frames, dims, {glm::ivec3(0), dims}, footprint, voxelFromSteps);
}

Box3 radiateRaw(Radiator& radiator, const MaskRaster& mask, std::span<const MaskFrame> frames,
                glm::ivec3 dims, const Box3& within, const Footprint& footprint,
                const glm::dvec3& voxelFromSteps) {
    radiator.begin(rawPointBox(mask, frames, voxelFromSteps), within, footprint);
    const SweepGrid grid = sweepGrid(dims, footprint, voxelFromSteps);
    std::vector<glm::vec4> points;
    gl::Buffer buffer(4, "raw points");
    const auto flush = [&] {
        if (!points.empty()) {
            buffer.reserve(points.size() * sizeof(glm::vec4));
            buffer.write(std::span<const glm::vec4>(points));
            radiator.deposit(buffer, points.size());
            points.clear();
        }
    };
    const Box3 near = reachOf(within, footprint);
    for (const MaskFrame& frame : frames) {
        if (intersect(rawPointBox(mask, std::span(&frame, 1), voxelFromSteps), near).isEmpty()) {
            continue;
        }
        const MaskElements elements = elementsInto(grid, mask, {frame, frame});
        for (int j = elements.lo.y; j < elements.hi.y; ++j) {
            for (int i = elements.lo.x; i < elements.hi.x; ++i) {
                if (mask.at(i, j) > 0) {
                    const glm::dvec2 place = mask.origin + mask.pitch * glm::dvec2(i, j);
                    points.emplace_back(glm::vec3(voxelFromSteps * frame.place(place)),
                                        kRawStrength * mask.at(i, j));
                }
                if (points.size() == Radiator::kMaxPoints) {
                    flush();
                }
            }
        }
    }
    flush();
    return radiator.finish();
}

} // namespace vs::sculpt
