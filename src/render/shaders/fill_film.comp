// The background with a film in the grid's box (behindFilm()) in squares of pixels where nothing can be seen.
// In: the view (rays.glsl), the list of squares. Out: image 0 (rgba32f) sums of display colours and coverage.
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/squares.glsl"
#include "render/shaders/shading.glsl"

uniform vec4 backgroundTop; // display colour
uniform vec4 backgroundBottom;

void main() {
    ivec2 pixel = pixelOfInvocation();
    if (any(greaterThanEqual(pixel, ivec2(viewport.xy)))) {
        return;
    }
    vec2 position = vec2(pixel) + pixelOffset;
    vec3 behind = background(position, viewport.xy, backgroundTop.xyz, backgroundBottom.xyz);
    Ray ray = rayThrough(position);
    addToPicture(pixel, vec4(behindFilm(behind, ray.tNear < ray.tFar), 0.0));
}
