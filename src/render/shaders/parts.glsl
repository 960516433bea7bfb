// What the parts of a picture show so far, pixel by pixel, while one after the other is cast (cast_rays.comp
// with PARTS). Images 1 to 4; TRANSLUCENT: with glass. Include "render/shaders/seen.glsl" first.

#include "render/shaders/bindings.glsl"
layout(rgba32f, binding = kSeenFrontImage) uniform image2D seenFront;
layout(rgba32f, binding = kSeenBehindImage) uniform image2D seenBehind;
#ifdef TRANSLUCENT
layout(rgba32f, binding = kSeenGlassImage) uniform image2D seenGlass;
layout(r32f, binding = kSeenGlassDepthImage) uniform image2D seenGlassDepth;
#endif

Seen seenOfParts(ivec2 pixel) {
    Seen seen;
    seen.front = imageLoad(seenFront, pixel);
    seen.behind = imageLoad(seenBehind, pixel);
#ifdef TRANSLUCENT
    seen.glass = imageLoad(seenGlass, pixel);
    seen.glassDepth = imageLoad(seenGlassDepth, pixel).r;
#endif
    return seen;
}

void setSeenOfParts(ivec2 pixel, Seen seen) {
    imageStore(seenFront, pixel, seen.front);
    imageStore(seenBehind, pixel, seen.behind);
#ifdef TRANSLUCENT
    imageStore(seenGlass, pixel, seen.glass);
    imageStore(seenGlassDepth, pixel, vec4(seen.glassDepth));
#endif
}

// One more part.
void addToParts(ivec2 pixel, Seen seen) { setSeenOfParts(pixel, together(seenOfParts(pixel), seen)); }
