// SPDX-License-Identifier: Apache-2.0
#include "studio/document/live_stroke.h"

#include "base/check.h"
#include "gl/context.h"
#include "studio/document/operation_log.h"
#include "studio/editing/cut_editor.h"
#include "studio/strokes/peel_stroke.h"
#include "studio/strokes/pen_stroke.h"
#include "studio/strokes/solid_strokes.h"

namespace vs::studio {

void LiveStroke::begin(Operation operation) {
    VS_CHECK(contents_.inHand == InHand::Nothing);
    const auto fillIn = [&](auto& op) {
        if constexpr (requires { op.canvas; }) {
            contents_.fillIn(op.canvas);
        }
    };
    std::visit(
        [&](auto& op) {
            if constexpr (std::is_same_v<std::decay_t<decltype(op)>, Fill> ||
                          std::is_same_v<std::decay_t<decltype(op)>, Unfill>) {
                std::visit(fillIn, op.stroke);
            } else {
                fillIn(op);
            }
        },
        operation);
    timer_ = Timer();
    isByHand_ = false;
    cuts_.beginInHand(operation);
    contents_.inHand = InHand::Stroke;
}

bool LiveStroke::isOpen() const { return contents_.inHand == InHand::Stroke; }

template <typename Stroke>
Stroke& LiveStroke::stroke() {
    VS_CHECK(isOpen());
    ++contents_.version;
    return dynamic_cast<Stroke&>(cuts_.stroke());
}

void LiveStroke::peelTo(double layers) { stroke<PeelStroke>().peelTo(layers); }
void LiveStroke::drawAt(const sculpt::PenPoint& pen) { stroke<PenStroke>().drawAt(pen); }
void LiveStroke::clipTo(const Clip& clip) { stroke<ClipStroke>().clipTo(clip); }

Operation LiveStroke::operation() const {
    VS_CHECK(isOpen());
    const Operation operation = cuts_.operation();
    return isByHand_ && cuts_.isRough() ? withoutDetours(operation) : operation;
}

Outcome LiveStroke::commit() {
    Operation operation = this->operation();
    try {
        cuts_.settle(operation);
    } catch (...) {
        contents_.inHand = cuts_.isOpen() ? InHand::Stroke : InHand::Nothing;
        throw;
    }
    operation = cuts_.operation();
    auto entry = log_.prepare(operation, contents_.view, contents_.view);
    Outcome outcome;
    try {
        outcome = cuts_.finish();
    } catch (...) { // there is no memory for what would undo it
        contents_.inHand = cuts_.isOpen() ? InHand::Stroke : InHand::Nothing;
        throw;
    }
    gl::Context::requireDevice();
    contents_.inHand = InHand::Nothing;
    outcome.name = name(operation);
    outcome.milliseconds = timer_.milliseconds();
    if (outcome.voxelsTouched > 0) {
        log_.add(std::move(entry));
        contents_.history.settle();
    }
    return outcome;
}

void LiveStroke::discard() {
    VS_CHECK(isOpen());
    cuts_.discard();
    contents_.inHand = InHand::Nothing;
}

} // namespace vs::studio
