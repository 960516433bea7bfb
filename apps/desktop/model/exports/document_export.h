// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/exports/portioned_export.h"

#include "studio/exports/exports.h"

#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <thread>

namespace vs::desktop {

// Files for other programs from the document as it is: read from it in portions, made on a thread of their
// own, which goes on beside the window. The document must not change until it is finished, or it stops with a
// word.
class DocumentExport : public PortionedExport {
    Q_OBJECT

public:
    using PortionedExport::PortionedExport;
    ~DocumentExport() override;

    void save(const std::filesystem::path& path, const studio::ExportSettings& settings,
              std::vector<studio::ExportedSegment> segments);
    void cancel() override;

    // Looks how many triangles the surfaces of segments have; estimated() follows.
    void estimate();
    // The number of triangles of each label's surface, by label; zeros while nothing is known.
    [[nodiscard]] const std::array<std::size_t, 256>& triangles() const { return triangles_; }

signals:
    void estimated();

protected:
    void tick() override;
    void letGo() override { reader_.reset(); }

private:
    // What the worker's thread and this one both look at.
    struct Shared {
        std::atomic<bool> isGivenUp = false;
        std::atomic<int> thousandths = 0;
    };

    void read();
    void beginWork();
    void tellProgress(int thousandths) { emit progressed(thousandths, 1000); }

    std::unique_ptr<studio::ExportReader> reader_; // while it reads
    std::filesystem::path path_;
    studio::ExportSettings settings_;
    std::array<std::size_t, 256> triangles_{};
    std::shared_ptr<Shared> shared_;
    std::jthread worker_;
    std::jthread estimator_;
};

} // namespace vs::desktop
