// SPDX-License-Identifier: Apache-2.0
#include "load_with_itk.h"

#include "base/error.h"
#include "base/timer.h"

#include <itkGDCMImageIO.h>
#include <itkGDCMSeriesFileNames.h>
#include <itkImageFileReader.h>
#include <itkImageSeriesReader.h>
#include <itkMetaImageIOFactory.h>
#include <itkNiftiImageIOFactory.h>
#include <itkNrrdImageIOFactory.h>
#include <itkVTKImageIOFactory.h>

#include <cstdint>
#include <filesystem>

namespace vs {

namespace {

template <typename Reader>
std::size_t voxelsOf(const Reader& reader) {
    reader->Update();
    return reader->GetOutput()->GetLargestPossibleRegion().GetNumberOfPixels();
}

template <typename T>
std::size_t readFile(const std::string& path) {
    const auto reader = itk::ImageFileReader<itk::Image<T, 3>>::New();
    reader->SetFileName(path);
    return voxelsOf(reader);
}

// What ITK takes to find out what a file holds counts too.
std::size_t readByType(const std::string& path) {
    const auto io =
        itk::ImageIOFactory::CreateImageIO(path.c_str(), itk::ImageIOFactory::IOFileModeEnum::ReadMode);
    if (io.IsNull()) {
        throw Error("{}: ITK does not know what it is", path);
    }
    io->SetFileName(path);
    io->ReadImageInformation();
    switch (io->GetComponentType()) {
    case itk::IOComponentEnum::UCHAR:
        return readFile<std::uint8_t>(path);
    case itk::IOComponentEnum::CHAR:
        return readFile<std::int8_t>(path);
    case itk::IOComponentEnum::USHORT:
        return readFile<std::uint16_t>(path);
    case itk::IOComponentEnum::SHORT:
        return readFile<std::int16_t>(path);
    case itk::IOComponentEnum::INT:
        return readFile<std::int32_t>(path);
    case itk::IOComponentEnum::UINT:
        return readFile<std::uint32_t>(path);
    default:
        return readFile<float>(path);
    }
}

std::size_t readSeries(const std::string& folder) {
    const auto names = itk::GDCMSeriesFileNames::New();
    names->SetDirectory(folder);
    if (names->GetSeriesUIDs().empty()) {
        throw Error("{}: ITK finds no DICOM series in it", folder);
    }
    const auto reader = itk::ImageSeriesReader<itk::Image<std::int16_t, 3>>::New();
    reader->SetImageIO(itk::GDCMImageIO::New());
    reader->SetFileNames(names->GetFileNames(names->GetSeriesUIDs().front()));
    return voxelsOf(reader);
}

} // namespace

ItkLoad loadWithItk(const std::string& path) {
    [[maybe_unused]] static const bool knowsFormats = [] {
        itk::NiftiImageIOFactory::RegisterOneFactory();
        itk::NrrdImageIOFactory::RegisterOneFactory();
        itk::MetaImageIOFactory::RegisterOneFactory();
        itk::VTKImageIOFactory::RegisterOneFactory();
        return true;
    }();
    const Timer timer;
    const std::size_t voxels = std::filesystem::is_directory(path) ? readSeries(path) : readByType(path);
    return {timer.milliseconds(), voxels};
}

} // namespace vs
