// SPDX-License-Identifier: Apache-2.0
#include "tools/mark_tool.h"

#include "model/studio/studio_controller.h"
#include "studio/document/document.h"
#include "studio/document/live_mark.h"
#include "tools/kinds/sketch_hints.h"

#include <algorithm>

namespace vs::desktop {

MarkTool::MarkTool(StudioController& studio) : SketchTool(studio, SketchPad::Needs::Line) {
    mark_.text = std::string("R");
}

bool MarkTool::isLive() const {
    return kind_ == Kind::Line && studio_.hand().shape() == studio::Shape::FreeForm;
}

QString MarkTool::hint() const {
    if (isDrawing_) {
        return erases_ ? tr("Erasing: let go to keep, Esc to undo.")
                       : tr("Marking: press harder for more. Let go to keep, Esc to undo.");
    }
    if (isSketching()) {
        return sketchHint(pad(), kind_ == Kind::Area ? SketchEnd::MarkArea : SketchEnd::Mark);
    }
    if (kind_ == Kind::Text) {
        return erases_ ? tr("Click where the letters should be wiped off.")
                       : tr("Click where the letters should stand; they are written upright.");
    }
    const QString what = erases_                ? tr("Draw over the marks that should go.")
                         : kind_ == Kind::Area  ? tr("Draw around what should be coloured.")
                         : kind_ == Kind::Arrow ? tr("Draw an arrow, its head at the end.")
                                                : tr("Draw on the surface: the marks stay on the material.");
    return what + " " +
           howToDraw(studio_.hand().shape(),
                     kind_ == Kind::Area ? SketchPad::Needs::Area : SketchPad::Needs::Line);
}

Overlays MarkTool::overlays() const {
    return isSketching() ? sketchOverlays(pad(), erases_ ? Overlay::Tint::Cutting : Overlay::Tint::Pen)
                         : Overlays{};
}

studio::Mark MarkTool::markOf(const studio::Sketch& sketch) const {
    studio::Mark mark = mark_;
    mark.kind = kind_;
    mark.sketch = sketch;
    mark.erases = erases_;
    mark.softMm = softness_ * 0.5 * mark.widthMm;
    mark.dashMm = isDashed_ && (kind_ == Kind::Line || kind_ == Kind::Arrow) ? 3 * mark.widthMm : 0;
    if (kind_ != Kind::Text) {
        mark.text.clear();
    }
    mark.canvas = studio_.view().canvas();
    return mark;
}

void MarkTool::press(const Pen& pen) {
    if (kind_ == Kind::Text) {
        write(pen);
        return;
    }
    if (!isLive()) {
        SketchTool::press(pen);
        return;
    }
    waiting_.clear();
    last_ = {glm::dvec2(-1e9), 0, {}};
    isDrawing_ = studio_.editor().beginStroke([&](auto& document, const auto& canvas) {
        studio::Mark mark = markOf({});
        mark.canvas = canvas;
        document.mark().begin(std::move(mark));
    });
    if (isDrawing_) {
        lead(pen);
        emit overlayChanged();
    }
}

void MarkTool::move(const Pen& pen) {
    if (isDrawing_) {
        lead(pen);
    } else {
        SketchTool::move(pen);
    }
}

void MarkTool::release(const Pen& pen) {
    if (!isDrawing_) {
        SketchTool::release(pen);
        return;
    }
    draw(1e9);        // all that is waiting
    if (isDrawing_) { // else that failed
        endLine(true);
    }
}

void MarkTool::clear() {
    if (isDrawing_) {
        endLine(false);
    } else {
        SketchTool::clear();
    }
}

void MarkTool::viewResized() { clear(); }

void MarkTool::lead(const Pen& pen) {
    const sculpt::PenPoint point{
        glm::dvec2(pen.position.x(), pen.position.y()) * studio_.view().devicePerLogical(), pen.pressure, {}};
    // What the pen has covered it covers once: from the same place, pressed no harder, nothing would change.
    if (glm::distance(point.pixel, last_.pixel) < 1 && point.pressure <= last_.pressure) {
        return;
    }
    last_ = point;
    waiting_.push_back(point);
    studio_.host().wake();
}

void MarkTool::advance() {
    constexpr double kPortionMs = 18; // less, and a hasty pen would be followed ever later
    draw(kPortionMs);
}

void MarkTool::draw(double budgetMs) {
    const Timer timer;
    while (isDrawing_ && !waiting_.empty()) {
        const sculpt::PenPoint point = waiting_.front();
        waiting_.pop_front();
        if (!studio_.host().workLong([&] { studio_.host().document()->mark().drawAt(point); })) {
            endLine(false);
            return;
        }
        if (timer.milliseconds() > budgetMs) {
            studio_.host().wake();
            return;
        }
    }
}

void MarkTool::endLine(bool keep) {
    studio_.editor().endStroke(keep);
    isDrawing_ = false;
    waiting_.clear();
    emit overlayChanged();
}

void MarkTool::takeSketch() {
    const studio::Mark mark = markOf(sketch());
    SketchTool::clear();
    studio_.editor().apply(mark);
}

void MarkTool::write(const Pen& pen) {
    if (mark_.text.empty()) {
        studio_.host().say(tr("Type the letters first, on the tool's page."));
        return;
    }
    const glm::dvec2 at = glm::dvec2(pen.position.x(), pen.position.y()) * studio_.view().devicePerLogical();
    studio_.editor().apply(markOf({studio::Shape::FreeForm, {at}}));
}

void MarkTool::removeAll() { studio_.editor().apply(studio::RemoveMarks{}); }

void MarkTool::tell() {
    emit settingsChanged();
    emit overlayChanged();
}

void MarkTool::setReversed(bool reversed) {
    if (reversed != erases_ && !isDrawing_) {
        erases_ = reversed;
        tell();
    }
}

void MarkTool::setKind(Kind kind) {
    clear();
    kind_ = kind;
    setNeeds(kind == Kind::Area ? SketchPad::Needs::Area : SketchPad::Needs::Line);
    tell();
}

void MarkTool::setColour(const QColor& colour) {
    mark_.colour = {colour.redF(), colour.greenF(), colour.blueF()};
    tell();
}

QColor MarkTool::colour() const {
    return QColor::fromRgbF(float(mark_.colour.x), float(mark_.colour.y), float(mark_.colour.z));
}

void MarkTool::setOpacity(double part) {
    mark_.opacity = std::clamp(part, 0.0, 1.0);
    tell();
}

void MarkTool::setWidthMm(double mm) {
    mark_.widthMm = std::clamp(mm, kLeastMm, kMostMm);
    tell();
}

void MarkTool::setSoftness(double part) {
    softness_ = std::clamp(part, 0.0, 1.0);
    tell();
}

void MarkTool::setDashed(bool on) {
    isDashed_ = on;
    tell();
}

void MarkTool::setPressureSets(studio::Mark::Pressure what) {
    mark_.pressureSets = what;
    tell();
}

void MarkTool::setText(const QString& text) {
    mark_.text = text.trimmed().toStdString();
    tell();
}

void MarkTool::setSizeMm(double mm) {
    mark_.sizeMm = std::clamp(mm, 1.0, 100.0);
    tell();
}

} // namespace vs::desktop
