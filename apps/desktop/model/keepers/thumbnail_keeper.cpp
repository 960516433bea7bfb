// SPDX-License-Identifier: Apache-2.0
#include "model/keepers/thumbnail_keeper.h"

#include "model/studio/studio_controller.h"
#include "studio/document/document_facts.h"
#include "volume/reading/read_volume.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <QSaveFile>
#include <QThreadPool>

namespace vs::desktop {

namespace {

constexpr int kIdleMs = 1200; // at rest for so long: nobody is waiting for the next picture

QImage imageOf(const image::Image& picture) {
    return QImage(picture.rgba.data(), picture.width, picture.height, QImage::Format_RGBA8888).copy();
}

// The middle of a picture at the thumbnail's shape.
QImage thumbnailOf(const QImage& picture) {
    const QSize size =
        ThumbnailKeeper::kSize.scaled(picture.size(), Qt::KeepAspectRatio).expandedTo(QSize(1, 1));
    const QPoint corner((picture.width() - size.width()) / 2, (picture.height() - size.height()) / 2);
    return picture.copy(QRect(corner, size))
        .convertToFormat(QImage::Format_RGB32)
        .scaled(ThumbnailKeeper::kSize, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

} // namespace

void writeThumbnail(const QString& path, const QImage& picture) {
    QDir().mkpath(QFileInfo(path).path());
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && picture.save(&file, "PNG")) {
        file.commit();
    }
}

ThumbnailKeeper::ThumbnailKeeper(StudioController& studio) : QObject(&studio), studio_(studio) {
    calm_.setSingleShot(true);
    calm_.setInterval(kIdleMs);
    connect(&calm_, &QTimer::timeout, this, &ThumbnailKeeper::keep);
    connect(&studio, &StudioController::pictureChanged, &calm_, qOverload<>(&QTimer::start));
    connect(&studio.host(), &DocumentHost::opened, this, &ThumbnailKeeper::remember);
    connect(&studio.files(), &DocumentFiles::saved, this, [this] {
        taken_ = -1; // the session is another document than its volume
        remember();
        keep();
    });
}

KnownDocument ThumbnailKeeper::present() const {
    const auto* document = studio_.host().document();
    const auto dims = document->volume().geometry.dims;
    KnownDocument known;
    known.request = studio_.files().source();
    for (auto* path : {&known.request.volume, &known.request.session}) {
        if (!path->empty() && !volume::isWebAddress(*path)) {
            *path = std::filesystem::absolute(*path).lexically_normal();
        }
    }
    if (known.isSession()) {
        known.scan = known.request.volume;
    }
    known.details = tr("%1 × %2 × %3").arg(dims.x).arg(dims.y).arg(dims.z);
    const auto& segments = document->segments().segments;
    known.hasSegments = studio_.host().facts()->growth.voxels > 0 || segments.size() > 1;
    known.seen = QDateTime::currentDateTime();
    return known;
}

void ThumbnailKeeper::remember() {
    const KnownDocument known = present();
    if (!known.path().isEmpty()) {
        rememberDocument(known);
    }
}

void ThumbnailKeeper::keep() {
    if (studio_.host().document() == nullptr || !studio_.isIdle() || studio_.picture().pictures() == taken_) {
        return;
    }
    const KnownDocument known = present();
    if (known.path().isEmpty()) {
        return;
    }
    studio_.host().guard([&] {
        taken_ = studio_.picture().pictures();
        rememberDocument(known);
        QThreadPool::globalInstance()->start([path = known.picturePath(), guard = QPointer(this),
                                              picture = imageOf(studio_.picture().readPicture())] {
            writeThumbnail(path, thumbnailOf(picture));
            QMetaObject::invokeMethod(
                qApp,
                [guard] {
                    if (guard) {
                        emit guard->kept();
                    }
                },
                Qt::QueuedConnection);
        });
    });
}

} // namespace vs::desktop
