// One axis of the Chebyshev distance transform: the smallest of max(offset, distance there) along that axis.
// In: texture 0 distances so far (r32ui). Out: image 0 (r8ui).
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

layout(binding = 0) uniform usampler3D distancesBefore;
layout(r32ui, binding = 0) uniform writeonly uimage3D distances;

layout(location = 0) uniform ivec3 direction;
layout(location = 1) uniform int far;

void main() {
    ivec3 cell = ivec3(gl_GlobalInvocationID);
    ivec3 size = imageSize(distances);
    if (any(greaterThanEqual(cell, size))) {
        return;
    }
    int best = int(texelFetch(distancesBefore, cell, 0).r);
    for (int k = 1; k < best; ++k) {
        ivec3 before = max(cell - k * direction, ivec3(0));
        ivec3 after = min(cell + k * direction, size - 1);
        int nearest = int(min(texelFetch(distancesBefore, before, 0).r, texelFetch(distancesBefore, after, 0).r));
        best = min(best, max(k, nearest));
    }
    imageStore(distances, cell, uvec4(uint(best)));
}
