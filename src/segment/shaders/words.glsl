// How growth keeps its state: words of 4 x 4 x 2 voxels, one bit a voxel (bit x + 4 y + 16 z), or 16 numbers
// of two generations each. A tile of 8^3 voxels has 2 x 2 x 4 words, a brick of 32^3 voxels 4^3 tiles; words,
// tiles and bricks are numbered x fastest. Four words of a tile that share z are a slab of 8 x 8 x 2 voxels,
// whose components they are. After the last brick comes one of zeros, which stands for everything outside the
// grid. Spaces: voxel indices; places of words are voxel / (4, 4, 2), of slabs voxel / (8, 8, 2), of tiles
// voxel / 8.

const ivec3 kWordSize = ivec3(4, 4, 2);
const uint kWordsPerTile = 16u;
const uint kTilesPerBrick = 64u;
const uint kWordsPerBrick = 1024u;
const uint kSlabsPerTile = 4u;
const uint kSlabsPerBrick = 256u;

uniform ivec3 dims;
uniform ivec3 brickDims;

uint brickCount() { return uint(brickDims.x * brickDims.y * brickDims.z); }

// Coordinates of the element with an index in a grid of this size, x fastest.
ivec3 placeIn(uint index, ivec3 size) {
    uvec3 s = uvec3(size);
    return ivec3(index % s.x, index / s.x % s.y, index / (s.x * s.y));
}

// The number of the tile at a place; outside the grid, of the first one of zeros.
uint tileAt(ivec3 place) {
    uvec3 t = uvec3(place);
    uvec3 b = t >> 2;
    bool isInside = all(lessThan(t, uvec3(brickDims) * 4u));
    uint brick = (b.z * uint(brickDims.y) + b.y) * uint(brickDims.x) + b.x;
    return isInside ? brick << 6 | (t.z & 3u) << 4 | (t.y & 3u) << 2 | (t.x & 3u) : brickCount() << 6;
}

// The number of the word at a place; outside the grid, of one of zeros.
uint wordAt(ivec3 place) {
    uvec3 w = uvec3(place);
    return tileAt(ivec3(place.xy >> 1, place.z >> 2)) << 4 | (w.z & 3u) << 2 | (w.y & 1u) << 1 | (w.x & 1u);
}

// The number of the slab at a place; outside the grid, of one of zeros.
uint slabAt(ivec3 place) { return tileAt(ivec3(place.xy, place.z >> 2)) << 2 | uint(place.z) & 3u; }

// Divides as floats, which is exact for the numbers of bricks there can be (below 2^20), and not one by one
// on software renderers.
ivec3 placeOfBrick(uint brick) {
    vec3 size = vec3(brickDims);
    float row = floor((float(brick) + 0.5) / size.x);
    float plane = floor((row + 0.5) / size.y);
    return ivec3(vec3(float(brick) - row * size.x, row - plane * size.y, plane));
}
ivec3 placeOfTile(uint tile) {
    return placeOfBrick(tile >> 6) * 4 + ivec3(tile & 3u, tile >> 2 & 3u, tile >> 4 & 3u);
}
ivec3 placeOfSlab(uint slab) { return placeOfTile(slab >> 2) * ivec3(1, 1, 4) + ivec3(0, 0, slab & 3u); }
ivec3 placeOfWord(uint word) {
    return placeOfTile(word >> 4) * ivec3(2, 2, 4) + ivec3(word & 1u, word >> 1 & 1u, word >> 2 & 3u);
}

ivec3 wordPlaceOf(ivec3 voxel) { return ivec3(voxel.xy >> 2, voxel.z >> 1); }
uint bitOf(ivec3 voxel) { return uint((voxel.x & 3) | (voxel.y & 3) << 2 | (voxel.z & 1) << 4); }
ivec3 voxelAt(ivec3 place, int bit) { return place * kWordSize + ivec3(bit & 3, bit >> 2 & 3, bit >> 4); }

// Bits of those voxels of a word that lie in the grid.
uint insideGrid(ivec3 place) {
    ivec3 size = clamp(dims - place * kWordSize, ivec3(0), kWordSize);
    uint alongX = 0x11111111u * ((1u << size.x) - 1u);
    uint alongY = 0x00010001u * ((1u << (4 * size.y)) - 1u);
    uint alongZ = size.z == 2 ? 0xffffffffu : size.z == 1 ? 0xffffu : 0u;
    return alongX & alongY & alongZ;
}

// Both halves of a number that the bits of two voxels choose.
uint halves(uint two) { return ((two & 1u) != 0u ? 0xffffu : 0u) | ((two & 2u) != 0u ? 0xffff0000u : 0u); }
