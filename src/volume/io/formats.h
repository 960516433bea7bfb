// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/read.h"

// The formats that volumes are read from, and their readers behind decodeVolume(). Internal to this folder.
namespace vs::volume {

enum class Format { Dicom, Nifti, Nrrd, Meta, Vtk, Tiff, Raw };

// By content where the content says so, else by the extension, so that a damaged file is judged as what it
// claims to be. Raw: neither says anything.
Format recognise(const std::filesystem::path& path);

// Each throws ReadError; none computes the range.
ReadResult readRaw(const std::filesystem::path& path, const RawLayout& layout,
                   const std::optional<Slices>& slices = {});
// `path` is a folder or one of its files.
ReadResult readDicom(const std::filesystem::path& path, const ReadOptions& options);
// One level of a store of OME-Zarr 0.4: `level` of the options, the finest without; `channel`, and `frame` of
// time, where there are several.
ReadResult readStore(const std::filesystem::path& path, const ReadOptions& options);

// A stack of pictures in TIFF or BigTIFF: the pages of a file, or the files of a folder in the order of their
// numbers; `slices` of the options, all of them without; `channel` and `frame` where ImageJ or OME say that
// there are several.
ReadResult readTiff(const std::filesystem::path& path, const ReadOptions& options);

// By its extension.
bool isTiffName(const std::filesystem::path& path);
// Whether a folder holds such pictures, and little else.
bool isTiffFolder(const std::filesystem::path& path);

// Whether a folder is a store of Zarr: whatever else is wrong with it, it is to be read as one.
bool isStore(const std::filesystem::path& path);

} // namespace vs::volume
