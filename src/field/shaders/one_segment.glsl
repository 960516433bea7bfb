// How much a place belongs to one segment alone, where others may touch it (PULLED with APART): what it would
// be if the others were hidden. Where no other is near, that is what all have together; where others are,
// tiles of its own have it (segment::ApartTiles). Included by scene.glsl.
//
// Bindings: textures 7 tiles, 15 a page for each tile of 16^3 voxels.
#include "field/shaders/apart_tiles.glsl"

layout(binding = kApartTilesTexture) uniform sampler3D apartTiles;
layout(binding = kApartPagesTexture) uniform usampler3D apartPages;

float ownMembershipAt(vec3 p) {
    vec3 inside = clamp(abs(p + 0.5) - 0.5, vec3(0.0), vec3(dims.xyz - 1)); // mirrored, as textures are
    ivec3 tile = ivec3(inside) / kApartTile;
    uint page = texelFetch(apartPages, tile, 0).r;
    uvec3 place =
        uvec3(page >> kPagePlaceShift, page >> (kPagePlaceShift + 8), page >> (kPagePlaceShift + 16)) & 255u;
    vec3 texel = vec3(kApartPadded * ivec3(place) - kApartTile * tile) + inside + 0.5;
    float stored = textureLod(apartTiles, texel / vec3(textureSize(apartTiles, 0)), 0.0).r;
    vec2 together = textureLod(segmentationTexture, textureFromVoxel(p), 0.0).rg;
    float ofKind = pulled.y == 0 ? together.r : together.g;
    bool isStored = (page & uint(kPageIsStored)) != 0u;
    return isStored ? stored : (page & uint(kPageIsShared)) != 0u ? ofKind : 0.0;
}
