// Casts one ray through each given viewport position and writes the surface point that it meets (SPEC 7).
// PICK_MAXIMUM: the place of the greatest value instead (MIP). CONTENT and SCULPTED: see surface.glsl.
// In: storage 0 positions in pixels. Out: storage 1 field::SurfacePoint, one each.
// variants: CONTENT=0;CONTENT=2 SCULPTED=1;CONTENT=0 PICK_MAXIMUM=1
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "gl/shaders/items.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/surface.glsl"

struct SurfacePoint {
    vec4 voxel;
    vec4 normal;
};

layout(std430, binding = 0) readonly buffer Positions { vec2 positions[]; };
layout(std430, binding = 1) writeonly buffer Points { SurfacePoint points[]; };

layout(location = 0) uniform int count;

#ifdef PICK_MAXIMUM
Hit findMaximum(Ray ray) {
    vec3 inverseDirection = safeInverse(ray.direction);
    Hit hit;
    hit.found = false;
    hit.normal = -ray.world;
    hit.t = 0.0;
    float greatest = -1e30;
    float t = ray.tNear;
    while (t < ray.tFar) {
        float skip = emptyUntil(ray, t, inverseDirection);
        vec3 p = at(ray, t);
        float value = dataAt(p);
        bool better = skip == 0.0 && visibility(p) >= 0.0 && value > greatest;
        greatest = better ? value : greatest;
        hit.t = better ? t : hit.t;
        hit.found = hit.found || better;
        t += skip > 0.0 ? skip : kDt;
    }
    hit.voxel = at(ray, hit.t);
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
    points[i].voxel = hit.found ? vec4(hit.voxel, 1.0) : vec4(0.0);
    points[i].normal = hit.found ? vec4(hit.normal, hit.t * spacing.w) : vec4(0.0);
}
