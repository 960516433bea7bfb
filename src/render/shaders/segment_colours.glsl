// How segments look, by label (render::SegmentColours). Uniform block 7.

#include "render/shaders/bindings.glsl"
layout(std140, binding = kSegmentColoursBlock) uniform SegmentColoursBlock {
    vec4 entries[256]; // linear, a opacity
};

vec4 entryOf(uint segment) { return entries[segment]; }
