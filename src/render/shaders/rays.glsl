// Rays of the current view, in voxel space, and walking along them.
// A ray's parameter t counts steps: one step is the smallest voxel spacing in mm, so dt = 0.5 samples twice
// per voxel. Bindings: uniform block 1 (render::ViewBlock), texture 3 macrocell distances, with SEGMENT_CELLS
// or DATA_BESIDE_SEGMENTS 11 those of cells where segments may be. DATA_BY_FUNCTION: a transfer function says
// what of the data can be seen, not the displayed range. BRICK_RANGES: see cast_rays.comp. Include
// "field/shaders/scene.glsl" first.

#include "render/shaders/bindings.glsl"
layout(std140, binding = kViewBlock) uniform ViewBlock {
    // World, for shading: unit vectors.
    vec4 viewForward; // w 1 if orthographic
    vec4 viewRight;
    vec4 viewUp;
    // Voxel space, per step, for rays (transformed in double precision, so that scans far from the world's
    // origin keep theirs). A ray has origin eye and direction forward + n.x * right - n.y * up (see
    // render/camera/camera.h).
    vec4 eyeVoxel;
    vec4 forwardVoxel;
    vec4 rightVoxel;
    vec4 upVoxel;
    vec4 viewport; // xy size in pixels, zw tangents of half the picture's width and height (perspective)
};

layout(binding = kCellDistancesTexture) uniform usampler3D cellDistances;
#if defined(SEGMENT_CELLS) || defined(DATA_BESIDE_SEGMENTS)
layout(binding = kSegmentCellDistancesTexture) uniform usampler3D segmentCellDistances;
#endif

struct Ray {
    vec3 origin;    // voxel space
    vec3 direction; // voxel space, per step
    vec3 world;     // world direction, unit
    float tNear;    // where it enters the grid's box, not before the eye
    float tFar;
    float tBegin; // nothing visible lies before tBegin or after tEnd; within tNear and tFar
    float tEnd;
    ivec2 beam;    // which beam it belongs to, if it is a pixel's
    vec2 beamEnds; // where that one may show something
};

#ifdef BRICKS
#define kDt (0.5 * fineStep())
#else
const float kDt = 0.5; // steps between samples of a surface
#endif

Ray rayThrough(vec2 pixel) {
    vec2 n = 2.0 * pixel / viewport.xy - 1.0;
    vec3 offset = n.x * rightVoxel.xyz - n.y * upVoxel.xyz;
    bool orthographic = viewForward.w > 0.5;
    vec3 slant = n.x * viewport.z * viewRight.xyz - n.y * viewport.w * viewUp.xyz;
    Ray ray;
    ray.world = orthographic ? viewForward.xyz : normalize(viewForward.xyz + slant);
    ray.origin = orthographic ? eyeVoxel.xyz + offset : eyeVoxel.xyz;
    // As long as one step in the world: the slanted direction is longer than the one straight ahead.
    ray.direction =
        orthographic ? forwardVoxel.xyz : (forwardVoxel.xyz + offset) / length(viewForward.xyz + slant);
    // The box reaches half a voxel beyond the outermost centres.
    vec3 inverse = 1.0 / (ray.direction + vec3(equal(ray.direction, vec3(0.0))) * 1e-20);
    vec3 a = (vec3(-0.5) - ray.origin) * inverse;
    vec3 b = (vec3(dims.xyz) - 0.5 - ray.origin) * inverse;
    vec3 lo = min(a, b);
    vec3 hi = max(a, b);
    ray.tNear = max(max(max(lo.x, lo.y), lo.z), 0.0);
    ray.tFar = min(min(hi.x, hi.y), hi.z);
    ray.tBegin = ray.tNear;
    ray.tEnd = ray.tFar;
    ray.beam = ivec2(0);
    ray.beamEnds = vec2(ray.tNear, ray.tFar);
    return ray;
}

vec3 at(Ray ray, float t) { return ray.origin + t * ray.direction; }

ivec3 cellAt(vec3 p) { return clamp(ivec3(floor(p * 0.25)), ivec3(0), textureSize(cellDistances, 0) - 1); }

// How far from t the ray goes until it has left all cells nearer to `cell` than `distance` (1: the cell
// itself). It ends a hair beyond their faces, in voxels and not in steps, or a ray almost along a face would
// creep towards it. The half voxel outside the outermost cells belongs to them. Never less than t's own
// resolution, or the ray would not move.
float leaveCells(Ray ray, float t, ivec3 cell, int distance, vec3 inverseDirection) {
    const float hair = 1e-3;
    const float outside = 1e5;
    ivec3 count = textureSize(cellDistances, 0);
    ivec3 lower = cell + 1 - distance;
    ivec3 upper = cell + distance;
    vec3 lowerFace = mix(4.0 * vec3(lower) - hair, vec3(-outside), lessThanEqual(lower, ivec3(0)));
    vec3 upperFace = mix(4.0 * vec3(upper) + hair, vec3(outside), greaterThanEqual(upper, count));
    vec3 face = mix(lowerFace, upperFace, greaterThan(ray.direction, vec3(0.0)));
    vec3 exits = (face - ray.origin) * inverseDirection;
    return max(min(min(exits.x, exits.y), exits.z) - t, max(1e-3, 2e-7 * t));
}

