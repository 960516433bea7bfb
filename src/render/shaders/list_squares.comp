// Lists the squares of 8 x 8 pixels of a window: those that may show something from the front, the others
// from the end. Squares without any of its pixels are nowhere in the list. In: storage 5 which may
// (mark_squares.comp). Out: storage 0 the squares (column, row << 16), storage 1 how many of them may show
// something, and how many not, storage 2 each square's place in the list.
layout(local_size_x = 16, local_size_y = 16) in;

#include "render/shaders/bindings.glsl"
layout(std430, binding = kMarksStorage) readonly buffer Marks { uint marks[]; }; // by row and column
layout(std430, binding = kSquaresStorage) writeonly buffer Squares { uint squares[]; };
layout(std430, binding = kSquareCountsStorage) buffer Counts { uint counts[2]; };
layout(std430, binding = kPlacesStorage) writeonly buffer Places { uint places[]; };

uniform ivec2 squareCount;
uniform vec4 window; // the pixels that are wanted, [xy, zw)

void main() {
    ivec2 square = ivec2(gl_GlobalInvocationID.xy);
    bool isWanted =
        all(lessThan(vec2(8 * square), window.zw)) && all(greaterThan(vec2(8 * square + 8), window.xy));
    if (any(greaterThanEqual(square, squareCount)) || !isWanted) {
        return;
    }
    int index = square.y * squareCount.x + square.x;
    uint place = marks[index] != 0u ? atomicAdd(counts[0], 1u)
                                    : uint(squareCount.x * squareCount.y) - 1u - atomicAdd(counts[1], 1u);
    squares[place] = uint(square.x) | uint(square.y) << 16;
    places[index] = place;
}
