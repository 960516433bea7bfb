// SPDX-License-Identifier: Apache-2.0
#include "dialogs/preferences_dialog.h"

#include "model/texts/library_texts.h"
#include "parts/panel_parts.h"

#include "render/slices/slice_windows.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace vs::desktop {

PreferencesDialog::PreferencesDialog(const Preferences& preferences, QWidget* parent)
    : QDialog(parent), preferences_(preferences) {
    setObjectName("preferencesDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Preferences"));
    auto* page = new QWidget;
    auto* form = makeForm(page);
    form->setVerticalSpacing(14);
    addTheme(form);
    addLanguage(form);
    addUndo(form);
    addScans(form);
    addRecordings(form);
    addQuality(form);
    addSlices(form);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(18);
    column->addWidget(page);
    column->addStretch(1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setObjectName("closePreferences");
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    setMinimumWidth(520);
}

void PreferencesDialog::addTheme(QFormLayout* form) {
    auto* themes =
        new ChoiceRow({{"themeDark", tr("Dark"), tr("The picture is the brightest thing")},
                       {"themeLight", tr("Light"), tr("For bright rooms")},
                       {"themeDesktop", tr("As the desktop"), tr("Dark or light as other windows are")}},
                      int(preferences_.theme), 3);
    connect(themes, &ChoiceRow::chosen, this, [this](int choice) {
        preferences_.theme = Theme(choice);
        tell();
    });
    form->addRow(tr("Theme"), themes);
}

// Languages are named in themselves, for who reads no other.
void PreferencesDialog::addLanguage(QFormLayout* form) {
    auto* languages = new ChoiceRow(
        {{"languageDesktop", tr("As the desktop"), tr("German where the desktop speaks it, else English")},
         {"languageEnglish", "English", tr("English, whatever the desktop speaks")},
         {"languageGerman", "Deutsch", tr("German, whatever the desktop speaks")}},
        int(preferences_.language), 3);
    auto* note = makeQuietLabel(tr("Start Volume Studio again to read it in the other language."));
    note->setVisible(false);
    connect(languages, &ChoiceRow::chosen, this, [this, note](int choice) {
        preferences_.language = Language(choice);
        note->setVisible(true);
        tell();
    });
    form->addRow(tr("Language"), languages);
    form->addRow(QString(), note);
}

void PreferencesDialog::addUndo(QFormLayout* form) {
    auto* memory = makeAmount("undoMemory", tr("Memory for undo"), 16, &Preferences::undoMegabytes);
    memory->setToolTip(tr("Undo has no end; what does not fit goes to a temporary file"));
    form->addRow(tr("Memory for undo"), memory);
}

QSpinBox* PreferencesDialog::makeAmount(const char* objectName, const QString& label, int least,
                                        int Preferences::*megabytes) {
    auto* amount = named(new QSpinBox, objectName, label);
    amount->setRange(least, 1 << 20);
    amount->setSingleStep(128);
    amount->setSuffix(tr(" MB"));
    amount->setSpecialValueText(least == 0 ? tr("Automatic") : QString());
    amount->setKeyboardTracking(false);
    amount->setButtonSymbols(QAbstractSpinBox::NoButtons); // wheel and arrow keys do
    amount->setValue(preferences_.*megabytes);
    connect(amount, &QSpinBox::valueChanged, this, [this, megabytes](int chosen) {
        preferences_.*megabytes = chosen;
        tell();
    });
    return amount;
}

void PreferencesDialog::addScans(QFormLayout* form) {
    const QString onDevice = tr("Graphics memory for scans");
    auto* device = makeAmount("deviceMemory", onDevice, 0, &Preferences::deviceMegabytes);
    device->setToolTip(tr("What scans and edits may take on the graphics device, from the next scan that is "
                          "opened on. Larger ones are worked on at a coarser level"));
    const QString onHost = tr("Memory for large scans");
    auto* host = makeAmount("hostMemory", onHost, 0, &Preferences::hostMegabytes);
    host->setToolTip(
        tr("What parts of large scans that were read, and growth in them, may take, from the next "
           "scan that is opened on"));
    form->addRow(onDevice, device);
    form->addRow(onHost, host);
}

void PreferencesDialog::addRecordings(QFormLayout* form) {
    auto* folder = named(new QLineEdit(preferences_.recordings), "recordings", tr("Folder to save in"));
    folder->setPlaceholderText(tr("Where the file dialog was last"));
    folder->setToolTip(
        tr("Where sessions, pictures and label maps are saved unless another folder is chosen"));
    connect(folder, &QLineEdit::editingFinished, this, [this, folder] {
        preferences_.recordings = folder->text().trimmed();
        tell();
    });
    auto* choose =
        named(new QPushButton(tr("Choose…")), "chooseRecordings", tr("Choose the folder to save in"));
    connect(choose, &QPushButton::clicked, this, [this, folder] {
        const QString chosen =
            QFileDialog::getExistingDirectory(this, tr("Folder to save in"), folder->text());
        if (!chosen.isEmpty()) {
            folder->setText(chosen);
            preferences_.recordings = chosen;
            tell();
        }
    });
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(folder, 1);
    row->addWidget(choose);
    form->addRow(tr("Recordings go to"), row);
}

void PreferencesDialog::addQuality(QFormLayout* form) {
    auto* smooth = makeCheckBox("preferSmooth", tr("Smooth sampling"),
                                tr("Tricubic instead of trilinear: no facets where the picture is enlarged"),
                                preferences_.smoothSampling);
    connect(smooth, &QCheckBox::toggled, this, [this](bool isOn) {
        preferences_.smoothSampling = isOn;
        tell();
    });
    auto* shadows = makeCheckBox("preferShadows", tr("Shadows"), tr("Ambient occlusion and soft shadows"),
                                 preferences_.shadows);
    connect(shadows, &QCheckBox::toggled, this, [this](bool isOn) {
        preferences_.shadows = isOn;
        tell();
    });
    form->addRow(tr("Volumes open with"), smooth);
    form->addRow(QString(), shadows);
}

void PreferencesDialog::addSlices(QFormLayout* form) {
    auto* windows = named(new QComboBox, "preferWindow", tr("Window of CT slices"));
    windows->setToolTip(
        tr("The values that slices of CT scans show from black to white when they are opened"));
    windows->addItem(tr("Automatic"), QString());
    for (const render::SliceWindow& window : render::kSliceWindows) {
        windows->addItem(libraryText(window.title), QString(window.name));
    }
    windows->setCurrentIndex(std::max(0, windows->findData(preferences_.sliceWindow)));
    connect(windows, &QComboBox::currentIndexChanged, this, [this, windows] {
        preferences_.sliceWindow = windows->currentData().toString();
        tell();
    });
    auto* tint =
        makeCheckBox("preferTint", tr("Tint what is shown"),
                     tr("Slices show in colour what the 3D picture shows"), preferences_.tintsSlices);
    connect(tint, &QCheckBox::toggled, this, [this](bool isOn) {
        preferences_.tintsSlices = isOn;
        tell();
    });
    form->addRow(tr("Slices of CT scans"), windows);
    form->addRow(tr("All slices"), tint);
}

} // namespace vs::desktop
