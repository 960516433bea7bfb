// The next level of the occlusion volume: each texel the mean of 4^3 of the level before, weighted 1 3 3 1
// along each axis, which is smooth where the mean of 2^3 shows its blocks. In: texture 9. Out: image 0 (r8),
// the next level, texels [texelLo, texelHi).
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

#include "gl/shaders/place.glsl"

#include "render/shaders/bindings.glsl"
layout(binding = kOcclusionTexture) uniform sampler3D occlusion;
layout(r8, binding = kAveragesImage) uniform writeonly image3D averages;

// 0: texels hold the part of their space that is filled; 1: the part of the light that something in them
// holds back, if it is nowhere behind anything else. Between the two thin walls stay seen from afar without
// solids growing.
const float kInTheWay = 0.6;

uniform ivec3 texelLo;
uniform ivec3 texelHi;
uniform int level; // the level before

void main() {
    ivec3 texel = texelLo + placeOfInvocation();
    if (any(greaterThanEqual(texel, texelHi))) {
        return;
    }
    // Between a texel of weight 3 and one of weight 1, linear interpolation gives both, in that proportion.
    vec3 size = vec3(textureSize(occlusion, level));
    vec3 lower = (2.0 * vec3(texel) + 1.0 - 0.75) / size;
    vec3 upper = (2.0 * vec3(texel) + 1.0 + 0.75) / size;
    float parts[8];
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        parts[i] =
            textureLod(occlusion, mix(lower, upper, vec3(i & 1, (i >> 1) & 1, i >> 2)), float(level)).r;
        sum += parts[i];
    }
    // Two neighbours in the way of the light block more than their mean, where they do not block the same
    // part of it. There are four pairs along each axis.
    float both = 0.0;
    for (int i = 0; i < 8; ++i) {
        both += parts[i] * (parts[i ^ 1] + parts[i ^ 2] + parts[i ^ 4]);
    }
    float oneBehindAnother = 0.25 * sum - both / 24.0;
    imageStore(averages, texel, vec4(mix(0.125 * sum, oneBehindAnother, kInTheWay)));
}
