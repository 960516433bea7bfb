// Cuts islands (pack_islands.comp) and two voxels around each, but nothing within one voxel of what is kept.
// One invocation a word of 32 voxels along x.
// variants: SCULPTURE_BITS=16;SCULPTURE_BITS=16 LIMITED=1
// In: storage 0 islands, 1 kept. In/out: image 1 sculpture.
layout(local_size_x = 8, local_size_y = 8) in;

#include "gl/shaders/place.glsl"

#include "sculpt/shaders/stored_values.glsl"

#include "sculpt/shaders/bindings.glsl"
layout(SCULPTURE_FORMAT, binding = kSculptureImage) uniform image3D sculpture;
layout(std430, binding = kIslandsStorage) readonly buffer Islands { uint islands[]; };
layout(std430, binding = kKeptStorage) readonly buffer Kept { uint kept[]; };

uniform ivec3 words;
uniform ivec3 dims;

#include "sculpt/shaders/limits.glsl"

bool isInside(ivec3 word) { return all(greaterThanEqual(word, ivec3(0))) && all(lessThan(word, words)); }

int placeOf(ivec3 word) { return (word.z * words.y + word.y) * words.x + word.x; }

void main() {
    ivec3 word = placeOfInvocation();
    if (any(greaterThanEqual(word, words))) {
        return;
    }
    uvec3 near = uvec3(0u); // islands within two rows: the word before, this one, the one after
    uvec3 keep = uvec3(0u); // what is kept within one row, likewise
    for (int n = 0; n < 25; ++n) {
        ivec2 offset = ivec2(n % 5, n / 5) - 2;
        bool isClose = all(lessThanEqual(abs(offset), ivec2(1)));
        for (int side = -1; side <= 1; ++side) {
            ivec3 other = word + ivec3(side, offset);
            bool exists = isInside(other);
            int place = exists ? placeOf(other) : 0;
            near[side + 1] |= exists ? islands[place] : 0u;
            keep[side + 1] |= exists && isClose ? kept[place] : 0u;
        }
    }
    uint around = near.y | (near.y << 1) | (near.y << 2) | (near.y >> 1) | (near.y >> 2) | (near.x >> 31) |
                  (near.x >> 30) | (near.z << 31) | (near.z << 30);
    uint fence = keep.y | (keep.y << 1) | (keep.y >> 1) | (keep.x >> 31) | (keep.z << 31);
    uint gone = around & ~fence;
    ivec3 voxel = ivec3(word.x * 32, word.yz);
    for (int n = 0; n < 32 && voxel.x < dims.x && gone != 0u; ++n) {
        if (((gone >> n) & 1u) != 0u) {
#ifdef LIMITED
            float before = imageLoad(sculpture, voxel).r;
            imageStore(sculpture, voxel, vec4(asStored(max(before, mostEnergy(voxel)))));
#else
            imageStore(sculpture, voxel, vec4(1.0));
#endif
        }
        ++voxel.x;
    }
}
