// SPDX-License-Identifier: Apache-2.0
// Tools of each kind in hand, for tests of what they do.
#pragma once

#include "gpu/gl_test.h"
#include "gpu/sculpt/surface_makers.h"
#include "gpu/studio/test_head.h"

#include "base/error.h"
#include "gpu/studio/sculpture_bytes.h"

#include <cmath>

namespace vs::studio {

using ToolsTest = test::GlTest;
using test::ellipseAt;
using test::testCanvas;
using test::testHead;

// A document of the head that looks as strokes are drawn.
struct Head : Document {
    Head() : Document(testHead()) { showView(testCanvas().view); }
};

template <typename Pen>
inline Pen penAt(double x, double y, double radius, sculpt::Stroke stroke = {}) {
    Pen op;
    op.mask = ellipseAt(x, y, radius, radius);
    op.stroke = stroke.empty() ? sculpt::Stroke{{{x, y}, 1}} : std::move(stroke);
    op.depthMax = 9;
    op.canvas = testCanvas();
    return op;
}

inline Sweep sweepAcross(double x, double y) {
    Sweep op;
    op.mask = ellipseAt(x, y, 6, 6);
    op.path.kind = SweepPath::Kind::Surface;
    op.path.stroke = {{x - 15, y}, {x, y + 3}, {x + 15, y}};
    op.canvas = testCanvas();
    return op;
}

inline Scissors scissorsAt(double x, double y, double radius) {
    Scissors op;
    op.outline = ellipseAt(x, y, radius, radius);
    op.canvas = testCanvas();
    return op;
}

inline Peel peelAt(double x, double y, double radius) {
    Peel op = test::somePeel(6);
    op.mask = ellipseAt(x, y, radius, radius);
    return op;
}

// Each tool, drawn about a place.
inline std::vector<Operation> toolsAt(double x, double y) {
    Scissors shallow = scissorsAt(x, y, 10);
    shallow.depth = 5;
    return {peelAt(x, y, 12),  penAt<Drill>(x, y, 10), penAt<Laser>(x, y, 10),
            sweepAcross(x, y), scissorsAt(x, y, 10),   shallow};
}

inline Operation restoring(Operation operation) {
    std::visit(
        [](auto& op) {
            if constexpr (requires { op.restores; }) {
                op.restores = true;
            }
        },
        operation);
    return operation;
}

inline std::vector<float> sculptureOf(const Document& document) {
    return sculpt::valuesOf(test::sculptureBytes(document), sculpt::Precision::Bits16);
}

} // namespace vs::studio
