// Volume mode: front-to-back compositing of what the transfer function shows (doc/behaviour.md, "Pictures";
// Max 1995, "Optical models for direct volume rendering"). A ray is cut into pieces between neighbouring
// samples, along which the value is taken to go evenly; the transfer function counts with all that it has
// between their ends, so that what is thin in it is not missed. Include "render/shaders/surface.glsl",
// "classification.glsl" and "shading.glsl" first. Defines: TF_KIND, SCULPTED.

const float kOpaque = 0.99; // nothing behind this much opacity is looked at
// Behind this much opacity pieces are twice as long, for little is left of what they miss. Where gradients
// count, never: they are asked for at every other piece, as far apart as they may be.
#if TF_KIND == 0
const float kCoarse = 0.8;
#else
const float kCoarse = 1.0;
#endif
const int kPieces = 8; // several a turn: on a software renderer the turn itself costs as much as four of
                       // them. What a turn finds is lit together; turns begin at every eighth sample, so that
                       // this does not depend on what was skipped, but at another one in each pixel: else
                       // surfaces that lie aslant would show terraces
const int kColoursAPiece = 2;       // of a transfer function of gradients, that are mixed
const float kUnseen = 1.0 / 2048.0; // pieces that make less of the pixel than this are not lit, only coloured

#ifdef MARKS
const float kMarkedInVolume = 0.5; // of steps: how sharp edges of marks are where nothing has a surface
#endif

// The part of the way from one place to the next that lies on the visible side: x where it begins, y where it
// ends.
vec2 visiblePart(float sideBefore, float sideAfter) {
    float crossing = sideBefore / (sideBefore - sideAfter);
    bool begins = sideBefore < 0.0 && sideAfter >= 0.0;
    bool ends = sideBefore >= 0.0 && sideAfter < 0.0;
    vec2 part = begins ? vec2(crossing, 1.0) : ends ? vec2(0.0, crossing) : vec2(0.0, 1.0);
    return max(sideBefore, sideAfter) < 0.0 ? vec2(0.0) : part;
}

// Opacity of `part` of a length whose opacity is `a`: 1 - (1 - a)^part to the third order, exact for 0, 1
// and 2.
float opacityOfPart(float a, float part) {
    return a * part * (1.0 + (1.0 - part) * a * (0.5 + (2.0 - part) * a / 6.0));
}

// What the function goes by at p: the value, or where that lies in the function's tables.
float seenValue(vec3 p) {
#if TF_KIND == 0
    return columnOf(dataAt(p));
#else
    return dataAt(p);
#endif
}

// Colour (premultiplied) and opacity of a length of `steps`, at most `dt`, along which the value goes evenly
// from front to back. `gradient` counts for functions that go by it.
vec4 colourOfPiece(float front, float back, float gradient, float steps, float dt) {
#if TF_KIND == 0
    vec4 c = classifySpan(front, back);
    return opacityOfPart(c.a, 2.0 * steps) * vec4(c.rgb, 1.0);
#else
    vec4 sum = vec4(0.0);
    for (int i = 0; i < kColoursAPiece; ++i) {
        vec4 c = classify(mix(front, back, (float(i) + 0.5) / float(kColoursAPiece)), gradient);
        // Opacities are per step; here for half a step or, in drafts, a whole one, shared by the colours.
#ifdef FINER
        float a = 1.0 - pow(1.0 - c.a, steps / float(kColoursAPiece)); // pieces are of any length
#else
        float a = dt > 0.75 ? c.a : 1.0 - sqrt(1.0 - c.a);
        a = opacityOfPart(a, steps / (dt * float(kColoursAPiece)));
#endif
        sum += (1.0 - sum.a) * a * vec4(c.rgb, 1.0);
    }
    return sum;
#endif
}

// What the light makes of an unlit colour at p.
vec3 litInVolume(vec4 colour, Ray ray, vec3 p, bool isCut) {
    vec3 gradient = dataGradient(p);
#ifdef SCULPTED
    if (isCut) {
        gradient = sculptureGradient(p);
    }
#endif
#ifdef FILLED
    bool isFilled = filledByAny(p) >= 0.45; // a little outside too: what is found is a mean of places
    while (isFilled) {
        gradient = abs(dataAt(p) - scanAt(p)) * anyFillGradient(p);
        isFilled = false;
    }
#endif
    // Where values hardly change there is no surface, only noise: it glows by itself.
    float surface = 1.0;
#if TF_KIND != 1
    surface = smoothstep(0.002, 0.012, length(gradient) * spacing.w * valueAxis.x);
#endif
    surface = isCut ? 1.0 : surface;
    vec3 normal = facing(gradient, -ray.world);
    vec3 albedo = colour.rgb / max(colour.a, 1e-6);
#ifdef LIT
    vec2 reaching = cheapLight(p, normal);
#else
    vec2 reaching = vec2(1.0);
#endif
    vec3 light = lit(albedo, normal, -ray.world, viewRight.xyz, viewUp.xyz, -viewForward.xyz,
                     lightingOfFunction.y, reaching);
    return mix(albedo, light, lightingOfFunction.x * surface) * colour.a;
}

// How far a ray has come, and what it has found since the light was last asked.
struct Walk {
    float number;   // of the sample where the next piece begins, counted from the eye
    float from;     // the same within the grid's box
    float front;    // what the function goes by there
    float side;     // and whether it is on the visible side
    float gradient; // where this piece and the one beside it meet
#ifdef SEGMENTS
    float clear; // and whether it is clear of segments, in which nothing of the data is seen
#endif
    vec4 found; // premultiplied, unlit
    float weightedT;
    bool isCut; // something found begins where the sculpture was cut
};

