// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/rays/ray_caster.h"
#include "studio/operations/operation.h"

#include <QObject>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <optional>

namespace vs::desktop {

class StudioController;

// Pictures of the document as it is seen, at any size, made in slices so that the window answers meanwhile:
// one, or a turntable of them around the patient's axis. No widgets. The document must not change until it is
// finished, or it stops with a word.
class PictureExport : public QObject {
    Q_OBJECT

public:
    explicit PictureExport(StudioController& studio);
    ~PictureExport() override;

    // Writes `picture.file` into the folder, and notes that in the session, so that its replay writes the
    // same picture. With more than one picture: "name-001.png" and so on, evenly all the way around; these
    // are not noted.
    void save(const studio::SavePicture& picture, const std::filesystem::path& folder, int pictures);
    // One picture for the clipboard, say.
    void make(const studio::SavePicture& picture, const std::function<void(const image::Image&)>& take);
    void cancel();
    [[nodiscard]] bool isRunning() const { return isRunning_; }

signals:
    void progressed(int done, int total);
    void finished(bool isDone, const QString& message);

private:
    void start(const studio::SavePicture& picture, int pictures);
    void begin();
    void startPicture();
    void tick();
    void takePicture();
    void stop(bool isDone, const QString& message);
    [[nodiscard]] std::filesystem::path pathOf(int picture) const;

    StudioController& studio_;
    bool isRunning_ = false;
    std::optional<render::RayCaster> caster_; // from when the window's own picture is finished
    studio::SavePicture picture_;
    render::ViewRays rays_; // of the picture in hand
    std::filesystem::path folder_;
    std::function<void(const image::Image&)> take_;
    int pictures_ = 1;
    int done_ = 0;
    std::uint64_t version_ = 0; // of the document, when it began
    QTimer timer_;
};

} // namespace vs::desktop
