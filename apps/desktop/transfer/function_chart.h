// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/document/function_editor.h"
#include "parts/chart_widget.h"

namespace vs::desktop {

// What charts on which a transfer function is edited have in common: one of its parts (points or shapes) is
// chosen; Tab goes through them, arrows move the chosen one (with Shift ten times as far), Delete removes it,
// Return or a double click asks for its colour, Ctrl+Z takes the last step back.
class FunctionChart : public ChartWidget {
    Q_OBJECT

public:
    FunctionChart(FunctionEditor& editor, FunctionEditor::Kind kind);

    // Adds something at a place that a person can then move.
    virtual void addPart() = 0;
    virtual void removeChosen() = 0;

signals:
    void colourWanted();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;

    [[nodiscard]] virtual std::size_t partCount() const = 0;
    // Moves the chosen part by steps: one bin or quantum across, a hundredth of the axis upwards.
    virtual void moveChosen(glm::dvec2 steps) = 0;
    [[nodiscard]] const render::TransferFunction& function() const { return editor_.function(kind_); }
    [[nodiscard]] std::optional<std::size_t> chosen() const { return editor_.chosen(kind_); }
    void change(const std::function<void(render::TransferFunction&)>& edit) { editor_.change(kind_, edit); }
    FunctionEditor& editor() { return editor_; }
    [[nodiscard]] FunctionEditor::Kind kind() const { return kind_; }
    // What is not in use is drawn fainter.
    [[nodiscard]] double strength() const { return editor_.isUsed(kind_) ? 1 : 0.45; }

private:
    FunctionEditor& editor_;
    FunctionEditor::Kind kind_;
};

inline QColor screenColour(render::Colour colour) { return {colour.x, colour.y, colour.z}; }

} // namespace vs::desktop
