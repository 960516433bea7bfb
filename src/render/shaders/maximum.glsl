// The greatest visible value along a ray (MIP), and where it is.
// Bindings: texture 4 value ranges of the macrocells (rg). Include "render/shaders/surface.glsl" first.

layout(binding = 4) uniform sampler3D dataCellRanges;

struct Greatest {
    float value; // -1e30 when nothing is visible
    float t;
};

// How far the ray can go from t without meeting a visible value above `greatest`; 0 if it may meet one at once.
float hopelessUntil(Ray ray, float t, float greatest, vec3 inverseDirection) {
    ivec3 cell = cellAt(at(ray, t));
    int distance = int(texelFetch(cellDistances, cell, 0).r);
    float top = min(texelFetch(dataCellRanges, cell, 0).g, range.y + valueScale.w);
    return distance > 0 || top <= greatest ? leaveCells(ray, t, cell, max(distance, 1), inverseDirection) : 0.0;
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
