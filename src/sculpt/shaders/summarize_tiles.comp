// Smallest and largest value among the 5^3 corner voxels of each macrocell (4^3 voxels) that has a corner in
// one of the radiation's result tiles; the others keep theirs. In: texture 0 sculpture, storage 0 stages
// (list_tiles.comp). Out: image 0 (rg32f) one texel a cell.
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

#include "gl/shaders/place.glsl"

#include "sculpt/shaders/bindings.glsl"
layout(std430, binding = kSummaryStagesStorage) readonly buffer Stages { uint stages[]; };
layout(binding = kWholeSculptureTexture) uniform sampler3D sculpture;
layout(rg32f, binding = kSculptureCellsImage) uniform writeonly image3D cells;

uniform ivec3 dims;
uniform ivec3 cellLo;
uniform ivec3 cellHi;
uniform ivec3 originTile; // of stages
uniform ivec3 tileDims;

bool isResult(ivec3 tile) {
    bool inside = all(greaterThanEqual(tile, ivec3(0))) && all(lessThan(tile, tileDims));
    return inside && (stages[(tile.z * tileDims.y + tile.y) * tileDims.x + tile.x] & 16u) != 0u;
}

void main() {
    ivec3 cell = cellLo + placeOfInvocation();
    if (any(greaterThanEqual(cell, cellHi))) {
        return;
    }
    ivec3 first = cell * 4;
    ivec3 last = min(first + 4, dims - 1);
    ivec3 lowTile = (first >> 3) - originTile;
    ivec3 highTile = (last >> 3) - originTile;
    bool isNew = false;
    for (int z = lowTile.z; z <= highTile.z; ++z) {
        for (int y = lowTile.y; y <= highTile.y; ++y) {
            for (int x = lowTile.x; x <= highTile.x; ++x) {
                isNew = isNew || isResult(ivec3(x, y, z));
            }
        }
    }
    if (!isNew) {
        return;
    }
    float lo = 1e38;
    float hi = -1e38;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                float value = texelFetch(sculpture, ivec3(x, y, z), 0).r;
                lo = min(lo, value);
                hi = max(hi, value);
            }
        }
    }
    imageStore(cells, cell, vec4(lo, hi, 0.0, 0.0));
}
