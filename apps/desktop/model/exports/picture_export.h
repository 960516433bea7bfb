// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/exports/portioned_export.h"

#include "render/rays/ray_caster.h"
#include "studio/operations/operation.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace vs::desktop {

// Pictures of the document as it is seen, at any size: one, or a turntable of them around the patient's axis.
// The document must not change until it is finished, or it stops with a word.
class PictureExport : public PortionedExport {
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
    void cancel() override;

protected:
    void tick() override;
    void letGo() override;

private:
    void startAll(const studio::SavePicture& picture, int pictures);
    void begin();
    void startPicture();
    void takePicture();
    [[nodiscard]] std::filesystem::path pathOf(int picture) const;

    std::optional<render::RayCaster> caster_; // from when the window's own picture is finished
    studio::SavePicture picture_;
    render::ViewRays rays_; // of the picture in hand
    std::filesystem::path folder_;
    std::function<void(const image::Image&)> take_;
    int pictures_ = 1;
    int done_ = 0;
};

} // namespace vs::desktop
