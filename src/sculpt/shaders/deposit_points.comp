// Deposits points into the WIDTH^3 voxels around each with B-spline weights, as fixed-point integers, so that
// the sum does not depend on the order. Marks the tiles it writes to. WIDTH 3: quadratic or, per axis,
// linear; 4: cubic or lower.
// variants: WIDTH=3 FIXED_ONE=4194304.0 FIXED_LIMIT=1073741824u MAX_POINT_ENERGY=16.0;WIDTH=4 FIXED_ONE=4194304.0 FIXED_LIMIT=1073741824u MAX_POINT_ENERGY=16.0;WIDTH=4 VS_EXCHANGE=1 FIXED_ONE=4194304.0 FIXED_LIMIT=1073741824u MAX_POINT_ENERGY=16.0;WIDTH=3 VS_EXCHANGE=1 FIXED_ONE=4194304.0 FIXED_LIMIT=1073741824u MAX_POINT_ENERGY=16.0
// In: storage 0 points (xyz voxel space, w energy). In/out: image 0 deposits, storage 1 one mark a tile: the
// round.
layout(local_size_x = 64) in;

#include "sculpt/shaders/bindings.glsl"
layout(std430, binding = kPointsStorage) readonly buffer Points { vec4 points[]; };
layout(std430, binding = kMarksStorage) buffer Marks { uint marks[]; };
layout(r32ui, binding = kDepositsImage) uniform uimage3D deposits;

uniform int count;
uniform ivec3 originVoxel; // of texel 0
uniform ivec3 tileDims;
uniform ivec3 degrees;
uniform int round;   // what is marked
uniform int running; // 0: sums are held to the limit; else 1 adds, -1 takes back, to the last bit

// Weights of the WIDTH voxels from the first on, along one axis; x: where the point lies beyond that first
// voxel.
#if WIDTH == 3
float[3] weightsAlong(int degree, float x) {
    float u = x - 1.0; // in [-0.5, 0.5]
    float before = degree == 1 ? max(-u, 0.0) : 0.5 * (0.5 - u) * (0.5 - u);
    float after = degree == 1 ? max(u, 0.0) : 0.5 * (0.5 + u) * (0.5 + u);
    return float[](before, 1.0 - before - after, after);
}
#else
float[4] weightsAlong(int degree, float x) {
    float weights[4];
    for (int n = 0; n < 4; ++n) {
        float d = abs(x - float(n));
        float linear = max(1.0 - d, 0.0);
        float outer = max(1.5 - d, 0.0);
        float quadratic = d < 0.5 ? 0.75 - d * d : 0.5 * outer * outer;
        float rest = max(2.0 - d, 0.0);
        float cubic = d < 1.0 ? (0.5 * d - 1.0) * d * d + 2.0 / 3.0 : rest * rest * rest / 6.0;
        weights[n] = degree == 1 ? linear : (degree == 2 ? quadratic : cubic);
    }
    return weights;
}
#endif

// Adds to a sum that is held to the limit.
#ifdef VS_EXCHANGE
// Hundreds of thousands of invocations may add to one voxel at once, so no sum passes the limit even for a
// moment: it could wrap.
void addUpToLimit(ivec3 texel, uint amount) {
    uint before = imageLoad(deposits, texel).r; // may be old; then the exchange tells what is there
    for (uint seen; amount > 0u && before < FIXED_LIMIT; before = seen) {
        seen = imageAtomicCompSwap(deposits, texel, before, min(before + amount, FIXED_LIMIT));
        amount = seen == before ? 0u : amount;
    }
}
#else
// Few invocations are at work at once, so what they add together does not reach from the limit to where a sum
// wraps: each brings back what it finds beyond. A fifth faster on software renderers than exchanging.
void addUpToLimit(ivec3 texel, uint amount) {
    if (imageAtomicAdd(deposits, texel, amount) >= FIXED_LIMIT) {
        imageAtomicMin(deposits, texel, FIXED_LIMIT);
    }
}
#endif

void main() {
    int index = int(gl_GlobalInvocationID.x);
    if (index >= count) {
        return;
    }
    vec4 point = points[index];
    vec3 first = floor(point.xyz + (WIDTH == 3 ? 0.5 : 0.0)) - 1.0;
    ivec3 texel = ivec3(first) - originVoxel;
    float energy = clamp(point.w, 0.0, MAX_POINT_ENERGY) * FIXED_ONE;
    if (any(lessThan(texel, ivec3(0))) || any(greaterThan(texel, tileDims * 8 - WIDTH)) || !(energy > 0.0)) {
        return;
    }
    float wx[WIDTH] = weightsAlong(degrees.x, point.x - first.x);
    float wy[WIDTH] = weightsAlong(degrees.y, point.y - first.y);
    float wz[WIDTH] = weightsAlong(degrees.z, point.z - first.z);
    for (int z = 0; z < WIDTH; ++z) {
        for (int y = 0; y < WIDTH; ++y) {
            float row = energy * wz[z] * wy[y];
            for (int x = 0; x < WIDTH; ++x) {
                uint amount = uint(row * wx[x] + 0.5);
                if (running == 0) {
                    addUpToLimit(texel + ivec3(x, y, z), amount);
                } else {
                    imageAtomicAdd(deposits, texel + ivec3(x, y, z), running < 0 ? 0u - amount : amount);
                }
            }
        }
    }
    ivec3 low = texel >> 3;
    ivec3 high = (texel + WIDTH - 1) >> 3;
    for (int n = 0; n < 8; ++n) {
        ivec3 tile = ivec3((n & 1) != 0 ? high.x : low.x, (n & 2) != 0 ? high.y : low.y,
                           (n & 4) != 0 ? high.z : low.z);
        marks[(tile.z * tileDims.y + tile.y) * tileDims.x + tile.x] = uint(round);
    }
}
