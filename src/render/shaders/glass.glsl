// Translucent segments: of all of them together, the first surface that a ray meets is drawn, as if it were
// made of thin glass. One surface and no more: a folded one would hide itself, and what lies in it, behind
// all of its folds. Include "render/shaders/surface.glsl" first.

// >= 0 where there is glass.
float glassAt(vec3 p) { return min(translucentAt(p) - 0.5, scanSideAt(p)); }

// Where it first is, before tEnd and a sample; `value` is glassAt there.
Crossing firstGlass(Ray ray, float tEnd, float jitter) {
    vec3 inverseDirection = safeInverse(ray.direction);
    Crossing crossing;
    crossing.t = nextSample(ray.tBegin, kDt, jitter);
    crossing.value = -1.0;
    do {
        float skip;
        do {
            skip = noSurfaceUntil(ray, crossing.t, inverseDirection);
            crossing.t = skip > 0.0 ? nextSample(crossing.t + skip, kDt, jitter) : crossing.t;
        } while (skip > 0.0 && crossing.t < tEnd + kDt);
        float first = float(kBatch);
        for (int i = kBatch - 1; i >= 0; --i) {
            float value = glassAt(at(ray, crossing.t + float(i) * kDt));
            first = value >= 0.0 ? float(i) : first;
            crossing.value = value >= 0.0 ? value : crossing.value;
        }
        crossing.t += first * kDt;
    } while (crossing.value < 0.0 && crossing.t < tEnd + kDt);
    crossing.before = max(crossing.t - kDt, ray.tNear);
    return crossing;
}

// Where the glass begins: an invisible place just before it, and the surface, by false position. Both are the
// same where the ray enters the grid's box in glass.
vec2 refineGlass(Ray ray, Crossing crossing) {
    vec2 outside = vec2(crossing.before, glassAt(at(ray, crossing.before)));
    vec2 inside = vec2(crossing.t, crossing.value);
    if (outside.y >= 0.0) {
        return outside.xx;
    }
    for (int i = 0; i < 3; ++i) {
        float margin = 0.05 * (inside.x - outside.x);
        float guess = mix(outside.x, inside.x, outside.y / (outside.y - inside.y));
        float place = clamp(guess, outside.x + margin, inside.x - margin);
        vec2 there = vec2(place, glassAt(at(ray, place)));
        bool seen = there.y >= 0.0;
        inside = seen ? there : inside;
        outside = seen ? outside : there;
    }
    return vec2(outside.x, mix(outside.x, inside.x, outside.y / (outside.y - inside.y)));
}

// The first surface of translucent segments along a ray, if it lies before tEnd.
Hit findGlass(Ray ray, float tEnd, float jitter) {
    Crossing crossing = firstGlass(ray, tEnd, jitter);
    vec2 bracket = refineGlass(ray, crossing);
    Hit hit;
    hit.t = bracket.y;
    hit.found = crossing.value >= 0.0 && hit.t < min(tEnd, ray.tEnd);
    hit.voxel = at(ray, hit.t);
    hit.isSegment = true;
    hit.inSegment = hit.voxel;
    hit.isFill = false;
    bool atBorder = bracket.y - ray.tNear < 1e-3 && ray.tNear > 0.0;
    hit.isCut = atBorder;
    vec3 outward = -translucentGradient(hit.voxel);
#ifdef SCULPTED
    if (visibleSide(sculptureAt(at(ray, bracket.x))) < 0.0 && !atBorder) {
        hit.isCut = true;
        outward = sculptureGradient(hit.voxel) * (dims.w == 1 ? 1.0 : -1.0);
    }
#endif
    hit.normal = outwards(atBorder ? boxNormal(hit.voxel) : outward, -ray.world);
    hit.cutShare = hit.isCut ? 1.0 : 0.0;
    hit.cutNormal = hit.normal;
    return hit;
}

// Opacity of glass that is `opacity` face on, seen at an angle of that cosine: its outline is denser, which
// shows its shape (Kay and Greenberg 1979, "Transparency for computer synthesized images"). Cut faces are
// not: they have no outline.
float opacityOfGlass(float opacity, float cosine, bool isCut) {
    float flatness = 1.0 - clamp(cosine, 0.0, 1.0);
    return isCut ? opacity : 1.0 - (1.0 - opacity) * (1.0 - flatness * flatness * flatness);
}
