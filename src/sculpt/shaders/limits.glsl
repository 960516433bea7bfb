// Where tools may work (sculpt::Limits). LIMITED: not everywhere.

#include "sculpt/shaders/bindings.glsl"
#ifdef LIMITED
layout(binding = kLimitsTexture) uniform sampler3D memberships; // r what is spared, g what alone is taken
uniform int takesOnly;

// The greatest energy that a voxel of the sculpture may get: nothing inside what is spared, all inside what
// alone is taken, a half at their surfaces.
float mostEnergy(ivec3 voxel) {
    vec2 membership = texelFetch(memberships, voxel, 0).rg;
    return min(1.0 - membership.r, takesOnly != 0 ? membership.g : 1.0);
}
#else
float mostEnergy(ivec3 voxel) { return 1.0; }
#endif
