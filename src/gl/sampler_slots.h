// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/uniforms.h"

// What Mesa's software renderer takes for the samplers of texel buffers. Internal to this folder.
namespace vs::gl {

// What a program has samplers of.
struct Samplers {
    bool areOfTextures = false;
    bool areOfTexelBuffers = false;
};
Samplers samplersOf(const Uniforms& uniforms);

// What is kept of them in each context.
struct SamplerSlots {
    static constexpr unsigned int kSeveral = ~0U;

    bool isKnown = false;
    bool isNeeded = false;
    unsigned int settling = 0; // the program of shaders/settle_samplers.comp, made when it is first needed
    // The only program that has left samplers of textures in the places since they were settled; 0: none has.
    unsigned int unsettledBy = kSeveral;
};

// Comes before each dispatch of a program. A texel buffer has no sampler, but on llvmpipe it has a place for
// one, which holds whatever sampler another program had there last; machine code is made, and kept, for each
// such sampler anew, although it is not looked at: 0.1 s at any time for a program of the ray caster, and
// never what was compiled in advance. So before a program that reads texel buffers a small one is dispatched
// that leaves one and the same sampler in all places, where another program has left its own there.
void settleSamplerSlots(unsigned int program, Samplers samplers);

// The program is deleted; its number may become another one's.
void forgetInSamplerSlots(unsigned int program);

} // namespace vs::gl
