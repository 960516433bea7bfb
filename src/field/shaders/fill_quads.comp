// The texels of a field once more as quads (field/quads.h): four neighbours of a slice in one texel of a
// buffer. In: texture 0 texels. Out: image 0 quads.
// variants: VS_FORMAT=rgba16;VS_FORMAT=rgba32f
layout(local_size_x = 64) in;

#include "gl/shaders/place.glsl"

#include "field/shaders/bindings.glsl"
layout(binding = kTexelsTexture) uniform sampler3D texels;
layout(VS_FORMAT, binding = kQuadsImage) uniform writeonly imageBuffer quads;

uniform ivec3 dims;

float texelAt(ivec3 voxel) { return texelFetch(texels, min(voxel, dims - 1), 0).r; }

void main() {
    ivec3 voxel = placeOfInvocation();
    if (any(greaterThanEqual(voxel, dims))) {
        return;
    }
    vec4 four = vec4(texelAt(voxel), texelAt(voxel + ivec3(1, 0, 0)), texelAt(voxel + ivec3(0, 1, 0)),
                     texelAt(voxel + ivec3(1, 1, 0)));
    imageStore(quads, (voxel.z * dims.y + voxel.y) * dims.x + voxel.x, four);
}
