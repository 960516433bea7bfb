// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/radiation/radiation.h"
#include "sculpt/radiation/tool_points.h"
#include "sculpt/sculpture/cut_target.h"
#include "sculpt/surface/tool_surface.h"

#include <vector>

namespace vs::sculpt {

// A sweep that is drawn deeper and back while its surface and mask stay: the peel. The depth is divided into
// fixed layers, each sampled on its own; whole layers stay deposited, the last, partial one is taken back and
// put anew. So a change of depth costs what lies between the depths, and whatever way led to a depth, the
// sculpture is the same to the last byte. Uses the radiator until it is done with or another use begins.
class LayeredCut {
public:
    // `surface` holds one point per element of `mask`; of `sweep` the depth does not count. `before` is the
    // sculpture as it was, and must stay so; null: nothing was cut.
    LayeredCut(std::span<const field::SurfacePoint> surface, const MaskRaster& mask, const ToolSweep& sweep,
               const volume::GridGeometry& geometry, const gl::Texture* before);

    // The sculpture becomes what it was before, cut to this depth in steps; 0 or less puts everything back.
    // Bricks are protected in `backup` (if any) before they change. Returns the box of voxels that may have
    // changed. Throws GlError when the device has no room.
    Box3 cutTo(double depthSteps, Radiator& radiator, PointGenerator& generator, Sculpture& sculpture,
               BrickBackup* backup);

    // Cuts that deep into what has not been cut by this before. The state stays that of no depth.
    Box3 cutAtOnce(double depthSteps, Radiator& radiator, PointGenerator& generator, CutTarget& target);

    // Points deposited and taken back by the last cutTo().
    [[nodiscard]] std::size_t pointsMoved() const { return pointsMoved_; }

private:
    struct Piece {
        float lo = 0;
        float hi = 0;
        bool operator==(const Piece&) const = default;
    };
    // The depth that the cut has: so many whole layers, then a partial one (none: hi == lo).
    struct State {
        int layers = 0;
        Piece partial;
        bool operator==(const State&) const = default;
    };
    [[nodiscard]] float edge(int layer) const;
    [[nodiscard]] State stateAt(double depthSteps) const;
    [[nodiscard]] bool isBeyondAll(const Piece& piece) const { return piece.lo >= emptyFrom_; }
    void makeRoom(float depth, Radiator& radiator, PointGenerator& generator);
    void put(const Piece& piece, bool takesBack, Radiator& radiator, PointGenerator& generator);

    SweptPatches swept_;
    glm::ivec3 dims_;
    Footprint footprint_;
    float outside_;
    const gl::Texture* before_;
    Box3 room_;           // of points, that the radiation has now
    float roomDepth_ = 0; // as deep as it reaches
    State state_;
    float emptyFrom_ = 1e30F; // no point lies deeper
    std::size_t pointsMoved_ = 0;
};

} // namespace vs::sculpt
