// The background's colour in squares of pixels where nothing can be seen.
// FILM: with a film in the grid's box, see behindFilm().
// In: the view (rays.glsl), the list of squares. Out: image 0 (rgba32f) sums of display colours and coverage.
// variants: ;FILM=1
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/squares.glsl"
#include "render/shaders/shading.glsl"

layout(location = 7) uniform vec4 backgroundTop; // display colour
layout(location = 8) uniform vec4 backgroundBottom;

void main() {
    ivec2 pixel = pixelOfInvocation();
    if (any(greaterThanEqual(pixel, ivec2(viewport.xy)))) {
        return;
    }
    vec2 position = vec2(pixel) + pixelOffset;
    vec3 colour = background(position, viewport.xy, backgroundTop.xyz, backgroundBottom.xyz);
#ifdef FILM
    Ray ray = rayThrough(position);
    colour = behindFilm(colour, ray.tNear < ray.tFar);
#endif
    addToPicture(pixel, vec4(colour, 0.0));
}
