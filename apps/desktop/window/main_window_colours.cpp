// SPDX-License-Identifier: Apache-2.0
#include "model/texts/library_texts.h"
#include "window/action_table.h"
#include "window/main_window.h"

#include "model/studio/studio_controller.h"

#include "base/error.h"
#include "render/colours/transfer_function_json.h"

#include <QActionGroup>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

namespace vs::desktop {

// The transfer functions: none, the presets, one from a file.
void MainWindow::makeColourMenu() {
    auto* menu = menuBar()->addMenu(tr("&Colours"));
    menu->setToolTipsVisible(true);
    auto* functions = new QActionGroup(this);
    functions->setExclusionPolicy(
        QActionGroup::ExclusionPolicy::ExclusiveOptional); // none: one of the person's own
    const auto shown = [this]() -> const auto& { return studio_.view().shown().transferFunction; };
    const auto add = [&](const std::string& name, const QString& text, const QString& tip,
                         const QKeySequence& key, const std::function<void()>& run,
                         const std::function<bool()>& isShown) {
        menu->QWidget::addAction(
            actions_->addChoice(functions, {"colours." + name, nullptr, text, tip, key, run, {}, isShown}));
    };
    const auto show = [this](const std::optional<render::TransferFunction>& function) {
        return [this, function] {
            studio_.view().chooseTransferFunction(function);
            actions_->refresh(); // chosen again it is still the one
        };
    };
    add("none", tr("The mode's own"),
        tr("Ivory surfaces and white rays; the volume as the displayed range has it"), tr("0"), show({}),
        [shown] { return !shown(); });
    menu->addSeparator();
    for (const std::string& name : render::presetNames()) {
        const auto preset = render::findPreset(name);
        add(name, libraryText(preset->name), libraryText(preset->description), {}, show(preset),
            [shown, preset] { return shown() == preset; });
    }
    menu->addSeparator();
    add(
        "file", tr("From a file\u2026"), tr("A transfer function as doc/transfer_functions.md describes it"),
        {}, [this] { openTransferFunction(); }, [] { return false; });
}

void MainWindow::openTransferFunction() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Transfer function"), {}, tr("JSON (*.json)"));
    if (path.isEmpty()) {
        actions_->refresh();
        return;
    }
    try {
        studio_.view().chooseTransferFunction(render::loadTransferFunction(path.toStdString()));
    } catch (const Error& error) {
        QMessageBox::warning(this, tr("Transfer function"), QString::fromUtf8(error.what()));
        actions_->refresh();
    }
}

} // namespace vs::desktop
