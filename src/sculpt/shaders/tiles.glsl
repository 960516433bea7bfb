// A list of tiles of 8^3 voxels, as sculpt::Radiator makes them: 4 uints of indirect arguments, then tile
// numbers (x fastest in a grid of tileDims). Work groups are 8 x 8; a list may be spread over two group
// dimensions. The includer declares `layout(std430, binding = ...) readonly buffer TileList { uint
// tileList[]; };`.

const uint tileListRow = 32768u; // work groups along x

// The tile of this work group; false when it lies beyond the list's end.
bool tileOfGroup(ivec3 tileDims, out ivec3 tile) {
    uint index = gl_WorkGroupID.y * tileListRow + gl_WorkGroupID.x;
    if (index >= tileList[3]) {
        return false;
    }
    int number = int(tileList[4u + index]);
    tile = ivec3(number % tileDims.x, (number / tileDims.x) % tileDims.y, number / (tileDims.x * tileDims.y));
    return true;
}
