// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/inspect.h"

#include <itkImageIOBase.h>

#include <optional>

// Bridges to ITK's image readers. Internal to this folder; ITK's headers stay out of the public ones.
namespace vs::volume {

// Sends what the decoding libraries print to nowhere while it lives: their causes reach the caller as
// exceptions, and standard error must hold our one line. Nothing is hidden when VOLUME_STUDIO_LOG=debug is
// set.
class QuietLibraries {
public:
    QuietLibraries();
    ~QuietLibraries();
    QuietLibraries(const QuietLibraries&) = delete;
    QuietLibraries& operator=(const QuietLibraries&) = delete;

private:
    int savedError_ = -1;
    int savedOutput_ = -1;
};

// The grid of the first three axes, after ReadImageInformation.
GridGeometry geometryOf(const itk::ImageIOBase& io);

// Reads the file with the given reader, which tells where the volume lies, after its header was inspected.
// `frame` picks a volume of a 4D file.
ReadResult readPlacedByItk(itk::ImageIOBase& io, const std::filesystem::path& path, Inspection&& inspection,
                           std::optional<int> frame);

// The first line of an exception's text without the place in ITK's sources.
std::string shortReason(const std::exception& error);

} // namespace vs::volume
