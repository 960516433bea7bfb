// SPDX-License-Identifier: Apache-2.0
#include "model/files/document_files.h"

#include "model/document/camera_motion.h"
#include "model/document/document_host.h"
#include "model/document/notices.h"
#include "model/document/view_model.h"
#include "model/edits/editor.h"
#include "model/hand/hand.h"
#include "model/hand/tool.h"
#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "model/texts/texts.h"

#include "base/progress.h"
#include "studio/document/document_facts.h"
#include "volume/reading/read_volume.h"

#include <algorithm>
#include <exception>

namespace vs::desktop {

namespace {

sculpt::Precision precisionOf(const Loaded& loaded) {
    return loaded.session         ? loaded.session->precision
           : loaded.request.block ? loaded.request.block->precision
                                  : sculpt::Precision::Bits16;
}

std::unique_ptr<studio::Document> documentOf(Loaded& loaded) {
    auto document =
        loaded.state ? std::make_unique<studio::Document>(std::move(loaded.volume), std::move(*loaded.state))
                     : std::make_unique<studio::Document>(std::move(loaded.volume), precisionOf(loaded));
    studio::showFinerLevels(*document, loaded.finer, loaded.notices);
    return document;
}

} // namespace

DocumentFiles::DocumentFiles(const Model& model) : model_(model), host_(model.host) {
    connectLoader();
    connect(&host_, &DocumentHost::givenUp, this, [this] {
        loader_.giveUp();
        isReplayGivenUp_ = true;
    });
}

std::size_t DocumentFiles::countEdits() const {
    if (host_.geometry() == nullptr) {
        return 0;
    }
    const auto& log = host_.document()->log();
    return std::size_t(std::count_if(log.begin(), log.end(), studio::isEdit));
}

// --- opening

void DocumentFiles::connectLoader() {
    connect(&loader_, &VolumeLoader::loaded, this, [this](const auto& loaded) {
        host_.setOpening(DocumentHost::Opening::Nothing);
        host_.whenHere([this, loaded] { finishOpening(loaded); });
    });
    connect(&loader_, &VolumeLoader::failed, this, [this](const QString& message) {
        host_.say(message);
        endReading();
        emit host_.openFailed(message);
    });
    connect(&loader_, &VolumeLoader::givenUp, this, [this] {
        host_.say(tr("Given up: nothing was opened"));
        endReading();
    });
    connect(&loader_, &VolumeLoader::volumeMissing, this,
            [this](const OpenRequest& request, const auto& wanted) {
                host_.say(request.journal.empty()
                              ? tr("%1 is not where %2 says")
                                    .arg(textOf(wanted.filename()), textOf(request.session.filename()))
                              : tr("%1 is not where it was").arg(textOf(wanted.filename())));
                endReading();
                emit volumeWanted(request, wanted);
            });
    connect(&loader_, &VolumeLoader::severalSeries, this,
            [this](const OpenRequest& request, const auto& choices) {
                host_.say(tr("%1 holds several series").arg(textOf(request.volume.filename())));
                endReading();
                emit seriesWanted(request, choices);
            });
}

// Without a volume.
void DocumentFiles::endReading() {
    host_.setOpening(DocumentHost::Opening::Nothing);
    emit host_.progress(1, 1);
    emit host_.changed();
}

QString DocumentFiles::begun(const OpenRequest& request) {
    if (request.block) {
        return tr("Making a block");
    }
    if (request.given) {
        return request.given->isMade() ? tr("Making the scan")
                                       : tr("Reading %1").arg(textOf(request.given->volumePath.filename()));
    }
    const auto& path = request.session.empty() ? request.volume : request.session;
    return path.empty() ? tr("Recovering") : tr("Reading %1").arg(textOf(path.filename()));
}

void DocumentFiles::open(const OpenRequest& request) {
    if (host_.isLoading()) {
        host_.say(tr("Still reading; open it again when that is done"));
        return;
    }
    host_.gl().makeCurrent();
    model_.editor.interrupt();
    model_.hand.tool().clear();
    host_.say(begun(request));
    host_.setOpening(DocumentHost::Opening::Reading);
    OpenRequest asked = request;
    asked.budgets = budgets_.orElse(preferred_);
    if (folders_ && (!request.session.empty() || !request.journal.empty())) {
        asked.folders = folders_();
    }
    loader_.start(asked);
    emit host_.progress(0, 0);
    emit host_.changed();
}

void DocumentFiles::finishOpening(const std::shared_ptr<Loaded>& loaded) {
    const bool hasState = loaded->state.has_value();
    const bool done = host_.guard([&] {
        std::unique_ptr<studio::Document> fresh;
        host_.runLong([&] { fresh = documentOf(*loaded); });
        host_.replace(std::move(fresh));
    });
    emit host_.progress(1, 1);
    if (!done && hasState) { // it is damaged where nobody has looked: do everything again
        loaded->request.stateTrouble = host_.message().toStdString();
        open(loaded->request);
        return;
    }
    if (!done) {
        emit host_.changed();
        emit host_.openFailed(host_.message());
        return;
    }
    model_.notices.clear();
    model_.notices.add(loaded->notices);
    source_ = loaded->request;
    checksum_ = loaded->checksum;
    const bool isPlayed = loaded->session && loaded->request.isPlayed;
    if (loaded->session) {
        takeSource(*loaded->session, loaded->isOfAnotherLevel);
        if (!isPlayed && !hasState) {
            takeOperations(*loaded->session);
        }
    }
    savedEdits_ = hasState ? countEdits() : 0;
    model_.view.forget();
    model_.view.adopt();
    if (!loaded->session) { // which says how it is looked at
        auto view = model_.view.shown();
        view.range = host_.facts()->firstLook.range;
        view.mode = host_.facts()->firstLook.mode;
        if (loaded->request.block && loaded->request.block->isBuiltUp) {
            view.sculptureView = field::SculptureView::Probe;
        }
        model_.view.showView(view);
        model_.camera.reset();
    }
    if (!host_.isReplaying()) {
        emit host_.ready();
    }
    if (!loaded->notices.empty()) {
        host_.say(QString::fromStdString(loaded->notices.front()));
    } else if (hasState) {
        host_.say(tr("Opened %1 as it was saved").arg(textOf(loaded->request.session.filename())));
    } else {
        host_.say(tr("Opened %1").arg(QString::fromStdString(host_.volume()->name)));
    }
    host_.wake();
    emit host_.opened();
    emit host_.changed();
    if (isPlayed) {
        emit playable(loaded->session->operations);
    }
}

void DocumentFiles::takeSource(const studio::Session& session, bool isOfAnotherLevel) {
    source_.rawLayout = session.rawLayout;
    source_.series = session.series;
    source_.frame = session.frame;
    source_.level = session.level;
    source_.channel = session.channel;
    source_.phantom = session.phantom;
    // It has not become what that file says, or is of another scan or level: none is saved over it.
    const bool isOfAnother = !session.volumeChecksum.empty() && session.volumeChecksum != checksum_;
    if (source_.isPlayed || isOfAnother || isOfAnotherLevel) {
        source_.session.clear();
    }
}

void DocumentFiles::takeOperations(const studio::Session& session) {
    replay_.assign(session.operations.begin(), session.operations.end());
    replayTotal_ = int(replay_.size());
    isReplayGivenUp_ = false;
    host_.setOpening(replay_.empty() ? DocumentHost::Opening::Nothing : DocumentHost::Opening::Replaying);
}

void DocumentFiles::replayOne() {
    const auto operation = replay_.front();
    const int number = replayTotal_ - int(replay_.size()) + 1;
    host_.say(tr("Replaying %1 of %2: %3").arg(number).arg(replayTotal_).arg(studio::name(operation)));
    emit host_.progress(number - 1, replayTotal_);
    QString error;
    bool isGivenUp = false;
    try {
        if (isReplayGivenUp_) {
            throw GivenUp("it was given up");
        }
        // A picture or label map that the session asks for was written when it was made; opening writes
        // nothing.
        if (studio::isOutput(operation)) {
            host_.document()->logOutput(operation);
        } else {
            host_.runLong([&] { host_.document()->apply(operation); }, LongWork::Input::GivesUp);
        }
        replay_.pop_front();
    } catch (const std::exception& e) {
        isGivenUp = dynamic_cast<const GivenUp*>(&e) != nullptr;
        error = tr("Replayed up to operation %1 (%2): %3")
                    .arg(number)
                    .arg(studio::name(operation), QString::fromUtf8(e.what()));
        replay_.clear();
    }
    if (replay_.empty()) {
        finishReplay(error, isGivenUp);
    }
    emit host_.changed();
}

void DocumentFiles::finishReplay(const QString& error, bool isGivenUp) {
    host_.setOpening(DocumentHost::Opening::Nothing);
    // What was recovered is in no session file.
    savedEdits_ = source_.journal.empty() ? countEdits() : 0;
    source_.journal.clear();
    host_.document()->seal();
    if (!error.isEmpty()) { // a part of it is not saved over the whole
        source_.session.clear();
    }
    model_.view.adopt();
    emit host_.ready();
    host_.say(error.isEmpty() ? tr("Replayed %1 operations").arg(replayTotal_) : error);
    emit host_.progress(1, 1);
    host_.wake();
    if (!error.isEmpty() && !isGivenUp) {
        emit host_.openFailed(error);
    }
}

// --- saving

studio::Session DocumentFiles::provenance() const {
    studio::Session source;
    const auto& volume = *host_.volume();
    source.phantom = source_.phantom;
    if (volume.path.empty() && !source.phantom) { // made from nothing
        const auto& geometry = host_.document()->geometryInFile();
        source.block = studio::Session::Block{geometry.dims, geometry.spacing()};
    } else if (!source.phantom) {
        source.volumePath = volume::absolutePath(volume.path);
    }
    source.volumeChecksum = checksum_;
    source.precision = host_.document()->sculpture().precision();
    source.rawLayout = source_.rawLayout;
    source.series = source_.series;
    source.frame = source_.frame;
    source.level = source_.level;
    source.channel = source_.channel;
    return source;
}

bool DocumentFiles::hasUnsavedEdits() const {
    return !host_.isReplaying() && (model_.growth.isPlaying() || countEdits() != savedEdits_);
}

bool DocumentFiles::saveSession(const std::filesystem::path& path) {
    if (host_.geometry() == nullptr || host_.isLoading()) {
        return false;
    }
    model_.hand.tool().finishPending();
    if (host_.facts()->isStrokeOpen()) {
        return false;
    }
    model_.editor.interrupt();
    model_.view.flush();
    const studio::Session source = provenance();
    std::vector<std::string> notices;
    if (!host_.workLong([&] { studio::saveDocument(path, *host_.document(), source, notices); })) {
        return false;
    }
    model_.notices.add(notices);
    savedEdits_ = countEdits();
    host_.document()->seal();
    source_.session = path;
    host_.say(tr("Saved %1").arg(textOf(path)));
    emit saved();
    return true;
}

bool DocumentFiles::exportLabels(const std::filesystem::path& path) {
    if (!model_.segments.hasVoxels()) {
        host_.say(tr("There is no segmentation to export yet: draw seeds first"));
        return false;
    }
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    const bool done = model_.editor.apply(studio::SaveLabels{path.filename().string()}, folder);
    if (done) {
        host_.say(tr("Exported labels to %1").arg(textOf(path)));
    }
    return done;
}

void DocumentFiles::close() {
    if (host_.geometry() == nullptr || host_.isLoading()) {
        return;
    }
    host_.gl().makeCurrent();
    model_.editor.interrupt();
    emit host_.closing();
    host_.replace(nullptr);
    source_ = {};
    savedEdits_ = 0;
    model_.notices.clear();
    model_.view.forget();
    host_.say({});
    emit host_.closed();
    emit host_.changed();
    emit host_.emptied();
}

} // namespace vs::desktop
