// Volume mode: front-to-back compositing of what the transfer function shows (SPEC 3; Max 1995, "Optical models for direct
// volume rendering"). A ray is cut into pieces between neighbouring samples; a piece's colour and opacity come from the
// values at both of its ends (pre-integrated: Engel, Kraus, Ertl 2001, "High-quality pre-integrated volume rendering").
// Include "render/shaders/surface.glsl", "classification.glsl" and "shading.glsl" first. Defines: TF_KIND, SCULPTED.

const float kOpaque = 0.995;     // nothing behind this much opacity is looked at
const float kLitPiece = 0.12;    // one look at the light for pieces of together this opacity,
const int kLitPieces = 4;        // or for this many of them
const float kUnseen = 1.0 / 4096.0; // pieces below this opacity are not lit, only coloured

// The part of the way from one place to the next that lies on the visible side: x where it begins, y where it ends.
vec2 visiblePart(float sideBefore, float sideAfter) {
    float crossing = sideBefore / (sideBefore - sideAfter);
    bool begins = sideBefore < 0.0 && sideAfter >= 0.0;
    bool ends = sideBefore >= 0.0 && sideAfter < 0.0;
    vec2 part = begins ? vec2(crossing, 1.0) : ends ? vec2(0.0, crossing) : vec2(0.0, 1.0);
    return max(sideBefore, sideAfter) < 0.0 ? vec2(0.0) : part;
}

// Colour and opacity of a length of `steps` along which the value goes evenly from front to back.
vec4 colourOfPiece(float front, float back, vec3 middle, float steps) {
#if TF_KIND == 0
    vec4 c = classifySegment(front, back);
    float opacity = 1.0 - pow(1.0 - c.a, steps / segmentOfFunction.x);
    return vec4(c.rgb * (opacity / max(c.a, 1e-6)), opacity);
#else
    // Four looks along the piece: thin features of the function do not band.
    float gradient = length(dataGradient(middle));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        vec4 c = classify(mix(front, back, (float(i) + 0.5) * 0.25), gradient);
        float a = 1.0 - pow(1.0 - c.a, 0.25 * steps);
        sum += (1.0 - sum.a) * vec4(c.rgb * a, a);
    }
    return sum;
#endif
}

// What the light makes of an unlit colour at p.
vec3 litInVolume(vec4 colour, Ray ray, vec3 p, bool isCut) {
    vec3 gradient = dataGradient(p);
#ifdef SCULPTED
    for (bool turn = isCut; turn; turn = false) { // once, or never: lanes without a cut skip it together
        gradient = sculptureGradient(p);
    }
#endif
    vec3 normal = facing(gradient, -ray.world);
    vec3 albedo = colour.rgb / max(colour.a, 1e-6);
    vec3 light = lit(albedo, normal, -ray.world, viewRight.xyz, viewUp.xyz, -viewForward.xyz, lightingOfFunction.y);
    return mix(albedo, light, lightingOfFunction.x) * colour.a;
}

// Premultiplied linear colour and opacity of everything along the ray. Samples `dt` steps apart, on the lattice that
// `jitter` shifts; the grid's box is met exactly, its ends cut pieces short.
vec4 compositeAlong(Ray ray, float dt, float jitter) {
    vec3 inverseDirection = safeInverse(ray.direction);
    vec4 sum = vec4(0.0);
    float stop = ray.tEnd;
    float t = nextSample(ray.tBegin, dt, jitter) - dt; // where the next piece begins
    float from = clamp(t, ray.tNear, ray.tFar);
    float front = dataAt(at(ray, from));
#ifdef SCULPTED
    float sideBefore = sideAt(at(ray, from));
#endif
    while (t < stop) {
        // Look for the next pieces that show something; they are lit together.
        vec4 found = vec4(0.0);
        float weightedT = 0.0;
        bool isCut = false;
        int pieces = 0;
        while (t < stop && pieces < kLitPieces && found.a < kLitPiece) {
            // Over what is empty, to the last sample before its end: the piece that begins there leads out of it.
            float skip = emptyUntil(ray, from, inverseDirection);
            float tAfter = max(t + dt, nextSample(t + skip, dt, jitter) - dt);
            bool isPiece = tAfter < t + 1.5 * dt;
            float to = clamp(tAfter, ray.tNear, ray.tFar);
            vec3 after = at(ray, to);
            float back = dataAt(after);
            vec2 part = vec2(0.0, 1.0);
#ifdef SCULPTED
            float sideAfter = sideAt(after);
            part = visiblePart(sideBefore, sideAfter);
            sideBefore = sideAfter;
#endif
            float steps = isPiece ? (part.y - part.x) * (to - from) : 0.0;
            float middle = mix(from, to, 0.5 * (part.x + part.y));
            vec4 c = colourOfPiece(mix(front, back, part.x), mix(front, back, part.y), at(ray, middle), steps);
            isCut = isCut || (c.a > 0.0 && part.x > 0.0);
            weightedT += (1.0 - found.a) * c.a * middle;
            found += (1.0 - found.a) * c;
            pieces += found.a > 0.0 ? 1 : 0;
            t = tAfter;
            from = to;
            front = back;
        }
        for (bool turn = found.a > kUnseen; turn; turn = false) {
            found.rgb = litInVolume(found, ray, at(ray, weightedT / found.a), isCut);
        }
        sum += (1.0 - sum.a) * found;
        stop = sum.a > kOpaque ? -1.0 : stop;
    }
    return sum;
}
