// Where tools may work (sculpt::Limits). LIMITED: not everywhere. LIMITS_COARSER: the memberships' grid is
// coarser than the sculpture's.

#include "sculpt/shaders/bindings.glsl"
#ifdef LIMITED
layout(binding = kLimitsTexture) uniform sampler3D memberships; // r what is spared, g what alone is taken
uniform int takesOnly;
#ifdef LIMITS_COARSER
uniform vec3 limitsScale;  // place among the memberships = voxel * this
uniform vec3 limitsOffset; // + this
vec2 membershipsOf(ivec3 voxel) {
    vec3 place = vec3(voxel) * limitsScale + limitsOffset;
    return textureLod(memberships, (place + 0.5) / vec3(textureSize(memberships, 0)), 0.0).rg;
}
#else
vec2 membershipsOf(ivec3 voxel) { return texelFetch(memberships, voxel, 0).rg; }
#endif

// The greatest energy that a voxel may get: nothing inside what is spared, all inside what alone is taken,
// a half at their surfaces.
float mostEnergy(ivec3 voxel) {
    vec2 membership = membershipsOf(voxel);
    return min(1.0 - membership.r, takesOnly != 0 ? membership.g : 1.0);
}
#else
float mostEnergy(ivec3 voxel) { return 1.0; }
#endif
