// Whether one of the beams that go through a square of 8 x 8 pixels may show something. Declare `beamPixels`,
// the side of a beam's square, at most 8. Bindings: texture 8 beams (rg: nearest and farthest t).

#include "render/shaders/bindings.glsl"
layout(binding = kBeamsTexture) uniform sampler2D beams;

bool mayShow(ivec2 square) {
    ivec2 first = square * 8 / beamPixels;
    ivec2 last = min((square * 8 + 7) / beamPixels, textureSize(beams, 0) - 1);
    bool may = false;
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            vec2 ends = texelFetch(beams, ivec2(x, y), 0).rg;
            may = may || ends.x < ends.y;
        }
    }
    return may;
}
