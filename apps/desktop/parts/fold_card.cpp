// SPDX-License-Identifier: Apache-2.0
#include "parts/fold_card.h"

#include "parts/panel_parts.h"

#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

namespace vs::desktop {

FoldCard::FoldCard(const QString& title, const char* buttonName, QWidget* parent) : QFrame(parent) {
    setObjectName("card");
    setAccessibleName(title);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(0);
    title_ = named(new QToolButton, buttonName, title);
    title_->setText(title);
    title_->setProperty("fold", true);
    title_->setCheckable(true);
    title_->setArrowType(Qt::RightArrow);
    title_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    title_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    title_->setFocusPolicy(Qt::TabFocus);
    column->addWidget(title_);
    body_ = new QWidget;
    content_ = new QVBoxLayout(body_);
    content_->setContentsMargins(6, 6, 6, 8);
    content_->setSpacing(8);
    body_->hide();
    column->addWidget(body_);
    connect(title_, &QToolButton::toggled, this, &FoldCard::show);
}

bool FoldCard::isOpen() const { return title_->isChecked(); }
void FoldCard::setOpen(bool open) { title_->setChecked(open); }

void FoldCard::show(bool open) {
    title_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    body_->setVisible(open);
    emit toggled(open);
    if (!open) {
        return;
    }
    QTimer::singleShot(0, this, [this] { // when it has its place
        for (QWidget* around = parentWidget(); around != nullptr; around = around->parentWidget()) {
            if (auto* scroll = qobject_cast<QScrollArea*>(around)) {
                scroll->ensureWidgetVisible(this, 0, 8);
            }
        }
    });
}

} // namespace vs::desktop
