// SPDX-License-Identifier: Apache-2.0
#include "model/exports/picture_export.h"

#include "model/studio/studio_controller.h"

#include "render/marks/draw_annotations.h"
#include "studio/document/document_facts.h"
#include "studio/editing/measurement_marks.h"

#include <fmt/format.h>

namespace vs::desktop {

namespace {
constexpr double kRenderMs = 20;
constexpr int kWaitMs = 50; // for the window's own picture
} // namespace

PictureExport::PictureExport(StudioController& studio) : PortionedExport(studio) {
    // The caster looks into the document.
    connect(&studio_.host(), &DocumentHost::closed, this, &PictureExport::cancel);
    connect(&studio_.host(), &DocumentHost::opened, this, &PictureExport::cancel);
}

PictureExport::~PictureExport() { PictureExport::letGo(); }

void PictureExport::save(const studio::SavePicture& picture, const std::filesystem::path& folder,
                         int pictures) {
    folder_ = folder;
    take_ = [this](const image::Image& made) {
        studio_.host().runLong([&] { image::writePng(pathOf(done_), made); });
    };
    startAll(picture, pictures);
}

void PictureExport::make(const studio::SavePicture& picture,
                         const std::function<void(const image::Image&)>& take) {
    take_ = take;
    startAll(picture, 1);
}

void PictureExport::startAll(const studio::SavePicture& picture, int pictures) {
    if (!isRunning() && studio_.host().document() != nullptr) {
        picture_ = picture;
        pictures_ = pictures;
        done_ = 0;
        start();
    }
}

void PictureExport::begin() {
    keepVersion();
    caster_.emplace();
    startPicture();
}

void PictureExport::startPicture() {
    auto camera = studio_.view().shown().camera;
    camera.azimuthDegrees += 360.0 * done_ / pictures_;
    rays_ = render::viewRays(camera, *studio_.host().geometry(), picture_.size);
    studio_.host().runLong([&] {
        auto frame = studio_.host().document()->frame(picture_.size);
        frame.samples = picture_.samples;
        frame.background = picture_.background;
        frame.rays = rays_;
        caster_->start(frame);
    });
}

void PictureExport::tick() {
    if (!caster_ && !studio_.isIdle()) {
        goOn(kWaitMs);
        return;
    }
    if (caster_ ? hasChanged() : studio_.host().document() == nullptr) {
        end(false, tr("The document changed: the pictures were given up"));
        return;
    }
    const bool isFine = studio_.host().guard([this] {
        if (!caster_) {
            begin();
            return;
        }
        bool isComplete = false;
        studio_.host().runLong([&] { isComplete = caster_->renderSome(kRenderMs); });
        if (isComplete) {
            takePicture();
        }
    });
    if (!isFine) {
        end(false, studio_.host().message());
    } else if (done_ == pictures_) {
        const QString name = QString::fromStdString(pathOf(pictures_ - 1).string());
        end(true, pictures_ > 1 ? tr("Saved %1 pictures up to %2").arg(pictures_).arg(name)
                                : tr("Saved picture %1").arg(name));
    } else {
        emit progressed(done_ * picture_.samples + caster_->completedSamples(), pictures_ * picture_.samples);
        goOn();
    }
}

void PictureExport::takePicture() {
    image::Image made;
    studio_.host().runLong([&] {
        made = caster_->readPicture();
        if (picture_.annotations) {
            studio::markMeasurements(made, *studio_.host().facts()->measured, rays_,
                                     *studio_.host().geometry());
            render::annotate(made, rays_, *studio_.host().geometry());
        }
    });
    take_(made);
    if (++done_ < pictures_) {
        startPicture();
    } else if (pictures_ == 1 && !picture_.file.empty()) {
        studio_.host().document()->logOutput(picture_);
    }
}

std::filesystem::path PictureExport::pathOf(int picture) const {
    const std::filesystem::path file(picture_.file);
    return folder_ / (pictures_ == 1 ? file.string()
                                     : fmt::format("{}-{:03}{}", file.stem().string(), picture + 1,
                                                   file.extension().string()));
}

void PictureExport::cancel() {
    if (isRunning()) {
        end(false, tr("Given up after %1 of %2 pictures").arg(done_).arg(pictures_));
    }
}

void PictureExport::letGo() {
    studio_.host().gl().makeCurrent();
    caster_.reset();
}

} // namespace vs::desktop
