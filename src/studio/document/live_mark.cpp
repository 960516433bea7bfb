// SPDX-License-Identifier: Apache-2.0
#include "studio/document/live_mark.h"

#include "base/check.h"
#include "gl/context.h"
#include "studio/document/operation_log.h"
#include "studio/marking/mark_editor.h"

namespace vs::studio {

void LiveMark::begin(Mark mark) {
    VS_CHECK(contents_.inHand == InHand::Nothing && mark.kind == Mark::Kind::Line);
    contents_.fillIn(mark.canvas);
    timer_ = Timer();
    marks_.begin(mark);
    contents_.inHand = InHand::Mark;
}

void LiveMark::drawAt(const sculpt::PenPoint& pen) {
    VS_CHECK(isOpen());
    marks_.drawAt(pen);
}

bool LiveMark::isOpen() const { return contents_.inHand == InHand::Mark; }

Outcome LiveMark::commit() {
    VS_CHECK(isOpen());
    try {
        const Operation operation = marks_.stroke().operation();
        auto entry = log_.prepare(operation, contents_.view, contents_.view);
        Outcome outcome = marks_.finish();
        gl::Context::requireDevice();
        contents_.inHand = InHand::Nothing;
        outcome.name = name(operation);
        outcome.milliseconds = timer_.milliseconds();
        if (outcome.voxelsTouched > 0) {
            log_.add(std::move(entry));
            contents_.history.settle();
        }
        return outcome;
    } catch (...) { // there is no memory for what would undo it, or no room for more marks
        if (marks_.isOpen()) {
            marks_.discard();
        }
        contents_.inHand = InHand::Nothing;
        throw;
    }
}

void LiveMark::discard() {
    VS_CHECK(isOpen());
    marks_.discard();
    contents_.inHand = InHand::Nothing;
}

} // namespace vs::studio
