// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace vs {

struct ItkLoad {
    double milliseconds = 0;
    std::size_t voxels = 0;
};

// Reads a file with itk::ImageFileReader, in the type that its values have, or a folder's first DICOM series,
// sorted by itk::GDCMSeriesFileNames, with itk::ImageSeriesReader. Throws itk::ExceptionObject.
ItkLoad loadWithItk(const std::string& path);

} // namespace vs
