// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/phrase.h"
#include "studio/operations/description.h"
#include "volume/grid/geometry.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vs::studio {

// Says where the scan's voxels really lie, where its file has that wrong: the distances between them in mm,
// and the sides of the patient that its axes lead towards, as three letters (volume::GridGeometry). What is
// not set is as in the file. Values and indices of voxels stay, and so does all that was done to them.
struct CorrectGeometry {
    static constexpr About kAbout{
        VS_TEXT("library", "geometry"), Effect::Lays,
        "says where the scan's voxels lie, where its file has that wrong; what is not "
        "given is as in the file, and what was cut or segmented stays in its voxels",
        "properties"};

    // What is beyond is a mistake of units: a millionth of a millimetre, a metre.
    static constexpr double kLeastSpacingMm = 1e-6;
    static constexpr double kMostSpacingMm = 1e3;

    std::optional<glm::dvec3> spacing = {};
    std::optional<std::string> orientation = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            sparse("spacing", &CorrectGeometry::spacing,
                   {.least = kLeastSpacingMm, .most = kMostSpacingMm, .unit = "mm"},
                   "between voxel centres along each axis"),
            sparse(
                "orientation", &CorrectGeometry::orientation, {.leastCount = 3, .mostCount = 3},
                "the sides that columns, rows and slices lead towards: a letter of L and R, one of P and A, "
                "one of S and I, as \"LPS\"")};
    }
    [[nodiscard]] Fault faultOf() const;
    [[nodiscard]] std::vector<Phrase> details() const;

    // Where voxels lie by it whose file says `inFile`. Throws Error where it makes no sense.
    [[nodiscard]] volume::GridGeometry corrected(const volume::GridGeometry& inFile) const;
};

using CorrectingOperations = std::variant<CorrectGeometry>;

} // namespace vs::studio
