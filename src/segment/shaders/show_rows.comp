// Which voxels are shown: those of visible segments, and of the segment at work those up to the playhead.
// In: texture 3 labels; storage 0 grown, 1 a number for each label, 3 and 4 generations, 7 brick numbers. Out: storage 2 the
// plane of those labels that have the wanted number.
// One row of 16 groups a brick, an invocation a word.
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/owners.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Grown { uint grown[]; };
layout(std430, binding = 1) readonly buffer Kinds { uint kinds[]; };
layout(std430, binding = 2) writeonly buffer Shown { uint shown[]; };
layout(std430, binding = 7) readonly buffer Bricks { uint bricks[]; };

layout(location = 9) uniform int firstBrick;
layout(location = 10) uniform uint playhead;
layout(location = 11) uniform int hidesSome; // 0: the playhead is at the end
layout(location = 12) uniform uint wanted;   // the number that makes a label's voxels appear in this plane

void main() {
    uint word = bricks[uint(firstBrick) + gl_WorkGroupID.y] * kWordsPerBrick + gl_GlobalInvocationID.x;
    uint bits = grown[word];
    uint visible = kinds[activeLabel] == wanted ? bits : 0u;
    for (uint left = hasOthers != 0 ? bits : 0u; left != 0u; left = 0u) {
        ivec3 place = placeOfWord(word);
        visible = 0u;
        for (uint some = bits; some != 0u; some &= some - 1u) {
            int bit = findLSB(some);
            visible |= uint(kinds[ownerOf(voxelAt(place, bit))] == wanted) << bit;
        }
    }
    for (uint left = hidesSome != 0 ? visible : 0u; left != 0u; left = 0u) {
        visible &= ~laterThan(word, ownVoxels(placeOfWord(word), visible), playhead);
    }
    shown[word] = visible;
}
