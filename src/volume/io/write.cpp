// SPDX-License-Identifier: Apache-2.0
#include "volume/io/write.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/lines.h"
#include "volume/io/inspect.h"
#include "volume/io/quiet_libraries.h"

#include <fmt/format.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace vs::volume {
namespace {

enum class WrittenFormat { Nifti, Nrrd, Meta, MetaPair };

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view wrong, std::string_view right) {
    throw WriteError("{}: {}; {}", path.string(), wrong, right);
}

// The part of the name that tells the format: ".nii.gz", ".nrrd" ...
std::string formatSuffix(const std::filesystem::path& path) {
    const auto extension = lowerCase(path.extension().string());
    return extension == ".gz" ? lowerCase(path.stem().extension().string()) + extension : extension;
}

WrittenFormat formatOf(const std::filesystem::path& path) {
    const auto suffix = formatSuffix(path);
    if (suffix == ".nii" || suffix == ".nii.gz") {
        return WrittenFormat::Nifti;
    }
    if (suffix == ".nrrd") {
        return WrittenFormat::Nrrd;
    }
    if (suffix == ".mha") {
        return WrittenFormat::Meta;
    }
    if (suffix == ".mhd") {
        return WrittenFormat::MetaPair;
    }
    fail(path, "the extension names no format", "it must be .nii, .nii.gz, .nrrd, .mha or .mhd");
}

template <typename T>
constexpr itk::IOComponentEnum componentOf() {
    return std::is_same_v<T, float>           ? itk::IOComponentEnum::FLOAT
           : std::is_same_v<T, std::uint8_t>  ? itk::IOComponentEnum::UCHAR
           : std::is_same_v<T, std::int8_t>   ? itk::IOComponentEnum::CHAR
           : std::is_same_v<T, std::int16_t>  ? itk::IOComponentEnum::SHORT
           : std::is_same_v<T, std::uint16_t> ? itk::IOComponentEnum::USHORT
           : std::is_same_v<T, std::int32_t>  ? itk::IOComponentEnum::INT
                                              : itk::IOComponentEnum::UINT;
}

void writeWith(itk::ImageIOBase& io, const std::filesystem::path& file, const GridGeometry& geometry,
               itk::IOComponentEnum component, const void* values,
               itk::IOPixelEnum pixel = itk::IOPixelEnum::SCALAR, unsigned components = 1) {
    const QuietLibraries quiet;
    io.SetFileName(file.string());
    io.SetNumberOfDimensions(3);
    io.SetPixelType(pixel);
    io.SetNumberOfComponents(components);
    io.SetComponentType(component);
    const auto spacing = geometry.spacing();
    itk::ImageIORegion region(3);
    for (unsigned axis = 0; axis < 3; ++axis) {
        const glm::dvec3 direction = glm::dvec3(geometry.worldFromVoxel[int(axis)]) / spacing[int(axis)];
        io.SetDimensions(axis, itk::SizeValueType(geometry.dims[int(axis)]));
        io.SetSpacing(axis, spacing[int(axis)]);
        io.SetOrigin(axis, geometry.worldFromVoxel[3][int(axis)]);
        io.SetDirection(axis, std::vector<double>{direction.x, direction.y, direction.z});
        region.SetSize(axis, itk::SizeValueType(geometry.dims[int(axis)]));
    }
    io.SetIORegion(region);
    io.SetUseCompression(true);
    io.WriteImageInformation();
    io.Write(values);
}

void inspectWritten(const std::filesystem::path& file, WrittenFormat format) {
    // ITK does not report a full disk: what was written must pass the checks that reading makes.
    switch (format) {
    case WrittenFormat::Nifti:
        inspectNifti(file);
        return;
    case WrittenFormat::Nrrd:
        inspectNrrd(file);
        return;
    case WrittenFormat::Meta:
    case WrittenFormat::MetaPair:
        inspectMeta(file);
        return;
    }
}

itk::ImageIOBase::Pointer writerOf(WrittenFormat format) {
    switch (format) {
    case WrittenFormat::Nifti:
        return itk::NiftiImageIO::New();
    case WrittenFormat::Nrrd:
        return itk::NrrdImageIO::New();
    case WrittenFormat::Meta:
    case WrittenFormat::MetaPair:
        break;
    }
    return itk::MetaImageIO::New();
}

// What fills a file with a whole volume; its name must have the format's extension.
template <typename T>
void writeWhole(const std::filesystem::path& file, WrittenFormat format, const GridGeometry& geometry,
                std::span<const T> values) {
    const auto io = writerOf(format);
    writeWith(*io, file, geometry, componentOf<T>(), values.data());
    inspectWritten(file, format);
}

