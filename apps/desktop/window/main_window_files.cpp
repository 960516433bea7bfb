// SPDX-License-Identifier: Apache-2.0
#include "window/main_window.h"

#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"

#include "volume/io/read.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTimer>

namespace vs::desktop {

namespace {

bool isHeaderless(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    return suffix == "raw" || suffix == "bin";
}

// A local file or folder; empty: there is none. Of several the first: any slice stands for its series.
QString droppedPath(const QMimeData& dropped) {
    const auto urls = dropped.urls();
    return urls.isEmpty() ? QString() : urls.front().toLocalFile();
}

} // namespace

void MainWindow::openPath(const QString& path) {
    OpenRequest request;
    const bool isSession = path.endsWith(".json", Qt::CaseInsensitive);
    (isSession ? request.session : request.volume) = pathOf(path);
    if (isSession || !isHeaderless(path)) {
        open(request);
        return;
    }
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName("rawLayout");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Layout of %1").arg(QFileInfo(path).fileName()));
    dialog->setLabelText(
        tr("This file has no header. Dimensions, type and spacing:\nDIMS:TYPE[:SPACING[:OFFSET]]"));
    dialog->setTextValue("256x256x108:int16:0.957,0.957,1.5");
    const auto openDescribed = [this, request](const QString& layout) {
        auto described = request;
        described.rawLayout = layout.trimmed().toStdString();
        open(described);
    };
    connect(dialog, &QInputDialog::textValueSelected, this, openDescribed, Qt::QueuedConnection);
    dialog->open();
}

QFileDialog* MainWindow::makeFileDialog(const char* objectName, const QString& title, bool isSave,
                                        const QString& filter, const QString& suggestion) {
    auto* dialog = new QFileDialog(this, title);
    dialog->setObjectName(objectName);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(isSave ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(isSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    if (filter.isEmpty()) {
        dialog->setFileMode(QFileDialog::Directory);
        dialog->setOption(QFileDialog::ShowDirsOnly);
    } else {
        dialog->setNameFilter(filter);
    }
    if (isSave) {
        if (const QString& folder = studio_.preferences().recordings; QFileInfo(folder).isDir()) {
            dialog->setDirectory(folder);
        }
        dialog->setDefaultSuffix(QFileInfo(suggestion).completeSuffix());
        dialog->selectFile(suggestion);
    }
    return dialog;
}

void MainWindow::choose(const char* objectName, const QString& title, bool isSave, const QString& filter,
                        const QString& suggestion, const std::function<void(const QString&)>& take) {
    auto* dialog = makeFileDialog(objectName, title, isSave, filter, suggestion);
    // Once the dialog has closed: what is asked then does not stand over it.
    connect(dialog, &QFileDialog::fileSelected, this, take, Qt::QueuedConnection);
    dialog->open();
}

QString MainWindow::suggestedName(const QString& suffix) const {
    const auto* document = studio_.host().document();
    const QString name = document != nullptr ? QString::fromStdString(document->volume().name) : "volume";
    return QFileInfo(name).baseName() + suffix;
}

// The file that it was opened from or saved to, else named after the volume.
QString MainWindow::suggestedSession() const {
    const auto& session = studio_.files().source().session;
    return session.empty() ? suggestedName(".json") : QString::fromStdString(session.string());
}

void MainWindow::openFile() {
    choose("openDialog", tr("Open a volume or a session"), false,
           tr("Volumes and sessions (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vtk *.dcm *.tif *.tiff *.raw "
              "*.json);;All "
              "files (*)"),
           {}, [this](const QString& path) { openPath(path); });
}

void MainWindow::playFile() {
    choose("playDialog", tr("Play a session"), false, tr("Sessions (*.json)"), {},
           [this](const QString& path) {
               OpenRequest request;
               request.session = pathOf(path);
               request.isPlayed = true;
               open(request);
           });
}

void MainWindow::playAgain() {
    auto session = std::make_shared<studio::Session>(
        studio::sessionOf(*studio_.host().document(), studio_.files().provenance()));
    OpenRequest request;
    request.given = std::move(session);
    request.isPlayed = true;
    open(request);
}

void MainWindow::openFolder() {
    choose("openFolderDialog", tr("Open a folder of DICOM slices"), false, {}, {},
           [this](const QString& path) { openPath(path); });
}

// A folder of slices is opened by any of its files.
void MainWindow::askForVolume(const OpenRequest& request, const std::filesystem::path& wanted) {
    const QString title = request.journal.empty()
                              ? tr("Where is %1, the scan of %2?")
                                    .arg(textOf(wanted.filename()), textOf(request.session.filename()))
                              : tr("Where is %1, the scan of what was lost?").arg(textOf(wanted.filename()));
    choose("findVolumeDialog", title, false,
           tr("Volumes (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vtk *.dcm *.tif *.tiff *.raw);;All files "
              "(*)"),
           {}, [this, request, wanted](const QString& path) {
               OpenRequest found = request;
               found.volume = pathOf(path);
               const auto folder = found.volume.parent_path();
               found.volume = folder.filename() == wanted.filename() ? folder : found.volume;
               found.journal.empty() ? studio_.files().open(found) : recover(found);
           });
}

void MainWindow::openLabels() {
    choose("openLabelsDialog", tr("Open a label map"), false,
           tr("Label maps (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vtk);;All files (*)"), {},
           [this](const QString& path) { studio_.segments().openLabels(pathOf(path)); });
}

// A file on an open volume may be a label map of it: only the person knows.
void MainWindow::dropOn(const QString& path) {
    const bool isVolume = !path.endsWith(".json", Qt::CaseInsensitive) && QFileInfo(path).isFile() &&
                          !volume::isHeaderless(pathOf(path));
    if (studio_.host().document() == nullptr || studio_.host().isLoading() || !isVolume) {
        openPath(path);
        return;
    }
    auto* question =
        new QMessageBox(QMessageBox::Question, tr("Volume Studio"),
                        tr("What is %1?").arg(QFileInfo(path).fileName()), QMessageBox::NoButton, this);
    question->setObjectName("dropQuestion");
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setInformativeText(tr("A label map of the open volume becomes segments of it."));
    auto* labels = question->addButton(tr("&Label map"), QMessageBox::AcceptRole);
    auto* volume = question->addButton(tr("Another &volume"), QMessageBox::ActionRole);
    labels->setObjectName("dropLabels");
    volume->setObjectName("dropVolume");
    question->addButton(QMessageBox::Cancel);
    question->setDefaultButton(labels);
    const auto take = [this, path](const QAbstractButton* chosen) {
        if (chosen->objectName() == "dropLabels") {
            studio_.segments().openLabels(pathOf(path));
        } else if (chosen->objectName() == "dropVolume") {
            QTimer::singleShot(0, this, [this, path] { openPath(path); }); // once the question has closed
        }
    };
    connect(question, &QMessageBox::buttonClicked, this, take);
    question->open();
}

// To where it lies, if it lies anywhere.
void MainWindow::saveSession() {
    const auto session = studio_.files().source().session;
    if (session.empty()) {
        saveSessionAs();
    } else {
        studio_.files().saveSession(session);
    }
}

void MainWindow::saveSessionAs() {
    choose("saveDialog", tr("Save the session"), true, tr("Sessions (*.json)"), suggestedSession(),
           [this](const QString& path) { studio_.files().saveSession(pathOf(path)); });
}

void MainWindow::exportLabels() {
    choose("labelsDialog", tr("Export the label map"), true, tr("Label maps (*.nrrd *.nii *.nii.gz)"),
           suggestedName("-labels.nrrd"),
           [this](const QString& path) { studio_.files().exportLabels(pathOf(path)); });
}

void MainWindow::screenshot() {
    choose("screenshotDialog", tr("Save the picture"), true, tr("Pictures (*.png)"), suggestedName(".png"),
           [this](const QString& path) { studio_.takeScreenshot(pathOf(path)); });
}

// Not while a dialog waits for an answer.
void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (QApplication::activeModalWidget() == nullptr && !droppedPath(*event->mimeData()).isEmpty()) {
        event->setDropAction(Qt::CopyAction);
        event->accept();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    event->setDropAction(Qt::CopyAction); // whatever is proposed: what is moved, its owner deletes
    event->accept();
    const QString path = droppedPath(*event->mimeData());
    if (!path.isEmpty()) { // else the other program has gone
        // Afterwards, so that it need not wait for a question to be answered, or for work to end.
        QTimer::singleShot(0, this,
                           [this, path] { studio_.host().whenHere([this, path] { dropOn(path); }); });
    }
}

} // namespace vs::desktop
