// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/phantom.h"
#include "studio/document/document.h"

namespace vs::test {

// A small head: air 0, a skull shell of 200, inside it brain of 100 with a dark core of 40; spacing 1 x 1
// x 1.2 mm.
inline volume::Volume testHead() {
    return phantom::makePhantom({72, 80, 60}, volume::ScalarType::UInt8,
                                [](glm::dvec3 p) {
                                    const double r = glm::length((p - glm::dvec3(35.5, 39.5, 29.5)) *
                                                                 glm::dvec3(1, 1, 1.2));
                                    return r > 31 ? 0 : r > 27 ? 200 : r > 25 ? 10 : r > 8 ? 100 : 40;
                                },
                                {1, 1, 1.2});
}

inline studio::Canvas testCanvas(Range range = {50, 255}) {
    studio::Canvas canvas;
    canvas.viewport = {400, 300};
    canvas.view.range = range;
    canvas.view.camera.elevationDegrees = 40;
    return canvas;
}

inline studio::Sketch ellipseAt(double x, double y, double rx, double ry) {
    return {studio::Shape::Ellipse, {{x - rx, y - ry}, {x + rx, y + ry}}};
}

inline studio::Peel somePeel(double layers = 8) {
    studio::Peel op;
    op.mask = ellipseAt(200, 110, 40, 30);
    op.layers = layers;
    op.canvas = testCanvas();
    return op;
}

inline studio::Drill drillOf(const studio::Sketch& mask, const studio::Canvas& canvas) {
    studio::Drill op;
    op.mask = mask;
    op.canvas = canvas;
    return op;
}

inline studio::Seed brainSeed() {
    studio::Seed op;
    op.voxels = {{35, 20, 29}};
    op.range = Range{80, 120};
    op.canvas = testCanvas();
    return op;
}

// The probe's view: where fences and empty sculptures can go wrong.
inline studio::View probeView() {
    studio::View view = testCanvas().view;
    view.sculptureView = field::SculptureView::Probe;
    return view;
}

inline studio::Drill drillInProbeView() {
    studio::Drill drill;
    drill.mask = ellipseAt(200, 150, 15, 15);
    drill.canvas = testCanvas();
    drill.canvas->view = probeView();
    return drill;
}

} // namespace vs::test
