// What counts as content at a place, and what keeps it from being seen: of what surfaces are made.
// CONTENT chooses: 0 data in the displayed range, 1 segmentation, 2 either of the two, 3 what the transfer
// function makes opaque enough to be touched. Its switches are those of surface.glsl, which includes it.

#if CONTENT == 1 || CONTENT == 2 || (CONTENT == 3 && defined(SEGMENTS))
#define MEETS_SEGMENTS
#endif

// Data that decides alone or beside segments is looked at again where it is close to the displayed range's
// ends (testBatch()).
#if CONTENT == 0 || CONTENT == 2
#define LOOKS_AGAIN
#endif

float rangeWidth() { return range.y > range.x ? range.y - range.x : 1.0; }
// How far a value is inside the displayed range, as a part of its width: of the same size as what the
// sculpture and the segmentation say, or the least of them would bend what is straight.
float partInside(float value) { return insideRange(value) / rangeWidth(); }

#if CONTENT == 3
// >= 0 where the transfer function makes the data opaque enough.
float opaqueAt(vec3 p) {
#if TF_KIND == 0
    return classify(scanAt(p), 0.0).a - lightingOfFunction.z;
#else
    return classify(scanAt(p), gradientAt(p)).a - lightingOfFunction.z;
#endif
}
#endif

// >= 0 where the data is to be seen beside segments.
#if CONTENT == 3
float dataShownAt(vec3 p) { return min(opaqueAt(p), clearOfSegments(membershipsAt(p))); }
float exactDataShownAt(vec3 p) { return dataShownAt(p); }
#else
float dataShownAs(vec3 p, float value) {
#ifdef TRANSLUCENT
    return min(partInside(value), clearOfGlass(membershipsAt(p)));
#else
    return partInside(value);
#endif
}
float dataShownAt(vec3 p) { return dataShownAs(p, scanAt(p)); }
float exactDataShownAt(vec3 p) { return dataShownAs(p, exactScanAt(p)); }
#endif

// >= 0 where there is content to see; continuous along each of its parts, so it can be bisected.
float contentAt(vec3 p) {
#if CONTENT == 0
    return partInside(scanAt(p));
#elif CONTENT == 1
    return segmentationAt(p) - 0.5;
#elif CONTENT == 3 && !defined(SEGMENTS)
    return opaqueAt(p);
#else
    return max(dataShownAt(p), segmentationAt(p) - 0.5);
#endif
}

// >= 0 on the visible side of the sculpture.
float sideAs(vec3 p, float sculpture) {
    float side = 1e30;
#ifdef SCULPTED
    side = visibleSide(sculpture);
#endif
#ifdef WITHIN_SEGMENTS
    vec2 memberships = membershipsAt(p);
    side = min(side, max(memberships.x, memberships.y) - 0.5);
#endif
    return side;
}
#ifdef SCULPTED
float cutSideAt(vec3 p) { return sideAs(p, sculptureAt(p)); }
float exactCutSideAt(vec3 p) { return sideAs(p, exactSculptureAt(p)); }
#else
float cutSideAt(vec3 p) { return sideAs(p, 0.0); }
float exactCutSideAt(vec3 p) { return sideAs(p, 0.0); }
#endif

#ifdef FILLED
#if CONTENT != 1
#define FILL_IS_CONTENT
#endif

// >= 0 where material is seen that fills p so much.
float fillShown(vec3 p, vec2 filled) {
    float shown = filled.y - 0.5;
#if CONTENT == 3 && TF_KIND == 0
    bool isAsked = filled.y > 0.25;
    uint material = materialAt(p, isAsked);
    shown = isAsked && classify(materials[material].w, 0.0).a < lightingOfFunction.z ? -1.0 : shown;
#endif
    return shown;
}

// >= 0 where what the scan has is on the visible side, and no material instead of it.
float scanSideAt(vec3 p) { return min(cutSideAt(p), 0.5 - filledByAny(p)); }
// >= 0 where whatever is at p, of the scan or material, is on the visible side.
float sideAt(vec3 p) { return withFill(cutSideAt(p), filledAt(p)); }
float exactSideAt(vec3 p) { return withFill(exactCutSideAt(p), filledAt(p)); }
#else
float scanSideAt(vec3 p) { return cutSideAt(p); }
float sideAt(vec3 p) { return cutSideAt(p); }
float exactSideAt(vec3 p) { return exactCutSideAt(p); }
#endif

// Content and side with material that is there: either is seen where both are >= 0.
vec2 withMaterial(vec3 p, vec2 parts) {
#if defined(FILL_IS_CONTENT)
    vec2 filled = filledAt(p);
    float shown = fillShown(p, filled);
    return vec2(max(parts.x, shown), max(min(parts.y, 0.5 - filled.x), shown));
#elif defined(FILLED)
    return vec2(parts.x, min(parts.y, 0.5 - filledByAny(p)));
#else
    return parts;
#endif
}

// What surfaces are made of: x content, y side, both >= 0 where something is seen.
vec2 partsOfSurface(vec3 p) { return withMaterial(p, vec2(contentAt(p), cutSideAt(p))); }

// Both as they are wherever in textures the data and the sculpture are kept (x content, y side), which is not
// said of segments and transfer functions: for where they are closer to zero than slack(), or decide where a
// surface lies. Values are rounded, and so are places in a texture, by some 1e-4 of a texel where its unit
// has floats. Units that know 256 places from one texel to the next may be off by more: by three times half a
// place of the sculpture, which rises by no more than one from voxel to voxel.
const float kSideSlack = 8e-3;
#ifdef LOOKS_AGAIN
float exactContentAt(vec3 p) {
#if CONTENT == 0
    return partInside(exactScanAt(p));
#else
    return max(exactDataShownAt(p), segmentationAt(p) - 0.5);
#endif
}
vec2 slack() { return vec2(32.0 * max(valueScale.w, limits.w) / rangeWidth() + 1e-4, kSideSlack); }
#else
float exactContentAt(vec3 p) { return contentAt(p); }
vec2 slack() { return vec2(0.0, kSideSlack); }
#endif
vec2 exactPartsAt(vec3 p) { return withMaterial(p, vec2(exactContentAt(p), exactCutSideAt(p))); }

// >= 0 where something is visible.
float visibility(vec3 p) {
    vec2 parts = partsOfSurface(p);
    return min(parts.x, parts.y);
}
