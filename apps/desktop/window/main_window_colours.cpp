// SPDX-License-Identifier: Apache-2.0
#include "model/texts/library_texts.h"
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
    QAction* none =
        addChoice(functions,
                  {"colours.none", nullptr, tr("The mode's own"),
                   tr("Ivory surfaces and white rays; the volume as the displayed range has it"), tr("0")},
                  [this] {
                      studio_.view().setTransferFunction({});
                      refreshColours();
                  });
    menu->QWidget::addAction(none);
    menu->addSeparator();
    for (const std::string& name : render::presetNames()) {
        const auto preset = render::findPreset(name);
        const std::string id = "colours." + name;
        QAction* choice = addChoice(
            functions, {id.c_str(), nullptr, libraryText(preset->name), libraryText(preset->description), {}},
            [this, preset] {
                studio_.view().setTransferFunction(preset);
                refreshColours(); // chosen again it is still the one
            });
        menu->QWidget::addAction(choice);
    }
    menu->addSeparator();
    QAction* fromFile = addChoice(functions,
                                  {"colours.file",
                                   nullptr,
                                   tr("From a file\u2026"),
                                   tr("A transfer function as doc/transfer_functions.md describes it"),
                                   {}},
                                  [this] { openTransferFunction(); });
    menu->QWidget::addAction(fromFile);
}

void MainWindow::openTransferFunction() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Transfer function"), {}, tr("JSON (*.json)"));
    if (path.isEmpty()) {
        refreshColours();
        return;
    }
    try {
        studio_.view().setTransferFunction(render::loadTransferFunction(path.toStdString()));
    } catch (const Error& error) {
        QMessageBox::warning(this, tr("Transfer function"), QString::fromUtf8(error.what()));
        refreshColours();
    }
}

// The menu shows what the view has, whoever chose it.
void MainWindow::refreshColours() {
    const auto& function = studio_.view().shown().transferFunction;
    std::string shown = function ? "" : "none";
    for (const std::string& name : render::presetNames()) {
        if (function && render::findPreset(name) == function) {
            shown = name;
        }
    }
    if (!shown.empty()) {
        action(("colours." + shown).c_str())->setChecked(true);
    } else if (QAction* other = action("colours.none")->actionGroup()->checkedAction()) {
        other->setChecked(false);
    }
}

} // namespace vs::desktop
