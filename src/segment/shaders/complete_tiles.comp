// Completes tiles of one segment alone (segment::ApartTiles): all their texels but the segment's own voxels
// beside others'. From the next tiles where those have such; else from what all segments have together, or
// nothing. One group a tile. In: storage 0 tiles; textures 1 all segments, 4 the segment's pages. In and out:
// image 0 tiles of segments alone.
layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kTilesStorage) readonly buffer Tiles { uint tiles[]; };
layout(binding = kSegmentationTexture) uniform sampler3D allSegments;
layout(binding = kPagesTexture) uniform usampler3D pages;
layout(r8, binding = kSegmentationImage) uniform image3D apartTiles;
#include "segment/shaders/apart_places.glsl"

uniform ivec3 tileDims;
uniform int firstTile;
uniform int channel;

void main() {
    uint index = tiles[uint(firstTile) + gl_WorkGroupID.y];
    uvec3 size = uvec3(tileDims);
    ivec3 tile = ivec3(index % size.x, index / size.x % size.y, index / (size.x * size.y));
    ivec3 place = placeOf(texelFetch(pages, tile, 0).r);
    const int texels = kApartPadded * kApartPadded * kApartPadded;
    for (int i = int(gl_LocalInvocationIndex); i < texels; i += 64) {
        ivec3 local =
            ivec3(i % kApartPadded, i / kApartPadded % kApartPadded, i / (kApartPadded * kApartPadded));
        ivec3 from = min(tile + local / kApartTile, tileDims - 1);
        uint page = texelFetch(pages, from, 0).r;
        int whose = int(page) & kPageWhose;
        if (whose == kBesideOthers && from == tile) {
            continue;
        }
        ivec3 voxel = kApartTile * tile + local;
        vec2 together = texelFetch(allSegments, min(voxel, textureSize(allSegments, 0) - 1), 0).rg;
        float value = 0.0;
        if (whose == kBesideOthers) {
            value = imageLoad(apartTiles, placeOf(page) + voxel % kApartTile).r;
        } else if (whose == kSharedWithNone) {
            value = channel == 0 ? together.r : together.g;
        }
        imageStore(apartTiles, place + local, vec4(value));
    }
}
