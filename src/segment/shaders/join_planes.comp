// Adds a plane to another, word by word. In: storage 1. In and out: storage 2.
layout(local_size_x = 64) in;

#include "gl/shaders/items.glsl"

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kAddedStorage) readonly buffer Added { uint added[]; };
layout(std430, binding = kMadePlaneStorage) buffer Plane { uint plane[]; };

uniform int count;

void main() {
    uint i = itemIndex();
    if (i < uint(count)) {
        plane[i] |= added[i];
    }
}
