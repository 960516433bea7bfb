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

void Trimmed::make(const Sculpture& sculpture) {
    leftForTools_ = gl::Texture(sculpture.dims(), sculpture.format(), gl::Filter::Nearest, "left for tools");
    leftForTools_.bindImage(kLeftForToolsImage, gl::Access::Write);
    program_.set("first", glm::ivec3(0)).set("last", sculpture.dims()).set("isNew", 1);
    program_.dispatchOver(sculpture.dims(), gl::Barrier::Image);
}

BrickDelta Trimmed::follow(Sculpture& sculpture, BrickDelta& change, bool isTrim) {
    if (change.isEmpty() || (isEmpty() && !isTrim)) {
        return {};
    }
    const gl::Pass pass("follow a trim");
    prepare(sculpture);
    const Box3 box = change.box();
    gl::Texture before;
    if (isTrim) {
        before = gl::Texture(box.size(), sculpture.format(), gl::Filter::Nearest, "sculpture before a trim");
        if (isEmpty()) {
            make(sculpture);
        }
        sculpture.swap(change);
        before.copyFrom(sculpture.texels(), box, glm::ivec3(0));
        sculpture.swap(change);
    }
    BrickBackup backup(leftForTools_);
    for (const Box3& brick : change.bricks()) {
        backup.protect(brick);
    }
    sculpture.texels().bindTexture(kWholeSculptureTexture);
    (isTrim ? before : sculpture.texels()).bindTexture(kBeforeTexture);
    leftForTools_.bindImage(kLeftForToolsImage, gl::Access::ReadWrite);
    program_.set("first", box.lo).set("last", box.hi).set("isTrim", isTrim ? 1 : 0).set("isNew", 0);
    program_.dispatchOver(box.size(), gl::Barrier::Texture);
    return backup.finish();
}

BrickDelta Trimmed::content(Precision precision) const {
    const float all = 1; // what make() leaves for tools
    return contentOf(leftForTools_, bricksOf(leftForTools_.size()), texelsOf({&all, 1}, precision));
}

void Trimmed::restore(const Sculpture& sculpture, const BrickDelta& content) {
    prepare(sculpture);
    make(sculpture);
    const float all = 1; // what make() leaves for tools
    content.bringInto(leftForTools_, texelsOf({&all, 1}, sculpture.precision()));
}

} // namespace vs::sculpt
