// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/layered_cut.h"

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

constexpr int kUnitLayers = 32;   // so many of one step each, then
constexpr int kOctaveLayers = 16; // so many until the depth has doubled
constexpr float kFirstRoom = 24;  // steps for which there is room from the beginning

SweptPatches inPieces(std::span<const field::SurfacePoint> surface, const MaskRaster& mask,
                      const volume::GridGeometry& geometry, ToolSweep sweep) {
    sweep.inPieces = true;
    sweep.depthSteps = 1;
    return sweepSurface(surface, mask, geometry, sweep);
}

} // namespace

LayeredCut::LayeredCut(std::span<const field::SurfacePoint> surface, const MaskRaster& mask,
                       const ToolSweep& sweep, const volume::GridGeometry& geometry,
                       const gl::Texture* before)
    : swept_(inPieces(surface, mask, geometry, sweep)), dims_(geometry.dims),
      footprint_(fitFootprint(sweep.radius, geometry.spacing())), outside_(-swept_.depthLo()),
      before_(before), state_(stateAt(0)) {}

// Where a whole layer begins, in steps: the first outside the surface, the second on it.
float LayeredCut::edge(int layer) const {
    if (layer <= kUnitLayers + 1) {
        return layer == 0 ? -outside_ : float(layer - 1);
    }
    const int beyond = layer - 1 - kUnitLayers;
    const float octave = std::ldexp(float(kUnitLayers), beyond / kOctaveLayers);
    return octave * (1 + float(beyond % kOctaveLayers) / kOctaveLayers);
}

LayeredCut::State LayeredCut::stateAt(double depthSteps) const {
    State state;
    if (depthSteps > 0) {
        const auto depth = float(std::min(depthSteps, 1e7));
        while (edge(state.layers + 1) <= depth) {
            ++state.layers;
        }
        state.partial = {edge(state.layers), depth};
    } else {
        state.partial = {edge(0), edge(0)};
    }
    return state;
}

Box3 LayeredCut::cutTo(double depthSteps, Radiator& radiator, PointGenerator& generator, Sculpture& sculpture,
                       BrickBackup* backup) {
    pointsMoved_ = 0;
    const State wanted = stateAt(depthSteps);
    if (wanted == state_) {
        return {};
    }
    makeRoom(wanted.partial.hi, radiator, generator);
    put(state_.partial, true, radiator, generator);
    while (state_.layers > wanted.layers) {
        --state_.layers;
        put({edge(state_.layers), edge(state_.layers + 1)}, true, radiator, generator);
    }
    for (; state_.layers < wanted.layers; ++state_.layers) {
        put({edge(state_.layers), edge(state_.layers + 1)}, false, radiator, generator);
    }
    put(wanted.partial, false, radiator, generator);
    state_ = wanted;
    const Box3 touched = radiator.finish();
    if (backup != nullptr) {
        backup->protect(touched);
    }
    return sculpture.combineWith(before_, radiator);
}

Box3 LayeredCut::cutAtOnce(double depthSteps, Radiator& radiator, PointGenerator& generator,
                           CutTarget& target) {
    const State wanted = stateAt(depthSteps);
    if (wanted == stateAt(0)) {
        return {};
    }
    const Box3 points = grow(swept_.hullBox(edge(0), wanted.partial.hi), 1);
    return target.cutIn(reachOf(points, footprint_), [&](const CutTarget::Part& part) {
        radiator.beginRunning(points, part.within, footprint_);
        const Box3 near = reachOf(part.within, footprint_);
        for (int layer = 0; layer <= wanted.layers; ++layer) {
            const Piece piece = layer < wanted.layers ? Piece{edge(layer), edge(layer + 1)} : wanted.partial;
            if (piece.lo < piece.hi && !isBeyondAll(piece)) {
                swept_.sweepPiece(piece.lo, piece.hi);
                emptyFrom_ = swept_.patches().empty() ? std::min(emptyFrom_, piece.lo) : emptyFrom_;
                generator.generateIn(near, swept_, [&](const gl::Buffer& made, std::size_t count) {
                    radiator.deposit(made, count);
                });
            }
        }
        const Box3 touched = radiator.finish();
        if (part.backup != nullptr) {
            part.backup->protect(touched);
        }
        return part.sculpture->combine(radiator, Combine::Cut);
    });
}

// The radiation keeps its deposits in a box of fixed size, which has room for a certain depth. For more it
// begins again with twice the depth, and what was there is deposited again.
void LayeredCut::makeRoom(float depth, Radiator& radiator, PointGenerator& generator) {
    if (depth <= roomDepth_) {
        return;
    }
    roomDepth_ = std::max(2 * depth, kFirstRoom);
    if (roomDepth_ > kFirstRoom) {
        swept_.sweepPiece(edge(0), roomDepth_);
        room_ = unite(room_, grow(swept_.pointBox(), 1));
    } else {
        room_ = grow(swept_.hullBox(edge(0), roomDepth_), 1);
    }
    radiator.beginRunning(room_, {glm::ivec3(0), dims_}, footprint_);
    for (int layer = 0; layer < state_.layers; ++layer) {
        put({edge(layer), edge(layer + 1)}, false, radiator, generator);
    }
    put(state_.partial, false, radiator, generator);
}

void LayeredCut::put(const Piece& piece, bool takesBack, Radiator& radiator, PointGenerator& generator) {
    if (!(piece.lo < piece.hi) || isBeyondAll(piece)) {
        return;
    }
    swept_.sweepPiece(piece.lo, piece.hi);
    if (swept_.patches().empty()) { // paths have ended or left the grid, and do not come back
        emptyFrom_ = std::min(emptyFrom_, piece.lo);
        return;
    }
    pointsMoved_ += swept_.pointCount();
    generator.generate(swept_, [&](const gl::Buffer& points, std::size_t count) {
        takesBack ? radiator.takeBack(points, count) : radiator.deposit(points, count);
    });
}

} // namespace vs::sculpt
