// Cuts what lies outside (or inside) a convex solid.
// variants: MAX_PLANES=32 SCULPTURE_BITS=16;MAX_PLANES=32 SCULPTURE_BITS=16 LIMITED=1
// In/out: image 0 sculpture.
#include "sculpt/shaders/cut_solid.glsl"

uniform ivec2 kind;              // x number of planes, y 1: cuts the inside
uniform vec4 planes[MAX_PLANES]; // unit normal outwards, offset; world, mm

float energyAt(vec3 voxel) {
    vec3 world = (worldFromVoxel * vec4(voxel, 1.0)).xyz;
    float outside = -1e6;
    for (int n = 0; n < kind.x; ++n) {
        outside = max(outside, dot(planes[n].xyz, world) + planes[n].w);
    }
    return energyBehind(kind.y != 0 ? -outside : outside);
}

void main() {
    ivec3 voxel;
    if (!lineStart(voxel)) {
        return;
    }
    for (int n = 0; n < 8 && voxel.x < dims.x; ++n) {
        combineVoxel(voxel, energyAt(vec3(voxel)));
        ++voxel.x;
    }
}
