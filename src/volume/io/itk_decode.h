// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/inspect.h"

#include <itkImageIOBase.h>

#include <optional>

// Bridges to ITK's image readers. Internal to this folder; ITK's headers stay out of the public ones.
namespace vs::volume {

// The grid of the first three axes, after ReadImageInformation.
GridGeometry geometryOf(const itk::ImageIOBase& io);

// Reads the file with the given reader, which tells where the volume lies, after its header was inspected.
// `frame` picks a volume of a 4D file.
ReadResult readPlacedByItk(itk::ImageIOBase& io, const std::filesystem::path& path, Inspection&& inspection,
                           std::optional<int> frame);

} // namespace vs::volume
