// SPDX-License-Identifier: Apache-2.0
#include "transfer/function_chart.h"

#include <QKeyEvent>

namespace vs::desktop {

namespace {

bool isOurs(const QKeyEvent& event) {
    switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return true;
    default:
        return event.matches(QKeySequence::Undo);
    }
}

} // namespace

FunctionChart::FunctionChart(FunctionEditor& editor, FunctionEditor::Kind kind)
    : editor_(editor), kind_(kind) {
    connect(&editor_, &FunctionEditor::changed, this, qOverload<>(&QWidget::update));
}

bool FunctionChart::event(QEvent* event) {
    // The window's own shortcuts come later.
    if (event->type() == QEvent::ShortcutOverride && isOurs(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return ChartWidget::event(event);
}

void FunctionChart::keyPressEvent(QKeyEvent* event) {
    if (isEmpty() || !isOurs(*event)) {
        ChartWidget::keyPressEvent(event);
        return;
    }
    if (event->matches(QKeySequence::Undo)) {
        editor_.undo();
        return;
    }
    if (!chosen()) {
        return;
    }
    const double far = event->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1;
    if (!event->isAutoRepeat()) {
        editor_.begin();
    }
    switch (event->key()) {
    case Qt::Key_Left:
        return moveChosen({-far, 0});
    case Qt::Key_Right:
        return moveChosen({far, 0});
    case Qt::Key_Up:
        return moveChosen({0, far});
    case Qt::Key_Down:
        return moveChosen({0, -far});
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return removeChosen();
    default:
        emit colourWanted();
    }
}

// Through the parts first, then on to the next widget.
bool FunctionChart::focusNextPrevChild(bool next) {
    const std::size_t count = partCount();
    const auto at = chosen();
    if (isEmpty() || count == 0 || (at && (next ? *at + 1 >= count : *at == 0))) {
        editor_.choose(kind_, std::nullopt);
        return ChartWidget::focusNextPrevChild(next);
    }
    editor_.choose(kind_, !at ? (next ? 0 : count - 1) : next ? *at + 1 : *at - 1);
    return true;
}

} // namespace vs::desktop
