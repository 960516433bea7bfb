// From the tiles that have deposits to the tiles that each pass of the convolution must compute: grown by one
// tile along x, then y, then z (the taps reach less than a tile). Of a running radiation only what this
// round's deposits reach. In: storage 0 one mark a tile: the last round with deposits there. Out: storage 1
// stages (bit 0 deposits, bits 1 to 3 computed by the pass along x, y, z, in this round or before, bit 4 a
// result of this round), storage 2 to 4 lists for those passes (see tiles.glsl), storage 5 lowest and highest
// tile of the last.
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

#include "gl/shaders/place.glsl"

#include "sculpt/shaders/bindings.glsl"
layout(std430, binding = kMarkedTilesStorage) readonly buffer Marks { uint marks[]; };
layout(std430, binding = kStagesStorage) writeonly buffer Stages { uint stages[]; };
layout(std430, binding = kListXStorage) buffer ListX { uint listX[]; };
layout(std430, binding = kListYStorage) buffer ListY { uint listY[]; };
layout(std430, binding = kListZStorage) buffer ListZ { uint listZ[]; };
layout(std430, binding = kTileBoundsStorage) buffer Bounds { int bounds[6]; };

uniform ivec3 tileDims;
uniform ivec3 insideLo; // tiles that reach into the grid: only those are results
uniform ivec3 insideHi;
uniform int round;

const uint tileListRow = 32768u; // work groups along x, as in tiles.glsl

const uint ever = 1u;
const uint now = 2u;

uint markAt(ivec3 tile) {
    bool inside = all(greaterThanEqual(tile, ivec3(0))) && all(lessThan(tile, tileDims));
    uint mark = inside ? marks[(tile.z * tileDims.y + tile.y) * tileDims.x + tile.x] : 0u;
    return (mark != 0u ? ever : 0u) | (mark == uint(round) ? now : 0u);
}

uint markAlongX(ivec3 tile) {
    return markAt(tile - ivec3(1, 0, 0)) | markAt(tile) | markAt(tile + ivec3(1, 0, 0));
}

uint markAlongXY(ivec3 tile) {
    return markAlongX(tile - ivec3(0, 1, 0)) | markAlongX(tile) | markAlongX(tile + ivec3(0, 1, 0));
}

void main() {
    ivec3 tile = placeOfInvocation();
    if (any(greaterThanEqual(tile, tileDims))) {
        return;
    }
    uint number = uint((tile.z * tileDims.y + tile.y) * tileDims.x + tile.x);
    uint alongX = markAlongX(tile);
    uint alongY = markAlongXY(tile);
    uint alongZ = markAlongXY(tile - ivec3(0, 0, 1)) | alongY | markAlongXY(tile + ivec3(0, 0, 1));
    bool isResult = all(greaterThanEqual(tile, insideLo)) && all(lessThan(tile, insideHi));
    // Tiles with deposits are always visited last, because that pass also clears the deposits.
    alongZ = isResult || markAt(tile) != 0u ? alongZ : 0u;
    stages[number] = (markAt(tile) & ever) | ((alongX & ever) << 1) | ((alongY & ever) << 2) |
                     (isResult ? (alongZ & ever) << 3 | (alongZ & now) << 3 : 0u);
    if ((alongX & now) != 0u) {
        uint slot = atomicAdd(listX[3], 1u);
        listX[4u + slot] = number;
        atomicMax(listX[0], min(slot + 1u, tileListRow));
        atomicMax(listX[1], slot / tileListRow + 1u);
    }
    if ((alongY & now) != 0u) {
        uint slot = atomicAdd(listY[3], 1u);
        listY[4u + slot] = number;
        atomicMax(listY[0], min(slot + 1u, tileListRow));
        atomicMax(listY[1], slot / tileListRow + 1u);
    }
    if ((alongZ & now) != 0u) {
        uint slot = atomicAdd(listZ[3], 1u);
        listZ[4u + slot] = number;
        atomicMax(listZ[0], min(slot + 1u, tileListRow));
        atomicMax(listZ[1], slot / tileListRow + 1u);
    }
    if ((alongZ & now) != 0u && isResult) {
        for (int axis = 0; axis < 3; ++axis) {
            atomicMin(bounds[axis], tile[axis]);
            atomicMax(bounds[3 + axis], tile[axis]);
        }
    }
}
