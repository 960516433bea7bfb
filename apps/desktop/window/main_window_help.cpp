// SPDX-License-Identifier: Apache-2.0
#include "window/action_table.h"
#include "window/main_window.h"

#include "dialogs/preferences_dialog.h"
#include "dialogs/shortcut_sheet.h"
#include "model/studio/studio_controller.h"
#include "parts/theme.h"

#include <QApplication>
#include <QLabel>
#include <QMessageBox>

namespace vs::desktop {

void MainWindow::makeHelpActions() {
    const auto always = [] { return true; };
    actions_
        ->add({"shortcuts", "keys", tr("Keyboard shortcuts"), tr("All keys, and what the mouse does"),
               tr("F1"), [this] { (new ShortcutSheet(*this))->open(); }, always})
        ->setShortcuts({QKeySequence(Qt::Key_F1), QKeySequence("?")});
    actions_->add({"preferences", "preferences", tr("Preferences…"), tr("Theme, memory, folders, quality"),
                   tr("Ctrl+,"), [this] { showPreferences(); }, always});
    actions_->add(
        {"about", "about", tr("About"), tr("About Volume Studio"), {}, [this] { about(); }, always});
}

void MainWindow::showPreferences() {
    auto* dialog = new PreferencesDialog(studio_.preferences(), this);
    connect(dialog, &PreferencesDialog::changed, this, [this](const Preferences& preferences) {
        const bool isThemeNew = preferences.theme != studio_.preferences().theme;
        preferences.save();
        studio_.setPreferences(preferences);
        if (isThemeNew) {
            applyTheme(*qApp, preferences.theme);
        }
    });
    dialog->open();
}

void MainWindow::about() {
    const auto& device = studio_.host().gl().device();
    const auto line = [](const QString& name, const QString& value) {
        return "<tr><td style='padding-right: 14px'>" + name + "</td><td>" + value.toHtmlEscaped() +
               "</td></tr>";
    };
    const auto text = [](const std::string& value) { return QString::fromStdString(value); };
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About Volume Studio"),
        tr("<h3>Volume Studio %1</h3><p>Reshape a 3D scan with a pen, on the rendered picture itself.</p>")
                .arg(QApplication::applicationVersion()) +
            "<table>" + line(tr("Device"), text(device.renderer)) + line(tr("Driver"), text(device.vendor)) +
            line(tr("OpenGL"), text(device.version)) + line(tr("Qt"), qVersion()) + "</table>" +
            tr("<p>Free software under the Apache licence 2.0.</p>"
               "<p>Not a medical device: do not use it for diagnosis or treatment.</p>"),
        QMessageBox::Ok, this);
    box->setObjectName("about");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse); // for reports of faults
    box->open();
}

} // namespace vs::desktop
