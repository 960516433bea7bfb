// Which voxels of a row count: those shown, with VS_APART those of one segment, and those without a label,
// which are what it is taken to be behind cuts when no other is shown. With VS_APART binding: texture 3
// labels.
#include "segment/shaders/bindings.glsl"

#ifdef VS_APART
layout(binding = kLabelTexture) uniform usampler3D labelTexture;

uniform uint ownLabel;

uint ownMembers(ivec3 first, uint members) {
    uint own = 0u;
    for (uint left = members; left != 0u; left &= left - 1u) {
        int x = findLSB(left);
        uint owner = texelFetch(labelTexture, first + ivec3(x, 0, 0), 0).r;
        own |= uint(owner == ownLabel || owner == 0u) << x;
    }
    return own;
}
#else
uint ownMembers(ivec3 first, uint members) { return members; }
#endif
