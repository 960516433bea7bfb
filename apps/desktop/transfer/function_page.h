// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/document/function_editor.h"

#include <QWidget>

class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace vs::desktop {

class ColourButton;
class FunctionChart;
class StudioController;

// A chart on which a transfer function is edited, with the numbers and the colour of its chosen part, and a
// line that says why the function is not seen, if so.
class FunctionPage : public QWidget {
    Q_OBJECT

public:
    // A volume was opened.
    virtual void takeDocument() = 0;

protected:
    // The names of its widgets begin with `prefix`.
    FunctionPage(StudioController& studio, FunctionEditor& editor, FunctionEditor::Kind kind,
                 FunctionChart* chart, const QString& prefix);

    // Opacity and colour of the chosen part, and the buttons: add, remove, undo.
    void addLookRow(QVBoxLayout* column);
    void addHint(QVBoxLayout* column);
    QDoubleSpinBox* makeNumber(const QString& name, const QString& accessibleName);
    // Numbers of a quantity: whole ones or so many digits as a thousandth of its range needs.
    static void setDigits(QDoubleSpinBox* box, const Range& range, bool isWhole);

    struct Look {
        double opacity = 0;
        render::Colour colour{255};
    };
    [[nodiscard]] virtual Look lookOf(const render::TransferFunction& function, std::size_t part) const = 0;
    virtual void setOpacity(render::TransferFunction& function, std::size_t part, double opacity) const = 0;
    virtual void setColour(render::TransferFunction& function, std::size_t part,
                           render::Colour colour) const = 0;
    // Shows the numbers of the chosen part, if there is one.
    virtual void refreshNumbers(std::optional<std::size_t> part) = 0;
    // One edit of the chosen part, a step of its own.
    void edit(const std::function<void(render::TransferFunction&, std::size_t)>& change);
    void refresh();
    [[nodiscard]] const render::TransferFunction& function() const { return editor_.function(kind_); }

    StudioController& studio_;
    FunctionEditor& editor_;
    const FunctionEditor::Kind kind_;

private:
    void refreshHint();

    FunctionChart* chart_;
    QString prefix_;
    QDoubleSpinBox* opacity_ = nullptr;
    ColourButton* colour_ = nullptr;
    QToolButton* remove_ = nullptr;
    QToolButton* undo_ = nullptr;
    QLabel* hint_ = nullptr;
};

} // namespace vs::desktop
