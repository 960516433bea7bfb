// The greatest visible value along a ray (MIP), and where it is.
// Bindings: texture 4 value ranges of the macrocells (rg). Include "render/shaders/surface.glsl" first.

#include "render/shaders/bindings.glsl"
layout(binding = kDataCellRangesTexture) uniform sampler3D dataCellRanges;

struct Greatest {
    float value; // -1e30 when nothing is visible
    float t;
};

// How far the ray can go from t without meeting a visible value above `greatest`; 0 if it may meet one at
// once.
float hopelessUntil(Ray ray, float t, float greatest, vec3 inverseDirection) {
    ivec3 cell = cellAt(at(ray, t));
    int distance = int(texelFetch(cellDistances, cell, 0).r);
    float top = min(texelFetch(dataCellRanges, cell, 0).g, limits.x + limits.w);
    return distance > 0 || top <= greatest ? leaveCells(ray, t, cell, max(distance, 1), inverseDirection)
                                           : 0.0;
}

// Samples `dt` steps apart.
Greatest findGreatest(Ray ray, float dt) {
    vec3 inverseDirection = safeInverse(ray.direction);
    Greatest best = Greatest(-1e30, ray.tNear);
    float t = nextSample(ray.tBegin, dt, 0.5);
    while (t < ray.tEnd) {
        float skip = hopelessUntil(ray, t, best.value, inverseDirection);
        while (skip > 0.0 && t < ray.tEnd) {
            t = nextSample(t + skip, dt, 0.5);
            skip = hopelessUntil(ray, t, best.value, inverseDirection);
        }
        vec3 p = at(ray, t);
        float value = dataAt(p);
        bool better = t < ray.tEnd && visibility(p) >= 0.0 && value > best.value;
        best.value = better ? value : best.value;
        best.t = better ? t : best.t;
        t += dt;
    }
    return best;
}

#ifdef SLABS
layout(binding = kSlabListsTexture) uniform usamplerBuffer slabLists;

// Looks at the samples of one slab.
void searchSlab(Ray ray, Slabs slabs, int slab, float dt, inout Greatest best) {
    float number = slabs.first + float(slab * slabs.samples) + 0.5;
    float end = number + float(slabs.samples);
    float highest = limits.x + limits.w;
    do {
        for (int i = 0; i < kSlabBatch; ++i) {
            float t = (number + float(i)) * dt;
            vec3 p = at(ray, t);
            float value = dataAt(p);
            // Values below the range are not, but one that is close to it may be.
            bool counts = t >= ray.tBegin && t < ray.tEnd && value <= highest && sideAt(p) >= 0.0;
#ifndef SEGMENTS
            value = min(value, range.y); // what lies above counts as the range's upper end
#endif
            bool better = counts && value > best.value;
            best.value = better ? value : best.value;
            best.t = better ? t : best.t;
        }
        number += float(kSlabBatch);
    } while (number < end);
}

// How close to the lower end of what is visible the exact value of a sample decides whether it is, for a
// texture unit may round it to either side.
float closeToEnd() { return 32.0 * max(valueScale.w, limits.w) + 1e-4 * rangeWidth(); }

// As findGreatest, for the ray of a pixel: its beam's slabs in order, and only those that may hold more.
Greatest findGreatestInSlabs(Ray ray, float dt) {
    Slabs slabs = slabsAlong(ray.beamEnds, dt);
    float lowest = range.x - max(2.0 * valueScale.w, 1e-30); // a little below what counts
    Greatest best = Greatest(-1e30, ray.tNear);
    int list = placeOfList(ray.beam);
    int place = 0;
    uint entry = texelFetch(slabLists, list).r;
    bool isOver;
    do {
        searchSlab(ray, slabs, int(entry >> 8), dt, best);
        uint code = best.value > lowest ? codeOfGreatest(best.value) : 0u;
#ifdef SEGMENTS
        code = min(
            code, 254u); // the very greatest, of all values above the range too: its place says what tints it
#endif
        uint bucket = bucketOf(code + 1u);
        do {
            ++place;
            entry = texelFetch(slabLists, list + place).r;
            isOver = (entry & 0xffu) == 0u || bucketOf(entry & 0xffu) < bucket;
        } while ((entry & 0xffu) <= code && !isOver);
    } while (!isOver);
    if (abs(range.x - best.value) < closeToEnd()) {
        best.value = exactDataAt(at(ray, best.t));
    }
    best.value = best.value > lowest ? min(best.value, range.y) : -1e30;
    return best;
}

#if defined(TF_KIND) || defined(SEGMENTS)
// Where the value is greatest among the sample that was found and those beside it, on the first of them:
// where two voxels are alike it hangs on a texture unit's rounding which of the samples between them and
// around them it finds the greatest.
const int kBeside = 4; // two voxels in samples that lie half a voxel apart
float settled(Ray ray, Greatest found, float dt) {
    float highest = limits.x + limits.w;
    float number = floor(found.t / dt);
    vec2 most = vec2(-1e30, found.t);
    for (int i = -kBeside; i <= kBeside && found.value > -1e30; ++i) {
        float t = (number + 0.5 + float(i)) * dt;
        vec3 p = at(ray, t);
        float value = exactDataAt(p);
        bool counts = t >= ray.tBegin && t < ray.tEnd && value <= highest && exactSideAt(p) >= 0.0;
        most = counts && value > most.x ? vec2(value, t) : most;
    }
    return most.y;
}
#endif
#endif
