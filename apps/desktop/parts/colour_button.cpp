// SPDX-License-Identifier: Apache-2.0
#include "parts/colour_button.h"

#include "parts/panel_parts.h"

#include "render/colours/function_edits.h"

#include <QColorDialog>
#include <QEvent>
#include <QPainter>

namespace vs::desktop {

ColourButton::ColourButton(const char* objectName, const QString& accessibleName) {
    named(this, objectName, accessibleName);
    setToolTip(tr("The colour; click to choose another one"));
    setIconSize(QSize(26, 16));
    setProperty("choice", true);
    setFocusPolicy(Qt::TabFocus);
    connect(this, &QToolButton::clicked, this, &ColourButton::ask);
    drawIcon();
}

void ColourButton::setColour(const QColor& colour) {
    if (colour != colour_) {
        colour_ = colour;
        drawIcon();
    }
}

void ColourButton::changeEvent(QEvent* event) {
    if (event->type() == QEvent::EnabledChange || event->type() == QEvent::PaletteChange) {
        drawIcon();
    }
    QToolButton::changeEvent(event);
}

void ColourButton::drawIcon() {
    const double ratio = devicePixelRatioF();
    QPixmap pixmap((QSizeF(iconSize()) * ratio).toSize());
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(isEnabled() ? colour_ : palette().color(QPalette::Window));
    painter.drawRoundedRect(QRectF(QPointF(0, 0), QSizeF(iconSize())).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    painter.end();
    setIcon(pixmap);
}

void ColourButton::ask() {
    if (!isEnabled()) {
        return;
    }
    for (std::size_t i = 0; i < render::kSafeColours.size(); ++i) {
        const auto safe = render::kSafeColours[i];
        QColorDialog::setCustomColor(int(i), QColor(safe.x, safe.y, safe.z));
    }
    auto* dialog = new QColorDialog(colour_, window());
    dialog->setObjectName("colourDialog");
    dialog->setWindowTitle(tr("Colour"));
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    emit asked();
    connect(dialog, &QColorDialog::currentColorChanged, this, &ColourButton::tried);
    connect(dialog, &QColorDialog::colorSelected, this, &ColourButton::kept);
    connect(dialog, &QDialog::rejected, this, &ColourButton::dropped);
    dialog->open();
}

} // namespace vs::desktop
