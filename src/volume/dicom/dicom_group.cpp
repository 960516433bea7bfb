// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/dicom.h"

#include <algorithm>

namespace vs::volume {
namespace {

// Whether two slices can be neighbours in one stack.
bool belongTogether(const DicomSlice& a, const DicomSlice& b) {
    constexpr double sameDirection = 0.9999; // cosine; 0.8 degrees, beyond any rounding of header values
    const auto spacingOf = [](const DicomSlice& s) { return s.pixelSpacing.value_or(glm::dvec2(0)); };
    const glm::dvec2 difference = glm::abs(spacingOf(a) - spacingOf(b));
    return a.seriesUid == b.seriesUid && a.size == b.size && a.hasOrientation == b.hasOrientation &&
           glm::dot(a.alongColumns, b.alongColumns) > sameDirection &&
           glm::dot(a.alongRows, b.alongRows) > sameDirection && std::max(difference.x, difference.y) < 1e-3;
}

} // namespace

std::vector<DicomGroup> groupSlices(std::vector<DicomSlice> slices) {
    std::vector<DicomGroup> groups;
    for (auto& slice : slices) {
        const auto group = std::find_if(groups.begin(), groups.end(), [&](const DicomGroup& candidate) {
            return belongTogether(candidate.slices.front(), slice);
        });
        if (group == groups.end()) {
            groups.push_back({{std::move(slice)}});
        } else {
            group->slices.push_back(std::move(slice));
        }
    }
    return groups;
}

} // namespace vs::volume
