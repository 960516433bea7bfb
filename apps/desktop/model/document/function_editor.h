// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/colours/transfer_function.h"

#include <QObject>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace vs::desktop {

class DocumentHost;
class ViewModel;

// The transfer functions under a person's hands: for each kind (intensity, gradient, both) one that can be
// edited, of which the one in use colours the picture. Positions are absolute. No widgets.
class FunctionEditor : public QObject {
    Q_OBJECT

public:
    using Kind = render::FunctionKind;

    FunctionEditor(DocumentHost& host, ViewModel& view);

    // The function of a kind that is edited: the one in use if it is of that kind, else the last that was,
    // else one to begin with.
    [[nodiscard]] const render::TransferFunction& function(Kind kind) const { return page(kind).function; }
    // Whether the function of a kind colours the picture.
    [[nodiscard]] bool isUsed(Kind kind) const;
    [[nodiscard]] std::optional<Kind> used() const;
    // Number of the point or shape that keys and numbers are for.
    [[nodiscard]] std::optional<std::size_t> chosen(Kind kind) const;
    void choose(Kind kind, std::optional<std::size_t> number);

    // Edits bring their function into use. All changes from one begin() to the next are one step of undo().
    void begin() { isStepBegun_ = false; }
    void change(Kind kind, const std::function<void(render::TransferFunction&)>& edit);
    void use(Kind kind);
    // Takes over a preset's or a file's function, with what it is best looked at with; nothing: the mode's
    // own colours.
    void take(const std::optional<render::TransferFunction>& function);
    // Spreads a named map over the points instead of their colours; empty: colours of their own.
    void useColourMap(const std::string& map);
    [[nodiscard]] bool canUndo() const { return !undo_.empty(); }
    void undo();
    // Whether something has changed since begin().
    [[nodiscard]] bool isEditBegun() const { return isStepBegun_; }

    // How far magnitudes go; 0: not known yet.
    void setGradientTop(double top);

signals:
    void changed();

private:
    struct Page {
        render::TransferFunction function;
        std::optional<std::size_t> chosen;
        bool isTouched = false; // it is not the one to begin with any more
    };
    // What undo() goes back to.
    struct Before {
        std::optional<render::TransferFunction> function;
        render::SuitedView view; // of which the step changed something
    };

    [[nodiscard]] Page& page(Kind kind) { return pages_[std::size_t(kind)]; }
    [[nodiscard]] const Page& page(Kind kind) const { return pages_[std::size_t(kind)]; }
    void forget();
    void followView();
    void makeFirst();
    void remember();
    void announce();
    void publish(const std::optional<render::TransferFunction>& function);

    DocumentHost& host_;
    ViewModel& view_;
    std::array<Page, 3> pages_;
    std::optional<render::TransferFunction> seen_; // of the view, when last looked at
    std::vector<Before> undo_;
    bool isStepBegun_ = false;
    double gradientTop_ = 0;
    Range firstRange_; // that the functions to begin with were made from
};

} // namespace vs::desktop
