// The first visible surface along a ray: what is seen, picked and cut.
// CONTENT chooses what counts as content: 0 data in the displayed range, 1 segmentation, 2 either of the two, 3 what the
// transfer function makes opaque enough to be touched. Include "render/shaders/rays.glsl" first, for 3 also
// "render/shaders/classification.glsl".

// >= 0 where there is content to see; continuous along each of its parts, so it can be bisected.
float contentAt(vec3 p) {
#if CONTENT == 0
    return insideRange(dataAt(p));
#elif CONTENT == 1
    return segmentationAt(p) - 0.5;
#elif CONTENT == 3
#if TF_KIND == 0
    return classify(dataAt(p), 0.0).a - lightingOfFunction.z;
#else
    return classify(dataAt(p), length(dataGradient(p))).a - lightingOfFunction.z;
#endif
#else
    return max(insideRange(dataAt(p)), segmentationAt(p) - 0.5);
#endif
}

// >= 0 on the visible side of the sculpture.
float sideAt(vec3 p) {
#ifdef SCULPTED
    return visibleSide(sculptureAt(p));
#else
    return 1e30;
#endif
}

// >= 0 where something is visible.
float visibility(vec3 p) { return min(contentAt(p), sideAt(p)); }

struct Hit {
    bool found;
    float t;      // steps along the ray
    vec3 voxel;   // where
    vec3 normal;  // world, unit, facing the viewer
    bool isCut;   // on a cut face: the sculpture's 0.5 level, or the grid's border
    bool isSegment;
};

#ifdef SCULPTED
// Between two places of which neither is visible, content may begin before the visible side ends, or the side begin before
// the content ends: a sliver thinner than a step, along the edge of a cut. Where it is, as a part of the way; -1: nowhere.
// x content, y side, as in contentAt and sideAt, taken as linear between the places.
float sliverBetween(vec2 before, vec2 after) {
    vec2 crossing = before / (before - after);
    bool contentBegins = before.x < 0.0 && after.x >= 0.0 && before.y >= 0.0 && after.y < 0.0;
    bool sideBegins = before.x >= 0.0 && after.x < 0.0 && before.y < 0.0 && after.y >= 0.0;
    bool isThere = (contentBegins && crossing.x <= crossing.y) || (sideBegins && crossing.y <= crossing.x);
    return isThere ? 0.5 * (crossing.x + crossing.y) : -1.0;
}
#endif

// First t at which something is visible, or tEnd and beyond. The loop only looks; shading comes after it.
// Several samples a turn: on a software renderer the turn itself costs as much as they do.
float firstVisible(Ray ray, float jitter) {
    const int batch = 4;
    vec3 inverseDirection = safeInverse(ray.direction);
    float t = nextSample(ray.tBegin, kDt, jitter);
    bool found = false;
    while (t < ray.tEnd && !found) {
        float skip = emptyUntil(ray, t, inverseDirection);
        while (skip > 0.0 && t < ray.tEnd) {
            t = nextSample(t + skip, kDt, jitter);
            skip = emptyUntil(ray, t, inverseDirection);
        }
        float first = float(batch);
        for (int i = batch - 1; i >= 0; --i) {
            first = visibility(at(ray, t + float(i) * kDt)) >= 0.0 ? float(i) : first;
        }
        found = first < float(batch);
        t += first * kDt;
    }
    return t;
}

// Moves a visible t back to the surface: an invisible and a visible place, almost together, around it. False position,
// kept off the ends so that a jump (the edge of non-finite voxels) is closed in on too. Content is in the volume's unit,
// the side a part of one: scaled to be alike, or the smaller unit would bend what is straight.
vec2 refine(Ray ray, float t) {
    float outside = max(t - kDt, ray.tNear);
    float inside = t;
    float contentOutside = contentAt(at(ray, outside));
    float contentInside = contentAt(at(ray, inside));
    float scale = 1.0 / max(max(abs(contentOutside), abs(contentInside)), 1e-30);
    float below = min(contentOutside * scale, sideAt(at(ray, outside)));
    float above = min(contentInside * scale, sideAt(at(ray, inside)));
    if (below >= 0.0) {
        return vec2(outside, outside); // visible from the start: the ray enters the box inside
    }
    for (int i = 0; i < 3; ++i) {
        float middle = mix(outside, inside, clamp(below / (below - above), 0.05, 0.95));
        float there = min(contentAt(at(ray, middle)) * scale, sideAt(at(ray, middle)));
        bool seen = there >= 0.0;
        inside = seen ? middle : inside;
        above = seen ? there : above;
        outside = seen ? outside : middle;
        below = seen ? below : there;
    }
    return vec2(outside, mix(outside, inside, below / (below - above)));
}

// Normal of the box face that the point is nearest to, facing out.
vec3 boxNormal(vec3 p) {
    vec3 centred = (p - 0.5 * vec3(dims.xyz - 1)) / (0.5 * vec3(dims.xyz));
    vec3 a = abs(centred);
    vec3 n = a.x >= a.y && a.x >= a.z ? vec3(sign(centred.x), 0.0, 0.0)
             : a.y >= a.z            ? vec3(0.0, sign(centred.y), 0.0)
                                     : vec3(0.0, 0.0, sign(centred.z));
    return normalize(transpose(mat3(voxelFromWorld)) * n);
}

// A direction of zero length stays harmless: seen face on.
vec3 facing(vec3 gradient, vec3 towardsViewer) {
    float l = length(gradient);
    vec3 n = l > 1e-12 ? gradient / l : towardsViewer;
    return dot(n, towardsViewer) < 0.0 ? -n : n;
}

// `jitter` in [0, 1) shifts the samples by that part of a step: what they all miss then differs from ray to ray.
Hit findSurface(Ray ray, float jitter) {
    Hit hit;
    hit.t = firstVisible(ray, jitter);
    hit.found = hit.t < ray.tEnd;
    hit.isCut = false;
    hit.isSegment = false;
    hit.normal = -ray.world;
    hit.voxel = vec3(0.0);
    if (!hit.found) {
        return hit;
    }
    vec2 bracket = refine(ray, hit.t);
    hit.t = bracket.y;
    hit.voxel = at(ray, hit.t);
    vec3 before = at(ray, bracket.x);
#if CONTENT == 1 || CONTENT == 2
    // The data's surface and the segment's rarely agree to the voxel: what lies just behind is tinted too.
    // Seeds lie up to a voxel behind the surface that they were drawn on.
    float nearby = segmentationAt(hit.voxel);
    for (int i = 1; i <= 3; ++i) {
        nearby = max(nearby, segmentationAt(at(ray, hit.t + 0.5 * float(i))));
    }
    hit.isSegment = nearby >= 0.5;
#endif
    bool atBorder = bracket.y - ray.tNear < 1e-3 && ray.tNear > 0.0;
    vec3 gradient = atBorder ? boxNormal(hit.voxel) : dataGradient(hit.voxel);
#if CONTENT == 1 || CONTENT == 2
    if (segmentationAt(hit.voxel) >= 0.5 && !atBorder) {
        gradient = segmentationGradient(hit.voxel);
    }
#endif
    hit.isCut = atBorder;
#ifdef SCULPTED
    if (visibleSide(sculptureAt(before)) < 0.0 && !atBorder) {
        hit.isCut = true;
        gradient = sculptureGradient(hit.voxel);
    }
#endif
    hit.normal = facing(gradient, -ray.world);
    return hit;
}
