// Smooths values along one axis: each invocation a run of 16 voxels, with a sliding window. Values below
// kNonFinite count for nothing and stay what they are; at the grid's border the outermost values go on.
// Spaces: voxel indices. Source and target may hold some slices of the grid only.
// In: texture 0 source. Out: image 0 target.
// VS_REACH: how many voxels to each side count, 1 to 6. VS_MASKED: some values may not count.
// variants: VS_FORMAT=r32f VS_REACH=6 VS_MASKED=1;VS_FORMAT=r16 VS_REACH=1;VS_FORMAT=r32f VS_REACH=3
layout(local_size_x = 8, local_size_y = 8) in;

#include "gl/shaders/place.glsl"

#include "field/shaders/bindings.glsl"
layout(binding = kSourceTexture) uniform sampler3D source;
layout(VS_FORMAT, binding = kTargetImage) uniform writeonly image3D target;

uniform ivec3 dims;
uniform int axisAtWork;
uniform ivec2 task; // of the grid's slices: the first to smooth, and the one past the last
uniform ivec3
    slices;        // x the grid's slice that is the source's first, y how many it has, z the target's first
uniform vec2 map;  // of values (x scale, y offset) when read, along z when written
uniform vec4 near; // weights of voxels at distance 0, 1, 2, 3
uniform vec3 far;  // 4, 5, 6

const int kRun = 16;
const int kReach = VS_REACH;
const int kTaps = 2 * kReach + 1;
const float kNonFinite = -1e29; // below this: the stand-in for values that are not finite

int along(ivec3 v, ivec3 axis) { return axis.x * v.x + axis.y * v.y + axis.z * v.z; }

#ifdef VS_MASKED
#define Value vec2 // and whether it counts
Value valueOf(float value) { return value < kNonFinite ? vec2(0.0) : vec2(value, 1.0); }
float result(Value middle, Value sum) { return middle.y > 0.0 ? sum.x / sum.y : -1e30; }
#else
#define Value float
Value valueOf(float value) { return value; }
float result(Value middle, Value sum) { return sum; }
#endif

Value fetched(ivec3 voxel, ivec3 axis, int place) {
    ivec3 at = voxel + axis * (clamp(place, 0, along(dims, axis) - 1) - along(voxel, axis));
    at.z = clamp(at.z - slices.x, 0, slices.y - 1);
    float value = texelFetch(source, at, 0).r;
    value = axisAtWork == 2 || value < kNonFinite ? value : value * map.x + map.y;
    return valueOf(value);
}

void main() {
    ivec3 axis = ivec3(axisAtWork == 0, axisAtWork == 1, axisAtWork == 2);
    ivec3 voxel = placeOfInvocation() * (ivec3(1) + axis * (kRun - 1)) + ivec3(0, 0, task.x);
    if (any(greaterThanEqual(voxel, ivec3(dims.xy, task.y)))) {
        return;
    }
    float weights[7] = float[](near.x, near.y, near.z, near.w, far.x, far.y, far.z);
    int first = along(voxel, axis);
    Value window[kTaps];
    for (int tap = 1; tap < kTaps; ++tap) {
        window[tap] = fetched(voxel, axis, first + tap - kReach - 1);
    }
    int end = axisAtWork == 2 ? task.y : along(dims, axis);
    int count = min(kRun, end - first);
    for (int i = 0; i < count; ++i) {
        for (int tap = 0; tap + 1 < kTaps; ++tap) {
            window[tap] = window[tap + 1];
        }
        window[kTaps - 1] = fetched(voxel, axis, first + i + kReach);
        Value sum = weights[0] * window[kReach];
        for (int tap = 1; tap <= kReach; ++tap) {
            sum += weights[tap] * (window[kReach - tap] + window[kReach + tap]);
        }
        float value = result(window[kReach], sum);
        value = axisAtWork == 2 && value > kNonFinite ? value * map.x + map.y : value;
        ivec3 here = voxel + axis * i;
        imageStore(target, here - ivec3(0, 0, task.x - slices.z), vec4(value));
    }
}
