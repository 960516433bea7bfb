// Generations of voxels, two to a number: their lower 16 bits, and with VS_WIDE, for runs longer than those
// can count, eight more bits in a buffer of their own, four voxels to a number. What has no generation reads
// 0. Include after words.glsl. Bindings: storage 3 and 4.

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGenerationsStorage) buffer Generations { uint generations[]; };
#ifdef VS_WIDE
layout(std430, binding = kLateGenerationsStorage) buffer LateGenerations { uint lateBits[]; };
#endif

// Gives the chosen voxels of a word this generation. The word must be the caller's own.
void storeGenerations(uint word, uint bits, uint generation) {
    uint both = (generation & 0xffffu) | generation << 16;
    uint first = word * 16u;
    for (uint left = bits; left != 0u;) {
        uint pair = uint(findLSB(left)) >> 1;
        uint mask = halves(left >> (2u * pair));
        generations[first + pair] = (generations[first + pair] & ~mask) | (both & mask);
        left &= ~(3u << (2u * pair));
    }
#ifdef VS_WIDE
    for (uint left = bits; left != 0u; left &= left - 1u) {
        uint bit = uint(findLSB(left));
        uint late = word * 8u + (bit >> 2);
        uint shift = 8u * (bit & 3u);
        lateBits[late] = (lateBits[late] & ~(0xffu << shift)) | (generation >> 16 & 0xffu) << shift;
    }
#endif
}

// The same for a slab, pair by pair of whichever word still has one. `before`: voxels that have the
// generation before this one; `older`: those that have any other. Memory is slow to answer, so it is asked
// only for what is not known.
void storeGenerationsOfSlab(uint slab, uvec4 bits, uvec4 before, uvec4 older, uint generation) {
#ifdef VS_WIDE
    for (uint i = 0u; i < 4u; ++i) {
        storeGenerations(4u * slab + i, bits[i], generation);
    }
#else
    uint now = (generation & 0xffffu) * 0x10001u;
    uint last = (generation - 1u & 0xffffu) * 0x10001u;
    if (bits != uvec4(0u)) {
        do {
            uint inPlane = bits.x | bits.y;
            uint i = inPlane != 0u ? uint(bits.x == 0u) : 2u + uint(bits.z == 0u);
            uint left = bits[i];
            uint pair = uint(findLSB(left)) >> 1;
            uint chosen = 3u << (2u * pair);
            uint at = slab * 64u + i * 16u + pair;
            uint value = (now & halves(left >> (2u * pair))) | (last & halves(before[i] >> (2u * pair)));
            if ((older[i] & chosen) != 0u) {
                value |= generations[at] & halves(older[i] >> (2u * pair));
            }
            generations[at] = value;
            bits[i] = left & ~chosen;
        } while (bits != uvec4(0u));
    }
#endif
}

uint generationIn(uint word, uint bit) {
    uint generation = generations[word * 16u + (bit >> 1)] >> (16u * (bit & 1u)) & 0xffffu;
#ifdef VS_WIDE
    generation |= (lateBits[word * 8u + (bit >> 2)] >> (8u * (bit & 3u)) & 0xffu) << 16;
#endif
    return generation;
}

// Which of the chosen voxels of a word have a generation above `last`.
uint laterThan(uint word, uint bits, uint last) {
    uint later = 0u;
#ifdef VS_WIDE
    for (uint left = bits; left != 0u; left &= left - 1u) {
        uint bit = uint(findLSB(left));
        later |= uint(generationIn(word, bit) > last) << bit;
    }
#else
    for (uint left = bits; left != 0u;) {
        uint pair = uint(findLSB(left)) >> 1;
        uint both = generations[word * 16u + pair];
        later |= (uint((both & 0xffffu) > last) | uint(both >> 16 > last) << 1) << (2u * pair);
        left &= ~(3u << (2u * pair));
    }
#endif
    return later & bits;
}
