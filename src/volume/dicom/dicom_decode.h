// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/dicom/dicom.h"

namespace vs::volume {

// Decodes slices of one size, in the given order, into one block of the smallest type that holds all of them,
// rescale slope and intercept of each applied. Sets dims only. Throws ReadError.
Volume decodeSlices(const std::filesystem::path& path, const std::vector<DicomSlice>& slices);

} // namespace vs::volume
