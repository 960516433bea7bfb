// How far outwards from surface points that were laid bare by cutting what was cut away can be put back: up
// to the uncut surface, which is the last place in the displayed range before what was cut away ends. In:
// storage 0 field::SurfacePoint, storage 1 outward directions (voxels a step, w the depth in steps). Out:
// storage 2 steps, one each.
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "gl/shaders/items.glsl"

struct SurfacePoint {
    vec4 voxel;
    vec4 normal;
};

#include "sculpt/shaders/bindings.glsl"
layout(std430, binding = kPointsStorage) readonly buffer Points { SurfacePoint points[]; };
layout(std430, binding = kWaysStorage) readonly buffer Ways { vec4 ways[]; };
layout(std430, binding = kReachStorage) writeonly buffer Reach { float reach[]; };

uniform int count;
uniform float radius; // steps

const float stride = 0.5; // steps
const float near = 1.0;   // within this of the point the cut face's own blur may say anything

void main() {
    int i = int(itemIndex());
    if (i >= count) {
        return;
    }
    vec3 from = points[i].voxel.xyz;
    vec3 way = ways[i].xyz;
    float depth = ways[i].w;
    bool isMarching = points[i].voxel.w > 0.5 && depth > 0.0;
    float last = -1.0; // where the data was last in range
    float t = 0.5 * stride;
    if (isMarching) {
        do {
            vec3 p = from + t * way;
            bool isCut = sculptureAt(p) >= 0.5;
            bool isInside =
                all(greaterThanEqual(p, vec3(-0.5))) && all(lessThanEqual(p, vec3(dims.xyz) - 0.5));
            last = isCut && isInside && insideRange(dataAt(p)) >= 0.0 ? t : last;
            isMarching = t <= depth && isInside && (isCut || t < near);
            t += stride;
        } while (isMarching);
    }
    // Before the far end the data came to an end: that is the uncut surface.
    bool reachesSurface = last + 2.0 * stride < depth;
    reach[i] = last < 0.0 ? 0.0 : (reachesSurface ? last + 0.5 * stride + radius : depth);
}
