// First half of an expansion: each parent word offers the neighbours of its frontier voxels to the words they lie in.
// Voxels already decided on (grown, or refused under these rules) are not offered.
// In: storage 0 decided, 3 parent words. In and out: 1 frontier (taken: left zero), 2 offers (bits are added), 5 steps.
// Out: 4 candidate words. With VS_NEIGHBOURS_26, edges and corners count as neighbours too.
#include "segment/shaders/words.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Decided { uint decided[]; };
layout(std430, binding = 1) buffer Frontier { uint frontier[]; };
layout(std430, binding = 2) buffer Offers { uint offers[]; };
layout(std430, binding = 3) readonly buffer Parents { uint parents[]; };
layout(std430, binding = 4) writeonly buffer Candidates { uint candidates[]; };
layout(std430, binding = 5) buffer Steps { Step steps[]; };

layout(location = 0) uniform int stepIndex;
layout(location = 1) uniform ivec3 wordDims;

// Bits that move within the word, and those that cross into the next or the previous word, along each axis.
uint stayX(uint b) { return ((b & 0x77777777u) << 1) | ((b & 0xeeeeeeeeu) >> 1); }
uint stayY(uint b) { return ((b & 0x0fff0fffu) << 4) | ((b & 0xfff0fff0u) >> 4); }
uint stayZ(uint b) { return (b << 16) | (b >> 16); }
uint crossX(uint b, int to) { return to > 0 ? (b & 0x88888888u) >> 3 : (b & 0x11111111u) << 3; }
uint crossY(uint b, int to) { return to > 0 ? (b & 0xf000f000u) >> 12 : (b & 0x000f000fu) << 12; }
uint crossZ(uint b, int to) { return to > 0 ? b >> 16 : b << 16; }

// Offset to one of the 27 words around and including a word.
ivec3 placeIn27(int neighbour) { return ivec3(neighbour % 3, neighbour / 3 % 3, neighbour / 9) - 1; }

// Offers bits to a word; true if it is a new candidate. Loops of one turn stand for ifs here: software renderers run both
// sides of an if, but leave a loop that no invocation needs, and most offers come to nothing.
bool offer(ivec3 word, uint bits) {
    bool isNew = false;
    for (bool isInside = bits != 0u && all(lessThan(uvec3(word), uvec3(wordDims))); isInside; isInside = false) {
        uint index = wordIndex(word, wordDims);
        for (bits &= ~decided[index]; bits != 0u; bits = 0u) {
            isNew = atomicOr(offers[index], bits) == 0u;
        }
    }
    return isNew;
}

// Each bit of the result is a neighbour (x + 3 y + 9 z, 13 the word itself) that is a new candidate.
uint spread(ivec3 word, uint bits) {
    uint fresh = 0u;
#ifdef VS_NEIGHBOURS_26
    for (int dz = -1; dz <= 1; ++dz) {
        uint alongZ = dz == 0 ? bits | stayZ(bits) : crossZ(bits, dz);
        for (int dy = -1; dy <= 1; ++dy) {
            uint alongY = dy == 0 ? alongZ | stayY(alongZ) : crossY(alongZ, dy);
            for (int dx = -1; dx <= 1; ++dx) {
                uint alongX = dx == 0 ? alongY | stayX(alongY) : crossX(alongY, dx);
                fresh |= uint(offer(word + ivec3(dx, dy, dz), alongX)) << (13 + dx + 3 * dy + 9 * dz);
            }
        }
    }
#else
    fresh |= uint(offer(word, stayX(bits) | stayY(bits) | stayZ(bits))) << 13;
    for (int to = -1; to <= 1; to += 2) {
        fresh |= uint(offer(word + ivec3(to, 0, 0), crossX(bits, to))) << (13 + to);
        fresh |= uint(offer(word + ivec3(0, to, 0), crossY(bits, to))) << (13 + 3 * to);
        fresh |= uint(offer(word + ivec3(0, 0, to), crossZ(bits, to))) << (13 + 9 * to);
    }
#endif
    return fresh;
}

void main() {
    uint count = steps[stepIndex].parents.w;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += gl_NumWorkGroups.x * kGroupSize) {
        ivec3 word = unpackWord(parents[i]);
        uint index = wordIndex(word, wordDims);
        uint bits = frontier[index];
        frontier[index] = 0u;
        uint fresh = spread(word, bits);
        if (fresh == 0u) {
            continue;
        }
        uint place = atomicAdd(steps[stepIndex].candidates.w, uint(bitCount(fresh)));
        for (; fresh != 0u; fresh &= fresh - 1u, ++place) {
            candidates[place] = packWord(word + placeIn27(findLSB(fresh)));
            if (place % kGroupSize == 0u) {
                atomicMax(steps[stepIndex].candidates.x, min(place / kGroupSize + 1u, kMaxGroups));
            }
        }
    }
}
