// Growth keeps one bit a voxel beside the seed map: a word holds a block of 4 x 4 x 2 voxels, bit x + 4 y + 16 z.
// A brick of 32^3 voxels is 8 x 8 x 16 words.

const ivec3 kWordSize = ivec3(4, 4, 2);
const ivec3 kWordsPerBrick = ivec3(8, 8, 16);
const uint kGroupSize = 64u;
const uint kMaxGroups = 65535u; // per dispatch; the lists are walked with a stride, so fewer groups lose nothing

ivec3 voxelInWord(int bit) { return ivec3(bit & 3, (bit >> 2) & 3, bit >> 4); }

ivec3 wordDimsFor(ivec3 voxels) { return (voxels + kWordSize - 1) / kWordSize; }

uint wordIndex(ivec3 word, ivec3 wordDims) {
    return (uint(word.z) * uint(wordDims.y) + uint(word.y)) * uint(wordDims.x) + uint(word.x);
}

// The lists hold a word's place in one number, since taking an index apart needs divisions: 10, 10 and 12 bits.
uint packWord(ivec3 word) { return uint(word.x) | uint(word.y) << 10 | uint(word.z) << 20; }
ivec3 unpackWord(uint place) { return ivec3(place & 1023u, place >> 10 & 1023u, place >> 20); }

// Coordinates of the element with an index in a grid of this size, x fastest.
ivec3 placeIn(uint index, ivec3 size) {
    uvec3 s = uvec3(size);
    return ivec3(index % s.x, index / s.x % s.y, index / (s.x * s.y));
}

// One expansion's work lists: arguments of the indirect dispatches, whose w counts the entries.
struct Step {
    uvec4 parents;     // x groups, y = z = 1, w words that hold voxels of the newest generation
    uvec4 candidates; // likewise, words that were offered voxels
    uvec4 grown;      // x voxels grown
};
