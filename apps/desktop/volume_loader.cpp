// SPDX-License-Identifier: Apache-2.0
#include "volume_loader.h"

namespace vs::desktop {

namespace {

void load(Loaded& result) {
    const OpenRequest& request = result.request;
    if (!request.session.empty()) {
        result.session = studio::loadSession(request.session);
        const auto replacement =
            request.volume.empty() ? std::nullopt : std::optional<std::filesystem::path>(request.volume);
        result.volume = studio::openVolume(*result.session, request.session, replacement, result.notices);
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
    auto read = volume::readVolume(request.volume, options);
    result.volume = std::move(read.volume);
    result.notices = std::move(read.notices);
}

} // namespace

void VolumeLoader::start(const OpenRequest& request) {
    isLoading_ = true;
    auto result = std::make_shared<Loaded>();
    result->request = request;
    worker_ = std::jthread([this, result] {
        QString error;
        try {
            load(*result);
        } catch (const std::exception& e) {
            error = QString::fromUtf8(e.what());
        }
        QMetaObject::invokeMethod(
            this, [this, result, error] { finish(result, error); }, Qt::QueuedConnection);
    });
}

void VolumeLoader::finish(const std::shared_ptr<Loaded>& result, const QString& error) {
    isLoading_ = false;
    if (error.isEmpty()) {
        emit loaded(result);
    } else {
        emit failed(error);
    }
}

} // namespace vs::desktop
