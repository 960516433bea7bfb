// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/cut_stroke.h"

#include <algorithm>
#include <utility>

namespace vs::studio {

sculpt::SculptureDelta CutStroke::finish() {
    const sculpt::FineSculpture* finer = cutter_->sculpture->finer();
    // What needs memory comes first: when it throws, everything is as it was.
    sculpt::FineDelta finest = finer != nullptr ? finer->since(originals_) : sculpt::FineDelta();
    sculpt::SculptureDelta delta(backup_.finish(), std::move(finest));
    originals_.clear();
    if (cutsInScene_) {
        cutter_->sculpture->cutFiner(delta);
    }
    if (delta.isEmpty()) {
        cutter_->sculpture->contentIsAsAt(contentVersion_);
    }
    return delta;
}

Box3 CutStroke::cutBy(const sculpt::CutTarget::Part& part, const std::vector<float>& energies) {
    const glm::ivec3 origin = part.sculpture->origin();
    const Box3 texels{part.within.lo - origin, part.within.hi - origin};
    std::vector<float> values = part.sculpture->values(texels);
    const std::vector<float> most = sculpt::mostEnergies(part.sculpture->limits(), texels);
    bool isAny = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float energy = most.empty() ? energies[i] : std::min(energies[i], most[i]);
        isAny = isAny || energy > values[i];
        values[i] = std::max(values[i], energy);
    }
    if (!isAny) {
        return {};
    }
    if (part.backup != nullptr) {
        part.backup->protect(part.within);
    }
    part.sculpture->upload(texels, sculpt::texelsOf(values, part.sculpture->precision()));
    return part.within;
}

void CutStroke::takeBack(sculpt::SculptureDelta& delta) {
    if (fillBefore_ != nullptr) {
        *cutter_->fill = fillBefore_;
    }
    cutter_->sculpture->swap(delta);
    cutter_->sculpture->contentIsAsAt(contentVersion_);
}

void CutStroke::discard() {
    if (fillBefore_ != nullptr) {
        *cutter_->fill = fillBefore_;
    }
    if (!originals_.empty()) {
        cutter_->sculpture->finer()->takeBack(originals_);
        originals_.clear();
    }
    if (!backup_.isEmpty()) {
        cutter_->sculpture->refresh(backup_.restore());
        cutter_->sculpture->contentIsAsAt(contentVersion_);
    }
}

} // namespace vs::studio
