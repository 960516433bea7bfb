// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/scan_editor.h"

namespace vs::studio {

void ScanEditor::lay(const volume::GridGeometry& geometry) {
    contents_.scan.lay(geometry);
    cutter_.follow(geometry);
    ++contents_.version;
}

Outcome ScanEditor::run(CorrectGeometry& op) {
    const volume::GridGeometry before = contents_.scan.volume.geometry;
    const volume::GridGeometry after = op.corrected(contents_.scan.inFile);
    if (after == before) {
        return {{}, 0, 0, say(VS_TEXT("library", "nothing has changed: the voxels lie there already"))};
    }
    Edit edit{shared(op), {}, {}};
    edit.geometryBefore = before;
    edit.geometryAfter = after;
    contents_.remember(std::move(edit));
    lay(after);
    const std::string code = after.orientationCode();
    return {{},
            0,
            0,
            volume::areMirrored(after, contents_.scan.inFile)
                ? say(VS_TEXT("library", "%1, the mirror image of what the file says"), code)
                : say("%1", code)};
}

} // namespace vs::studio
