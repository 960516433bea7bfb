// What is seen along a ray, what several parts show together, and the display colour of that. Include
// "field/shaders/scene.glsl" and "render/shaders/shading.glsl" first; declare `exposure`, `backgroundTop`
// and, in MIP and X-ray, `isInverted` (cast_rays.comp). MODE, TF_KIND, SEGMENTS, TRANSLUCENT: see there.

// Where a value lies in the displayed range, 0 to 1; a range of one value counts in full.
float partOfRange(float value) { return range.y > range.x ? (value - range.x) / (range.y - range.x) : 1.0; }

#if MODE == 1 || MODE == 2
// The display colour that is accumulated for one that is to be seen.
vec3 accumulatedFor(vec3 displayColour) { return isInverted != 0 ? 1.0 - displayColour : displayColour; }
#elif MODE == 3
vec3 accumulatedFor(vec3 displayColour) { return displayColour; }
#endif

#if MODE == 2 || MODE == 3
// The display colour of an integral: white, or what the transfer function and segments say.
vec3 integralColour(vec4 integral) {
#if defined(TF_KIND) || (defined(SEGMENTS) && MODE == 2)
    return accumulatedFor(displayFromLinear(integral.rgb / max(integral.a, 1e-6)));
#else
    return vec3(1.0);
#endif
}
#endif

// What a ray sees, before the background is put behind it.
struct Seen {
    // Surface, segment, overlay: display colour, depth in steps of the whole picture. MIP: colour, value.
    // X-ray: an integral. Volume: premultiplied linear colour, opacity.
    vec4 front;
    // Overlay: an integral. Volume: x depth.
    vec4 behind;
#ifdef TRANSLUCENT
    vec4 glass; // in front of that surface: premultiplied display colour, opacity
    float glassDepth;
#endif
};

const float kNothing = 1e30; // a depth

Seen nothingSeen() {
    Seen seen;
#if MODE == 0 || MODE == 3 || MODE == 4
    seen.front = vec4(vec3(0.0), kNothing);
#elif MODE == 1
    seen.front = vec4(vec3(0.0), -kNothing);
#else
    seen.front = vec4(0.0);
#endif
    seen.behind = vec4(0.0);
#ifdef TRANSLUCENT
    seen.glass = vec4(0.0);
    seen.glassDepth = kNothing;
#endif
    return seen;
}

#ifdef TRANSLUCENT
// Glass of two parts, of which a surface as far as `depth` hides what is behind it; as if of one from then
// on.
void mergeGlass(inout Seen one, Seen other, float depth) {
    vec4 a = one.glassDepth < depth ? one.glass : vec4(0.0);
    vec4 b = other.glassDepth < depth ? other.glass : vec4(0.0);
    one.glass = one.glassDepth < other.glassDepth ? a + (1.0 - a.a) * b : b + (1.0 - b.a) * a;
    one.glassDepth = min(one.glassDepth, other.glassDepth);
}
#endif

// Two parts in one picture: what is nearer hides what is farther, integrals add up, the greater value wins.
Seen together(Seen one, Seen other) {
#ifdef TRANSLUCENT
    mergeGlass(one, other, min(one.front.a, other.front.a));
#endif
#if MODE == 0 || MODE == 4
    one.front = other.front.a < one.front.a ? other.front : one.front;
#elif MODE == 1
    one.front = other.front.a > one.front.a ? other.front : one.front;
#elif MODE == 2
    one.front += other.front;
#elif MODE == 3
    one.front = other.front.a < one.front.a ? other.front : one.front;
    one.behind += other.behind;
#else
    bool swapped = other.front.a > 0.0 && (one.front.a == 0.0 || other.behind.x < one.behind.x);
    vec4 near = swapped ? other.front : one.front;
    vec4 far = swapped ? one.front : other.front;
    one.front = near + (1.0 - near.a) * far;
    one.behind.x = swapped ? other.behind.x : one.behind.x;
#endif
    return one;
}

// What is seen through the glass in front of it.
vec3 throughGlass(Seen seen, vec3 colour) {
#ifdef TRANSLUCENT
    return seen.glass.rgb + (1.0 - seen.glass.a) * colour;
#else
    return colour;
#endif
}

// How much of the background the glass hides.
float hiddenByGlass(Seen seen) {
#ifdef TRANSLUCENT
    return seen.glass.a;
#else
    return 0.0;
#endif
}

// Display colour over what is behind, and coverage: that colour is linear in `behind`, and 1 - coverage its
// slope.
vec4 shown(Seen seen, vec3 behind) {
#if MODE == 0 || MODE == 4
    bool found = seen.front.a < kNothing;
    return vec4(throughGlass(seen, found ? seen.front.rgb : behind), found ? 1.0 : hiddenByGlass(seen));
#elif MODE == 1
    float brightness = clamp(partOfRange(seen.front.a), 0.0, 1.0);
#ifdef TF_KIND
    vec4 ramp = vec4(seen.front.rgb, 1.0);
#else
#ifdef SEGMENTS
    vec3 brightest = seen.front.rgb;
#else
    const vec3 brightest = vec3(1.0);
#endif
    vec4 ramp = vec4(mix(behind * 0.3, brightest, brightness), 1.0 - 0.3 * (1.0 - brightness));
#endif
    return seen.front.a > -1e29 ? ramp : vec4(behind, 0.0);
#elif MODE == 2
    float brightness = clamp(seen.front.a / exposure.y * exposure.x, 0.0, 1.0);
    return vec4(mix(behind, integralColour(seen.front), brightness), brightness);
#elif MODE == 3
    bool found = seen.front.a < kNothing;
    float brightness = clamp(seen.behind.a / exposure.y * exposure.x, 0.0, 1.0);
    float hidden = found ? 1.0 : hiddenByGlass(seen);
    float veil = brightness * mix(0.9, 0.45, hidden);
    vec3 base = throughGlass(seen, found ? seen.front.rgb : behind);
    return vec4(mix(base, vec3(0.86, 0.91, 1.0) * integralColour(seen.behind), veil),
                1.0 - (1.0 - hidden) * (1.0 - veil));
#else
    if (backgroundTop.w >
        0.5) { // light is mixed here, not display colours: what programs that do so make of it
        return vec4(displayFromLinear(seen.front.rgb / max(seen.front.a, 1e-6)) * seen.front.a, seen.front.a);
    }
    return vec4(displayFromLinear(seen.front.rgb + (1.0 - seen.front.a) * linearFromDisplay(behind)),
                seen.front.a);
#endif
}
