// Turns what splat_points.comp added up into energies, and sets it back to zero for the next use.
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

layout(r32ui, binding = 0) uniform uimage3D splatted;
layout(r32f, binding = 1) uniform writeonly image3D energy;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel, imageSize(splatted)))) {
        return;
    }
    imageStore(energy, texel, vec4(float(imageLoad(splatted, texel).r) / FIXED_ONE));
    imageStore(splatted, texel, uvec4(0u));
}
