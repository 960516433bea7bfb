// SPDX-License-Identifier: Apache-2.0
#include "panel_parts.h"

#include "icons.h"

#include <QLocale>
#include <QVBoxLayout>

namespace vs::desktop {

QFrame* makeCard(const QString& title, QVBoxLayout*& content) {
    auto* card = new QFrame;
    card->setObjectName("card");
    card->setAccessibleName(title);
    content = new QVBoxLayout(card);
    content->setContentsMargins(12, 9, 12, 12);
    content->setSpacing(8);
    auto* heading = new QLabel(title);
    heading->setObjectName("cardTitle");
    content->addWidget(heading);
    return card;
}

QLabel* makeQuietLabel(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("quiet", true);
    return label;
}

QToolButton* makeIconButton(const char* iconName, const char* objectName, const QString& text,
                            const QString& tip) {
    auto* button = named(new QToolButton, objectName, text);
    button->setIcon(icon(iconName));
    button->setIconSize(QSize(20, 20));
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QDoubleSpinBox* makeSpinBox(const char* objectName, const QString& accessibleName) {
    auto* box = named(new QDoubleSpinBox, objectName, accessibleName);
    box->setKeyboardTracking(false);
    box->setAlignment(Qt::AlignRight);
    box->setLocale(QLocale::c());
    box->setMinimumWidth(84);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons); // wheel and arrow keys do
    // The single-key shortcuts work again once a number is typed.
    QObject::connect(box, &QAbstractSpinBox::editingFinished, box, &QWidget::clearFocus);
    return box;
}

QString grouped(qulonglong number) { return QLocale(QLocale::English).toString(number); }

} // namespace vs::desktop
