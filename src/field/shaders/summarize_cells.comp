// Smallest and largest value among the 5^3 corner voxels of each macrocell in a box of cells.
// In: texture 0 values. Out: image 0 (rg32f) one texel a cell.
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

#include "gl/shaders/place.glsl"

#include "field/shaders/bindings.glsl"
layout(binding = kValuesTexture) uniform sampler3D values;
layout(rg32f, binding = kCellsImage) uniform writeonly image3D cells;

uniform ivec3 dims;
uniform ivec3 cellLo;
uniform ivec3 cellHi;
uniform vec2 valueScaleOffset;

void main() {
    ivec3 cell = cellLo + placeOfInvocation();
    if (any(greaterThanEqual(cell, cellHi))) {
        return;
    }
    ivec3 first = cell * 4;
    ivec3 last = min(first + 4, dims - 1);
    float lo = 1e38;
    float hi = -1e38;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                float value = texelFetch(values, ivec3(x, y, z), 0).r;
                lo = min(lo, value);
                hi = max(hi, value);
            }
        }
    }
    imageStore(cells, cell, vec4(vec2(lo, hi) * valueScaleOffset.x + valueScaleOffset.y, 0.0, 0.0));
}
