// Where along the rays of a square of pixels something may be visible: one walk for all of them (a beam), so that each ray
// starts close to what it will meet, or not at all.
// In: the scene and the view, the macrocells. Out: image 0 (rg32f) nearest and farthest t, one texel a square.
layout(local_size_x = 8, local_size_y = 8) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/beam.glsl"

layout(rg32f, binding = 0) uniform writeonly image2D beams;

layout(location = 0) uniform int beamPixels; // side of a square

// From t, where nothing before it (walking forward) or after it (backward) can be seen, to the farthest such t that the
// distances around the central ray vouch for; `limit` at the most.
float walk(Beam beam, float t, float limit, bool forward) {
    const float outside = 1e5;
    ivec3 count = textureSize(cellDistances, 0);
    vec3 high = beam.central.direction + beam.spread; // velocities of the beam's upper and lower faces
    vec3 low = beam.central.direction - beam.spread;
    vec3 backward = vec3(forward ? 1.0 : -1.0);
    for (int turn = 0; turn < 1000 && (forward ? t < limit : t > limit); ++turn) {
        vec3 p = at(beam.central, t);
        vec3 extent = beam.reach + t * beam.spread;
        ivec3 cell = cellAt(p);
        int distance = int(texelFetch(cellDistances, cell, 0).r);
        ivec3 lower = cell + 1 - distance;
        ivec3 upper = cell + distance;
        vec3 lowerFace = mix(4.0 * vec3(lower), vec3(-outside), lessThanEqual(lower, ivec3(0)));
        vec3 upperFace = mix(4.0 * vec3(upper), vec3(outside), greaterThanEqual(upper, count));
        if (distance == 0 || any(lessThan(p - extent, lowerFace)) || any(greaterThan(p + extent, upperFace))) {
            break;
        }
        vec3 upperExit = (upperFace - beam.central.origin - beam.reach) / high;
        vec3 lowerExit = (lowerFace - beam.central.origin + beam.reach) / low;
        vec3 exits = backward * 1e30;
        exits = mix(exits, upperExit, greaterThan(high * backward, vec3(1e-12)));
        vec3 others = mix(backward * 1e30, lowerExit, lessThan(low * backward, vec3(-1e-12)));
        float next = forward ? min(min(min(exits.x, exits.y), exits.z), min(min(others.x, others.y), others.z))
                             : max(max(max(exits.x, exits.y), exits.z), max(max(others.x, others.y), others.z));
        if (abs(next - t) < 0.05) {
            break;
        }
        t = next;
    }
    return t;
}

void main() {
    ivec2 square = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(square, imageSize(beams)))) {
        return;
    }
    vec2 lower = vec2(square * beamPixels);
    Beam beam = beamThrough(lower, min(lower + float(beamPixels), viewport.xy));

    // The grid's box, grown by what the beam reaches beside its central ray anywhere near it.
    vec3 inverse = safeInverse(beam.central.direction);
    float farthest = length(beam.central.origin - 0.5 * vec3(dims.xyz)) * 2.0 + 2.0 * length(vec3(dims.xyz));
    farthest /= max(length(beam.central.direction), 1e-20);
    vec3 extent = beam.reach + farthest * beam.spread + 0.5;
    vec3 a = (-extent - beam.central.origin) * inverse;
    vec3 b = (vec3(dims.xyz) - 1.0 + extent - beam.central.origin) * inverse;
    vec3 lo = min(a, b);
    vec3 hi = max(a, b);
    float tNear = max(max(max(lo.x, lo.y), lo.z), 0.0);
    float tFar = min(min(hi.x, hi.y), hi.z);
    float begin = walk(beam, tNear, tFar, true);
    float end = begin < tFar ? walk(beam, tFar, begin, false) : begin;
    imageStore(beams, square, begin < end ? vec4(begin, end, 0.0, 0.0) : vec4(1e30, -1e30, 0.0, 0.0));
}
