// SPDX-License-Identifier: Apache-2.0
#include "model/exports/document_export.h"

#include "model/segments/growth_controller.h"
#include "model/studio/studio_controller.h"

#include "base/progress.h"
#include "studio/state/region.h"

#include <exception>

namespace vs::desktop {

namespace {
constexpr double kSliceMs = 20;
constexpr int kWatchMs = 50;      // how often progress is looked at
constexpr double kReading = 0.15; // of the whole
} // namespace

DocumentExport::DocumentExport(StudioController& studio) : studio_(studio) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &DocumentExport::tick);
}

DocumentExport::~DocumentExport() {
    if (shared_) {
        shared_->isGivenUp = true;
    }
}

void DocumentExport::save(const std::filesystem::path& path, const studio::ExportSettings& settings,
                          std::vector<studio::ExportedSegment> segments) {
    if (isRunning_ || studio_.host().document() == nullptr) {
        return;
    }
    studio_.growth().pause();
    (void)studio_.view().canvas(); // what was looked at last belongs to the document
    path_ = path;
    settings_ = settings;
    version_ = studio_.host().document()->version();
    reader_ = std::make_unique<studio::ExportReader>(*studio_.host().document(), settings.what,
                                                     std::move(segments));
    const OpenRequest& origin = studio_.files().source();
    reader_->setReading(
        {{}, origin.series.empty() ? std::nullopt : std::optional(origin.series), origin.frame});
    shared_ = std::make_shared<Shared>();
    isRunning_ = true;
    timer_.start(0);
}

void DocumentExport::tick() {
    if (!isRunning_) {
        return;
    }
    if (reader_) {
        read();
    } else {
        emit progressed(shared_->thousandths);
        timer_.start(kWatchMs);
    }
}

void DocumentExport::read() {
    if (shared_->isGivenUp) {
        end(false, tr("The export was given up"));
        return;
    }
    if (studio_.host().document() == nullptr || studio_.host().document()->version() != version_) {
        end(false, tr("The document changed: the export was given up"));
        return;
    }
    bool isAllRead = false;
    if (!studio_.host().workLong([&] { isAllRead = reader_->readSome(kSliceMs); })) {
        end(false, studio_.host().message());
        return;
    }
    emit progressed(int(1000 * kReading * reader_->share()));
    if (isAllRead) {
        beginWork();
    }
    timer_.start(0);
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
    if (isRunning_) {
        shared_->isGivenUp = true;
    }
}

void DocumentExport::end(bool isDone, const QString& message) {
    timer_.stop();
    isRunning_ = false;
    reader_.reset();
    emit finished(isDone, message);
}

void DocumentExport::estimate() {
    std::vector<std::uint8_t> labels;
    if (studio_.host().document() == nullptr || estimator_.joinable() ||
        !studio_.host().workLong([&] { labels = studio_.host().document()->region().labelMap(); })) {
        return;
    }
    estimator_ = std::jthread([this, labels = std::move(labels), dims = studio_.host().geometry()->dims] {
        const auto triangles = studio::estimatedTriangles(labels, dims);
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
