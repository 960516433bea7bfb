// The segmentation volume as it is written: opaque segments in r, with VS_GLASS translucent ones in g. With
// VS_APART instead the tiles of one segment alone (segment::ApartTiles); storage 6 has where each lies.
// Include "segment/shaders/tiles.glsl" first.

#include "segment/shaders/bindings.glsl"
#ifdef VS_APART
layout(r8, binding = kSegmentationImage) uniform writeonly image3D apartTiles;
layout(std430, binding = kPagesOfTilesStorage) readonly buffer PagesOfTiles { uint pagesOfTiles[]; };
#include "segment/shaders/apart_places.glsl"

void storeMembership(ivec3 voxel, float value) {
    uint page = pagesOfTiles[uint(firstTile) + gl_WorkGroupID.y];
    imageStore(apartTiles, placeOf(page) + voxel % kApartTile, vec4(value));
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
