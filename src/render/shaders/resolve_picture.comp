// Divides the accumulated samples by their number. In: image 0 (rgba32f) sums of display colours, and of coverage and samples (a).
// Out: image 1 (rgba8) the picture; a 1, or on nothing the coverage, with colours that are not multiplied by it.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = 0) uniform readonly image2D accumulation;
layout(rgba8, binding = 1) uniform writeonly image2D picture;

layout(location = 1) uniform int isTransparent;

const float kSampleCount = 1024.0; // for each sample, in the sum of coverages: see squares.glsl

// Half a step of the display's 8 bits either way, the same for each pixel each time: dark gradients do not band.
float dither(ivec2 pixel) {
    // Interleaved gradient noise (Jimenez 2014, "Next generation post processing in Call of Duty: Advanced Warfare").
    float noise = fract(52.9829189 * fract(dot(vec2(pixel), vec2(0.06711056, 0.00583715))));
    return (noise - 0.5) / 255.0;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) {
        return;
    }
    vec4 sum = imageLoad(accumulation, pixel);
    float samples = max(floor(sum.a / kSampleCount), 1.0);
    sum.a = max(sum.a - samples * kSampleCount, 0.0);
    if (isTransparent != 0) {
        vec3 colour = sum.a > 0.0 ? sum.rgb / sum.a + dither(pixel) : vec3(0.0);
        imageStore(picture, pixel, vec4(colour, sum.a / samples));
    } else {
        imageStore(picture, pixel, vec4(sum.rgb / samples + dither(pixel), 1.0));
    }
}
