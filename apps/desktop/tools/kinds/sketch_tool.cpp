// SPDX-License-Identifier: Apache-2.0
#include "tools/kinds/sketch_tool.h"

#include "model/studio/studio_controller.h"

namespace vs::desktop {

template <class Base>
void SketchTool<Base>::press(const Pen& pen) {
    if (!isDrawing_) { // else the next corner of a polyline
        const Hand& hand = this->studio_.hand();
        pad_.begin(hand.shape(), pen.position, hand.stencil(), needs_);
    }
    pad_.press(pen);
    isDrawing_ = true;
    emit this->overlayChanged();
}

template <class Base>
void SketchTool<Base>::move(const Pen& pen) {
    if (isDrawing_) {
        pad_.extend(pen.position);
        emit this->overlayChanged();
    }
}

template <class Base>
void SketchTool<Base>::release(const Pen& pen) {
    if (!isDrawing_) {
        return;
    }
    if (pad_.end(pen.position)) {
        end();
    }
    emit this->overlayChanged();
}

template <class Base>
bool SketchTool<Base>::accept() {
    const bool isDone = isDrawing_ && pad_.finish();
    if (isDone) {
        end();
    }
    return isDone;
}

template <class Base>
void SketchTool<Base>::end() {
    isDrawing_ = false;
    emit this->overlayChanged();
    if (pad_.isOfUse()) {
        takeSketch();
    } else {
        this->clear();
    }
}

template <class Base>
void SketchTool<Base>::clear() {
    isDrawing_ = false;
    pad_.clear();
    emit this->overlayChanged();
}

template <class Base>
studio::Sketch SketchTool<Base>::sketch() const {
    return pad_.sketch(this->studio_.view().devicePerLogical());
}

template class SketchTool<StudioTool>;
template class SketchTool<CutTool>;

} // namespace vs::desktop
