// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/file_writer.h"

#include "image/image.h"
#include "render/marks/draw_annotations.h"
#include "studio/editing/measurement_marks.h"
#include "studio/editing/stroke_marks.h"
#include "volume/io/write.h"

#include <span>

namespace vs::studio {

image::Image FileWriter::picture(const SavePicture& op, const View& view, const Drawn& drawn) {
    if (!caster_) {
        caster_.emplace();
    }
    render::Frame picture = display_.frame(view, op.size);
    picture.samples = op.samples;
    picture.background = op.background;
    caster_->render(picture);
    image::Image pixels = caster_->readPicture();
    if (!drawn.isEmpty()) {
        markStrokes(pixels, drawn, op.strokes == ShownStrokes::Last, view, contents_.scan.volume.geometry);
    }
    if (op.annotations) {
        markMeasurements(pixels, allMeasured(*contents_.measurements, contents_.scan.volume), picture.rays,
                         contents_.scan.volume.geometry);
        render::annotate(pixels, picture.rays, contents_.scan.volume.geometry);
    }
    return pixels;
}

Outcome FileWriter::run(const SavePicture& op, const std::filesystem::path& folder, const Drawn& drawn) {
    image::writePng(folder / op.file, picture(op, contents_.view, drawn));
    return {{}, 0, 0, say("%1", op.file)};
}

Outcome FileWriter::run(const SaveLabels& op, const std::filesystem::path& folder) {
    const auto labels = contents_.region.labelMap();
    volume::writeGrid(folder / op.file, contents_.scan.volume.geometry,
                      std::span<const std::uint8_t>(labels));
    return {{}, 0, contents_.grownVoxels(), say("%1", op.file)};
}

Outcome FileWriter::run(const SaveSculpture& op, const std::filesystem::path& folder) {
    const std::vector<float> values = cutter_.sculptureAsFloats();
    volume::writeGrid(folder / op.file, contents_.scan.volume.geometry, std::span<const float>(values));
    return {{}, 0, 0, say("%1", op.file)};
}

} // namespace vs::studio
