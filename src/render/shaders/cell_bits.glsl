// Macrocells as bits, in blocks of 32 x 4 x 1: a component a row, bit x of it a cell. Blocks are numbered x
// fastest; after a plane's last block comes one of zeros, which stands for everything outside the grid. Plane
// r holds the cells that are at most r from one that may hold something; one more plane is scratch. Spaces:
// cells.

const ivec3 kBlock = ivec3(32, 4, 1);

uniform ivec3 cells;

ivec3 blocks() { return (cells + kBlock - 1) / kBlock; }
int blockCount() {
    ivec3 size = blocks();
    return size.x * size.y * size.z;
}
int blocksPerPlane() { return blockCount() + 1; }

// The number of the block at a place.
int blockAt(ivec3 place) {
    ivec3 size = blocks();
    bool isInside = all(lessThan(uvec3(place), uvec3(size)));
    return isInside ? (place.z * size.y + place.y) * size.x + place.x : blockCount();
}
