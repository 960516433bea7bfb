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
    return classify(dataAt(p), 0.0).a - lightingOfFunction.z;
#else
    return classify(dataAt(p), gradientAt(p)).a - lightingOfFunction.z;
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
float dataShownAt(vec3 p) { return dataShownAs(p, dataAt(p)); }
float exactDataShownAt(vec3 p) { return dataShownAs(p, exactDataAt(p)); }
#endif

// >= 0 where there is content to see; continuous along each of its parts, so it can be bisected.
float contentAt(vec3 p) {
#if CONTENT == 0
    return partInside(dataAt(p));
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
float sideAt(vec3 p) { return sideAs(p, sculptureAt(p)); }
float exactSideAt(vec3 p) { return sideAs(p, exactSculptureAt(p)); }
#else
float sideAt(vec3 p) { return sideAs(p, 0.0); }
float exactSideAt(vec3 p) { return sideAs(p, 0.0); }
#endif

// Both as they are wherever in textures the data and the sculpture are kept (x content, y side), which is not
// said of segments and transfer functions: for where they are closer to zero than slack(), or decide where a
// surface lies. Values are rounded, and so are places in a texture, by some 1e-4 of a texel where its unit
// has floats. Units that know 256 places from one texel to the next may be off by more: by three times half a
// place of the sculpture, which rises by no more than one from voxel to voxel.
const float kSideSlack = 8e-3;
#ifdef LOOKS_AGAIN
float exactContentAt(vec3 p) {
#if CONTENT == 0
    return partInside(exactDataAt(p));
#else
    return max(exactDataShownAt(p), segmentationAt(p) - 0.5);
#endif
}
vec2 slack() { return vec2(32.0 * max(valueScale.w, limits.w) / rangeWidth() + 1e-4, kSideSlack); }
#else
float exactContentAt(vec3 p) { return contentAt(p); }
vec2 slack() { return vec2(0.0, kSideSlack); }
#endif
vec2 exactPartsAt(vec3 p) { return vec2(exactContentAt(p), exactSideAt(p)); }

// >= 0 where something is visible.
float visibility(vec3 p) { return min(contentAt(p), sideAt(p)); }
