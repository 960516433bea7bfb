// Orders the squares of pixels that may show something anew: those whose first two samples differ from the
// front, the others, which are left at two samples, from the end. In: storage 0 the squares
// (list_squares.comp), storage 3 how far the samples are apart in each. Out: storage 4 the squares in their
// new order, storage 1 how many differ, and how many do not, storage 2 each square's place in the list.
layout(local_size_x = 64) in;

#include "gl/shaders/items.glsl"

#include "render/shaders/bindings.glsl"
layout(std430, binding = kSquaresStorage) readonly buffer Squares { uint squares[]; };
layout(std430, binding = kSquareCountsStorage) buffer Counts { uint counts[2]; };
layout(std430, binding = kPlacesStorage) writeonly buffer Places { uint places[]; };
layout(std430, binding = kContrastsStorage) readonly buffer Contrasts { uint contrasts[]; };
layout(std430, binding = kOrderedStorage) writeonly buffer Ordered { uint ordered[]; };

uniform ivec2 squareCount;
uniform int occupied;

// Five of 255 levels: the mean of two samples that far apart is off by hardly more than two, less than an
// edge or a speck makes.
const uint kMostContrast = 5u * 257u;

void main() {
    uint item = itemIndex();
    if (item >= uint(squareCount.x * squareCount.y)) {
        return;
    }
    uint square = squares[item];
    if (item >= uint(occupied)) {
        ordered[item] = square; // nothing can be seen there
        return;
    }
    uint index = (square >> 16) * uint(squareCount.x) + (square & 0xffffu);
    uint place = contrasts[index] > kMostContrast ? atomicAdd(counts[0], 1u)
                                                  : uint(occupied) - 1u - atomicAdd(counts[1], 1u);
    ordered[place] = square;
    places[index] = place;
}
