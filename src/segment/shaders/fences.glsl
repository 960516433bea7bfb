// Where the sculpture hides part of the grid. Spaces: voxel indices.
// Bindings: texture 1 the sculpture, 4 the ranges of its macrocells (rg).

#include "segment/shaders/bindings.glsl"
layout(binding = kSculptureTexture) uniform sampler3D sculptureTexture;
layout(binding = kSculptureCellsTexture) uniform sampler3D sculptureCells;

uniform int hides; // 0: nothing; 1: where the sculpture is >= 0.5; 2: where it is < 0.5

bool isHiding(float value) { return hides != 0 && (value >= 0.5) == (hides == 1); }

// Whether the viewer cannot see a voxel; outside the grid as at its border.
bool isHidden(ivec3 voxel) {
    ivec3 inside = clamp(voxel, ivec3(0), textureSize(sculptureTexture, 0) - 1);
    return isHiding(texelFetch(sculptureTexture, inside, 0).r);
}

// Whether some of the voxels of macrocells `first` to `last` are hidden and some are not. Looks at nothing if
// not `wanted`.
bool isFenceIn(ivec3 first, ivec3 last, bool wanted) {
    first = max(first, ivec3(0));
    last = min(last, textureSize(sculptureCells, 0) - 1);
    last.z = wanted && hides != 0 ? last.z : first.z - 1;
    vec2 range = vec2(1.0, 0.0);
    for (int z = first.z; z <= last.z && !(range.x < 0.5 && range.y >= 0.5); ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                vec2 cell = texelFetch(sculptureCells, ivec3(x, y, z), 0).rg;
                range = vec2(min(range.x, cell.x), max(range.y, cell.y));
            }
        }
    }
    return range.x < 0.5 && range.y >= 0.5;
}
