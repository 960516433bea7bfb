// SPDX-License-Identifier: Apache-2.0
#include "view/view_grid.h"

#include "model/studio/studio_controller.h"
#include "parts/theme.h"
#include "view/slice_canvas.h"
#include "view/view_widget.h"

#include <QFocusEvent>
#include <QGridLayout>
#include <QPainter>

namespace vs::desktop {

namespace {

ViewGrid::Arrangement large(render::SliceKind kind) {
    return ViewGrid::Arrangement(int(ViewGrid::Arrangement::Axial) + int(kind));
}

} // namespace

ViewGrid::ViewGrid(StudioController& studio, ToolBox& tools, ViewWidget* view, QWidget* parent)
    : QWidget(parent), view_(view), grid_(new QGridLayout(this)) {
    constexpr int kFrame = 2; // where the frame of what has the keyboard is painted
    grid_->setContentsMargins(kFrame, kFrame, kFrame, kFrame);
    grid_->setSpacing(3);
    grid_->addWidget(view_, 0, 0);
    view_->installEventFilter(this);
    for (const auto kind : render::kSliceKinds) {
        auto* slice = new SliceWidget(studio, tools, kind, this);
        slice->hide();
        slice->findChild<SliceCanvas*>()->installEventFilter(this);
        connect(slice, &SliceWidget::enlargeRequested, this, [this, kind] { enlarge(kind); });
        connect(slice, &SliceWidget::penMoved, this,
                [this, slice, kind] { emit penMoved(kind, slice->canvas().placeUnderPen()); });
        slices_[std::size_t(kind)] = slice;
    }
}

void ViewGrid::offerOnSlices(const QList<QAction*>& actions) {
    for (SliceWidget* slice : slices_) {
        slice->findChild<SliceCanvas*>()->QWidget::addActions(actions);
    }
}

// By Tab the keyboard goes where no pointer shows it; a click needs no frame.
bool ViewGrid::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) {
        const auto reason = static_cast<QFocusEvent*>(event)->reason();
        const bool isShown = event->type() == QEvent::FocusIn &&
                             (reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason);
        auto* widget = qobject_cast<QWidget*>(watched);
        framed_ = !isShown          ? nullptr
                  : widget == view_ ? widget
                                    : widget->parentWidget(); // a slice with its header
        update();
    }
    return QWidget::eventFilter(watched, event);
}

void ViewGrid::paintEvent(QPaintEvent*) {
    if (framed_ != nullptr && framed_->isVisible()) {
        QPainter painter(this);
        const QRect around(framed_->mapTo(this, QPoint(0, 0)), framed_->size());
        painter.fillRect(around.adjusted(-2, -2, 2, 2), theme::kAccent);
    }
}

void ViewGrid::enlarge(render::SliceKind kind) {
    arrange(arrangement_ == large(kind) ? Arrangement::Four : large(kind));
}

void ViewGrid::arrange(Arrangement arrangement) {
    arrangement_ = arrangement;
    for (QWidget* widget : std::initializer_list<QWidget*>{view_, slices_[0], slices_[1], slices_[2]}) {
        grid_->removeWidget(widget);
    }
    for (int n = 0; n < 3; ++n) {
        grid_->setColumnStretch(n, 0);
        grid_->setRowStretch(n, 0);
    }
    const bool isOnly3D = arrangement == Arrangement::Only3D;
    if (isOnly3D) {
        grid_->addWidget(view_, 0, 0);
    } else if (arrangement == Arrangement::Four) {
        grid_->addWidget(slices_[0], 0, 0);
        grid_->addWidget(view_, 0, 1);
        grid_->addWidget(slices_[1], 1, 0);
        grid_->addWidget(slices_[2], 1, 1);
        for (int n = 0; n < 2; ++n) {
            grid_->setColumnStretch(n, 1);
            grid_->setRowStretch(n, 1);
        }
    } else {
        grid_->addWidget(view_, 0, 1);
        int row = 1;
        for (SliceWidget* slice : slices_) {
            if (large(slice->kind()) == arrangement) {
                grid_->addWidget(slice, 0, 0, 3, 1);
            } else {
                grid_->addWidget(slice, row++, 1);
            }
        }
        grid_->setColumnStretch(0, 5);
        grid_->setColumnStretch(1, 3);
        for (int n = 0; n < 3; ++n) {
            grid_->setRowStretch(n, 1);
        }
    }
    view_->setMinimumSize(isOnly3D ? QSize(320, 240)
                                   : QSize(160, 120)); // or it would take room from the slices
    for (SliceWidget* slice : slices_) {
        slice->setVisible(!isOnly3D);
        slice->setLarge(large(slice->kind()) == arrangement);
    }
    emit arranged();
}

} // namespace vs::desktop
