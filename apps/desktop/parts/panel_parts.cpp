// SPDX-License-Identifier: Apache-2.0
#include "parts/panel_parts.h"

#include "model/texts/language.h"
#include "parts/icons.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QLocale>
#include <QVBoxLayout>

#include <cmath>

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

void tipIfSilent(QWidget& widget, const QString& tip) {
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    const bool isBox = qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
                       qobject_cast<const QAbstractSlider*>(&widget) != nullptr ||
                       qobject_cast<const QComboBox*>(&widget) != nullptr ||
                       qobject_cast<const QLineEdit*>(&widget) != nullptr;
    if (isBox || (button != nullptr && button->text().remove("…") != tip)) {
        widget.setToolTip(tip);
    }
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

QFormLayout* makeForm(QWidget* page) {
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(8);
    form->setHorizontalSpacing(12);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    return form;
}

QSlider* makeSlider(const char* objectName, const QString& accessibleName, int lo, int hi, int value) {
    auto* slider = named(new QSlider(Qt::Horizontal), objectName, accessibleName);
    slider->setRange(lo, hi);
    slider->setValue(value);
    return slider;
}

QWidget* withValue(QSlider* slider, const std::function<QString(int)>& format) {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    auto* value = new QLabel(format(slider->value()));
    value->setMinimumWidth(46);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(slider, 1);
    row->addWidget(value);
    QObject::connect(slider, &QSlider::valueChanged, value,
                     [value, format](int v) { value->setText(format(v)); });
    return holder;
}

QCheckBox* makeCheckBox(const char* objectName, const QString& text, const QString& tip, bool isOn) {
    auto* box = named(new QCheckBox(text), objectName, text);
    box->setToolTip(tip);
    box->setChecked(isOn);
    box->setFocusPolicy(Qt::TabFocus);
    return box;
}

ChoiceRow::ChoiceRow(const std::vector<Choice>& choices, int chosenAtFirst, int perRow) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(3);
    auto* group = new QButtonGroup(this);
    for (int n = 0; n < int(choices.size()); ++n) {
        const Choice& choice = choices[std::size_t(n)];
        auto* button = named(new QToolButton, choice.objectName, choice.text);
        button->setText(choice.text);
        button->setToolTip(choice.tip);
        button->setCheckable(true);
        button->setProperty("choice", true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        group->addButton(button, n);
        grid->addWidget(button, n / perRow, n % perRow);
        buttons_.push_back(button);
    }
    choose(chosenAtFirst);
    connect(group, &QButtonGroup::idClicked, this, &ChoiceRow::chosen);
}

void ChoiceRow::rename(int choice, const QString& text, const QString& tip) {
    QToolButton* button = buttons_.at(std::size_t(choice));
    button->setText(text);
    button->setAccessibleName(text);
    button->setToolTip(tip);
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

double numberIn(const QDoubleSpinBox& box, double before) {
    const bool isSame = std::abs(box.value() - before) <= 0.51 * std::pow(10.0, -box.decimals());
    return isSame ? before : box.value();
}

QString grouped(qulonglong number) {
    const QString text = QLocale(QLocale::English).toString(number);
    // A comma is a decimal sign elsewhere, and numbers have points in every language.
    return textLocale().language() == QLocale::English ? text : QString(text).replace(',', QChar(0x202f));
}

} // namespace vs::desktop
