// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/trimmed.h"

#include "gl/pass.h"
#include "sculpt/shaders/bindings.h"

namespace vs::sculpt {

void Trimmed::prepare(const Sculpture& sculpture) {
    if (!program_) {
        program_ = gl::Program("sculpt/shaders/follow_trim.comp", storedDefines(sculpture.precision()));
    }
}

gl::Texture Trimmed::nothingTrimmed(const Sculpture& sculpture) {
    gl::Texture left(sculpture.dims(), sculpture.format(), gl::Filter::Nearest, "left for tools");
    left.bindImage(kLeftForToolsImage, gl::Access::Write);
    program_.set("first", glm::ivec3(0)).set("last", sculpture.dims()).set("isNew", 1);
    program_.dispatchOver(sculpture.dims(), gl::Barrier::Image);
    return left;
}

BrickDelta Trimmed::follow(const Sculpture& sculpture, const BrickDelta& change, bool isTrim) {
    if (change.isEmpty() || (isEmpty() && !isTrim)) {
        return {};
    }
    const gl::Pass pass("follow a trim");
    prepare(sculpture);
    const Box3 box = change.box();
    const gl::Texture before =
        isTrim ? change.before(sculpture.texels(), "sculpture before a trim") : gl::Texture();
    if (isEmpty()) {
        leftForTools_ = nothingTrimmed(sculpture);
        try {
            return follow(sculpture, change, box, before);
        } catch (...) {
            leftForTools_ = {};
            throw;
        }
    }
    return follow(sculpture, change, box, before);
}

// Where it throws, nothing has changed.
BrickDelta Trimmed::follow(const Sculpture& sculpture, const BrickDelta& change, const Box3& box,
                           const gl::Texture& before) {
    const bool isTrim = bool(before);
    BrickBackup backup(leftForTools_);
    for (const Box3& brick : change.bricks()) {
        backup.protect(brick);
    }
    sculpture.texels().bindTexture(kWholeSculptureTexture);
    (isTrim ? before : sculpture.texels()).bindTexture(kBeforeTexture);
    leftForTools_.bindImage(kLeftForToolsImage, gl::Access::ReadWrite);
    program_.set("first", box.lo).set("last", box.hi).set("isTrim", isTrim ? 1 : 0).set("isNew", 0);
    program_.dispatchOver(box.size(), gl::Barrier::Texture);
    try {
        return backup.finish();
    } catch (...) { // no memory to hold what would undo it
        backup.restore();
        throw;
    }
}

BrickDelta Trimmed::content(Precision precision) const {
    const float all = 1; // of which everything is left
    return contentOf(leftForTools_, bricksOf(leftForTools_.size()), texelsOf({&all, 1}, precision));
}

void Trimmed::restore(const Sculpture& sculpture, const BrickDelta& content) {
    prepare(sculpture);
    gl::Texture left = nothingTrimmed(sculpture);
    const float all = 1; // of which everything is left
    content.bringInto(left, texelsOf({&all, 1}, sculpture.precision()));
    leftForTools_ = std::move(left);
}

} // namespace vs::sculpt
