// SPDX-License-Identifier: Apache-2.0
#include "studio/state/pasted_parts.h"

#include "gl/pass.h"
#include "sculpt/shaders/bindings.h"

namespace vs::studio {

std::shared_ptr<const gl::Texture> PastedParts::remember(const sculpt::Sculpture& sculpture) {
    const gl::Texture& texels = sculpture.texels();
    gl::Texture copy(texels.size(), texels.format(), gl::Filter::Linear, "sculpture at a paste");
    copy.copyFrom(texels, {glm::ivec3(0), texels.size()}, glm::ivec3(0));
    return std::make_shared<const gl::Texture>(std::move(copy));
}

std::vector<PastedParts::Part> PastedParts::parts(const sculpt::Sculpture& sculpture,
                                                  const PastedState& state, std::size_t places) {
    const Part everything{&sculpture.texels(), &sculpture.cells(), 0};
    const std::size_t count = state.sculptures.size();
    if (count < 2) { // one part is all that was cut
        derived_.clear();
        return std::vector<Part>(places, everything);
    }
    derived_.resize(count);
    std::vector<Part> parts;
    for (std::size_t k = 0; k < places; ++k) {
        if (k >= count) {
            parts.push_back(everything);
            continue;
        }
        Derived& part = derived_[k];
        const auto from = k > 0 ? state.sculptures[k - 1] : nullptr;
        const auto upTo = k + 1 < count ? state.sculptures[k] : nullptr;
        const bool isNew = !part.texels || part.from != from || part.upTo != upTo;
        if (isNew) {
            part.from = from;
            part.upTo = upTo;
            part.making = ++makings_;
            derive(part, sculpture, {glm::ivec3(0), sculpture.dims()});
        } else if (part.version != sculpture.version()) {
            derive(part, sculpture, sculpture.changedSince(part.version));
        }
        part.version = sculpture.version();
        parts.push_back({&part.texels, &part.cells, part.making});
    }
    return parts;
}

void PastedParts::derive(Derived& part, const sculpt::Sculpture& sculpture, const Box3& box) {
    if (box.isEmpty()) {
        return;
    }
    const gl::Pass pass("derive pasted part");
    if (!program_) {
        program_ =
            gl::Program("sculpt/shaders/derive_part.comp", sculpt::storedDefines(sculpture.precision()));
    }
    if (!part.texels) {
        part.texels =
            gl::Texture(sculpture.dims(), sculpture.texels().format(), gl::Filter::Linear, "pasted part");
        part.cells = gl::Texture(sculpture.cells().size(), gl::Format::RG32F, gl::Filter::Nearest,
                                 "pasted part cells");
    }
    sculpture.texels().bindTexture(sculpt::kWholeSculptureTexture);
    (part.upTo ? *part.upTo : sculpture.texels()).bindTexture(sculpt::kUpToTexture);
    (part.from ? *part.from : sculpture.texels()).bindTexture(sculpt::kFromTexture);
    part.texels.bindImage(sculpt::kPartImage, gl::Access::Write);
    program_.set("first", box.lo)
        .set("last", box.hi)
        .set("has", glm::ivec2(part.upTo ? 1 : 0, part.from ? 1 : 0));
    program_.dispatchOver(box.size(), gl::Barrier::Texture);
    updater_.update(part.texels, box, part.cells);
}

} // namespace vs::studio
