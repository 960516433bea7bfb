// SPDX-License-Identifier: Apache-2.0
#include "engine/volume_loader.h"

#include "base/progress.h"
#include "studio/json/journal_content.h"

namespace vs::desktop {

namespace {

// The levels that are finer than what was read.
void findFiner(Loaded& result, const volume::ReadOptions& used) {
    result.finer = studio::finerLevels(result.volume, used, studio::Storage::Auto, result.request.budgets,
                                       result.notices);
}

// What a session says, or, where it names no level and speaks of a finest one that this machine has no room
// to work on, that of one that it has.
volume::ReadOptions wantedOf(const studio::Session& session, const OpenRequest& request,
                             const std::optional<std::filesystem::path>& replacement) {
    volume::ReadOptions wanted;
    if (!session.level && !session.isMade()) {
        volume::ReadOptions finest;
        finest.channel = session.channel;
        finest.frame = session.frame;
        wanted.level = studio::levelInReach(studio::volumePathOf(session, request.session, replacement),
                                            finest, request.budgets);
    }
    return wanted;
}

void load(Loaded& result) {
    OpenRequest& request = result.request;
    if (request.block) {
        studio::Session made;
        made.block = request.block->block;
        result.volume = studio::openVolume(made, {}, std::nullopt, result.notices);
        return;
    }
    if (!request.journal.empty()) {
        auto content = studio::readJournal(request.journal);
        const auto replacement = request.volume.empty() ? std::nullopt : std::optional(request.volume);
        request.session = content.savedAs;
        result.session = std::move(content.session);
        if (!content.leftOut.empty()) {
            result.notices.push_back(content.leftOut);
        }
        volume::ReadOptions used;
        result.volume = studio::openVolume(*result.session, request.journal, replacement, result.notices, {},
                                           request.folders, &used);
        findFiner(result, used);
        request.volume = replacement.value_or(result.session->volumePath);
        return;
    }
    if (request.given) {
        result.session = *request.given;
        result.volume = studio::openVolume(*result.session, {}, std::nullopt, result.notices);
        return;
    }
    if (!request.session.empty()) {
        result.session = studio::loadSession(request.session);
        const auto replacement =
            request.volume.empty() ? std::nullopt : std::optional<std::filesystem::path>(request.volume);
        volume::ReadOptions used;
        result.volume =
            studio::openVolume(*result.session, request.session, replacement, result.notices,
                               wantedOf(*result.session, request, replacement), request.folders, &used);
        const bool growsFinest = true;
        result.isOfAnotherLevel = studio::goToLevel(*result.session, request.session, replacement, used,
                                                    growsFinest, result.notices);
        // What did not fit another volume is not said of it when the session is saved.
        if (!used.raw) {
            result.session->rawLayout.clear();
        }
        result.session->series = used.series.value_or("");
        result.session->frame = used.frame;
        result.session->level = used.level;
        result.session->channel = used.channel;
        findFiner(result, used);
        if (!request.stateTrouble.empty()) {
            result.notices.push_back(request.session.string() + ": its state cannot be used (" +
                                     request.stateTrouble + "); everything is done again");
        } else if (!request.isPlayed) {
            result.state = studio::loadState(request.session, *result.session, result.volume, result.notices,
                                             result.finer && result.finer->areFinerThan(result.volume));
        }
        return;
    }
    volume::ReadOptions options;
    if (!request.rawLayout.empty()) {
        options.raw = volume::parseRawLayout(request.rawLayout);
    }
    if (!request.series.empty()) {
        options.series = request.series;
    }
    options.frame = request.frame;
    options.level = request.level;
    options.channel = request.channel;
    auto opened = studio::openScan(request.volume, options, studio::Storage::Auto, request.budgets);
    request.level = opened.options.level;
    result.volume = std::move(opened.read.volume);
    result.notices = std::move(opened.read.notices);
    result.finer = std::move(opened.finer);
}

} // namespace

void VolumeLoader::start(const OpenRequest& request) {
    isLoading_ = true;
    isGivenUp_ = false;
    auto result = std::make_shared<Loaded>();
    result->request = request;
    worker_ = std::jthread([this, result] {
        const ProgressListener listener([this](std::optional<double>) { return !isGivenUp_; });
        Ending ending;
        try {
            load(*result);
            reportProgress();
            result->checksum = volume::checksum(result->volume);
        } catch (const volume::SeveralSeries& e) {
            ending.error = QString::fromUtf8(e.what());
            ending.choices = e.choices();
        } catch (const studio::MovedVolume& e) {
            ending.error = QString::fromUtf8(e.what());
            ending.missing = e.wanted();
        } catch (const std::exception& e) {
            ending.error = QString::fromUtf8(e.what());
        }
        QMetaObject::invokeMethod(
            this, [this, result, ending] { finish(result, ending); }, Qt::QueuedConnection);
    });
}

void VolumeLoader::finish(const std::shared_ptr<Loaded>& result, const Ending& ending) {
    isLoading_ = false;
    if (isGivenUp_) {
        emit givenUp();
    } else if (ending.error.isEmpty()) {
        emit loaded(result);
    } else if (!ending.choices.empty() && result->request.session.empty()) {
        emit severalSeries(result->request, ending.choices);
    } else if (!ending.missing.empty() &&
               !(result->request.session.empty() && result->request.journal.empty())) {
        emit volumeMissing(result->request, ending.missing);
    } else {
        emit failed(ending.error);
    }
}

} // namespace vs::desktop
