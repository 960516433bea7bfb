// SPDX-License-Identifier: Apache-2.0
#include "gl/sampler_slots.h"

#include "gl/context.h"
#include "gl/errors.h"
#include "gl/shader_source.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
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

bool isTexelBuffer(GLenum type) {
    return type == GL_SAMPLER_BUFFER || type == GL_INT_SAMPLER_BUFFER ||
           type == GL_UNSIGNED_INT_SAMPLER_BUFFER;
}

bool isTexture(GLenum type) {
    constexpr std::array<GLenum, 6> kTypes{GL_SAMPLER_2D, GL_INT_SAMPLER_2D, GL_UNSIGNED_INT_SAMPLER_2D,
                                           GL_SAMPLER_3D, GL_INT_SAMPLER_3D, GL_UNSIGNED_INT_SAMPLER_3D};
    return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

} // namespace

Samplers samplersOf(const Uniforms& uniforms) {
    Samplers samplers;
    for (const auto& [name, uniform] : uniforms) {
        const bool isUsed = uniform.location >= 0;
        samplers.areOfTexelBuffers |= isUsed && isTexelBuffer(uniform.type);
        samplers.areOfTextures |= isUsed && isTexture(uniform.type);
    }
    return samplers;
}

void settleSamplerSlots(unsigned int program, Samplers samplers) {
    if (currentRecord() == nullptr) {
        return;
    }
    SamplerSlots& slots = currentRecord()->samplerSlots;
    if (!slots.isKnown) {
        slots.isKnown = true;
        slots.isNeeded = Context::isSoftware();
    }
    if (!slots.isNeeded) {
        return;
    }
    if (samplers.areOfTexelBuffers && slots.unsettledBy != 0 && slots.unsettledBy != program) {
        glUseProgram(settlingProgram(slots));
        glDispatchCompute(1, 1, 1);
        slots.unsettledBy = 0;
    }
    if (samplers.areOfTextures) {
        const bool isAlone = slots.unsettledBy == 0 || slots.unsettledBy == program;
        slots.unsettledBy = isAlone ? program : SamplerSlots::kSeveral;
    }
}

void forgetInSamplerSlots(unsigned int program) {
    if (currentRecord() != nullptr && currentRecord()->samplerSlots.unsettledBy == program) {
        currentRecord()->samplerSlots.unsettledBy = SamplerSlots::kSeveral;
    }
}

} // namespace vs::gl
