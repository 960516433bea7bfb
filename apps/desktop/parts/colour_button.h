// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

namespace vs::desktop {

// Shows a colour; a click asks for another one in a dialog whose own colours are told apart by colour-blind
// people too. What is tried there is seen at once.
class ColourButton : public QToolButton {
    Q_OBJECT

public:
    ColourButton(const char* objectName, const QString& accessibleName);

    void setColour(const QColor& colour);
    void ask();

signals:
    void asked();                     // a dialog opens: one step begins
    void tried(const QColor& colour); // now, perhaps to be taken back
    void dropped();                   // everything tried since asked() was not meant
    void kept(const QColor& colour);  // this one was

protected:
    void changeEvent(QEvent* event) override;

private:
    void drawIcon();

    QColor colour_{Qt::white};
};

} // namespace vs::desktop
