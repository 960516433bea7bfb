// The segmentation volume as it is written: opaque segments in r, with VS_GLASS translucent ones in g.

#include "segment/shaders/bindings.glsl"
#ifdef VS_GLASS
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
