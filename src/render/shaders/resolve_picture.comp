// Divides the accumulated samples by their number. In: image 0 (rgba32f) sums. Out: image 1 (rgba8) the picture.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = 0) uniform readonly image2D accumulation;
layout(rgba8, binding = 1) uniform writeonly image2D picture;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) {
        return;
    }
    vec4 sum = imageLoad(accumulation, pixel);
    imageStore(picture, pixel, vec4(sum.rgb / max(sum.a, 1.0), 1.0));
}
