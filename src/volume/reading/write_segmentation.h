// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/dicom/dicom_segmentation.h"

#include <cstdint>
#include <filesystem>
#include <span>

namespace vs::volume {

// Writes a DICOM Segmentation object, made by the decoder as makeDicomSegmentation() says. Returns how many
// files the series has that it names. Atomic. Throws WriteError naming the file, also when the grid's axes
// are not perpendicular; GivenUp ends the decoder and leaves an older file.
int writeDicomSegmentation(const std::filesystem::path& path, const SegmentationOrder& order,
                           std::span<const std::uint8_t> labels);

} // namespace vs::volume
