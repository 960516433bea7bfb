// SPDX-License-Identifier: Apache-2.0
#include "studio_controller.h"

#include "growth_controller.h"
#include "segment_controller.h"
#include "segment_measurer.h"
#include "tool.h"

#include "base/error.h"
#include "sculpt/outline_image.h"

#include <algorithm>
#include <variant>

namespace vs::desktop {

namespace {

QString text(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

// Looking and writing files are no edits.
std::size_t countEdits(const studio::Document* document) {
    if (document == nullptr) {
        return 0;
    }
    const auto& log = document->log();
    return std::size_t(std::count_if(log.begin(), log.end(), [](const studio::Operation& operation) {
        return !studio::isOutput(operation) && !std::holds_alternative<studio::SetView>(operation);
    }));
}

} // namespace

void StudioController::open(const OpenRequest& request) {
    if (isLoading()) {
        return;
    }
    host_.makeCurrent();
    growth_->pause();
    tool_->clear();
    say(tr("Reading %1").arg(text((request.session.empty() ? request.volume : request.session).filename())));
    loader_.start(request);
    emit progress(0, 0);
    emit changed();
}

void StudioController::finishOpening(const std::shared_ptr<Loaded>& loaded) {
    host_.makeCurrent();
    const bool done = guard([&] {
        auto fresh = std::make_unique<studio::Document>(std::move(loaded->volume),
                                                        loaded->session ? loaded->session->precision
                                                                        : sculpt::Precision::Bits16);
        measurer_->stop();
        picture_->setDocument(nullptr); // before the old document goes
        document_ = std::move(fresh);
    });
    emit progress(1, 1);
    if (!done) {
        emit changed();
        emit openFailed(message_);
        return;
    }
    source_ = loaded->request;
    if (loaded->session) {
        const auto& session = *loaded->session;
        source_.rawLayout = session.rawLayout;
        source_.series = session.series;
        source_.frame = session.frame;
        replay_.assign(session.operations.begin(), session.operations.end());
    }
    savedEdits_ = 0;
    replayTotal_ = int(replay_.size());
    view_ = document_->view();
    isViewPending_ = false;
    growth_->reset();
    if (!isReplaying()) {
        picture_->setDocument(document_.get());
    }
    say(loaded->notices.empty() ? tr("Opened %1").arg(QString::fromStdString(document_->volume().name))
                                : QString::fromStdString(loaded->notices.front()));
    wake();
    emit opened();
    emit changed();
}

void StudioController::replayOne() {
    const auto operation = replay_.front();
    const int number = replayTotal_ - int(replay_.size()) + 1;
    say(tr("Replaying %1 of %2: %3").arg(number).arg(replayTotal_).arg(studio::name(operation)));
    emit progress(number - 1, replayTotal_);
    QString error;
    try {
        // A picture or label map that the session asks for was written when it was made; opening writes
        // nothing.
        if (studio::isOutput(operation)) {
            document_->note(operation);
        } else {
            document_->apply(operation);
        }
        replay_.pop_front();
    } catch (const std::exception& e) {
        error = tr("Replayed up to operation %1 (%2): %3")
                    .arg(number)
                    .arg(studio::name(operation), QString::fromUtf8(e.what()));
        replay_.clear();
    }
    if (!isReplaying()) {
        savedEdits_ = countEdits(document_.get());
        view_ = document_->view();
        picture_->setDocument(document_.get());
        say(error.isEmpty() ? tr("Replayed %1 operations").arg(replayTotal_) : error);
        emit progress(1, 1);
        wake();
        if (!error.isEmpty()) {
            emit openFailed(error);
        }
    }
    emit changed();
}

bool StudioController::hasUnsavedEdits() const {
    return !isReplaying() && (growth_->isPlaying() || countEdits(document_.get()) != savedEdits_);
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
        studio::Session source;
        if (!document_->volume().path.empty()) { // else it was made from nothing
            source.volumePath = std::filesystem::absolute(document_->volume().path);
        }
        source.rawLayout = source_.rawLayout;
        source.series = source_.series;
        source.frame = source_.frame;
        const auto session = studio::sessionOf(*document_, source);
        studio::saveSession(path, session);
        savedEdits_ = countEdits(document_.get());
        say(tr("Saved %1").arg(text(path)));
    });
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
    guard([&] {
        image::writePng(path, picture_->readPicture());
        say(tr("Saved picture %1").arg(text(path)));
    });
    emit changed();
}

bool StudioController::setStencil(const std::filesystem::path& picture) {
    const bool isRead = guard([&] {
        stencil_.clear();
        for (const glm::dvec2 point : sculpt::outlineFromImage(image::readPng(picture), 1)) {
            stencil_.emplace_back(point.x, -point.y);
        }
    });
    shape_ = isRead ? studio::Shape::Polyline : shape_;
    if (isRead) {
        say(tr("Drag a box for the shape of %1").arg(text(picture.filename())));
    }
    emit changed();
    return isRead;
}

} // namespace vs::desktop
