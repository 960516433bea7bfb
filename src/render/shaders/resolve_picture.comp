// Divides the accumulated samples by their number. In: image 0 (rgba32f) sums of display colours and coverage
// (a). Out: image 1 (rgba8) the picture; a 1, or on nothing the coverage, with colours that are not
// multiplied by it. PIXELS_DONE: of the first sample, which is under way, those that have it: a 0 elsewhere.
// variants: ;PIXELS_DONE=1
layout(local_size_x = 8, local_size_y = 8) in;

#include "render/shaders/shading.glsl"

#include "render/shaders/bindings.glsl"
layout(rgba32f, binding = kAccumulationImage) uniform readonly image2D accumulation;
layout(rgba8, binding = kPictureImage) uniform writeonly image2D picture;

#ifdef PIXELS_DONE
layout(r32ui, binding = kRoundsImage) uniform readonly uimage2D rounds; // see cast_rays.comp
#endif

layout(std430, binding = kPlacesStorage) readonly buffer Places {
    uint places[];
}; // of squares of pixels, see list_squares.comp

uniform vec4 window; // the pixels that are wanted, [xy, zw)
// Whole samples; squares that have one more; squares that may show something.
uniform ivec3 progress;
uniform int isFilmAhead; // 1: the other squares have one more
uniform int isTransparent;
uniform int isFlat;     // the background is of one colour, which stays exactly that
uniform int isInverted; // the picture is the complement of what was accumulated
uniform int isBare;     // no samples are taken of squares where nothing can be seen: there is the background
uniform ivec2 settled;  // x the place from which on squares have settled, y after how many samples
uniform vec4 backgroundTop; // display colour
uniform vec4 backgroundBottom;

int placeOfSquareAt(ivec2 pixel) {
    int squaresAcross = (imageSize(picture).x + 7) / 8;
    return int(places[(pixel.y / 8) * squaresAcross + pixel.x / 8]);
}

float samplesAt(int place) {
    bool hasMore = place < progress.z ? place < progress.y : isFilmAhead != 0;
    if (place >= settled.x && place < progress.z) {
        return float(settled.y);
    }
    return float(progress.x + (hasMore ? 1 : 0));
}

// Half a step of the display's 8 bits either way, the same for each pixel each time: dark gradients do not
// band.
float dither(ivec2 pixel) {
    // Interleaved gradient noise (Jimenez 2014, "Next generation post processing in Call of Duty: Advanced
    // Warfare").
    float noise = fract(52.9829189 * fract(dot(vec2(pixel), vec2(0.06711056, 0.00583715))));
    return (noise - 0.5) / 255.0;
}

// What an image of 8 bits holds exactly, so that every device stores it alike; what is quite white stays so.
vec4 asStored(vec4 colour) { return floor(clamp(colour, 0.0, 1.0) * 255.0 + 0.5001) / 255.0; }

vec3 shownColour(vec3 accumulated) { return isInverted != 0 ? 1.0 - accumulated : accumulated; }

void main() {
    ivec2 pixel = ivec2(window.xy) + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(window.zw)))) {
        return;
    }
    int place = placeOfSquareAt(pixel);
#ifdef PIXELS_DONE
    if (place < progress.z && imageLoad(rounds, pixel).r == 0u) {
        imageStore(picture, pixel, vec4(0.0));
        return;
    }
#endif
    vec4 sum = imageLoad(accumulation, pixel);
    float samples = max(samplesAt(place), 1.0);
    if (isBare != 0 && place >= progress.z) {
        vec2 size = vec2(imageSize(picture));
        sum = vec4(background(vec2(pixel) + 0.5, size, backgroundTop.xyz, backgroundBottom.xyz), 0.0);
        samples = 1.0;
    }
    if (isTransparent != 0) {
        vec3 colour = sum.a > 0.0 ? shownColour(sum.rgb / sum.a) + dither(pixel) : vec3(0.0);
        imageStore(picture, pixel, asStored(vec4(colour, sum.a / samples)));
    } else {
        float offset = isFlat != 0 && sum.a == 0.0 ? 0.0 : dither(pixel);
        imageStore(picture, pixel, asStored(vec4(shownColour(sum.rgb / samples) + offset, 1.0)));
    }
}
