// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/correcting.h"

#include "base/error.h"

namespace vs::studio {

Fault CorrectGeometry::faultOf() const {
    if (orientation && !volume::isOrientationCode(*orientation)) {
        return {"orientation",
                "must be a letter of L and R, one of P and A, and one of S and I, in any order"};
    }
    return {};
}

std::vector<Phrase> CorrectGeometry::details() const {
    std::vector<Phrase> said;
    if (orientation) {
        said.push_back({"%1", {*orientation}});
    }
    if (spacing) {
        said.push_back(
            {"%1", {fmt::format("{:.4g} × {:.4g} × {:.4g} mm", spacing->x, spacing->y, spacing->z)}});
    }
    if (said.empty()) {
        said.push_back({VS_TEXT("library", "as in the file")});
    }
    return said;
}

volume::GridGeometry CorrectGeometry::corrected(const volume::GridGeometry& inFile) const {
    if (const Fault fault = faultOf(); !fault.wanted.empty()) {
        throw Error("{}: '{}' {}", fault.place, *orientation, fault.wanted);
    }
    if (spacing && !glm::all(glm::greaterThan(*spacing, glm::dvec3(0)))) {
        throw Error("spacing: {} x {} x {} mm make no grid; all three must be above 0", spacing->x,
                    spacing->y, spacing->z);
    }
    volume::GridGeometry grid = inFile;
    if (orientation) {
        grid = volume::reoriented(grid, *orientation);
    }
    return spacing ? volume::respaced(grid, *spacing) : grid;
}

} // namespace vs::studio
