// Which segment a grown voxel belongs to. The label texture is written after growing, not while: a grown
// voxel without a label belongs to the segment at work. Include after words.glsl. Binding: texture 3.

#include "segment/shaders/bindings.glsl"
layout(binding = kLabelTexture) uniform usampler3D labelTexture;

uniform uint activeLabel;
uniform int hasOthers; // 0: there is no other segment

uint ownerOf(ivec3 voxel) {
    uint label = texelFetch(labelTexture, voxel, 0).r;
    return label == 0u ? activeLabel : label;
}

// Which of a word's grown voxels belong to the segment at work.
uint ownVoxels(ivec3 place, uint grownBits) {
    uint own = grownBits;
    for (uint left = hasOthers != 0 ? grownBits : 0u; left != 0u; left &= left - 1u) {
        int bit = findLSB(left);
        uint isForeign = uint(ownerOf(voxelAt(place, bit)) != activeLabel);
        own &= ~(isForeign << bit);
    }
    return own;
}
