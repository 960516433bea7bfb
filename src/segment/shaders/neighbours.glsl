// Voxels next to the set bits of a plane, a word at a time. Include after words.glsl; the includer defines
// `uint bitsOf(uint word)`, which reads the plane. With VS_NEIGHBOURS_26, edges and corners count as neighbours too.

// Bits that move within a word along each axis, and those that come in from the words before and after it.
uint stayX(uint b) { return (b & 0x77777777u) << 1 | (b & 0xeeeeeeeeu) >> 1; }
uint stayY(uint b) { return (b & 0x0fff0fffu) << 4 | (b & 0xfff0fff0u) >> 4; }
uint stayZ(uint b) { return b << 16 | b >> 16; }
uint comeX(uint before, uint after) { return (before & 0x88888888u) >> 3 | (after & 0x11111111u) << 3; }
uint comeY(uint before, uint after) { return (before & 0xf000f000u) >> 12 | (after & 0x000f000fu) << 12; }
uint comeZ(uint before, uint after) { return before >> 16 | after << 16; }

#ifdef VS_NEIGHBOURS_26
uint alongX(ivec3 place) {
    uint b = bitsOf(wordAt(place));
    return b | stayX(b) | comeX(bitsOf(wordAt(place - ivec3(1, 0, 0))), bitsOf(wordAt(place + ivec3(1, 0, 0))));
}

uint alongXY(ivec3 place) {
    uint b = alongX(place);
    return b | stayY(b) | comeY(alongX(place - ivec3(0, 1, 0)), alongX(place + ivec3(0, 1, 0)));
}

uint nextTo(ivec3 place) {
    uint b = alongXY(place);
    return b | stayZ(b) | comeZ(alongXY(place - ivec3(0, 0, 1)), alongXY(place + ivec3(0, 0, 1)));
}
#else
uint nextTo(ivec3 place) {
    uint b = bitsOf(wordAt(place));
    return stayX(b) | stayY(b) | stayZ(b) |
           comeX(bitsOf(wordAt(place - ivec3(1, 0, 0))), bitsOf(wordAt(place + ivec3(1, 0, 0)))) |
           comeY(bitsOf(wordAt(place - ivec3(0, 1, 0))), bitsOf(wordAt(place + ivec3(0, 1, 0)))) |
           comeZ(bitsOf(wordAt(place - ivec3(0, 0, 1))), bitsOf(wordAt(place + ivec3(0, 0, 1))));
}
#endif
