// SPDX-License-Identifier: Apache-2.0
#include "model/exports/document_export.h"

#include "model/segments/growth_controller.h"
#include "model/studio/studio_controller.h"

#include "base/progress.h"
#include "studio/state/region.h"

#include <cmath>
#include <exception>

namespace vs::desktop {

namespace {
constexpr double kReadMs = 20;
constexpr int kWatchMs = 50;      // how often progress is looked at
constexpr double kReading = 0.15; // of the whole
} // namespace

DocumentExport::~DocumentExport() {
    if (shared_) {
        shared_->isGivenUp = true;
    }
}

void DocumentExport::save(const std::filesystem::path& path, const studio::ExportSettings& settings,
                          std::vector<studio::ExportedSegment> segments) {
    if (isRunning() || studio_.host().document() == nullptr) {
        return;
    }
    studio_.growth().pause();
    (void)studio_.view().canvas(); // what was looked at last belongs to the document
    path_ = path;
    settings_ = settings;
    keepVersion();
    reader_ = std::make_unique<studio::ExportReader>(*studio_.host().document(), settings.what,
                                                     std::move(segments));
    const OpenRequest& origin = studio_.files().source();
    volume::ReadOptions reading;
    reading.series = origin.series.empty() ? std::nullopt : std::optional(origin.series);
    reading.frame = origin.frame;
    reading.level = origin.level;
    reading.channel = origin.channel;
    reader_->setReading(reading);
    shared_ = std::make_shared<Shared>();
    start();
}

void DocumentExport::tick() {
    if (reader_) {
        read();
    } else {
        tellProgress(shared_->thousandths);
        goOn(kWatchMs);
    }
}

void DocumentExport::read() {
    if (shared_->isGivenUp) {
        end(false, tr("The export was given up"));
        return;
    }
    if (hasChanged()) {
        end(false, tr("The document changed: the export was given up"));
        return;
    }
    bool isAllRead = false;
    if (!studio_.host().workLong([&] { isAllRead = reader_->readSome(kReadMs); })) {
        end(false, studio_.host().message());
        return;
    }
    tellProgress(int(1000 * kReading * reader_->share()));
    if (isAllRead) {
        beginWork();
    }
    goOn();
}

void DocumentExport::beginWork() {
    // The volume stays as long as the document, and that cannot go while the dialog is open.
    worker_ =
        std::jthread([this, shared = shared_, path = path_, settings = settings_, source = reader_->take()] {
            QString message;
            bool isDone = false;
            try {
                const auto lines = studio::writeExport(path, source, settings, [&](double share) {
                    shared->thousandths = int(1000 * (kReading + (1 - kReading) * share));
                    return !shared->isGivenUp;
                });
                message = lines.size() == 1 ? tr("Exported %1").arg(QString::fromStdString(lines.front()))
                                            : tr("Exported %1 files up to %2")
                                                  .arg(lines.size())
                                                  .arg(QString::fromStdString(lines.back()));
                isDone = true;
            } catch (const GivenUp&) {
                message = tr("The export was given up");
            } catch (const std::bad_alloc&) {
                message = tr("There is not enough memory for this export; close what is open, or keep fewer "
                             "triangles");
            } catch (const std::exception& error) {
                message = QString::fromUtf8(error.what());
            }
            QMetaObject::invokeMethod(
                this, [this, isDone, message] { end(isDone, message); }, Qt::QueuedConnection);
        });
    reader_.reset();
}

void DocumentExport::cancel() {
    if (isRunning()) {
        shared_->isGivenUp = true;
    }
}

void DocumentExport::estimate() {
    std::vector<std::uint8_t> labels;
    double finestVoxels = 1; // in one of those that the labels are of
    const auto look = [&] {
        const studio::Region& region = studio_.host().document()->region();
        labels = region.labelMap();
        finestVoxels = double(region.geometry().voxelCount()) / double(labels.size());
    };
    if (studio_.host().document() == nullptr || estimator_.joinable() || !studio_.host().workLong(look)) {
        return;
    }
    estimator_ = std::jthread([this, labels = std::move(labels), dims = studio_.host().geometry()->dims,
                               perFace = std::pow(finestVoxels, 2.0 / 3)] {
        auto triangles = studio::estimatedTriangles(labels, dims);
        for (std::size_t& count : triangles) {
            count = std::size_t(double(count) * perFace);
        }
        QMetaObject::invokeMethod(
            this,
            [this, triangles] {
                triangles_ = triangles;
                emit estimated();
            },
            Qt::QueuedConnection);
    });
}

} // namespace vs::desktop
