// Cuts tiles whole (or restores them).
// In/out: image 0 sculpture.
// variants: SCULPTURE_BITS=8;SCULPTURE_BITS=16;SCULPTURE_BITS=32;SCULPTURE_BITS=16 LIMITED=1
#include "sculpt/shaders/cut_solid.glsl"

void main() {
    ivec3 voxel;
    if (!lineStart(voxel)) {
        return;
    }
    for (int n = 0; n < 8 && voxel.x < dims.x; ++n) {
        combineVoxel(voxel, 1.0);
        ++voxel.x;
    }
}
