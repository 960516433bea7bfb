// One bit a voxel: what is visible and does not belong to a region (islands), and what does (kept). One
// invocation a word of 32 voxels along x. In: the scene, image 0 the region (0 = outside). Out: storage 0
// islands, 1 kept, 2 lowest and highest voxel of islands.
layout(local_size_x = 8, local_size_y = 8) in;

#include "gl/shaders/place.glsl"

#include "field/shaders/scene.glsl"

#include "sculpt/shaders/bindings.glsl"
layout(r8ui, binding = kRegionImage) uniform readonly uimage3D region;
layout(std430, binding = kIslandsStorage) writeonly buffer Islands { uint islands[]; };
layout(std430, binding = kKeptStorage) writeonly buffer Kept { uint kept[]; };
layout(std430, binding = kIslandBoundsStorage) buffer Bounds { int bounds[6]; };

uniform ivec3 words;

void main() {
    ivec3 word = placeOfInvocation();
    if (any(greaterThanEqual(word, words))) {
        return;
    }
    ivec3 voxel = ivec3(word.x * 32, word.yz);
    uint isIsland = 0u;
    uint isKept = 0u;
    for (int n = 0; n < 32 && voxel.x < dims.x; ++n) {
        bool belongs = imageLoad(region, voxel).r != 0u;
        bool isSeen = insideRange(voxelValue(voxel)) >= 0.0 &&
                      visibleSide(texelFetch(sculptureTexture, dims.w == 0 ? ivec3(0) : voxel, 0).r) >= 0.0;
        isKept |= uint(belongs) << n;
        isIsland |= uint(isSeen && !belongs) << n;
        ++voxel.x;
    }
    int place = (word.z * words.y + word.y) * words.x + word.x;
    islands[place] = isIsland;
    kept[place] = isKept;
    if (isIsland != 0u) {
        atomicMin(bounds[0], word.x * 32 + findLSB(isIsland));
        atomicMin(bounds[1], word.y);
        atomicMin(bounds[2], word.z);
        atomicMax(bounds[3], word.x * 32 + findMSB(isIsland));
        atomicMax(bounds[4], word.y);
        atomicMax(bounds[5], word.z);
    }
}
