// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/read.h"

namespace vs::volume {

// Reads a volume in this process, with the libraries that decode it; for the decoder (apps/decoder) and for
// tests. A damaged file can end the process, or keep it busy without end: all others call readVolume()
// (volume/reading/read_volume.h), which says what is read and thrown.
ReadResult decodeVolume(const std::filesystem::path& path, const ReadOptions& options = {});

} // namespace vs::volume
