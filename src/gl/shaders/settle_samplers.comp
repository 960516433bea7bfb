// Leaves the state of these samplers in the first sixteen places that a driver has for samplers
// (gl/sampler_slots.h). Nothing is bound to their units, so that they are always the driver's own; what they
// give is looked at, or they would be left out.
layout(local_size_x = 1) in;

#include "gl/shaders/bindings.glsl"
layout(binding = kUnusedTextures) uniform sampler2D unused[16];

shared uint beyondOne; // textures that are not there are black

void main() {
    float sum = 0.0;
    for (int n = 0; n < 16; ++n) {
        sum += textureLod(unused[n], vec2(0.5), 0.0).r;
    }
    if (sum > 1.0) {
        atomicAdd(beyondOne, 1u);
    }
}
