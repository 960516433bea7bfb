// Casts one ray through each given viewport position and writes the surface point that it meets
// (doc/behaviour.md, "What is visible"). Translucent segments are met as opaque ones are: to reach through
// one, hide it. PICK_MAXIMUM: the place of the greatest value instead (what is seen in MIP). CONTENT and
// SCULPTED: see surface.glsl. In: storage 0 positions in pixels. Out: storage 1 field::SurfacePoint, one
// each.
// variants: CONTENT=0;CONTENT=3 TF_KIND=2 SCULPTED=1;CONTENT=2 SCULPTED=1;CONTENT=1 SCULPTED=1;CONTENT=0 PICK_MAXIMUM=1;CONTENT=0 QUADS=1;CONTENT=2 QUADS=1 SMOOTHED=1;CONTENT=3 TF_KIND=1 SEGMENTS=1;CONTENT=0 BRICKS=1 BRICK_RANGES=1 FETCHED=1;CONTENT=3 TF_KIND=2 SCULPTED=1 BRICKS=1 BRICK_RANGES=1 FINER=1 FETCHED=1 FINER_CUTS=1;CONTENT=0 SCULPTED=1 BRICKS=1 FINER=1 FETCHED=1 FINER_CUTS=1;CONTENT=2 BRICKS=1 FINER=1 FETCHED=1 FINER_SEGMENTS=1;CONTENT=1 SCULPTED=1 BRICKS=1 FINER=1 FETCHED=1 FINER_CUTS=1 FINER_SEGMENTS=2;CONTENT=0 SCULPTED=1 FILLED=1;CONTENT=2 FILLED=2;CONTENT=3 TF_KIND=0 FILLED=1 SCULPTED=1;CONTENT=3 TF_KIND=1 SEGMENTS=1 FILLED=1;CONTENT=1 FILLED=1;CONTENT=0 PICK_MAXIMUM=1 FILLED=1
layout(local_size_x = 64) in;

#define ALL_SEGMENTS
#if CONTENT == 3
#define DATA_BY_FUNCTION
#endif
#if CONTENT == 0 || (CONTENT == 3 && !defined(SEGMENTS))
#define DATA_ONLY
#endif
#include "field/shaders/bindings.glsl"
#include "render/shaders/bindings.glsl"
#include "field/shaders/scene.glsl"
#include "gl/shaders/items.glsl"
#include "render/shaders/rays.glsl"
#if CONTENT == 3
#include "render/shaders/classification.glsl"
#include "render/shaders/gradients.glsl"
#endif
#include "render/shaders/surface.glsl"
#include "render/shaders/maximum.glsl"

struct SurfacePoint {
    vec4 voxel;
    vec4 normal;
};

layout(std430, binding = kPositionsStorage) readonly buffer Positions { vec2 positions[]; };
layout(std430, binding = kPointsStorage) writeonly buffer Points { SurfacePoint points[]; };

uniform int count;
uniform int first; // of the points

#ifdef PICK_MAXIMUM
Hit findMaximum(Ray ray) {
    Greatest greatest = findGreatest(ray, kDt);
    Hit hit;
    hit.found = greatest.value > -1e29;
    hit.t = greatest.t;
    hit.voxel = at(ray, hit.t);
    hit.normal = -ray.world;
    return hit;
}
#endif

void main() {
    int i = int(itemIndex());
    if (i >= count) {
        return;
    }
    Ray ray = rayThrough(positions[i]);
#ifdef PICK_MAXIMUM
    Hit hit = findMaximum(ray);
#else
    Hit hit = findSurface(ray, 0.0);
#endif
    points[first + i].voxel = hit.found ? vec4(hit.voxel, 1.0) : vec4(0.0);
    points[first + i].normal = hit.found ? vec4(hit.normal, hit.t * spacing.w) : vec4(0.0);
}
