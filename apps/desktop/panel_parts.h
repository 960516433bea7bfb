// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>
#include <QFrame>
#include <QLabel>
#include <QString>
#include <QToolButton>

class QVBoxLayout;

namespace vs::desktop {

// A framed group with a title; fill the returned frame's layout.
QFrame* makeCard(const QString& title, QVBoxLayout*& content);

// A label in the quieter colour.
QLabel* makeQuietLabel(const QString& text);

// Gives a widget the name that scripts find it by and the one that screen readers say.
template <typename W>
W* named(W* widget, const char* objectName, const QString& accessibleName) {
    widget->setObjectName(objectName);
    widget->setAccessibleName(accessibleName);
    return widget;
}

// An icon button with a tooltip.
QToolButton* makeIconButton(const char* iconName, const char* objectName, const QString& text,
                            const QString& tip);

// A number that is taken over when typing is finished, not at every digit.
QDoubleSpinBox* makeSpinBox(const char* objectName, const QString& accessibleName);

// With separators between thousands.
QString grouped(qulonglong number);

} // namespace vs::desktop
