// The greatest value that can be seen in each macrocell, and in it and the next ones along any of the axes:
// eight boxes of 1 or 2 cells a side, so that any small box of cells is looked up at once. As codes
// (slabs.glsl). In: the scene, textures 3 macrocell distances, 4 what samples in each cell can give (rg:
// smallest, largest). Out: image 0 (r32ui) at (x, y, 2 z + 1 if the box is two cells deep): four codes, first
// those one cell wide along y, first of each those one cell wide along x.
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

#include "gl/shaders/place.glsl"

#include "field/shaders/scene.glsl"
#include "render/shaders/slabs.glsl"

#include "render/shaders/bindings.glsl"
layout(binding = kCellDistancesTexture) uniform usampler3D cellDistances;
layout(binding = kDataCellRangesTexture) uniform sampler3D dataCellRanges;
layout(r32ui, binding = kTopsImage) uniform writeonly uimage3D tops;

uint codeOfCell(ivec3 cell) {
    ivec3 member = min(cell, textureSize(cellDistances, 0) - 1);
    bool isVisible = texelFetch(cellDistances, member, 0).r == 0u;
    return isVisible ? codeOfBound(texelFetch(dataCellRanges, member, 0).g) : 0u;
}

// One cell, two along x, two along y, four.
uvec4 codesInLayer(ivec3 cell) {
    uvec2 row = uvec2(codeOfCell(cell), codeOfCell(cell + ivec3(1, 0, 0)));
    uvec2 next = max(row, uvec2(codeOfCell(cell + ivec3(0, 1, 0)), codeOfCell(cell + ivec3(1, 1, 0))));
    return uvec4(row.x, max(row.x, row.y), next.x, max(next.x, next.y));
}

uvec4 inOneWord(uvec4 codes) { return uvec4(codes.x | codes.y << 8 | codes.z << 16 | codes.w << 24); }

void main() {
    ivec3 cell = placeOfInvocation();
    if (any(greaterThanEqual(cell, textureSize(cellDistances, 0)))) {
        return;
    }
    uvec4 layer = codesInLayer(cell);
    uvec4 both = max(layer, codesInLayer(cell + ivec3(0, 0, 1)));
    imageStore(tops, cell * ivec3(1, 1, 2), inOneWord(layer));
    imageStore(tops, cell * ivec3(1, 1, 2) + ivec3(0, 0, 1), inOneWord(both));
}
