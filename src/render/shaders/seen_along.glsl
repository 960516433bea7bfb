// What one ray sees, mode by mode. MODE, CONTENT, SCULPTED, TF_KIND: see cast_rays.comp, which includes this.
// LIT: ambient occlusion and soft shadows. Include "render/shaders/seen.glsl" first.

const vec3 kSurfaceColour = vec3(0.72, 0.57, 0.45); // linear: the ivory of anatomical plates

#ifdef TF_KIND
// The transfer function's colour of a value at p, linear.
vec3 functionColour(float value, vec3 p) {
#if TF_KIND == 0
    return classify(value, 0.0).rgb;
#else
    return classify(value, gradientAt(p)).rgb;
#endif
}
#endif

// The colour of the data's own surface. It shows one value, the displayed range's end, so a transfer function
// is asked for what lies a step behind it.
vec3 surfaceColour(Hit hit, Ray ray) {
#ifdef TF_KIND
    vec3 behind = hit.voxel + fineStep() * ray.direction;
    return functionColour(dataAt(behind), behind);
#else
    return kSurfaceColour;
#endif
}

// How much of the key light (x) and of the light from all around (y) reaches a hit.
vec2 lightAt(Hit hit) {
#ifdef LIT
    return vec2(lightReaching(hit.voxel, hit.normal), ambientAt(hit.voxel, hit.normal));
#else
    return vec2(1.0);
#endif
}

float greyOf(float value) { return clamp((value - range.z) / max(range.w - range.z, 1e-20), 0.0, 1.0); }

#ifdef MARKS
uniform vec2 pixelWidth; // in steps: at the eye, and how much more for each step of t
#endif

// The display colour of a hit; `segmentColour` is its segment's, if it has one.
vec3 shadeHit(Hit hit, Ray ray, vec3 segmentColour) {
    vec3 right = viewRight.xyz;
    vec3 up = viewUp.xyz;
    vec2 reaching = lightAt(hit);
    vec3 albedo = hit.isSegment ? segmentColour : surfaceColour(hit, ray);
#ifdef FILL_IS_CONTENT
    vec3 added = materials[materialAt(hit.voxel, hit.isFill)].rgb;
    albedo = hit.isFill ? added : albedo;
#endif
#ifdef MARKS
    vec4 mark = markAt(hit.voxel, pixelWidth.x + pixelWidth.y * hit.t);
    albedo = mix(albedo, mark.rgb, mark.a);
#endif
    vec3 surface =
        displayFromLinear(lit(albedo, hit.normal, -ray.world, right, up, -viewForward.xyz, 0.12, reaching));
    // A section shows the data's own values: grey, shaded just enough to tell its shape.
#ifdef TF_KIND
    vec3 section = functionColour(sectionValueAt(hit.voxel), hit.voxel);
#else
    vec3 section =
        linearFromDisplay(vec3(0.15 + 0.85 * greyOf(sectionValueAt(hit.voxel))) * vec3(1.0, 0.985, 0.96));
#endif
    section = hit.isSegment ? mix(section, segmentColour, 0.55) : section;
#ifdef MARKS
    section = mix(section, mark.rgb, mark.a);
#endif
    vec3 key = normalize(-0.45 * right + 0.65 * up - 0.75 * viewForward.xyz);
    section = displayFromLinear(section *
                                (0.55 * reaching.y + 0.45 * reaching.x * max(dot(hit.cutNormal, key), 0.0)));
    return mix(surface, section, hit.cutShare);
}

#if MODE == 3 || MODE == 4 || (MODE == 5 && defined(SEGMENTS))
// The colour of the segment that was hit.
vec4 segmentColourOf(Hit hit, bool translucent) {
    return segmentColourAt(hit.inSegment, -hit.normal, translucent, hit.found && hit.isSegment);
}

// Display colour of a hit in a picture with segments.
vec3 shadeOpaque(Hit hit, Ray ray) { return shadeHit(hit, ray, segmentColourOf(hit, false).rgb); }
#elif MODE == 0
vec3 shadeOpaque(Hit hit, Ray ray) { return shadeHit(hit, ray, vec3(0.0)); }
#endif

#ifdef TRANSLUCENT
// Premultiplied display colour and opacity of glass; nothing where there is none.
vec4 shadeGlass(Hit hit, Ray ray) {
    vec4 colour = segmentColourOf(hit, true);
    float opacity = opacityOfGlass(colour.a, dot(hit.normal, -ray.world), hit.isCut);
    return hit.found ? opacity * vec4(shadeHit(hit, ray, colour.rgb), 1.0) : vec4(0.0);
}
#endif

#if defined(SEGMENTS) && (MODE == 1 || MODE == 2)
// The linear colour of what a ray goes through: white, or black in an inverted picture, or what the transfer
// function says.
vec3 colourInRay(float value, vec3 p) {
#ifdef TF_KIND
    return functionColour(value, p);
#else
    return vec3(isInverted != 0 ? 0.0 : 1.0);
#endif
}

vec3 tinted(vec3 colour, vec3 p) {
    vec4 tint = tintAt(p);
    return mix(colour, tint.rgb, tint.a);
}
#endif

