// The segmentation volume as it is written: opaque segments in r, with VS_GLASS translucent ones in g. With
// VS_APART instead what tells each segment alone, as one byte: twice what the voxel's own segment has in it
// beyond 128 of 255, plus 1 where that does not tell what others have; in voxels that are nobody's, 1 where
// several segments have something.

#include "segment/shaders/bindings.glsl"
#ifdef VS_APART
layout(r8, binding = kSegmentationImage) uniform writeonly image3D segmentation;

// `share` is 128 to 255; isUnsure: what others have there cannot be told from it.
void storeShare(ivec3 voxel, float share, bool isUnsure) {
    imageStore(segmentation, voxel, vec4((2.0 * (share - 128.0) + (isUnsure ? 1.0 : 0.0)) / 255.0));
}

void storeMembership(ivec3 voxel, float value) {
    if (value >= 0.5) {
        storeShare(voxel, 255.0, false);
    }
}
#elif defined(VS_GLASS)
layout(rg8, binding = kSegmentationImage) uniform image3D segmentation;
uniform int channel;

void storeMembership(ivec3 voxel, float value) {
    vec2 both = imageLoad(segmentation, voxel).rg;
    imageStore(segmentation, voxel,
               channel == 0 ? vec4(value, both.g, 0.0, 0.0) : vec4(both.r, value, 0.0, 0.0));
}
#else
layout(r8, binding = kSegmentationImage) uniform writeonly image3D segmentation;

void storeMembership(ivec3 voxel, float value) { imageStore(segmentation, voxel, vec4(value)); }
#endif