// A MetaImage in two files: written with its values inside, then taken apart.
template <typename T>
void writePair(const std::filesystem::path& header, const GridGeometry& geometry, std::span<const T> values) {
    const auto dataName = header.stem().string() + ".zraw"; // its values are compressed
    std::string head;
    const auto splitInto = [&](const std::filesystem::path& data) {
        const Leftover whole(std::filesystem::path(data).replace_extension(".mha"));
        try {
            writeWhole(whole.path(), WrittenFormat::Meta, geometry, values);
        } catch (const std::exception& error) { // before it is removed, and there is room again
            throw std::runtime_error(reasonNotFilled(whole.path(), error.what()));
        }
        std::ifstream input(whole.path(), std::ios::binary);
        const std::string last = "ElementDataFile = ";
        for (std::string line; nextLine(input, line, whole.path()) && !line.starts_with(last);) {
            head += line + "\n";
        }
        head += last + dataName + "\n";
        std::ofstream out(data, std::ios::binary);
        out << input.rdbuf();
        out.close();
        if (!out || !input) {
            throw std::runtime_error(reasonNotFilled(data, "its values could not be copied"));
        }
    };
    const std::array<FileWriting, 2> files{
        {{header.parent_path() / dataName, splitInto},
         {header, [&](const std::filesystem::path& temporary) { writingOf(head)(temporary); }}}};
    writeAllAtomically(files);
}

template <typename T>
void writeTyped(const std::filesystem::path& path, const GridGeometry& geometry, std::span<const T> values) {
    const WrittenFormat format = formatOf(path);
    if (values.size() != geometry.voxelCount() || values.empty()) {
        fail(path, fmt::format("{} values for {} voxels", values.size(), geometry.voxelCount()),
             "a grid has one value for each voxel");
    }
    // NIfTI's quaternion cannot hold axes that are not perpendicular; NRRD and MetaImage hold any.
    if (format == WrittenFormat::Nifti && geometry.isSheared()) {
        fail(path, "NIfTI cannot hold this grid, whose axes are not perpendicular", "write .nrrd or .mha");
    }
    if (format == WrittenFormat::Nifti &&
        std::max({geometry.dims.x, geometry.dims.y, geometry.dims.z}) > 32767) {
        fail(path, "NIfTI holds at most 32767 voxels along an axis", "write .nrrd or .mha");
    }
    if (format == WrittenFormat::MetaPair) {
        writePair(path, geometry, values);
        return;
    }
    writeAtomically(path, [&](const std::filesystem::path& temporary) {
        try {
            writeWhole(temporary, format, geometry, values);
        } catch (const std::exception& failure) {
            throw std::runtime_error(shortReason(failure));
        }
    });
}

} // namespace

void checkGridName(const std::filesystem::path& path) { formatOf(path); }

void writeGrid(const std::filesystem::path& path, const GridGeometry& geometry,
               std::span<const std::uint8_t> values) {
    writeTyped(path, geometry, values);
}

void writeGrid(const std::filesystem::path& path, const GridGeometry& geometry,
               std::span<const std::int16_t> values) {
    writeTyped(path, geometry, values);
}

void writeGrid(const std::filesystem::path& path, const GridGeometry& geometry,
               std::span<const std::uint32_t> values) {
    writeTyped(path, geometry, values);
}

void writeGrid(const std::filesystem::path& path, const GridGeometry& geometry,
               std::span<const float> values) {
    writeTyped(path, geometry, values);
}

void writeColours(const std::filesystem::path& path, const GridGeometry& geometry,
                  std::span<const std::array<std::uint8_t, 4>> colours) {
    if (formatOf(path) != WrittenFormat::Nrrd) {
        fail(path, "colours of voxels are written as NRRD", "write .nrrd");
    }
    writeAtomically(path, [&](const std::filesystem::path& temporary) {
        try {
            const auto io = itk::NrrdImageIO::New();
            writeWith(*io, temporary, geometry, itk::IOComponentEnum::UCHAR, colours.data(),
                      itk::IOPixelEnum::RGBA, 4);
            const QuietLibraries quiet; // ITK does not report a full disk
            std::vector<std::array<std::uint8_t, 4>> written(colours.size());
            const auto reader = itk::NrrdImageIO::New();
            reader->SetFileName(temporary.string());
            reader->ReadImageInformation();
            itk::ImageIORegion region(3);
            for (unsigned axis = 0; axis < 3; ++axis) {
                region.SetSize(axis, reader->GetDimensions(axis));
            }
            reader->SetIORegion(region);
            if (std::size_t(reader->GetImageSizeInBytes()) != colours.size() * 4) {
                throw std::runtime_error("not all of it could be written");
            }
            reader->Read(written.data());
            if (!std::equal(written.begin(), written.end(), colours.begin(), colours.end())) {
                throw std::runtime_error("what was written is not what was given");
            }
        } catch (const std::exception& failure) {
            throw std::runtime_error(shortReason(failure));
        }
    });
}

void writeVolume(const std::filesystem::path& path, const Volume& volume) {
    visit(volume, [&](const auto* values) {
        writeTyped(path, volume.geometry, std::span(values, volume.geometry.voxelCount()));
    });
}

} // namespace vs::volume
