// Cuts by energies given for each voxel.
// In: image 1 energies of the voxels that the sculpture has. In/out: image 0 sculpture.
// variants: SCULPTURE_BITS=16;SCULPTURE_BITS=16 LIMITED=1
#include "sculpt/shaders/cut_solid.glsl"

#include "sculpt/shaders/bindings.glsl"
layout(r32f, binding = kEnergiesImage) uniform readonly image3D energies;

void main() {
    ivec3 voxel;
    if (!lineStart(voxel)) {
        return;
    }
    for (int n = 0; n < 8 && voxel.x < dims.x; ++n) {
        combineVoxel(voxel, clamp(imageLoad(energies, voxel - firstVoxel).r, 0.0, 1.0));
        ++voxel.x;
    }
}
