// SPDX-License-Identifier: Apache-2.0
#include "volume/io/decode.h"

#include "volume/io/formats.h"
#include "volume/io/inspect.h"
#include "volume/io/itk_decode.h"
#include "volume/io/quiet_libraries.h"
#include "volume/io/take_values.h"

#include <fmt/format.h>
#include <itkMetaImageIO.h>
#include <itkNrrdImageIO.h>

#include <fstream>
#include <initializer_list>
#include <utility>

namespace vs::volume {
namespace {

[[noreturn]] void refuseRaw(const std::filesystem::path& path) {
    const auto extension = lowerCase(path.extension().string());
    if (extension == ".img") {
        refuse(path, "it is the data half of a pair", "open the .hdr file beside it");
    }
    if (extension == ".raw" || extension == ".bin") {
        refuse(path, "a raw file has no header",
               "describe it with --raw, for example --raw 256x256x128:uint8:1,1,2");
    }
    refuse(path, "it is no volume of a known format",
           "NIfTI (.nii, .nii.gz), NRRD, MetaImage, VTK legacy, DICOM, TIFF, OME-Zarr or a raw file with "
           "--raw can be opened");
}

template <typename ImageIo>
ReadResult decode(const char* format, const std::filesystem::path& path, Inspection inspection,
                  const ReadOptions& options) {
    ReadResult result = readPlacedByItk(*ImageIo::New(), path, std::move(inspection), options.frame);
    result.volume.details.format = format;
    return result;
}

ReadResult readNifti(const std::filesystem::path& path, const ReadOptions& options) {
    NiftiInspection inspection = inspectNifti(path, Inflated::Kept);
    const Scaling scaling{inspection.slope, inspection.intercept};
    return readPlaced("NIfTI", path, std::move(inspection), options.frame, scaling);
}

// What was chosen that means nothing for this kind of thing.
void refuseOptions(const std::filesystem::path& path, std::string_view kind,
                   std::initializer_list<std::pair<const char*, bool>> options) {
    for (const auto& [name, isGiven] : options) {
        if (isGiven) {
            refuse(path, fmt::format("it is {}", kind), fmt::format("leave out {}", name));
        }
    }
}

ReadResult readFormat(const std::filesystem::path& path, const ReadOptions& options) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        refuse(path, "there is no such file or folder", "check the name");
    }
    if (std::filesystem::is_directory(status)) {
        if (options.raw) {
            refuse(path, "it is a folder", "--raw describes one file");
        }
        if (isStore(path)) {
            refuseOptions(path, "a store of OME-Zarr", {{"--series", options.series.has_value()}});
            return readStore(path, options);
        }
        if (isTiffFolder(path)) {
            refuseOptions(path, "a stack of pictures",
                          {{"--series", options.series.has_value()}, {"--level", options.level.has_value()}});
            return readTiff(path, options);
        }
        refuseOptions(path, "a folder of DICOM files",
                      {{"--level", options.level.has_value()}, {"--channel", options.channel.has_value()}});
        return readDicom(path, options);
    }
    if (!std::filesystem::is_regular_file(status)) {
        refuse(path, "it is neither a file nor a folder", "give a volume file or a DICOM folder");
    }
    if (!std::ifstream(path).good()) {
        refuse(path, "it cannot be opened", "check its permissions");
    }
    const Format format = options.raw ? Format::Raw : recognise(path);
    refuseOptions(path, "one file", {{"--level", options.level.has_value()}});
    if (format != Format::Tiff) {
        refuseOptions(path, "no stack of pictures", {{"--channel", options.channel.has_value()}});
    }
    if (options.raw) {
        return readRaw(path, *options.raw, options.slices);
    }
    if (std::filesystem::file_size(path) == 0) {
        refuse(path, "it is empty", "get a complete copy of the file");
    }
    if (options.series && format != Format::Dicom) {
        refuse(path, "it holds no DICOM series", "leave out --series");
    }
    switch (format) {
    case Format::Nifti:
        return readNifti(path, options);
    case Format::Nrrd:
        return decode<itk::NrrdImageIO>("NRRD", path, inspectNrrd(path, Inflated::Kept), options);
    case Format::Meta:
        return decode<itk::MetaImageIO>("MetaImage", path, inspectMeta(path, Inflated::Kept), options);
    case Format::Vtk:
        return readPlaced("VTK", path, inspectVtk(path), options.frame);
    case Format::Dicom:
        return readDicom(path, options);
    case Format::Tiff:
        return readTiff(path, options);
    case Format::Raw:
        break;
    }
    refuseRaw(path);
}

} // namespace

ReadResult decodeVolume(const std::filesystem::path& path, const ReadOptions& options) {
    try {
        ReadResult result = readFormat(path, options);
        Volume& volume = result.volume;
        checkGeometry(path, volume.geometry);
        volume.path = path;
        const auto normal = path.lexically_normal();
        volume.name = (normal.has_filename() ? normal.filename() : normal.parent_path().filename()).string();
        computeRange(volume);
        if (result.ofFinest) {
            const bool areAllUsual = volume.usual == volume.range;
            volume.range = {std::min(volume.range.lo, result.ofFinest->lo),
                            std::max(volume.range.hi, result.ofFinest->hi)};
            volume.usual = areAllUsual ? volume.range : volume.usual;
        }
        if (volume.nonFiniteCount > 0) {
            result.notices.push_back(
                fmt::format("{}: {} of {} voxels are not finite (NaN or infinite); they lie "
                            "outside every range",
                            path.string(), volume.nonFiniteCount, volume.geometry.voxelCount()));
        }
        return result;
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        refuse(path, "it does not fit into memory", "crop it or use a machine with more");
    } catch (const std::exception& error) {
        refuse(path, fmt::format("it cannot be read ({})", shortReason(error)), "check the file");
    }
}

} // namespace vs::volume
