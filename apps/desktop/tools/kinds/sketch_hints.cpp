// SPDX-License-Identifier: Apache-2.0
#include "tools/kinds/sketch_hints.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"

namespace vs::desktop {

namespace {

using studio::Shape;

struct EndWords {
    QString lift;  // letting go ends it
    QString ends;  // keys and clicks that end a polyline
    QString close; // a click on the first corner
};

EndWords wordsOf(SketchEnd end) {
    switch (end) {
    case SketchEnd::Mask:
        return {tr("Let go to close the mask."),
                tr("Enter, a double click or a click on the first corner closes the mask."),
                tr("Click the first corner to close the mask.")};
    case SketchEnd::Cut:
        return {tr("Let go to cut."), tr("Enter, a double click or a click on the first corner cuts."),
                tr("Click the first corner to cut.")};
    case SketchEnd::Restore:
        return {tr("Let go to put it back."),
                tr("Enter, a double click or a click on the first corner puts it back."),
                tr("Click the first corner to put it back.")};
    case SketchEnd::Remove:
        return {tr("Let go to remove it."),
                tr("Enter, a double click or a click on the first corner removes it."),
                tr("Click the first corner to remove it.")};
    case SketchEnd::Add:
        return {tr("Let go to add it."), tr("Enter, a double click or a click on the first corner adds it."),
                tr("Click the first corner to add it.")};
    case SketchEnd::Seed:
        return {tr("Let go to place the seeds."), tr("Enter or a double click places the seeds."),
                tr("Click the first corner to close the line and place the seeds.")};
    case SketchEnd::Fill:
        return {tr("Let go to fill it."),
                tr("Enter, a double click or a click on the first corner fills it."),
                tr("Click the first corner to fill it.")};
    case SketchEnd::Mark:
        return {tr("Let go to mark it."), tr("Enter or a double click marks it."),
                tr("Click the first corner to close the line and mark it.")};
    case SketchEnd::MarkArea:
        return {tr("Let go to colour it."),
                tr("Enter, a double click or a click on the first corner colours it."),
                tr("Click the first corner to colour it.")};
    case SketchEnd::Absorb:
        break;
    }
    return {tr("Let go to absorb from here."), tr("Enter or a double click absorbs from here."),
            tr("Click the first corner to close the line and absorb from here.")};
}

// The next corner of a polyline whose button is up.
QString nextCorner(std::size_t corners) {
    return corners == 1   ? tr("Click the second corner.")
           : corners == 2 ? tr("Click the third corner.")
                          : tr("Click the next corner.");
}

QString polylineHint(const SketchPad& pad, const EndWords& words) {
    if (pad.isHeld()) {
        if (pad.isAtFirstCorner()) {
            return words.lift;
        }
        if (!pad.isAtLastCorner()) {
            return tr("Let go to set a corner here.");
        }
        return pad.isOfUse() ? words.lift
                             : tr("A corner is here. Let go and click the next one, or drag on to it.");
    }
    if (pad.isAtFirstCorner()) {
        return words.close;
    }
    return pad.isOfUse() ? nextCorner(pad.corners()) + " " + words.ends : nextCorner(pad.corners());
}

} // namespace

QString lockedHint(StudioController& studio) {
    const auto& working = studio.segments().list().working();
    return working.isLocked ? tr("%1 is locked: unlock it, or go to work on another segment.")
                                  .arg(QString::fromStdString(working.name))
                            : QString();
}

QString howToDraw(Shape shape, SketchPad::Needs needs) {
    switch (shape) {
    case Shape::FreeForm:
        return needs == SketchPad::Needs::Line ? tr("Free-form: press and draw a line.")
                                               : tr("Free-form: press and draw; it closes when you let go.");
    case Shape::Polyline:
        return tr("Polyline: click corner after corner.");
    case Shape::Circle:
        return tr("Circle: drag from its centre to its rim.");
    case Shape::Ellipse:
        return tr("Ellipse: drag from corner to corner of its box.");
    case Shape::Rectangle:
        return tr("Rectangle: drag from corner to corner.");
    case Shape::Stencil:
        break;
    }
    return tr("Picture: drag the box that it fills.");
}

QString sketchHint(const SketchPad& pad, SketchEnd end) {
    const EndWords words = wordsOf(end);
    const QString drop = " " + tr("Esc drops it.");
    if (pad.shape() == Shape::Polyline) {
        return polylineHint(pad, words) + drop;
    }
    return (pad.isOfUse() ? words.lift : tr("Go on: nothing is enclosed yet.")) + drop;
}

Overlays sketchOverlays(const SketchPad& pad, Overlay::Tint tint, double lineWidth) {
    Overlays overlays;
    if (pad.isLine()) {
        overlays.push_back({pad.area(), tint, 0, lineWidth});
        overlays.push_back({pad.stretchToPen(), Overlay::Tint::Pen, 0, 1});
    } else {
        overlays.push_back({pad.area(), tint, Overlay::kMaskFill, 1});
        overlays.push_back({pad.outline(), Overlay::Tint::Pen});
    }
    if (const QPainterPath ring = pad.firstCorner(); !ring.isEmpty()) {
        overlays.push_back({ring, tint, pad.isAtFirstCorner() ? 0.6 : 0.0});
    }
    return overlays;
}

} // namespace vs::desktop
