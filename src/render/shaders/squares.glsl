// Squares of 8 x 8 pixels, those that may show something first: one work group of 64 invocations each.
// Bindings: storage 0 the squares (list_squares.comp), storage 3 how far two samples are apart in each, image
// 0 (rgba32f) sums of display colours and coverage. Include "render/shaders/rays.glsl" first.

#include "render/shaders/bindings.glsl"
layout(std430, binding = kSquaresStorage) readonly buffer Squares { uint squares[]; }; // column, row << 16

layout(rgba32f, binding = kAccumulationImage) uniform image2D accumulation;

uniform ivec2 squareRange; // of the list: first square, how many
uniform vec2 pixelOffset;  // where in the pixel this sample lies, 0..1
uniform int addToPrevious;
uniform int measuresContrast; // 1: this is the second sample, to be compared with the first

layout(std430, binding = kContrastsStorage) buffer Contrasts {
    uint contrasts[];
}; // of 65535, by row and column of squares

const ivec2 kNowhere = ivec2(1 << 30);

// Eight invocations after one another are 4 x 2 pixels, 16 are 4 x 4: their rays stay together. Rows of work
// groups take every so manyth square, as a software renderer gives each of its threads one piece of the
// sequence of groups: so all take as long.
ivec2 pixelOfInvocation() {
    int index = int(gl_WorkGroupID.x * gl_NumWorkGroups.y + gl_WorkGroupID.y);
    uint square = squares[squareRange.x + min(index, squareRange.y - 1)];
    int i = int(gl_LocalInvocationIndex);
    ivec2 inSquare = ivec2((i & 3) + ((i >> 2) & 4), ((i >> 2) & 3) + ((i >> 3) & 4));
    ivec2 pixel = 8 * ivec2(square & 0xffffu, square >> 16) + inSquare;
    return index < squareRange.y ? pixel : kNowhere;
}

// Display colour and coverage.
void addToPicture(ivec2 pixel, vec4 sum) {
    if (addToPrevious != 0) {
        vec4 before = imageLoad(accumulation, pixel);
        if (measuresContrast != 0) {
            vec4 apart = abs(sum - before);
            float most = max(max(apart.r, apart.g), max(apart.b, apart.a));
            int squaresAcross = (imageSize(accumulation).x + 7) / 8;
            atomicMax(contrasts[(pixel.y / 8) * squaresAcross + pixel.x / 8], uint(65535.0 * min(most, 1.0)));
        }
        sum += before;
    }
    imageStore(accumulation, pixel, sum);
}
