// The display colour of what all parts of a picture show, added to the picture: one sample. With CLEARS
// nothing is shown yet: what the parts of the sample before this one showed is forgotten. MODE, TF_KIND,
// SEGMENTS, TRANSLUCENT: those of the picture, see cast_rays.comp. In: the view of what remains (rays.glsl),
// the list of squares, images 1 to 4 what the parts show (parts.glsl). Out: image 0 (rgba32f) sums of display
// colours and coverage, or images 1 to 4.
// variants: MODE=0;MODE=1;MODE=1 TF_KIND=0;MODE=1 SEGMENTS=1;MODE=2;MODE=2 SEGMENTS=1;MODE=3;MODE=3 TRANSLUCENT=1 TF_KIND=2;MODE=4 TRANSLUCENT=1;MODE=5;MODE=5 SEGMENTS=1 TRANSLUCENT=1;MODE=0 CLEARS=1;MODE=3 TRANSLUCENT=1 CLEARS=1
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/squares.glsl"
#include "render/shaders/shading.glsl"

uniform vec2 exposure;      // x: X-ray gain per diagonal; y: volume's diagonal in steps
uniform vec4 backgroundTop; // display colour; w 1: there is none, and it is black
uniform vec4 backgroundBottom;
#if MODE == 1 || MODE == 2
uniform int isInverted; // colours that are to stay are accumulated as their complements
#endif

#include "render/shaders/seen.glsl"
#include "render/shaders/parts.glsl"

void main() {
    ivec2 pixel = pixelOfInvocation();
    if (any(greaterThanEqual(pixel, ivec2(viewport.xy)))) {
        return;
    }
#ifdef CLEARS
    setSeenOfParts(pixel, nothingSeen());
#else
    vec2 position = vec2(pixel) + pixelOffset;
    vec3 behind = background(position, viewport.xy, backgroundTop.xyz, backgroundBottom.xyz);
#if MODE == 1 || MODE == 2 || MODE == 3
    Ray ray = rayThrough(position);
    behind = behindFilm(behind, ray.tNear < ray.tFar);
#endif
    addToPicture(pixel, shown(seenOfParts(pixel), behind));
#endif
}
