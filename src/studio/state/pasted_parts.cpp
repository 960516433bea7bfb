// SPDX-License-Identifier: Apache-2.0
#include "studio/state/pasted_parts.h"

#include "gl/pass.h"
#include "sculpt/shaders/bindings.h"

#include <algorithm>

namespace vs::studio {

std::shared_ptr<const gl::Texture> PastedParts::remember(const sculpt::Sculpture& sculpture) {
    const gl::Texture& texels = sculpture.texels();
    gl::Texture copy(texels.size(), texels.format(), gl::Filter::Linear, "sculpture at a paste");
    copy.copyFrom(texels, {glm::ivec3(0), texels.size()}, glm::ivec3(0));
    return std::make_shared<const gl::Texture>(std::move(copy));
}

std::vector<PastedParts::Part> PastedParts::parts(const sculpt::Sculpture& sculpture,
                                                  const sculpt::Trimmed& trimmed, const PastedState& state,
                                                  std::size_t places) {
    if (places == 0) {
        derived_.clear();
        return {};
    }
    const Part everything{&sculpture.texels(), &sculpture.cells(), 0};
    const std::size_t count = std::min(places, state.parts.size());
    derived_.resize(count);
    std::vector<Part> parts(places, everything);
    for (std::size_t k = 0; k < count; ++k) {
        const PastedPart& wanted = state.parts[k];
        const auto upTo = state.isOpen(k) ? nullptr : wanted.upTo;
        const bool takesTrimmed = wanted.takesTrimmed || trimmed.isEmpty();
        Derived& part = derived_[k];
        if (!wanted.from && !upTo && takesTrimmed) { // all that was cut
            part = {};
            continue;
        }
        const bool isNew = !part.texels || part.from != wanted.from || part.upTo != upTo ||
                           part.takesTrimmed != takesTrimmed;
        if (isNew) {
            part.from = wanted.from;
            part.upTo = upTo;
            part.takesTrimmed = takesTrimmed;
            part.making = ++makings_;
            try {
                derive(part, sculpture, trimmed, {glm::ivec3(0), sculpture.dims()});
            } catch (...) { // no room for it: it is not there
                part = {};
                throw;
            }
        } else if (part.version != sculpture.version()) {
            derive(part, sculpture, trimmed, sculpture.changedSince(part.version));
        }
        part.version = sculpture.version();
        parts[k] = {&part.texels, &part.cells, part.making};
    }
    return parts;
}

std::vector<glm::vec2> PastedParts::cellsOf(const PastedPart& part, const sculpt::Sculpture& sculpture,
                                            const sculpt::Trimmed& trimmed) {
    Derived derived;
    derived.from = part.from;
    derived.upTo = part.upTo;
    derived.takesTrimmed = part.takesTrimmed || trimmed.isEmpty();
    if (!derived.from && !derived.upTo && derived.takesTrimmed) {
        return sculpture.cells().downloadAll<glm::vec2>();
    }
    derive(derived, sculpture, trimmed, {glm::ivec3(0), sculpture.dims()});
    return derived.cells.downloadAll<glm::vec2>();
}

void PastedParts::derive(Derived& part, const sculpt::Sculpture& sculpture, const sculpt::Trimmed& trimmed,
                         const Box3& box) {
    if (box.isEmpty()) {
        return;
    }
    const gl::Pass pass("derive pasted part");
    if (!program_) {
        program_ =
            gl::Program("sculpt/shaders/derive_part.comp", sculpt::storedDefines(sculpture.precision()));
    }
    if (!part.texels) {
        part.texels = gl::Texture(sculpture.dims(), sculpture.format(), gl::Filter::Linear, "pasted part");
        part.cells = gl::Texture(sculpture.cells().size(), gl::Format::RG32F, gl::Filter::Nearest,
                                 "pasted part cells");
    }
    const gl::Texture& whole = sculpture.texels();
    whole.bindTexture(sculpt::kWholeSculptureTexture);
    (part.upTo ? *part.upTo : whole).bindTexture(sculpt::kUpToTexture);
    (part.from ? *part.from : whole).bindTexture(sculpt::kFromTexture);
    (part.takesTrimmed ? whole : trimmed.leftForTools()).bindTexture(sculpt::kLeftForToolsTexture);
    part.texels.bindImage(sculpt::kPartImage, gl::Access::Write);
    program_.set("first", box.lo)
        .set("last", box.hi)
        .set("has", glm::ivec3(part.upTo ? 1 : 0, part.from ? 1 : 0, part.takesTrimmed ? 0 : 1));
    program_.dispatchOver(box.size(), gl::Barrier::Texture);
    updater_.update(part.texels, box, part.cells);
}

} // namespace vs::studio
