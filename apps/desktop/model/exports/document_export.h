// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/exports/exports.h"

#include <QObject>
#include <QTimer>

#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <thread>

namespace vs::desktop {

class StudioController;

// Files for other programs from the document as it is: read from it in slices, made on a thread of their own,
// so that the window answers meanwhile. No widgets. The document must not change until it is finished, or it
// stops with a word.
class DocumentExport : public QObject {
    Q_OBJECT

public:
    explicit DocumentExport(StudioController& studio);
    ~DocumentExport() override;

    void save(const std::filesystem::path& path, const studio::ExportSettings& settings,
              std::vector<studio::ExportedSegment> segments);
    void cancel();
    [[nodiscard]] bool isRunning() const { return isRunning_; }

    // Looks how many triangles the surfaces of segments have; estimated() follows.
    void estimate();
    // The number of triangles of each label's surface, by label; zeros while nothing is known.
    [[nodiscard]] const std::array<std::size_t, 256>& triangles() const { return triangles_; }

signals:
    void progressed(int thousandths);
    void finished(bool isDone, const QString& message);
    void estimated();

private:
    // What the worker's thread and this one both look at.
    struct Shared {
        std::atomic<bool> isGivenUp = false;
        std::atomic<int> thousandths = 0;
    };

    void tick();
    void read();
    void beginWork();
    void end(bool isDone, const QString& message);

    StudioController& studio_;
    bool isRunning_ = false;
    std::unique_ptr<studio::ExportReader> reader_; // while it reads
    std::filesystem::path path_;
    studio::ExportSettings settings_;
    std::uint64_t version_ = 0; // of the document, when it began
    std::array<std::size_t, 256> triangles_{};
    QTimer timer_;
    std::shared_ptr<Shared> shared_;
    std::jthread worker_;
    std::jthread estimator_;
};

} // namespace vs::desktop
