// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>
#include <QFrame>
#include <QLabel>
#include <QSlider>
#include <QString>
#include <QToolButton>

#include <functional>
#include <vector>

class QCheckBox;
class QFormLayout;
class QVBoxLayout;

namespace vs::desktop {

// A framed group with a title; fill the returned frame's layout.
QFrame* makeCard(const QString& title, QVBoxLayout*& content);

// A label in the quieter colour.
QLabel* makeQuietLabel(const QString& text);

// A tip for what can be used and does not say what it is, until it gets a better one.
void tipIfSilent(QWidget& widget, const QString& tip);

// Gives a widget the name that scripts find it by and the one that screen readers say.
template <typename W>
W* named(W* widget, const char* objectName, const QString& accessibleName) {
    widget->setObjectName(objectName);
    widget->setAccessibleName(accessibleName);
    tipIfSilent(*widget, accessibleName);
    return widget;
}

// An icon button with a tooltip.
QToolButton* makeIconButton(const char* iconName, const char* objectName, const QString& text,
                            const QString& tip);

// Rows of settings, each with its name.
QFormLayout* makeForm(QWidget* page);

QSlider* makeSlider(const char* objectName, const QString& accessibleName, int lo, int hi, int value);

// A slider with its value beside it.
QWidget* withValue(QSlider* slider, const std::function<QString(int)>& format);

QCheckBox* makeCheckBox(const char* objectName, const QString& text, const QString& tip, bool isOn);

// A few things of which one holds, as buttons side by side, `perRow` in a row.
class ChoiceRow : public QWidget {
    Q_OBJECT

public:
    struct Choice {
        const char* objectName;
        QString text;
        QString tip;
    };
    ChoiceRow(const std::vector<Choice>& choices, int chosen, int perRow = 4);
    void choose(int choice) { buttons_.at(std::size_t(choice))->setChecked(true); }
    void rename(int choice, const QString& text, const QString& tip);

signals:
    void chosen(int choice); // by the person

private:
    std::vector<QToolButton*> buttons_;
};

// A number that is taken over when typing is finished, not at every digit.
QDoubleSpinBox* makeSpinBox(const char* objectName, const QString& accessibleName);

// What a box says that showed `before`, which it may have rounded.
double numberIn(const QDoubleSpinBox& box, double before);

// A number with separators between thousands.
QString grouped(qulonglong number);

} // namespace vs::desktop
