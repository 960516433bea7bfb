// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/read.h"

namespace vs::volume {

// Whether a path is the address of something on a web server: "http://host/scan.zarr".
bool isWebAddress(const std::filesystem::path& path);
// std::filesystem::absolute(), but for such addresses, which are absolute already.
std::filesystem::path absolutePath(const std::filesystem::path& path);

// Reads NIfTI, NRRD, MetaImage, VTK legacy, a DICOM folder (or any file of it) or a described raw file.
// Headers are inspected before anything is allocated. DICOM slices are placed by their positions; tilted,
// uneven or missing slices are resampled to a regular grid with a notice. Throws ReadError with one line
// naming the file, what is wrong and what would be right; SeveralSeries where a series must be chosen. A
// store may lie on a web server (isWebAddress()).
//
// All of that happens in another process, the decoder, which has little memory and time (decision 0030): a
// file that crashes it, or keeps it busy without end, is refused like any other that is damaged. Whoever
// waits reports progress (base/progress.h); GivenUp ends the decoder.
ReadResult readVolume(const std::filesystem::path& path, const ReadOptions& options = {});

} // namespace vs::volume
