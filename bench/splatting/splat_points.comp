// The straightforward way: each point adds its share to each of the (2 RADIUS)^3 voxels around it, a Gaussian
// of sigma RADIUS / 3 normalised along each axis, as fixed-point integers so that the order does not matter.
// SLICES 1: one invocation a point; 2 RADIUS: one invocation for each slice of voxels that a point reaches.
// In: storage 0 points (xyz voxel space, w energy). In/out: image 0 energy in 1 / FIXED_ONE.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Points { vec4 points[]; };
layout(r32ui, binding = 0) uniform uimage3D energy;

uniform int count;
uniform ivec3 originVoxel; // of texel 0

const int WIDTH = 2 * RADIUS;

float[WIDTH] weightsAlong(float offset) {
    const float sigma = float(RADIUS) / 3.0;
    float weights[WIDTH];
    float sum = 0.0;
    for (int n = 0; n < WIDTH; ++n) {
        float x = (float(n + 1 - RADIUS) - offset) / sigma;
        weights[n] = exp(-0.5 * x * x);
        sum += weights[n];
    }
    for (int n = 0; n < WIDTH; ++n) {
        weights[n] /= sum;
    }
    return weights;
}

void main() {
    int index = int(gl_GlobalInvocationID.x) / SLICES;
    if (index >= count) {
        return;
    }
    vec4 point = points[index];
    if (!(point.w > 0.0)) {
        return;
    }
    vec3 base = floor(point.xyz);
    ivec3 texel = ivec3(base) + 1 - RADIUS - originVoxel;
    if (any(lessThan(texel, ivec3(0))) || any(greaterThan(texel + WIDTH, imageSize(energy)))) {
        return;
    }
    float wx[WIDTH] = weightsAlong(point.x - base.x);
    float wy[WIDTH] = weightsAlong(point.y - base.y);
    float wz[WIDTH] = weightsAlong(point.z - base.z);
    int slice = int(gl_GlobalInvocationID.x) % SLICES;
    int first = SLICES == 1 ? 0 : slice;
    int last = SLICES == 1 ? WIDTH - 1 : slice;
    for (int z = first; z <= last; ++z) {
        for (int y = 0; y < WIDTH; ++y) {
            float row = point.w * FIXED_ONE * wz[z] * wy[y];
            for (int x = 0; x < WIDTH; ++x) {
                imageAtomicAdd(energy, texel + ivec3(x, y, z), uint(row * wx[x] + 0.5));
            }
        }
    }
}
