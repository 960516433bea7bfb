// Marks the squares of 8 x 8 pixels in which a part of the picture may show something. In: texture 8 the
// part's beams. Out: storage 5 a mark for each square; those of other parts stay.
layout(local_size_x = 16, local_size_y = 16) in;

uniform ivec2 squareCount;
uniform int beamPixels;

#include "render/shaders/beams_of_square.glsl"

#include "render/shaders/bindings.glsl"
layout(std430, binding = kMarksStorage) writeonly buffer Marks { uint marks[]; }; // by row and column

void main() {
    ivec2 square = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(square, squareCount)) && mayShow(square)) {
        marks[square.y * squareCount.x + square.x] = 1u;
    }
}
