// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/session.h"

#include <QObject>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace vs::desktop {

// What to open: a volume, or a session (which names its volume).
struct OpenRequest {
    std::filesystem::path volume;
    std::filesystem::path session;
    std::string rawLayout;
    std::string series;
    std::optional<int> frame;
};

struct Loaded {
    OpenRequest request;
    volume::Volume volume;
    std::optional<studio::Session> session;
    std::vector<std::string> notices;
};

// Reads volumes on a thread of its own, so that the window answers meanwhile. No OpenGL here: a volume is
// uploaded by the document, on the window's thread.
class VolumeLoader : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    // One at a time; must not be called while isLoading().
    void start(const OpenRequest& request);
    [[nodiscard]] bool isLoading() const { return isLoading_; }

signals:
    void loaded(const std::shared_ptr<vs::desktop::Loaded>& result);
    void failed(const QString& message);

private:
    void finish(const std::shared_ptr<Loaded>& result, const QString& error);

    bool isLoading_ = false;
    std::jthread worker_;
};

} // namespace vs::desktop
