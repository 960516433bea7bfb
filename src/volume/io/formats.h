// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/read.h"

// The readers behind readVolume. Internal to this folder. Each throws ReadError; none computes the range.
namespace vs::volume {

ReadResult readRaw(const std::filesystem::path& path, const RawLayout& layout);
ReadResult readNifti(const std::filesystem::path& path, const ReadOptions& options);
// `path` is a folder or one of its files.
ReadResult readDicom(const std::filesystem::path& path, const ReadOptions& options);

} // namespace vs::volume
