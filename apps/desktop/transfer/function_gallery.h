// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include <functional>
#include <string>

class QGridLayout;
class QToolButton;

namespace vs::desktop {

class FunctionEditor;

// A sheet of pictures that drops down: the transfer functions that the program brings along, and the colour
// tables. A click, or arrow keys and Return, takes one.
class FunctionGallery : public QFrame {
    Q_OBJECT

public:
    FunctionGallery(FunctionEditor& editor, QWidget* parent);

    // Below a widget, or above where there is more room.
    void showAt(const QWidget& widget);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QToolButton* makeButton(const std::string& name, const QString& text, const QString& tip,
                            const QImage& image, const std::function<void()>& take);
    void fillPresets(QGridLayout* grid);
    void fillMaps(QGridLayout* grid);

    FunctionEditor& editor_;
};

} // namespace vs::desktop
