// Voxels next to the set bits of a plane, a slab of four words at a time. Include after words.glsl; the
// includer defines `uvec4 bitsOf(uint slab)`, which reads the plane. With VS_NEIGHBOURS_26, edges and corners
// count as neighbours too.

// The set bits and their neighbours along an axis, those in the slabs before and after it included.
uvec4 spreadX(uvec4 b, uvec4 before, uvec4 after) {
    uvec4 lower = uvec4(before.y, b.x, before.w, b.z);
    uvec4 upper = uvec4(b.y, after.x, b.w, after.z);
    return b | (b & 0x77777777u) << 1 | (b & 0xeeeeeeeeu) >> 1 | (lower & 0x88888888u) >> 3 |
           (upper & 0x11111111u) << 3;
}
uvec4 spreadY(uvec4 b, uvec4 before, uvec4 after) {
    uvec4 lower = uvec4(before.zw, b.xy);
    uvec4 upper = uvec4(b.zw, after.xy);
    return b | (b & 0x0fff0fffu) << 4 | (b & 0xfff0fff0u) >> 4 | (lower & 0xf000f000u) >> 12 |
           (upper & 0x000f000fu) << 12;
}
uvec4 spreadZ(uvec4 b, uvec4 before, uvec4 after) {
    return b | b << 16 | b >> 16 | before >> 16 | after << 16;
}

uvec4 bitsAt(ivec3 place) { return bitsOf(slabAt(place)); }

#ifdef VS_NEIGHBOURS_26
uvec4 nextInRow(ivec3 place) {
    return spreadX(bitsAt(place), bitsAt(place - ivec3(1, 0, 0)), bitsAt(place + ivec3(1, 0, 0)));
}

uvec4 nextInPlane(ivec3 place) {
    return spreadY(nextInRow(place), nextInRow(place - ivec3(0, 1, 0)), nextInRow(place + ivec3(0, 1, 0)));
}

uvec4 nextTo(ivec3 place) {
    return spreadZ(nextInPlane(place), nextInPlane(place - ivec3(0, 0, 1)),
                   nextInPlane(place + ivec3(0, 0, 1)));
}
#else
uvec4 nextTo(ivec3 place) {
    uvec4 b = bitsAt(place);
    return spreadX(b, bitsAt(place - ivec3(1, 0, 0)), bitsAt(place + ivec3(1, 0, 0))) |
           spreadY(b, bitsAt(place - ivec3(0, 1, 0)), bitsAt(place + ivec3(0, 1, 0))) |
           spreadZ(b, bitsAt(place - ivec3(0, 0, 1)), bitsAt(place + ivec3(0, 0, 1)));
}
#endif
