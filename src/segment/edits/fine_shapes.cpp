// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/fine_shapes.h"

#include "base/error.h"
#include "base/progress.h"
#include "segment/edits/margins.h"
#include "segment/edits/nearby.h"
#include "segment/edits/smoothing.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace vs::segment {

namespace {

constexpr int kLeastSide = 64; // voxels of a piece along each axis, without what lies around it
constexpr int kUsualSide = 128;
constexpr int kMostSide = 320; // with it

// Pieces are cubes of that side; the one that a voxel lies in.
struct Piece {
    glm::ivec3 at{0};
    bool operator<(const Piece& other) const {
        return std::tie(at.z, at.y, at.x) < std::tie(other.at.z, other.at.y, other.at.x);
    }
};

// The side of pieces around which `halo` voxels are looked at.
int sideFor(glm::ivec3 halo, double mm) {
    const int most = std::max({halo.x, halo.y, halo.z});
    const int side =
        std::min(std::max(kUsualSide, 2 * most), kMostSide - 2 * most) / field::kBrick * field::kBrick;
    if (side < kLeastSide) {
        throw Error(
            "{:g} mm are too far for an edit at the finest level of this volume: {} voxels of it have to be "
            "looked at around each, and {} at the most can be; work on a coarser level alone (--level N "
            "--storage "
            "dense)",
            std::abs(mm), most, (kMostSide - kLeastSide) / 2);
    }
    return side;
}

// The pieces that have a voxel within `reach` of the set's bricks.
std::set<Piece> piecesAround(const FineSet& set, glm::ivec3 reach, int side) {
    std::set<Piece> pieces;
    for (const auto& [brick, bits] : set.bricks()) {
        const Box3 own = set.boxOf(brick);
        const Box3 around = intersect(Box3{own.lo - reach, own.hi + reach}, Box3{glm::ivec3(0), set.dims()});
        forEachVoxel(Box3{around.lo / side, divideUp(around.hi, side)},
                     [&](glm::ivec3 at, std::size_t) { pieces.insert({at}); });
    }
    return pieces;
}

// What edit(mask) makes of a set: of a voxel it depends on those within `halo` alone, and it adds none beyond
// `reach`.
template <typename Edit>
FineSet inPieces(const FineSet& set, glm::ivec3 halo, glm::ivec3 reach, double mm, Edit edit) {
    const int side = sideFor(halo, mm);
    const std::set<Piece> pieces = piecesAround(set, reach, side);
    FineSet result(set.dims());
    std::size_t done = 0;
    for (const Piece& piece : pieces) {
        reportProgress(double(done++) / double(pieces.size()));
        const Box3 own = intersect(Box3{piece.at * side, (piece.at + 1) * side}, {glm::ivec3(0), set.dims()});
        const Box3 around{own.lo - halo, own.hi + halo};
        const VoxelSet edited = edit(VoxelSet{around, set.within(around)});
        result.add(intersect(own, edited.box), edited.box, edited.inside);
    }
    return result;
}

// How far a distance reaches, and the layer beyond in which what is outside begins.
glm::ivec3 haloOf(const volume::GridGeometry& geometry, double mm) {
    return reachOf(geometry, std::abs(mm)) + 1;
}

} // namespace

FineSet changeMargin(const FineSet& set, const volume::GridGeometry& geometry, double mm) {
    checkDistance(geometry, std::abs(mm));
    const glm::ivec3 halo = haloOf(geometry, mm);
    return inPieces(set, halo, mm > 0 ? halo : glm::ivec3(0), mm,
                    [&](const VoxelSet& piece) { return changeMargin(piece, geometry, mm); });
}

FineSet opening(const FineSet& set, const volume::GridGeometry& geometry, double mm) {
    checkDistance(geometry, mm);
    return inPieces(set, 2 * haloOf(geometry, mm), glm::ivec3(0), mm,
                    [&](const VoxelSet& piece) { return opening(piece, geometry, mm); });
}

FineSet closing(const FineSet& set, const volume::GridGeometry& geometry, double mm) {
    checkDistance(geometry, mm);
    const glm::ivec3 halo = haloOf(geometry, mm);
    return inPieces(set, 2 * halo, halo, mm,
                    [&](const VoxelSet& piece) { return closing(piece, geometry, mm); });
}

FineSet hollow(const FineSet& set, const volume::GridGeometry& geometry, double thicknessMm) {
    checkDistance(geometry, thicknessMm);
    return subtract(set, changeMargin(set, geometry, -thicknessMm));
}

FineSet smooth(const FineSet& set, const volume::GridGeometry& geometry, double mm) {
    checkSmoothing(geometry, mm);
    const glm::ivec3 reach = smoothingReach(geometry, mm);
    return inPieces(set, 2 * reach + 1, reach, mm,
                    [&](const VoxelSet& piece) { return smooth(piece, geometry, mm); });
}

} // namespace vs::segment
