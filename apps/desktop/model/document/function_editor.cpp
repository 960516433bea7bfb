// SPDX-License-Identifier: Apache-2.0
#include "model/document/function_editor.h"

#include "model/document/document_host.h"
#include "model/document/view_model.h"

#include "render/colours/function_edits.h"

namespace vs::desktop {

namespace {
constexpr std::size_t kMostSteps = 200;
}

FunctionEditor::FunctionEditor(DocumentHost& host, ViewModel& view) : host_(host), view_(view) {
    makeFirst();
    connect(&host_, &DocumentHost::opened, this, &FunctionEditor::forget);
    connect(&host_, &DocumentHost::changed, this, &FunctionEditor::followView);
}

bool FunctionEditor::isUsed(Kind kind) const { return used() == kind; }

std::optional<FunctionEditor::Kind> FunctionEditor::used() const {
    const auto& function = view_.shown().transferFunction;
    return function ? std::optional(function->kind) : std::nullopt;
}

std::optional<std::size_t> FunctionEditor::chosen(Kind kind) const {
    const Page& on = page(kind);
    const std::size_t count = kind == Kind::TwoD ? on.function.shapes.size() : on.function.points.size();
    return on.chosen && *on.chosen < count ? on.chosen : std::nullopt;
}

void FunctionEditor::choose(Kind kind, std::optional<std::size_t> number) {
    page(kind).chosen = number;
    emit changed();
}

void FunctionEditor::forget() {
    pages_ = {};
    undo_.clear();
    seen_.reset();
    gradientTop_ = 0;
    makeFirst();
    followView();
    emit changed();
}

// Until they are touched, the functions to begin with follow the displayed range.
void FunctionEditor::makeFirst() {
    firstRange_ = view_.shown().range;
    const double top = gradientTop_ > 0 ? gradientTop_ : 1;
    const auto put = [this](const render::TransferFunction& function) {
        if (!page(function.kind).isTouched) {
            page(function.kind).function = function;
        }
    };
    put(render::functionOfRange(firstRange_));
    put(render::functionOfGradients(top));
    put(render::functionOfBoth(firstRange_, top));
}

void FunctionEditor::setGradientTop(double top) {
    gradientTop_ = top;
    makeFirst();
    emit changed();
}

void FunctionEditor::followView() {
    bool isNew = false;
    if (!(view_.shown().range == firstRange_)) {
        makeFirst();
        isNew = true;
    }
    const auto& function = view_.shown().transferFunction;
    if (!(function == seen_)) {
        seen_ = function;
        isNew = true;
        if (auto* document = host_.document(); function && document != nullptr) {
            host_.workLong([&] { page(function->kind).function = document->resolved(*function); });
            page(function->kind).isTouched = true;
        }
    }
    if (isNew) {
        emit changed();
    }
}

void FunctionEditor::remember() {
    if (!isStepBegun_) {
        isStepBegun_ = true;
        undo_.push_back({view_.shown().transferFunction, {}});
        if (undo_.size() > kMostSteps) {
            undo_.erase(undo_.begin());
        }
    }
}

void FunctionEditor::publish(const std::optional<render::TransferFunction>& function) {
    view_.setTransferFunction(function);
    announce();
}

void FunctionEditor::announce() {
    followView();
    emit changed();
}

void FunctionEditor::change(Kind kind, const std::function<void(render::TransferFunction&)>& edit) {
    if (host_.document() == nullptr || host_.isLoading()) {
        return;
    }
    auto function = page(kind).function;
    edit(function);
    // An edit that leaves it as it was brings nothing into use: a click, for example.
    if (!(function == page(kind).function)) {
        remember();
        publish(function);
    }
}

void FunctionEditor::use(Kind kind) {
    begin();
    remember();
    publish(page(kind).function);
}

void FunctionEditor::take(const std::optional<render::TransferFunction>& function) {
    begin();
    remember();
    if (function) {
        page(function->kind).chosen.reset();
        const studio::View& shown = view_.shown();
        const render::SuitedView& wanted = function->suits;
        render::SuitedView& before = undo_.back().view;
        before.mode = wanted.mode ? std::optional(shown.mode) : std::nullopt;
        before.shadows = wanted.shadows ? std::optional(shown.shadows) : std::nullopt;
        before.sampling = wanted.sampling ? std::optional(shown.sampling) : std::nullopt;
    }
    view_.chooseTransferFunction(function);
    announce();
}

void FunctionEditor::useColourMap(const std::string& map) {
    const Kind kind = used().value_or(Kind::Intensity);
    if (kind == Kind::TwoD) {
        host_.say(
            tr("A colour table is for functions over intensity or gradient; shapes have a colour each"));
        return;
    }
    begin();
    change(kind, [&](render::TransferFunction& function) {
        map.empty() ? render::useOwnColours(function) : render::useColourMap(function, map);
    });
    if (!isUsed(kind)) {
        use(kind); // it had that table already
    }
}

void FunctionEditor::undo() {
    if (!undo_.empty()) {
        const auto before = undo_.back();
        undo_.pop_back();
        begin();
        view_.suit(before.view);
        publish(before.function);
    }
}

} // namespace vs::desktop
