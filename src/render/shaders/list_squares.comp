// Lists the squares of 8 x 8 pixels: those that may show something from the front, the others from the end.
// In: texture 8 beams (rg: nearest and farthest t). Out: storage 0 the squares (column, row << 16), storage 1
// how many of them may show something, and how many not, storage 2 each square's place in the list.
layout(local_size_x = 16, local_size_y = 16) in;

#include "render/shaders/bindings.glsl"
layout(binding = kBeamsTexture) uniform sampler2D beams;

layout(std430, binding = kSquaresStorage) writeonly buffer Squares { uint squares[]; };
layout(std430, binding = kSquareCountsStorage) buffer Counts { uint counts[2]; };

layout(std430, binding = kPlacesStorage) writeonly buffer Places { uint places[]; };

uniform ivec2 squareCount;
uniform int beamPixels; // side of a beam's square; at most 8
uniform int takeAll;    // 1: as if all of them might

void main() {
    ivec2 square = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(square, squareCount))) {
        return;
    }
    ivec2 first = square * 8 / beamPixels;
    ivec2 last = min((square * 8 + 7) / beamPixels, textureSize(beams, 0) - 1);
    bool mayShow = takeAll != 0;
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            vec2 ends = texelFetch(beams, ivec2(x, y), 0).rg;
            mayShow = mayShow || ends.x < ends.y;
        }
    }
    uint packedSquare = uint(square.x) | uint(square.y) << 16;
    uint place = mayShow ? atomicAdd(counts[0], 1u)
                         : uint(squareCount.x * squareCount.y) - 1u - atomicAdd(counts[1], 1u);
    squares[place] = packedSquare;
    places[square.y * squareCount.x + square.x] = place;
}
