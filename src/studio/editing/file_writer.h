// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "render/rays/ray_caster.h"
#include "studio/editing/contents.h"
#include "studio/editing/display.h"
#include "studio/editing/outcome.h"
#include "studio/operations/drawn.h"
#include "studio/strokes/cutter.h"
#include "volume/store/multiscales.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace vs::studio {

// Carries out the operations that write a file, into a folder: pictures, label maps, the sculpture. They
// change nothing. Throws WriteError.
class FileWriter {
public:
    // All three must outlive it.
    FileWriter(const Contents& contents, Display& display, const Cutter& cutter)
        : contents_(contents), display_(display), cutter_(cutter) {}

    // The picture that SavePicture would write of a view.
    image::Image picture(const SavePicture& op, const View& view, const Drawn& drawn);
    // `drawn`: the strokes that the picture shows, if it shows any.
    Outcome run(const SavePicture& op, const std::filesystem::path& folder, const Drawn& drawn);
    Outcome run(const SaveMarks& op, const std::filesystem::path& folder);
    Outcome run(const SaveFill& op, const std::filesystem::path& folder);
    Outcome run(const SaveFillSurface& op, const std::filesystem::path& folder);
    Outcome run(const SaveLabels& op, const std::filesystem::path& folder);
    Outcome run(const SaveSculpture& op, const std::filesystem::path& folder);

private:
    [[nodiscard]] std::vector<volume::StoreFacts::Label> labelFacts() const;

    const Contents& contents_;
    Display& display_;
    const Cutter& cutter_;
    std::optional<render::RayCaster> caster_; // made when first used
};

} // namespace vs::studio
