// SPDX-License-Identifier: Apache-2.0
#include "model/exports/export_formats.h"

#include "model/texts/texts.h"

namespace vs::desktop {

std::vector<ExportFormat> exportFormats(ExportKind kind) {
    if (kind == ExportKind::Table) {
        return {{tr("CSV table"), ".csv", 0, tr("Volumes, intensities, surfaces and places, a row each")}};
    }
    // A closed surface has half as many points as triangles.
    std::vector<ExportFormat> formats{
        {tr("STL surface"), ".stl", 50, tr("For 3D printing; all in one, without colours")},
        {tr("glTF surface"), ".glb", 24, tr("For viewers, the web and Blender; objects with their colours")},
        {tr("PLY surface"), ".ply", 20.5, tr("All in one, in colour")},
        {tr("OBJ surface"), ".obj", 66, tr("Objects with their colours, for modelling programs")}};
    if (kind == ExportKind::Segments) {
        formats.push_back({tr("DICOM segmentation"), ".dcm", 0, tr("For clinical viewers and archives")});
    }
    const bool isSegments = kind == ExportKind::Segments;
    formats.push_back({isSegments ? tr("NRRD label map") : tr("NRRD volume"), ".nrrd", 0,
                       isSegments ? tr("A number for each segment") : tr("The values, in their own type")});
    formats.push_back({isSegments ? tr("NIfTI label map") : tr("NIfTI volume"), ".nii.gz", 0,
                       isSegments ? tr("A number for each segment") : tr("The values, in their own type")});
    return formats;
}

} // namespace vs::desktop