#if MODE == 2 || MODE == 3
// Integral of (value - lo) / (hi - lo) over the visible part of the ray up to tEnd, in steps: a. The transfer
// function's colours, each weighted by that: rgb.
vec4 integralAlong(Ray ray, float tEnd) {
    const int batch = 8; // samples a turn: see surface.glsl
    vec3 inverseDirection = safeInverse(ray.direction);
    vec4 sum = vec4(0.0);
    float t = nextSample(ray.tBegin, lattice.x, lattice.y);
    do {
        // Whole steps only, so that the samples stay evenly spaced across a skip.
        float skip;
        do {
            skip = noDataUntil(ray, t, inverseDirection);
            t = skip > 0.0 ? nextSample(t + skip, lattice.x, lattice.y) : t;
        } while (skip > 0.0 && t < tEnd);
        for (int i = 0; i < batch; ++i) {
            float here = t + float(i) * lattice.x;
            vec3 p = at(ray, here);
            float value = dataAt(p);
            bool counts = here < tEnd && insideRange(value) >= 0.0 && sideAt(p) >= 0.0;
            value = min(value, range.y); // what lies above counts as the range's upper end
            float part = counts ? partOfRange(value) : 0.0;
            sum.a += part;
#if defined(SEGMENTS)
            sum.rgb += part * tinted(colourInRay(value, p), p);
#elif defined(TF_KIND)
            sum.rgb += part * functionColour(value, p);
#endif
        }
        t += float(batch) * lattice.x;
    } while (t < tEnd);
    return sum * lattice.x;
}
#endif

#if MODE == 5 && defined(SEGMENTS)
// What the transfer function shows along a stretch of a ray; of a segment that is alone, nothing.
vec4 compositeData(Ray stretch, float jitter, out float depth) {
#ifdef PULLED
    depth = 0.0;
    return vec4(0.0);
#else
    return compositeAlong(stretch, sampleStep, jitter, depth);
#endif
}

// As compositeAlong(), with the surfaces of segments where they are: glass, what is behind it, and the first
// opaque one, behind which nothing is seen.
vec4 compositeWithSegments(Ray ray, float jitter, out float depth) {
    Hit hit = findSurface(ray, jitter);
    float end = hit.found ? hit.t : ray.tFar;
    vec4 sum = vec4(0.0);
    float weightedT = 0.0;
    Ray stretch = ray;
    stretch.tEnd = min(ray.tEnd, end);
    stretch.tFar = end;
    float tPart;
#ifdef TRANSLUCENT
    Hit glass = findGlass(ray, min(end, ray.tEnd), jitter);
    vec4 surface = shadeGlass(glass, ray);
    surface.rgb = surface.a > 0.0 ? linearFromDisplay(surface.rgb / surface.a) * surface.a : vec3(0.0);
    float middle = glass.found ? glass.t : end; // where there is none, nothing is left for the second stretch
    for (int i = 0; i < 2; ++i) {
        bool isBefore = i == 0;
        stretch.tNear = isBefore ? ray.tNear : middle;
        stretch.tFar = isBefore ? middle : end;
        stretch.tBegin = max(ray.tBegin, stretch.tNear);
        stretch.tEnd = min(ray.tEnd, stretch.tFar);
        vec4 part = compositeData(stretch, jitter, tPart);
        weightedT += (1.0 - sum.a) * part.a * tPart;
        sum += (1.0 - sum.a) * part;
        vec4 here = isBefore ? surface : vec4(0.0);
        weightedT += (1.0 - sum.a) * here.a * glass.t;
        sum += (1.0 - sum.a) * here;
    }
#else
    sum = compositeData(stretch, jitter, tPart);
    weightedT = sum.a * tPart;
#endif
    vec4 opaque = hit.found ? vec4(linearFromDisplay(shadeOpaque(hit, ray)), 1.0) : vec4(0.0);
    weightedT += (1.0 - sum.a) * opaque.a * hit.t;
    sum += (1.0 - sum.a) * opaque;
    depth = weightedT / max(sum.a, 1e-6);
    return sum;
}
#endif

// `scale`: steps of the whole picture in one of the ray's own.
Seen seenAlong(Ray ray, float jitter, float scale) {
    Seen seen = nothingSeen();
#if MODE == 0 || MODE == 3 || MODE == 4
    Ray searched = ray;
#if MODE == 3
    searched.tEnd = sceneFlags.x > 0.5 ? ray.tEnd : ray.tBegin; // no segmentation, no surface
#endif
    Hit hit = findSurface(searched, jitter);
    seen.front = hit.found ? vec4(shadeOpaque(hit, ray), hit.t * scale) : seen.front;
#ifdef TRANSLUCENT
    Hit glass = findGlass(searched, hit.found ? hit.t : ray.tEnd, jitter);
    seen.glass = shadeGlass(glass, ray);
    seen.glassDepth = glass.found ? glass.t * scale : kNothing;
#endif
#if MODE == 3 && !defined(PULLED)
    seen.behind = scale * integralAlong(ray, hit.found ? hit.t : ray.tEnd);
#endif
#elif MODE == 1
    Greatest greatest = findGreatestInSlabs(ray, sampleStep);
#if defined(SEGMENTS)
    vec3 brightest = at(ray, settled(ray, greatest, sampleStep));
    vec3 colour = tinted(colourInRay(greatest.value, brightest), brightest);
    seen.front.rgb = accumulatedFor(displayFromLinear(colour));
#elif defined(TF_KIND)
    seen.front.rgb = accumulatedFor(
        displayFromLinear(functionColour(greatest.value, at(ray, settled(ray, greatest, sampleStep)))));
#endif
    seen.front.a = greatest.value;
#elif MODE == 2
    seen.front = scale * integralAlong(ray, ray.tEnd);
#elif defined(SEGMENTS)
    seen.front = compositeWithSegments(ray, jitter, seen.behind.x);
    seen.behind.x *= scale;
#else
    seen.front = compositeAlong(ray, sampleStep, jitter, seen.behind.x);
    seen.behind.x *= scale;
#endif
    return seen;
}
