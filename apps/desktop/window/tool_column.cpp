// SPDX-License-Identifier: Apache-2.0
#include "window/tool_column.h"

#include <QAction>
#include <QFrame>
#include <QGridLayout>
#include <QToolButton>

#include <algorithm>

namespace vs::desktop {

namespace {
constexpr int kColumns = 2;
constexpr QSize kButton{62, 46};
} // namespace

ToolColumn::ToolColumn(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
    grid_->setContentsMargins(6, 6, 6, 6);
    grid_->setSpacing(2);
}

void ToolColumn::add(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setObjectName(action->objectName());
    button->setAccessibleName(action->text());
    button->setProperty("column", true);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(QSize(22, 22));
    button->setFixedHeight(kButton.height());
    button->setFocusPolicy(Qt::TabFocus);
    button->ensurePolished(); // or its text is measured in another font
    width_ = std::max({width_, kButton.width(), button->sizeHint().width()});
    grid_->addWidget(button, next_ / kColumns, next_ % kColumns);
    ++next_;
    for (auto* other : findChildren<QToolButton*>()) {
        other->setFixedWidth(width_); // all as wide as the longest text needs
    }
}

void ToolColumn::addSeparator() {
    next_ = (next_ + kColumns - 1) / kColumns * kColumns;
    auto* line = new QFrame;
    line->setFrameShape(QFrame::HLine);
    line->setProperty("separator", true);
    line->setFixedHeight(7);
    grid_->addWidget(line, next_ / kColumns, 0, 1, kColumns);
    next_ += kColumns;
}

} // namespace vs::desktop
