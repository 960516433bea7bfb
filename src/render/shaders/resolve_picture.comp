// Divides the accumulated samples by their number. In: image 0 (rgba32f) sums. Out: image 1 (rgba8) the picture.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = 0) uniform readonly image2D accumulation;
layout(rgba8, binding = 1) uniform writeonly image2D picture;

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
    imageStore(picture, pixel, vec4(sum.rgb / max(sum.a, 1.0) + dither(pixel), 1.0));
}
