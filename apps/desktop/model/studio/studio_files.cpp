// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"

#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "model/segments/segment_measurer.h"
#include "model/studio/tool.h"

#include "base/progress.h"
#include "sculpt/mask/outline_image.h"

#include <algorithm>
#include <variant>

namespace vs::desktop {

namespace {

QString text(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

std::size_t countEdits(const studio::Document* document) {
    if (document == nullptr) {
        return 0;
    }
    const auto& log = document->log();
    return std::size_t(std::count_if(log.begin(), log.end(), studio::isEdit));
}

} // namespace

void StudioController::connectLoader() {
    connect(&loader_, &VolumeLoader::loaded, this,
            [this](const auto& loaded) { whenHere([this, loaded] { finishOpening(loaded); }); });
    connect(&loader_, &VolumeLoader::failed, this, [this](const QString& message) {
        say(message);
        emit progress(1, 1);
        emit changed();
        emit openFailed(message);
    });
    connect(&loader_, &VolumeLoader::givenUp, this, [this] {
        say(tr("Given up: nothing was opened"));
        emit progress(1, 1);
        emit changed();
    });
    connect(&loader_, &VolumeLoader::severalSeries, this,
            [this](const OpenRequest& request, const auto& choices) {
                say(tr("%1 holds several series").arg(text(request.volume.filename())));
                emit progress(1, 1);
                emit changed();
                emit seriesWanted(request, choices);
            });
}

void StudioController::open(const OpenRequest& request) {
    if (isLoading()) {
        say(tr("Still reading; open it again when that is done"));
        return;
    }
    host_.makeCurrent();
    growth_->pause();
    tool_->clear();
    say(request.volume.empty() && request.session.empty()
            ? tr("Recovering")
            : tr("Reading %1")
                  .arg(text((request.session.empty() ? request.volume : request.session).filename())));
    loader_.start(request);
    emit progress(0, 0);
    emit changed();
}

void StudioController::finishOpening(const std::shared_ptr<Loaded>& loaded) {
    host_.makeCurrent();
    const bool done = guard([&] {
        std::unique_ptr<studio::Document> fresh;
        longWork_.run([&] {
            fresh = std::make_unique<studio::Document>(std::move(loaded->volume),
                                                       loaded->session ? loaded->session->precision
                                                                       : sculpt::Precision::Bits16);
        });
        measurer_->stop();
        picture_->setDocument(nullptr); // before the old document goes
        document_ = std::move(fresh);
        screenshot_.clear(); // it was to be of the former one
    });
    emit progress(1, 1);
    if (!done) {
        emit changed();
        emit openFailed(message_);
        return;
    }
    source_ = loaded->request;
    checksum_ = loaded->checksum;
    if (loaded->session) {
        const auto& session = *loaded->session;
        source_.rawLayout = session.rawLayout;
        source_.series = session.series;
        source_.frame = session.frame;
        replay_.assign(session.operations.begin(), session.operations.end());
    }
    savedEdits_ = 0;
    replayTotal_ = int(replay_.size());
    isReplayGivenUp_ = false;
    view_ = document_->view();
    isViewPending_ = false;
    growth_->reset();
    document_->setUndoMemory(std::size_t(preferences_.undoMegabytes) << 20);
    if (!isReplaying()) {
        picture_->setDocument(document_.get());
    }
    say(loaded->notices.empty() ? tr("Opened %1").arg(QString::fromStdString(document_->volume().name))
                                : QString::fromStdString(loaded->notices.front()));
    wake();
    emit opened();
    if (!isReplaying()) {
        prefer();
    }
    emit changed();
}

void StudioController::replayOne() {
    const auto operation = replay_.front();
    const int number = replayTotal_ - int(replay_.size()) + 1;
    say(tr("Replaying %1 of %2: %3").arg(number).arg(replayTotal_).arg(studio::name(operation)));
    emit progress(number - 1, replayTotal_);
    QString error;
    bool isGivenUp = false;
    try {
        if (isReplayGivenUp_) {
            throw GivenUp("it was given up");
        }
        // A picture or label map that the session asks for was written when it was made; opening writes
        // nothing.
        if (studio::isOutput(operation)) {
            document_->note(operation);
        } else {
            longWork_.run([&] { document_->apply(operation); }, LongWork::Input::GivesUp);
        }
        replay_.pop_front();
    } catch (const std::exception& e) {
        isGivenUp = dynamic_cast<const GivenUp*>(&e) != nullptr;
        error = tr("Replayed up to operation %1 (%2): %3")
                    .arg(number)
                    .arg(studio::name(operation), QString::fromUtf8(e.what()));
        replay_.clear();
    }
    if (!isReplaying()) {
        // What was recovered is in no session file.
        savedEdits_ = source_.journal.empty() ? countEdits(document_.get()) : 0;
        source_.journal.clear();
        document_->seal();
        view_ = document_->view();
        picture_->setDocument(document_.get());
        say(error.isEmpty() ? tr("Replayed %1 operations").arg(replayTotal_) : error);
        emit progress(1, 1);
        wake();
        if (!error.isEmpty() && !isGivenUp) {
            emit openFailed(error);
        }
    }
    emit changed();
}

bool StudioController::hasUnsavedEdits() const {
    return !isReplaying() && (growth_->isPlaying() || countEdits(document_.get()) != savedEdits_);
}

void StudioController::setPreferences(const Preferences& preferences) {
    const bool isQualityNew = preferences.smoothSampling != preferences_.smoothSampling ||
                              preferences.shadows != preferences_.shadows;
    preferences_ = preferences;
    if (document() != nullptr) {
        document_->setUndoMemory(std::size_t(preferences_.undoMegabytes) << 20);
        if (isQualityNew && !isReplaying()) {
            prefer();
        }
    }
}

// A view of the preferred quality. A session has its own.
void StudioController::prefer() {
    auto view = view_;
    view.sampling = preferences_.smoothSampling ? field::Sampling::Tricubic : field::Sampling::Trilinear;
    view.shadows = preferences_.shadows;
    look(view);
}

studio::Session StudioController::provenance() const {
    studio::Session source;
    const auto& volume = document_->volume();
    if (volume.path.empty()) { // made from nothing
        source.block = studio::Session::Block{volume.geometry.dims, volume.geometry.spacing()};
    } else {
        source.volumePath = std::filesystem::absolute(volume.path);
    }
    source.volumeChecksum = checksum_;
    source.precision = document_->precision();
    source.rawLayout = source_.rawLayout;
    source.series = source_.series;
    source.frame = source_.frame;
    return source;
}

bool StudioController::saveSession(const std::filesystem::path& path) {
    if (document_ == nullptr || isLoading()) {
        return false;
    }
    tool_->settle();
    if (document_->isStrokeOpen()) {
        return false;
    }
    growth_->pause();
    return guard([&] {
        flushView();
        const auto session = studio::sessionOf(*document_, provenance());
        studio::saveSession(path, session);
        savedEdits_ = countEdits(document_.get());
        document_->seal();
        source_.session = path;
        say(tr("Saved %1").arg(text(path)));
        emit saved();
    });
}

void StudioController::close() {
    if (document_ == nullptr || isLoading()) {
        return;
    }
    host_.makeCurrent();
    growth_->pause();
    growth_->reset();
    emit closing();
    measurer_->stop(); // it and the picture look into the document
    picture_->setDocument(nullptr);
    document_.reset();
    source_ = {};
    screenshot_.clear();
    savedEdits_ = 0;
    view_ = {};
    isViewPending_ = false;
    say({});
    emit closed();
    emit changed();
    emit pictureChanged();
}

bool StudioController::exportLabels(const std::filesystem::path& path) {
    if (!segments_->hasVoxels()) {
        say(tr("There is no segmentation to export yet: draw seeds first"));
        return false;
    }
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    const bool done = apply(studio::SaveLabels{path.filename().string()}, folder);
    if (done) {
        say(tr("Exported labels to %1").arg(text(path)));
    }
    return done;
}

void StudioController::takeScreenshot(const std::filesystem::path& path) {
    if (document_ == nullptr || isLoading()) {
        return;
    }
    growth_->pause();
    screenshot_ = path;
    say(tr("Finishing the picture"));
    schedule(0);
    emit changed();
}

void StudioController::writeScreenshot() {
    if (screenshot_.empty()) {
        return;
    }
    const auto path = std::exchange(screenshot_, {});
    if (workLong([&] { image::writePng(path, picture_->readPicture()); })) {
        say(tr("Saved picture %1").arg(text(path)));
    }
    emit changed();
}

bool StudioController::setStencil(const std::filesystem::path& picture) {
    std::vector<glm::dvec2> outline;
    const bool isRead = guard([&] {
        for (const glm::dvec2 point : sculpt::outlineFromImage(image::readPng(picture), 1)) {
            outline.emplace_back(point.x, -point.y);
        }
    });
    if (isRead) {
        stencil_ = std::move(outline);
        setShape(studio::Shape::Stencil);
        say(tr("Drag a box for the shape of %1").arg(text(picture.filename())));
    }
    return isRead;
}

} // namespace vs::desktop
