// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>

namespace vs::volume {

// What a label map's file says of a label: 3D Slicer's .seg.nrrd does, and stores of OME-Zarr.
struct LabelLook {
    static constexpr std::size_t kLongestName = 200; // bytes; what a segment may be called

    std::string name;                 // one line of UTF-8; empty: none
    std::optional<glm::dvec3> colour; // sRGB, 0 to 1
};
using LabelLooks = std::map<std::int64_t, LabelLook>; // by the label's value in the file

// Names and colours of labels in a file, or a store's folder; none of other formats.
LabelLooks labelLooksOf(const std::filesystem::path& path);
// Reads them from a header of NRRD: "Segment0_Name:=Liver".
LabelLooks labelLooksIn(std::istream& header, const std::filesystem::path& path = "a label map");
// Reads them from what a store says of itself: "image-label" of OME-NGFF 0.4. What is wrong there is passed
// over: labels are what their voxels say.
LabelLooks labelLooksInStore(const nlohmann::ordered_json& attributes);

} // namespace vs::volume