#ifdef SEGMENTS
// >= 0 where what the function shows is to be seen beside segments: material that lies in one is.
float clearAt(vec3 p) {
    float clear = clearOfSegments(membershipsAt(p));
#ifdef FILLED
    clear = max(clear, filledBySeen(p) - 0.5);
#endif
    return clear;
}
#endif

// One piece, up to the sample of that number; `stride`: how many samples it goes over. Gradient magnitudes
// change little from piece to piece: two pieces share the one where they meet, the end of the first.
void addPiece(inout Walk walk, Ray ray, float numberAfter, float stride, float dt, float jitter,
              bool isFirst) {
    bool isPiece = numberAfter < walk.number + stride + 0.5; // else a way over nothing
    float to = clamp((numberAfter + jitter) * dt, ray.tNear, ray.tFar);
    vec3 after = at(ray, to);
    float back = seenValue(after);
    vec2 part = vec2(0.0, 1.0);
#ifdef SCULPTED
    float sideAfter = sideAt(after);
    part = visiblePart(walk.side, sideAfter);
    walk.side = sideAfter;
#endif
    float cutAt = part.x;
#ifdef SEGMENTS
    float clearAfter = clearAt(after);
    vec2 clearPart = visiblePart(walk.clear, clearAfter);
    walk.clear = clearAfter;
    part = vec2(max(part.x, clearPart.x), min(part.y, clearPart.y));
    part.y = max(part.x, part.y);
#endif
    float steps = isPiece ? (part.y - part.x) * (to - walk.from) : 0.0;
    float middle = mix(walk.from, to, 0.5 * (part.x + part.y));
#if TF_KIND != 0
    if (isFirst) {
        walk.gradient = gradientAt(after);
    }
#endif
    vec4 c =
        colourOfPiece(mix(walk.front, back, part.x), mix(walk.front, back, part.y), walk.gradient, steps, dt);
    walk.isCut = walk.isCut || (c.a > 0.0 && cutAt > 0.0 && cutAt == part.x);
    walk.weightedT += (1.0 - walk.found.a) * c.a * middle;
    walk.found += (1.0 - walk.found.a) * c;
    walk.number = numberAfter;
    walk.from = to;
    walk.front = back;
}

#ifdef MARKS
// Ink on what has been found: it takes the ink's colour, and hides what is behind as ink does, however
// transparent it is itself.
void ink(inout Walk walk, vec4 mark) {
    const float density = 12.0; // of what is inked, in what it was
    float opacity = 1.0 - pow(1.0 - walk.found.a, 1.0 + density * mark.a);
    vec3 colour = mix(walk.found.rgb / walk.found.a, mark.rgb, mark.a);
    walk.weightedT *= opacity / walk.found.a;
    walk.found = opacity * vec4(colour, 1.0);
}
#endif

// Premultiplied linear colour and opacity of everything along the ray. Samples `dt` steps apart, on the
// lattice that `jitter` shifts; the grid's box is met exactly, its ends cut pieces short. `depth`: mean t of
// what is seen.
vec4 compositeAlong(Ray ray, float dt, float jitter, out float depth) {
    vec3 inverseDirection = safeInverse(ray.direction);
    vec4 sum = vec4(0.0);
    depth = 0.0;
    const float pieces = float(kPieces);
    float stop = ray.tEnd / dt - jitter; // the number of a sample that is too far
    Walk walk;
    // The number of a sample where a turn begins; even, as the pairs are that share a gradient.
    float phase = 2.0 * floor(0.5 * pieces * fract(61.7 * jitter));
    walk.number = pieces * floor((ray.tBegin / dt - jitter - phase) / pieces) + phase - 1.0;
    walk.from = clamp((walk.number + jitter) * dt, ray.tNear, ray.tFar);
    walk.front = seenValue(at(ray, walk.from));
    walk.side = sideAt(at(ray, walk.from));
    walk.gradient = 0.0;
#ifdef SEGMENTS
    walk.clear = clearAt(at(ray, walk.from));
#endif
    do {
        // Look for the next turn that shows something.
        walk.found = vec4(0.0);
        walk.weightedT = 0.0;
        walk.isCut = false;
        float stride = sum.a > kCoarse && dt < 0.75 ? 2.0 : 1.0; // in drafts pieces are long enough
        do {
            // Over what is empty, whole ways of it: rays that are through wait here for those beside them,
            // which costs less than looking at pieces of nothing with them. A turn's first piece leads to the
            // last eighth sample before the end of that.
            float begin = walk.from;
            float skip;
            do {
                skip = noDataUntil(ray, begin, inverseDirection);
                begin += skip;
            } while (skip > 0.0 && begin < ray.tEnd);
            float last = ceil(begin / dt - jitter) - 1.0;
            float turn = max(floor((walk.number - phase) / pieces) + 1.0, floor((last - phase) / pieces));
            addPiece(walk, ray, pieces * turn + phase, stride, dt, jitter, true);
            for (int i = 1; i < kPieces; ++i) {
                addPiece(walk, ray, walk.number + stride, stride, dt, jitter, i % 2 == 0);
            }
        } while (walk.number < stop && walk.found.a == 0.0);
        if (walk.found.a * (1.0 - sum.a) > kUnseen) {
#ifdef MARKS
            ink(walk, markAt(at(ray, walk.weightedT / walk.found.a), kMarkedInVolume));
#endif
            walk.found.rgb = litInVolume(walk.found, ray, at(ray, walk.weightedT / walk.found.a), walk.isCut);
        }
        depth += (1.0 - sum.a) * walk.weightedT;
        sum += (1.0 - sum.a) * walk.found;
        stop = sum.a > kOpaque ? -1e30 : stop;
    } while (walk.number < stop);
    depth /= max(sum.a, 1e-6);
    return sum;
}
