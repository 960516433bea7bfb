// SPDX-License-Identifier: Apache-2.0
#include "gl/sampler_slots.h"

#include "gl/context.h"
#include "gl/errors.h"
#include "gl/shader_source.h"

#include <epoxy/gl.h>

#include <string>

namespace vs::gl {

namespace {

GLuint settlingProgram(SamplerSlots& slots) {
    if (slots.settling == 0) {
        const std::string source = expandSource("gl/shaders/settle_samplers.comp", {}).text;
        const char* text = source.c_str();
        slots.settling = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &text);
    }
    return slots.settling;
}

} // namespace

void settleSamplerSlots(unsigned int program, bool readsTexelBuffers) {
    if (currentRecord() == nullptr) {
        return;
    }
    SamplerSlots& slots = currentRecord()->samplerSlots;
    if (!slots.isKnown) {
        slots.isKnown = true;
        slots.isNeeded = Context::isSoftware();
    }
    if (slots.isNeeded && readsTexelBuffers && slots.last != program) {
        glUseProgram(settlingProgram(slots));
        glDispatchCompute(1, 1, 1);
    }
    slots.last = program;
}

void forgetInSamplerSlots(unsigned int program) {
    if (currentRecord() != nullptr && currentRecord()->samplerSlots.last == program) {
        currentRecord()->samplerSlots.last = 0;
    }
}

} // namespace vs::gl
