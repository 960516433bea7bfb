// SPDX-License-Identifier: Apache-2.0
#include "volume/io/formats.h"
#include "volume/io/inspect.h"
#include "volume/io/itk_decode.h"

namespace vs::volume {

ReadResult readNifti(const std::filesystem::path& path, const ReadOptions& options) {
    NiftiInspection inspection = inspectNifti(path, Inflated::Kept);
    const std::int64_t frames = inspection.sizes.size() > 3 ? inspection.sizes[3] : 1;
    const int frame = chosenFrame(path, frames, options.frame);
    ReadResult result;
    result.notices = inspection.notices;
    Volume& volume = result.volume;
    volume.geometry = inspection.geometry;
    takeFrame(path, inspection, frame, result, {inspection.slope, inspection.intercept});
    volume.details.format = "NIfTI";
    volume.details.slope = inspection.slope;
    volume.details.intercept = inspection.intercept;
    return result;
}

} // namespace vs::volume
