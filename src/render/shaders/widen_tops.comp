// The greatest value that windows of 2^3 macrocells, one beginning at every cell, can show: cells with nothing to see have none.
// In: texture 3 macrocell distances, texture 4 what samples in each cell can give (rg: smallest, largest).
// Out: image 0 (r32f) one texel a window.
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

layout(binding = 3) uniform usampler3D cellDistances;
layout(binding = 4) uniform sampler3D dataCellRanges;
layout(r32f, binding = 0) uniform writeonly image3D tops;

void main() {
    ivec3 cell = ivec3(gl_GlobalInvocationID);
    ivec3 last = imageSize(tops) - 1;
    if (any(greaterThan(cell, last))) {
        return;
    }
    float top = -1e38;
    for (int i = 0; i < 8; ++i) {
        ivec3 member = min(cell + ivec3(i & 1, (i >> 1) & 1, i >> 2), last);
        bool isVisible = texelFetch(cellDistances, member, 0).r == 0u;
        top = isVisible ? max(top, texelFetch(dataCellRanges, member, 0).g) : top;
    }
    imageStore(tops, cell, vec4(top));
}
