// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QToolButton;

namespace vs::desktop {

class FunctionEditor;
class StudioController;

// Shows which transfer function is in use, with its picture; a click opens the gallery. Beside it stand
// buttons to reset it, to open one and to save it as a file.
class FunctionBar : public QWidget {
    Q_OBJECT

public:
    FunctionBar(StudioController& studio, FunctionEditor& editor);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showGallery();
    void open();
    void save();
    void refresh();

    StudioController& studio_;
    FunctionEditor& editor_;
    QToolButton* chosen_;
    QToolButton* reset_;
    QToolButton* save_;
};

} // namespace vs::desktop
