// SPDX-License-Identifier: Apache-2.0
#include "dialogs/film_dialog.h"
#include "dialogs/picture_dialog.h"
#include "model/exports/picture_export.h"
#include "model/studio/studio_controller.h"
#include "window/action_table.h"
#include "window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QImage>

namespace vs::desktop {

void MainWindow::makePictureActions() {
    actions_->add({"exportPicture", "screenshot", tr("Pictures\u2026"),
                   tr("Save the picture at any size, with scale bar or without, or a turntable of pictures"),
                   tr("Shift+F12"), [this] {
                       auto* dialog = new PictureDialog(studio_, suggestedName(".png"), this);
                       dialog->setAttribute(Qt::WA_DeleteOnClose);
                       dialog->open();
                   }});
    actions_->add(
        {"film", "play", tr("Film\u2026"),
         tr("A film around what is seen, of its growth, of all that was done, or from view to view"),
         tr("Ctrl+F12"), [this] {
             if (film_ == nullptr) { // the window stays free beside it
                 film_ = new FilmDialog(studio_, suggestedName({}), this);
                 film_->setAttribute(Qt::WA_DeleteOnClose);
             }
             film_->show();
             film_->raise();
         }});
    actions_->add({"copyPicture", nullptr, tr("Copy picture"),
                   tr("The picture as it is seen, for another program"), QKeySequence::Copy,
                   [this] { copyPicture(); }});
    copying_ = new PictureExport(studio_);
    copying_->setParent(this);
    connect(copying_, &PictureExport::finished, this, [this](bool isDone, const QString& message) {
        studio_.host().say(isDone ? tr("The picture is on the clipboard") : message);
    });
}

void MainWindow::copyPicture() {
    studio::SavePicture picture;
    picture.size = studio_.picture().viewport();
    picture.annotations = actions_->find("annotations")->isChecked();
    copying_->make(picture, [](const image::Image& made) {
        const QImage seen(made.rgba.data(), made.width, made.height, qsizetype(4) * made.width,
                          QImage::Format_RGBA8888);
        QApplication::clipboard()->setImage(seen.copy());
    });
}

} // namespace vs::desktop
