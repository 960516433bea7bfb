// Smallest and largest value of each macrocell and the 26 around it: what a kernel that reaches into them can
// give. In: texture 0 ranges (rg: smallest, largest value in the cell). Out: image 0 (rg32f) the same size.
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

#include "gl/shaders/place.glsl"

#include "render/shaders/bindings.glsl"
layout(binding = kRangesTexture) uniform sampler3D ranges;
layout(rg32f, binding = kDilatedImage) uniform writeonly image3D dilated;

void main() {
    ivec3 cell = placeOfInvocation();
    ivec3 last = imageSize(dilated) - 1;
    if (any(greaterThan(cell, last))) {
        return;
    }
    vec2 range = texelFetch(ranges, cell, 0).rg;
    for (int i = 0; i < 27; ++i) {
        ivec3 neighbour = clamp(cell + ivec3(i % 3, i / 3 % 3, i / 9) - 1, ivec3(0), last);
        vec2 there = texelFetch(ranges, neighbour, 0).rg;
        range = vec2(min(range.x, there.x), max(range.y, there.y));
    }
    imageStore(dilated, cell, vec4(range, 0.0, 0.0));
}
