// SPDX-License-Identifier: Apache-2.0
#include "transfer/function_bar.h"

#include "model/document/function_editor.h"
#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"
#include "transfer/function_gallery.h"
#include "transfer/function_picture.h"

#include "render/colours/transfer_function_json.h"

#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>

namespace vs::desktop {

namespace {
constexpr QSize kPicture{52, 16};
}

FunctionBar::FunctionBar(StudioController& studio, FunctionEditor& editor)
    : studio_(studio), editor_(editor) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    chosen_ = named(new QToolButton, "functionChoice", tr("Choose colours"));
    chosen_->setToolTip(tr("The transfer function in use; click to choose another one"));
    chosen_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    chosen_->setIconSize(kPicture);
    chosen_->setProperty("choice", true);
    chosen_->setFocusPolicy(Qt::TabFocus);
    chosen_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // long names are cut, not the panel
    row->addWidget(chosen_, 1);
    const auto add = [&](const char* iconName, const char* name, const QString& text, const QString& tip) {
        auto* button = makeIconButton(iconName, name, text, tip);
        button->setIconSize(QSize(18, 18));
        row->addWidget(button);
        return button;
    };
    reset_ = add("reset", "functionReset", tr("Reset colours"), tr("Back to the mode's own colours"));
    auto* openButton =
        add("open", "functionOpen", tr("Open colours"), tr("Open a transfer function from a file"));
    save_ = add("save", "functionSave", tr("Save colours"), tr("Save the transfer function as a file"));
    connect(chosen_, &QToolButton::clicked, this, &FunctionBar::showGallery);
    connect(reset_, &QToolButton::clicked, this, [this] { editor_.take({}); });
    connect(openButton, &QToolButton::clicked, this, &FunctionBar::open);
    connect(save_, &QToolButton::clicked, this, &FunctionBar::save);
    connect(&editor_, &FunctionEditor::changed, this, &FunctionBar::refresh);
    refresh();
}

void FunctionBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        refresh();
    }
    QWidget::changeEvent(event);
}

void FunctionBar::showGallery() {
    auto* gallery = new FunctionGallery(editor_, this);
    gallery->setAttribute(Qt::WA_DeleteOnClose);
    gallery->showAt(*chosen_);
}

void FunctionBar::refresh() {
    const auto& function = studio_.view().shown().transferFunction;
    const QString name = !function                ? tr("The mode's own colours")
                         : function->name.empty() ? tr("Colours of your own")
                                                  : QString::fromStdString(function->name);
    chosen_->setText(name);
    chosen_->setProperty("report", name);
    if (function) {
        const QSize pixels = (QSizeF(kPicture) * devicePixelRatioF()).toSize();
        QImage image = functionPicture(*function, pixels, palette().color(QPalette::Base));
        image.setDevicePixelRatio(devicePixelRatioF());
        chosen_->setIcon(QPixmap::fromImage(image));
    } else {
        chosen_->setIcon({});
    }
    reset_->setEnabled(function.has_value());
    save_->setEnabled(function.has_value());
}

void FunctionBar::open() {
    auto* dialog =
        new QFileDialog(window(), tr("Open a transfer function"), {}, tr("Transfer functions (*.json)"));
    dialog->setObjectName("functionOpenDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        studio_.host().guard([&] {
            editor_.take(render::loadTransferFunction(path.toStdString()));
            studio_.host().say(tr("Opened colours %1").arg(path));
        });
    });
    dialog->open();
}

void FunctionBar::save() {
    auto* dialog =
        new QFileDialog(window(), tr("Save the transfer function"), {}, tr("Transfer functions (*.json)"));
    dialog->setObjectName("functionSaveDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix("json");
    dialog->selectFile("colours.json");
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        studio_.host().guard([&] {
            render::saveTransferFunction(path.toStdString(), *studio_.view().shown().transferFunction);
            studio_.host().say(tr("Saved colours %1").arg(path));
        });
    });
    dialog->open();
}

} // namespace vs::desktop
