// The background's colour in squares of pixels where nothing can be seen.
// In: the view (rays.glsl), the list of squares. Out: image 0 (rgba32f) sum of display colours.
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/squares.glsl"
#include "render/shaders/shading.glsl"

layout(location = 3) uniform int showsFilm;      // 1: the grid's box has a film
layout(location = 7) uniform vec4 backgroundTop; // display colours
layout(location = 8) uniform vec4 backgroundBottom;

void main() {
    ivec2 pixel = pixelOfInvocation();
    if (any(greaterThanEqual(pixel, ivec2(viewport.xy)))) {
        return;
    }
    vec2 position = vec2(pixel) + pixelOffset;
    Ray ray = rayThrough(position);
    vec3 behind = background(position, viewport.xy, backgroundTop.xyz, backgroundBottom.xyz);
    bool isFilm = showsFilm != 0 && ray.tNear < ray.tFar;
    addToPicture(pixel, vec4(isFilm ? min(behind, kFilm) : behind, 0.0));
}
