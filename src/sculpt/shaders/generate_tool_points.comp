// Samples the solids that patches of a mask sweep, one invocation a patch. P(u, v, d) = start(u, v) + d *
// direction(u, v), both bilinear between four corners; a sample carries mask * det(dP/du, dP/dv, dP/dd) du dv
// dd, in voxels. In: storage 0 corners, storage 1 patches (sculpt/radiation/swept_patches.h), all in voxel
// space. Out: storage 2 points (xyz voxel space, w energy), each patch from its own first place on.
layout(local_size_x = 64) in;

struct Corner {
    vec4 start; // w mask
    vec4 direction;
};
struct Patch {
    uint corners[4];
    uint firstPoint;
    uint counts;
    float mask;
    uint offset; // of a single sample from the middle in u and v
    float depthLo;
    float depthHi;
};

#include "sculpt/shaders/bindings.glsl"
layout(std430, binding = kCornersStorage) readonly buffer Corners { Corner corners[]; };
layout(std430, binding = kPatchesStorage) readonly buffer Patches { Patch patches[]; };
layout(std430, binding = kToolPointsStorage) writeonly buffer Points { vec4 points[]; };

uniform int firstPatch;
uniform int patchCount;
uniform uint basePoint;    // the buffer's first place belongs to this point
uniform vec2 depths;       // of the whole sweep: from, to
uniform float orientation; // sign of forward motion; 0: each patch's own near depth 0, until paths meet

vec4 bilinear(vec4 a, vec4 b, vec4 c, vec4 d, vec2 uv) { return mix(mix(a, b, uv.x), mix(c, d, uv.x), uv.y); }

// Where a + b t + c t^2, positive at t = 0, first reaches zero on either side.
vec2 rootsAround(float a, float b, float c) {
    vec2 ends = vec2(-1e30, 1e30);
    float discriminant = b * b - 4.0 * a * c;
    if (discriminant >= 0.0) {
        float root = sqrt(discriminant);
        ends.x = -root - b < 0.0 ? 2.0 * a / (-root - b) : ends.x;
        ends.y = root - b > 0.0 ? 2.0 * a / (root - b) : ends.y;
    }
    return ends;
}

void main() {
    int index = int(gl_GlobalInvocationID.x);
    if (index >= patchCount) {
        return;
    }
    Patch p = patches[firstPatch + index];
    Corner a = corners[p.corners[0]];
    Corner b = corners[p.corners[1]];
    Corner c = corners[p.corners[2]];
    Corner d = corners[p.corners[3]];
    ivec3 counts = ivec3(p.counts & 255u, (p.counts >> 8) & 255u, p.counts >> 16);
    vec3 stride = vec3(1.0, 1.0, p.depthHi - p.depthLo) / vec3(counts);
    float cellVolume = stride.x * stride.y * stride.z;

    float nearest = clamp(0.0, depths.x, depths.y);
    vec3 middleU = (b.start - a.start + d.start - c.start +
                    nearest * (b.direction - a.direction + d.direction - c.direction))
                       .xyz;
    vec3 middleV = (c.start - a.start + d.start - b.start +
                    nearest * (c.direction - a.direction + d.direction - b.direction))
                       .xyz;
    vec3 middleD = (a.direction + b.direction + c.direction + d.direction).xyz;
    float forwards = orientation != 0.0 ? orientation : sign(dot(cross(middleU, middleV), middleD));

    uint place = p.firstPoint - basePoint;
    for (int j = 0; j < counts.y; ++j) {
        for (int i = 0; i < counts.x; ++i) {
            vec2 uv = (vec2(i, j) + 0.5) * stride.xy + unpackSnorm2x16(p.offset);
            vec4 start = bilinear(a.start, b.start, c.start, d.start, uv);
            vec3 direction = bilinear(a.direction, b.direction, c.direction, d.direction, uv).xyz;
            vec3 startU = mix(b.start - a.start, d.start - c.start, uv.y).xyz;
            vec3 startV = mix(c.start - a.start, d.start - b.start, uv.x).xyz;
            vec3 directionU = mix(b.direction - a.direction, d.direction - c.direction, uv.y).xyz;
            vec3 directionV = mix(c.direction - a.direction, d.direction - b.direction, uv.x).xyz;
            float mask = p.mask >= 0.0 ? p.mask : start.w;
            // A path ends where it meets its neighbours: the determinant is a quadratic of the depth.
            vec2 ends = vec2(-1e30, 1e30);
            vec3 nearU = startU + nearest * directionU;
            vec3 nearV = startV + nearest * directionV;
            float here = forwards * dot(cross(nearU, nearV), direction);
            if (orientation == 0.0 && here > 0.0) {
                float slope = forwards * dot(cross(nearU, directionV) + cross(directionU, nearV), direction);
                ends = nearest +
                       rootsAround(here, slope, forwards * dot(cross(directionU, directionV), direction));
            }
            for (int k = 0; k < counts.z; ++k) {
                float depth = p.depthLo + (float(k) + 0.5) * stride.z;
                vec3 alongU = startU + depth * directionU;
                vec3 alongV = startV + depth * directionV;
                float density = max(forwards * dot(cross(alongU, alongV), direction), 0.0);
                // Beyond the point where paths meet in both u and v at once the determinant is positive
                // again.
                bool hasCrossed = dot(alongU, middleU) < 0.0 || dot(alongV, middleV) < 0.0 ||
                                  depth < ends.x || depth > ends.y;
                points[place++] =
                    vec4(start.xyz + depth * direction, hasCrossed ? 0.0 : mask * density * cellVolume);
            }
        }
    }
}
