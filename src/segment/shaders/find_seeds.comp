// Moves each surface point to the nearest admissible corner of its cell and keeps every voxel once, with a
// hash set. Spaces: points in voxel space; distances in world millimetres. In: texture 0 data, 1 sculpture;
// storage 0 surface points. In and out: storage 1 hash set of voxel indices + 1, zeros at first. Out: storage
// 2 count, then voxel indices in no particular order.
#include "segment/shaders/constraints.glsl"

layout(local_size_x = 64) in;

#include "gl/shaders/items.glsl"

struct SurfacePoint {
    vec4 voxel; // w 1 = hit
    vec4 normal;
};
#include "segment/shaders/bindings.glsl"
layout(std430, binding = kPointsStorage) readonly buffer Points { SurfacePoint points[]; };
layout(std430, binding = kTableStorage) buffer Table { uint table[]; };
layout(std430, binding = kFoundStorage) buffer Found {
    uint foundCount;
    uint found[];
};

uniform int count;
uniform uint tableMask;
uniform mat4 worldFromVoxel;

// Puts a voxel into the set; true for the invocation that put it there.
bool insert(uint voxel) {
    uint slot = (voxel * 2654435761u) >> 7; // Knuth's multiplicative hash
    for (uint probe = 0u; probe <= tableMask; ++probe, ++slot) {
        uint before = atomicCompSwap(table[slot & tableMask], 0u, voxel + 1u);
        if (before == 0u) {
            return true;
        }
        if (before == voxel + 1u) {
            return false;
        }
    }
    return false;
}

void main() {
    uint i = itemIndex();
    if (i >= uint(count) || points[i].voxel.w < 0.5) {
        return;
    }
    vec3 point = points[i].voxel.xyz;
    ivec3 cell = ivec3(floor(point));
    float nearest = 1e38;
    uint voxel = 0u;
    for (int corner = 0; corner < 8; ++corner) {
        ivec3 candidate = cell + ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
        vec3 apart = mat3(worldFromVoxel) * (vec3(candidate) - point);
        float squared = dot(apart, apart);
        if (squared < nearest && isInside(candidate) && isAdmissible(candidate)) {
            nearest = squared;
            voxel = indexOf(candidate);
        }
    }
    if (nearest < 1e38 && insert(voxel)) {
        found[atomicAdd(foundCount, 1u)] = voxel;
    }
}
