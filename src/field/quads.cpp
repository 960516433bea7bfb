// SPDX-License-Identifier: Apache-2.0
#include "field/quads.h"

#include "base/check.h"
#include "field/shaders/bindings.h"
#include "gl/context.h"
#include "gl/limits.h"
#include "gl/program.h"

#include <atomic>

namespace vs::field {

namespace {

std::atomic<std::size_t> mostQuadBytes = kMostQuadBytes;

gl::Format fourOf(gl::Format format) {
    VS_CHECK(format == gl::Format::R8 || format == gl::Format::R16 || format == gl::Format::R32F);
    return format == gl::Format::R8    ? gl::Format::RGBA8
           : format == gl::Format::R16 ? gl::Format::RGBA16
                                       : gl::Format::RGBA32F;
}

} // namespace

void limitQuads(std::size_t bytes) { mostQuadBytes = bytes; }

gl::TexelBuffer makeQuads(glm::ivec3 dims, gl::Format ofTexels) {
    const std::size_t voxels = Box3{glm::ivec3(0), dims}.volume();
    const gl::Format format = fourOf(ofTexels);
    if (!gl::Context::isSoftware() || gl::pretendedFilterSteps() > 0 ||
        voxels * gl::bytesPerTexel(format) > mostQuadBytes || voxels > gl::TexelBuffer::mostTexels()) {
        return {};
    }
    return {voxels, format, "data in quads", gl::Reach::Shared};
}

void fillQuads(const gl::Texture& texels, gl::TexelBuffer& quads) {
    VS_CHECK(texels.format() == gl::Format::R16 || texels.format() == gl::Format::R32F);
    gl::Program fill("field/shaders/fill_quads.comp",
                     {{"VS_FORMAT", texels.format() == gl::Format::R16 ? "rgba16" : "rgba32f"}});
    texels.bindTexture(kTexelsTexture);
    quads.bindImage(kQuadsImage, gl::Access::Write);
    fill.set("dims", texels.size());
    fill.dispatchOver(texels.size(), gl::Barrier::Texture);
}

} // namespace vs::field
