// SPDX-License-Identifier: Apache-2.0
#include "render/space/slab_bounds.h"

#include "gl/pass.h"
#include "render/shaders/bindings.h"

namespace vs::render {

namespace {
constexpr int kEntriesOfBeam = 193; // as in slabs.glsl
}

SlabBounds::SlabBounds()
    : widen_("render/shaders/widen_tops.comp"), bound_("render/shaders/bound_slabs.comp") {}

void SlabBounds::widenTops(const Macrocells& macrocells) {
    if (topsVersion_ == macrocells.version()) {
        return;
    }
    const gl::Pass pass("widen tops");
    const glm::ivec3 size = macrocells.size() * glm::ivec3(1, 1, 2);
    if (tops_.size() != size) {
        tops_ = gl::Texture(size, gl::Format::R32UI, gl::Filter::Nearest, "tops of cells");
    }
    tops_.bindImage(kTopsImage, gl::Access::Write);
    widen_.dispatchOver(macrocells.size(), gl::Barrier::Texture);
    topsVersion_ = macrocells.version();
}

void SlabBounds::update(const Macrocells& macrocells, const gl::Texture& beams, int beamPixels,
                        float sampleStep) {
    widenTops(macrocells);
    const gl::Pass pass("bound slabs");
    const std::size_t entries = std::size_t(beams.size().x) * std::size_t(beams.size().y) * kEntriesOfBeam;
    if (lists_.texels() < entries) {
        lists_ = gl::TexelBuffer(entries, gl::Format::R16UI, "lists of slabs");
    }
    tops_.bindTexture(kCellTopsTexture);
    lists_.bindImage(kListsImage, gl::Access::Write);
    bound_.set("beamPixels", beamPixels).set("dt", sampleStep).set("beamsAcross", beams.size().x);
    bound_.dispatchOver(beams.size(), gl::Barrier::Texture);
}

void SlabBounds::bind() const { lists_.bindTexture(kSlabListsTexture); }

} // namespace vs::render
