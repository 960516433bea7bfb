// Where along the rays of a square of pixels something may be visible: one walk for all of them (a beam), so
// that each ray starts close to what it will meet, or not at all. In: the scene and the view, the macrocells.
// Out: image 0 (rg32f) nearest and farthest t, one texel a square.
layout(local_size_x = 8, local_size_y = 8) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/beam.glsl"

#include "render/shaders/bindings.glsl"
layout(rg32f, binding = kBeamsImage) uniform writeonly image2D beams;

uniform int beamPixels; // side of a square
uniform vec4 window;    // the pixels that are wanted, [xy, zw): nothing is to be seen in squares without any

const vec2 kNowhere = vec2(1e30, -1e30);

// From t, where nothing before it (walking forward) or after it (backward) can be seen, to the farthest such
// t that the distances around the central ray vouch for; `limit` at the most.
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
        if (distance == 0 || any(lessThan(p - extent, lowerFace)) ||
            any(greaterThan(p + extent, upperFace))) {
            break;
        }
        vec3 upperExit = (upperFace - beam.central.origin - beam.reach) / high;
        vec3 lowerExit = (lowerFace - beam.central.origin + beam.reach) / low;
        vec3 exits = backward * 1e30;
        exits = mix(exits, upperExit, greaterThan(high * backward, vec3(1e-12)));
        vec3 others = mix(backward * 1e30, lowerExit, lessThan(low * backward, vec3(-1e-12)));
        float next = forward
                         ? min(min(min(exits.x, exits.y), exits.z), min(min(others.x, others.y), others.z))
                         : max(max(max(exits.x, exits.y), exits.z), max(max(others.x, others.y), others.z));
        if (abs(next - t) < 0.05) {
            break;
        }
        t = next;
    }
    return t;
}

// Between which t any of the rays can be in the grid's box. How far a plane is along a ray has its extremes
// in the square's corners, but for a hair, as directions are normalised; how far the box is need not: one of
// its corners may point at us.
vec2 wayInBox(vec2 lower, vec2 upper) {
    const float hair = 0.02;
    vec3 nearest = vec3(1e30);
    vec3 farthest = vec3(-1e30);
    for (int corner = 0; corner < 4; ++corner) {
        Ray ray =
            rayThrough(vec2((corner & 1) == 0 ? lower.x : upper.x, (corner & 2) == 0 ? lower.y : upper.y));
        vec3 inverse = safeInverse(ray.direction);
        vec3 a = (vec3(-0.5) - ray.origin) * inverse;
        vec3 b = (vec3(dims.xyz) - 0.5 - ray.origin) * inverse;
        nearest = min(nearest, min(a, b));
        farthest = max(farthest, max(a, b));
    }
    return vec2(max(max(max(nearest.x, nearest.y), nearest.z) - hair, 0.0),
                min(min(farthest.x, farthest.y), farthest.z) + hair);
}

void main() {
    ivec2 square = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(square, imageSize(beams)))) {
        return;
    }
    vec2 lower = vec2(square * beamPixels);
    vec2 upper = min(lower + float(beamPixels), viewport.xy);
    if (any(greaterThanEqual(lower, window.zw)) || any(lessThanEqual(upper, window.xy))) {
        imageStore(beams, square, vec4(kNowhere, 0.0, 0.0));
        return;
    }
    Beam beam = beamThrough(lower, upper);
    vec2 way = wayInBox(lower, upper);
    float begin = walk(beam, way.x, way.y, true);
    float end = begin < way.y ? walk(beam, way.y, begin, false) : begin;
    imageStore(beams, square, vec4(begin < end ? vec2(begin, end) : kNowhere, 0.0, 0.0));
}
