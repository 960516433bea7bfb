// Which voxels are shown: those of visible segments, and of the segment at work those up to the playhead.
// In: texture 3 labels; storage 0 grown, 1 a number for each label, 3 and 4 generations, 7 brick numbers. In
// and out: storage 2 the plane of those labels that have the wanted number; 5 which tiles changes reach
// (note_changes.glsl). With VS_OTHERS there are other segments, with VS_HIDES generations after the playhead;
// with VS_OWNERS a voxel that goes from one segment to another has changed too: storage 6 has a number for
// each word that tells so. One row of 16 groups a brick, an invocation a word.
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/owners.glsl"
#include "segment/shaders/note_changes.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGrownStorage) readonly buffer Grown { uint grown[]; };
layout(std430, binding = kKindsStorage) readonly buffer Kinds { uint kinds[]; };
layout(std430, binding = kShownBitsStorage) buffer Shown { uint shown[]; };
layout(std430, binding = kBricksStorage) readonly buffer Bricks { uint bricks[]; };
#ifdef VS_OWNERS
layout(std430, binding = kOwnersStorage) buffer Owners { uint ownersOfWords[]; };
#endif

uniform uint playhead;
uniform uint wanted; // the number that makes a label's voxels appear in this plane

uint visibleIn(uint word) {
    uint bits = grown[word];
#ifdef VS_OTHERS
    ivec3 place = placeOfWord(word);
    uint own = ownVoxels(place, bits);
    uint visible = 0u;
    for (; bits != 0u; bits &= bits - 1u) {
        int bit = findLSB(bits);
        visible |= uint(kinds[ownerOf(voxelAt(place, bit))] == wanted) << bit;
    }
#else
    uint own = bits;
    uint visible = kinds[activeLabel] == wanted ? bits : 0u;
#endif
#ifdef VS_HIDES
    visible &= ~laterThan(word, own, playhead);
#endif
    return visible;
}

#ifdef VS_OWNERS
// Another number when other segments have the visible voxels of a word; 0 when none is visible.
uint ownersIn(uint word, uint visible) {
    ivec3 place = placeOfWord(word);
    uint number = 0u;
    for (uint bits = visible; bits != 0u; bits &= bits - 1u) {
        int bit = findLSB(bits);
        number = (number ^ (ownerOf(voxelAt(place, bit)) << 8 | uint(bit))) * 16777619u; // as FNV-1a does
    }
    return number;
}
#endif

void main() {
    uint word = bricks[uint(firstBrick) + gl_WorkGroupID.y] * kWordsPerBrick + gl_GlobalInvocationID.x;
    uint visible = visibleIn(word);
    uint changed = visible ^ shown[word];
#ifdef VS_OWNERS
    uint owners = ownersIn(word, visible);
    changed |= owners != ownersOfWords[word] ? visible : 0u;
    ownersOfWords[word] = owners;
#endif
    noteChanges(word, changed);
    shown[word] = visible;
}