// How far from t the ray can go without meeting an occupied macrocell; 0 if the cell at t is occupied itself.
float emptyUntil(Ray ray, float t, vec3 inverseDirection) {
    ivec3 cell = cellAt(at(ray, t));
    int distance = int(texelFetch(cellDistances, cell, 0).r);
    return distance > 0 ? leaveCells(ray, t, cell, distance, inverseDirection) : 0.0;
}

#if defined(BRICK_RANGES) && !defined(TRICUBIC) && !defined(FILLED) // whose samples reach beyond a cell's
#define GOES_BY_BRICKS
#ifdef DATA_BY_FUNCTION
bool mayBeVisible(float lo, float hi); // classification.glsl
bool mayDataBeSeen(vec2 values) { return mayBeVisible(values.x, values.y); }
#else
bool mayDataBeSeen(vec2 values) {
    return values.y >= range.x - valueScale.w && values.x <= limits.x + limits.w;
}
#endif

// How far from t the ray goes until it has left a box of the sampled level's voxel space; what lies outside
// of the grid belongs to the boxes at its border.
float leaveBox(Ray ray, float t, vec3 lower, vec3 upper, vec3 inverseDirection) {
    const float hair = 3e-4; // see leaveCells()
    const float outside = 1e5;
    vec3 lowerFace = (lower - levelOrigin.xyz) / levelScale.xyz - hair;
    vec3 upperFace = (upper - levelOrigin.xyz) / levelScale.xyz + hair;
    lowerFace = mix(lowerFace, vec3(-outside), lessThanEqual(lower, vec3(0.0)));
    upperFace = mix(upperFace, vec3(outside), greaterThanEqual(upper, vec3(levelDims.xyz - 1)));
    vec3 face = mix(lowerFace, upperFace, greaterThan(ray.direction, vec3(0.0)));
    vec3 exits = (face - ray.origin) * inverseDirection;
    return max(min(min(exits.x, exits.y), exits.z) - t, max(1e-3, 2e-7 * t));
}

// How far from t the ray can go without meeting data that may be seen, by what is known of bricks; 0 if it
// may meet some at once.
float unseenInBricks(Ray ray, float t, vec3 inverseDirection) {
    vec3 q = clamp(levelFromVoxel(at(ray, t)), vec3(0.0), vec3(levelDims.xyz - 1));
    ivec3 brick = ivec3(q * levelOrigin.w);
    Held held = heldByBrick(brick);
    bool isUnseen = !mayDataBeSeen(held.range);
    bool asksCell = !isUnseen && brickCells.w > 0;
    while (asksCell) {
        held = heldByCell(brick, q);
        isUnseen = !mayDataBeSeen(held.range);
        asksCell = false;
    }
    return isUnseen ? leaveBox(ray, t, held.lower, held.upper, inverseDirection) : 0.0;
}
#endif

// How far from t the ray can go without meeting data that may be seen.
float noDataUntil(Ray ray, float t, vec3 inverseDirection) {
    float skip = emptyUntil(ray, t, inverseDirection);
#ifdef GOES_BY_BRICKS
    bool asksBricks = skip == 0.0;
    while (asksBricks) {
        skip = unseenInBricks(ray, t, inverseDirection);
        asksBricks = false;
    }
#endif
    return skip;
}

#if defined(SEGMENT_CELLS) || defined(DATA_BESIDE_SEGMENTS)
// How far from t the ray can go without meeting a cell where segments may be; 0 if the one at t is one.
float noSegmentUntil(Ray ray, float t, vec3 inverseDirection) {
    ivec3 cell = cellAt(at(ray, t));
    int distance = int(texelFetch(segmentCellDistances, cell, 0).r);
    return distance > 0 ? leaveCells(ray, t, cell, distance, inverseDirection) : 0.0;
}
#endif

// How far from t the ray can go without meeting what surfaces are looked for in. SEGMENT_CELLS: segments
// alone. DATA_ONLY: the data alone. DATA_BESIDE_SEGMENTS: one or the other.
float noSurfaceUntil(Ray ray, float t, vec3 inverseDirection) {
#if defined(SEGMENT_CELLS)
    return noSegmentUntil(ray, t, inverseDirection);
#elif defined(DATA_ONLY)
    return noDataUntil(ray, t, inverseDirection);
#elif defined(DATA_BESIDE_SEGMENTS) && defined(GOES_BY_BRICKS)
    float skip = emptyUntil(ray, t, inverseDirection);
    bool asksBricks = skip == 0.0;
    while (asksBricks) {
        skip = min(noSegmentUntil(ray, t, inverseDirection), noDataUntil(ray, t, inverseDirection));
        asksBricks = false;
    }
    return skip;
#else
    return emptyUntil(ray, t, inverseDirection);
#endif
}

// The first place at or after t where samples `dt` apart lie: the same for all rays and however a ray got
// there, so that skipping what cannot be seen changes nothing. `jitter` in [0, 1) shifts them.
float nextSample(float t, float dt, float jitter) { return (ceil(t / dt - jitter) + jitter) * dt; }

// A component of zero becomes a tiny one of the same sign as `greaterThan(direction, 0)` assumes.
vec3 safeInverse(vec3 d) {
    vec3 tiny = mix(vec3(-1e-12), vec3(1e-12), greaterThan(d, vec3(0.0)));
    return 1.0 / mix(d, tiny, lessThan(abs(d), vec3(1e-12)));
}
