// Lists the squares of 8 x 8 pixels in which one part of the picture may show something, of those that take
// the current sample. In: texture 8 the part's beams, storage 2 each square's place among all of them
// (list_squares.comp). Out: storage 0 the squares (column, row << 16), storage 1 how many there are.
layout(local_size_x = 16, local_size_y = 16) in;

uniform ivec2 squareCount;
uniform int beamPixels;
uniform int activeSquares; // squares from this place on take no more samples

#include "render/shaders/beams_of_square.glsl"

#include "render/shaders/bindings.glsl"
layout(std430, binding = kSquaresStorage) writeonly buffer Squares { uint squares[]; };
layout(std430, binding = kSquareCountsStorage) buffer Counts { uint counts[2]; };
layout(std430, binding = kPlacesStorage) readonly buffer Places { uint places[]; };

void main() {
    ivec2 square = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(square, squareCount))) {
        return;
    }
    bool takesSample = places[square.y * squareCount.x + square.x] < uint(activeSquares);
    if (takesSample && mayShow(square)) {
        squares[atomicAdd(counts[0], 1u)] = uint(square.x) | uint(square.y) << 16;
    }
}
