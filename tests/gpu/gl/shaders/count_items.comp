// Counts how often each item of a list is worked on.
layout(local_size_x = 64) in;
#include "gl/shaders/items.glsl"
layout(std430, binding = 0) buffer Visits { uint visits[]; };
uniform int count;
void main() {
    uint i = itemIndex();
    if (i < uint(count)) {
        atomicAdd(visits[i], 1u);
    }
}
