// Whether growth may enter a voxel. Set by segment::bindConstraints. Which rules there are is said by
// VS_FENCED (the sculpture), VS_GRADIENT, VS_DIFFERENCE and VS_GRADIENT_DIFFERENCE. Spaces: voxel indices.
// Bindings: texture 0 data, texture 1 sculpture.
#if defined(VS_DIFFERENCE) || defined(VS_GRADIENT_DIFFERENCE)
#define VS_PAIRED // rules that ask for the parent too
#endif

#include "segment/shaders/bindings.glsl"
layout(binding = kDataTexture) uniform sampler3D dataTexture;
uniform ivec3 gridDims;
uniform vec3 valueScale; // x scale, y offset, z 1 if values are whole numbers
uniform vec2 valueRange; // all ranges are closed; in the volume's unit
#ifdef VS_FENCED
layout(binding = kSculptureTexture) uniform sampler3D sculptureTexture;
uniform int keepsCutPart; // 1: only where the sculpture is >= 0.5; 0: only where it is < 0.5
#endif
uniform vec3 gradientAlongX; // of a difference of 1 across two voxels: 1 / mm, in world axes
uniform vec3 gradientAlongY;
uniform vec3 gradientAlongZ;
uniform vec2 gradientRange;   // the volume's unit per mm
uniform vec2 differenceRange; // child - parent
uniform vec2 gradientDifferenceRange;

bool isInside(ivec3 voxel) {
    // As unsigned numbers, negative coordinates are too large as well.
    return all(lessThan(uvec3(voxel), uvec3(gridDims)));
}

bool isWithin(float value, vec2 range) { return value >= range.x && value <= range.y; }

// Products and sums below are rounded one by one, so that every device gives what a plain program gives.
float valueOf(ivec3 voxel) {
    precise float scaled = texelFetch(dataTexture, voxel, 0).r * valueScale.x;
    precise float value = scaled + valueScale.y;
    return valueScale.z > 0.5 ? round(value) : value;
}

// The square root, rounded to the nearest float as a processor's is; those of devices may be a few steps off.
// s * s compares with the argument as whole numbers: (s - 1/2)^2 < argument < (s + 1/2)^2.
float exactSqrt(float argument) {
    float about = sqrt(argument);
    uint bits = floatBitsToUint(argument);
    int exponent = int(bits >> 23) - 127;
    if (!(argument > 0.0) || exponent == -127 || exponent == 128) {
        return about; // zero, too small to matter, or no number
    }
    uint digits = (bits & 0x7FFFFFu) | 0x800000u; // argument = digits * 2^(exponent - 23)
    int rootExponent = exponent >> 1;             // of the root
    int shift = 23 + (exponent & 1);
    uvec2 wanted = uvec2(digits >> (32 - shift), digits << shift); // high and low word of s * s
    uint s = uint(about * uintBitsToFloat(uint(127 + 23 - rootExponent) << 23));
    for (int n = 0; n < 8; ++n) {
        uvec2 above; // s * (s + 1): what is more belongs to s + 1
        uvec2 below; // s * (s - 1): what is not more belongs to s - 1
        umulExtended(s, s + 1u, above.x, above.y);
        umulExtended(s, s - 1u, below.x, below.y);
        bool isMore = wanted.x > above.x || (wanted.x == above.x && wanted.y > above.y);
        bool isLess = wanted.x < below.x || (wanted.x == below.x && wanted.y <= below.y);
        if (isMore == isLess) {
            break;
        }
        s = isMore ? s + 1u : s - 1u;
    }
    return float(s) * uintBitsToFloat(uint(127 - 23 + rootExponent) << 23);
}

// Central differences; beyond the grid values are those at its border.
float gradientMagnitude(ivec3 voxel) {
    ivec3 before = max(voxel - 1, 0);
    ivec3 after = min(voxel + 1, gridDims - 1);
    precise vec3 along =
        vec3(valueOf(ivec3(after.x, voxel.yz)) - valueOf(ivec3(before.x, voxel.yz)),
             valueOf(ivec3(voxel.x, after.y, voxel.z)) - valueOf(ivec3(voxel.x, before.y, voxel.z)),
             valueOf(ivec3(voxel.xy, after.z)) - valueOf(ivec3(voxel.xy, before.z)));
    precise vec3 x = gradientAlongX * along.x;
    precise vec3 y = gradientAlongY * along.y;
    precise vec3 z = gradientAlongZ * along.z;
    precise vec3 xy = x + y;
    precise vec3 gradient = xy + z;
    precise vec3 squares = gradient * gradient;
    precise float sum = squares.x + squares.y;
    precise float squared = sum + squares.z;
    return exactSqrt(squared);
}

// What the voxel alone decides. It must be inside the grid.
bool isAdmissible(ivec3 voxel) {
    bool admissible = isWithin(valueOf(voxel), valueRange);
#ifdef VS_FENCED
    admissible = admissible && (texelFetch(sculptureTexture, voxel, 0).r >= 0.5) == (keepsCutPart == 1);
#endif
#ifdef VS_GRADIENT
    admissible = admissible && isWithin(gradientMagnitude(voxel), gradientRange);
#endif
    return admissible;
}

#ifdef VS_PAIRED
// What it decides together with the voxel that it would be entered from.
bool isAdmissibleFrom(ivec3 parent, ivec3 child) {
    bool admissible = true;
#ifdef VS_DIFFERENCE
    precise float difference = valueOf(child) - valueOf(parent);
    admissible = isWithin(difference, differenceRange);
#endif
#ifdef VS_GRADIENT_DIFFERENCE
    precise float steeper = gradientMagnitude(child) - gradientMagnitude(parent);
    admissible = admissible && isWithin(steeper, gradientDifferenceRange);
#endif
    return admissible;
}
#endif

ivec3 voxelOf(uint index) {
    uvec3 size = uvec3(gridDims);
    return ivec3(index % size.x, index / size.x % size.y, index / (size.x * size.y));
}

uint indexOf(ivec3 voxel) {
    return (uint(voxel.z) * uint(gridDims.y) + uint(voxel.y)) * uint(gridDims.x) + uint(voxel.x);
}
