// The background's colour in squares of pixels where nothing can be seen.
// In: the view (rays.glsl), the list of squares. Out: image 0 (rgba32f) sum of display colours.
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/squares.glsl"
#include "render/shaders/shading.glsl"

void main() {
    ivec2 pixel = pixelOfInvocation();
    if (any(greaterThanEqual(pixel, ivec2(viewport.xy)))) {
        return;
    }
    addToPicture(pixel, background(vec2(pixel) + pixelOffset, viewport.xy));
}
