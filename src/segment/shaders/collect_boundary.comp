// After the rules have changed, or the newest generations were erased: what grows next grows from voxels that have a neighbour
// which has not grown. Takes those of the segment at work, other than frozen ones, as the newest, and forgets what was refused.
// In: texture 3 labels; storage 0 grown, 3 and 4 generations, 7 brick numbers. Out: storage 2 newest, 5 steps[0], 6 work.
// One row of 16 groups a brick, an invocation a word.
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/owners.glsl"
#include "segment/shaders/active_tiles.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Grown { uint grown[]; };
layout(std430, binding = 2) writeonly buffer Newest { uint newest[]; };
layout(std430, binding = 7) readonly buffer Bricks { uint bricks[]; };

layout(location = 9) uniform int firstBrick;
layout(location = 10) uniform uint newestAt;
layout(location = 11) uniform uint frozen; // generations up to this one do not grow any more

uint bitsOf(uint word) { return ~grown[word]; }
#include "segment/shaders/neighbours.glsl"

void main() {
    uint word = bricks[uint(firstBrick) + gl_WorkGroupID.y] * kWordsPerBrick + gl_GlobalInvocationID.x;
    uint from = 0u;
    for (uint left = grown[word]; left != 0u; left = 0u) {
        ivec3 place = placeOfWord(word);
        left &= nextTo(place);
        for (left = ownVoxels(place, left); left != 0u; left = 0u) {
            from = frozen == 0u ? left : laterThan(word, left, frozen);
        }
        for (left = from; left != 0u; left = 0u) {
            newest[newestAt + word] = from;
            activateAround(placeOfTile(word / kWordsPerTile), tilesTouched(sidesOf(from, word)));
        }
    }
}
