// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

class QToolButton;
class QVBoxLayout;

namespace vs::desktop {

// A card whose title opens and closes it. Opened in a scroll area, it is brought into sight.
class FoldCard : public QFrame {
    Q_OBJECT

public:
    // `buttonName` is the object name of the title's button.
    FoldCard(const QString& title, const char* buttonName, QWidget* parent = nullptr);

    // What is shown when it is open.
    [[nodiscard]] QVBoxLayout* content() const { return content_; }
    [[nodiscard]] bool isOpen() const;
    void setOpen(bool open);

signals:
    void toggled(bool isOpen);

private:
    void show(bool open);

    QToolButton* title_;
    QWidget* body_;
    QVBoxLayout* content_;
};

} // namespace vs::desktop
