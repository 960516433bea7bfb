// Which bricks are near a place where the sculpture begins to hide: those with a hidden and a visible voxel
// in them or up to a macrocell around. One invocation a brick of the list. In: fences.glsl; storage 7 brick
// numbers. Out: storage 1, 1 or 0 for each.
#include "segment/shaders/words.glsl"
#include "segment/shaders/fences.glsl"

layout(local_size_x = 16) in;

#include "gl/shaders/items.glsl"

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kAnswersStorage) writeonly buffer Answers { uint answers[]; };
layout(std430, binding = kBricksStorage) readonly buffer Bricks { uint bricks[]; };

uniform int count;

const int kCellsPerBrick = 8;

void main() {
    uint i = itemIndex();
    if (i < uint(count)) {
        ivec3 first = placeOfBrick(bricks[i]) * kCellsPerBrick;
        answers[i] = uint(isFenceIn(first - 1, first + kCellsPerBrick, true));
    }
}
