// SPDX-License-Identifier: Apache-2.0
#include "volume/io/write.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "volume/io/inspect.h"
#include "volume/io/itk_decode.h"

#include <fmt/format.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

namespace vs::volume {
namespace {

enum class WrittenFormat { Nifti, Nrrd, Meta, MetaPair };

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view wrong, std::string_view right) {
    throw WriteError("{}: {}; {}", path.string(), wrong, right);
}

// The part of the name that tells ITK the format: ".nii.gz", ".nrrd" ...
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

void syncFile(const std::filesystem::path& path, int flags) {
    const int file = open(path.c_str(), flags | O_CLOEXEC);
    const bool synced = file >= 0 && fsync(file) == 0;
    if (file >= 0) {
        close(file);
    }
    if (!synced) {
        throw std::runtime_error("it cannot be synced to disk");
    }
}

// A file beside the target that is gone unless it was renamed.
class TemporaryFile {
public:
    TemporaryFile(const std::filesystem::path& target, const std::string& suffix)
        : path_(target.parent_path() / fmt::format(".{}.{}{}", target.stem().string(), getpid(), suffix)) {}
    ~TemporaryFile() {
        std::error_code error;
        std::filesystem::remove(path_, error);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    void renameTo(const std::filesystem::path& target) const {
        syncFile(path_, O_RDONLY);
        std::filesystem::rename(path_, target);
        // The new name itself must reach the disk too.
        syncFile(target.parent_path().empty() ? "." : target.parent_path(), O_RDONLY | O_DIRECTORY);
    }

private:
    std::filesystem::path path_;
};

// NIfTI's quaternion cannot hold axes that are not perpendicular; NRRD and MetaImage hold any.
bool isSheared(const GridGeometry& geometry) {
    constexpr double tolerance = 1e-3; // cosine; half a voxel over 500, and beyond what float headers round
    const auto m = glm::dmat3(geometry.worldFromVoxel);
    const auto cosine = [](glm::dvec3 a, glm::dvec3 b) {
        return std::abs(glm::dot(glm::normalize(a), glm::normalize(b)));
    };
    return std::max({cosine(m[0], m[1]), cosine(m[1], m[2]), cosine(m[2], m[0])}) > tolerance;
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
               itk::IOComponentEnum component, const void* values) {
    const QuietLibraries quiet;
    io.SetFileName(file.string());
    io.SetNumberOfDimensions(3);
    io.SetPixelType(itk::IOPixelEnum::SCALAR);
    io.SetNumberOfComponents(1);
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

// Splits a MetaImage with its values inside into header and data file. The data get their name first, so that
// the header never names what is not there.
void publishPair(const TemporaryFile& whole, const std::filesystem::path& target) {
    std::ifstream input(whole.path(), std::ios::binary);
    std::string header;
    const std::string last = "ElementDataFile = ";
    bool compressed = false;
    for (std::string line; std::getline(input, line);) {
        compressed = compressed || line == "CompressedData = True";
        if (line.starts_with(last)) {
            break;
        }
        header += line + "\n";
    }
    const auto dataName = target.stem().string() + (compressed ? ".zraw" : ".raw");
    const TemporaryFile data(target, ".raw");
    const TemporaryFile head(target, ".head");
    std::ofstream dataOut(data.path(), std::ios::binary);
    std::ofstream headOut(head.path(), std::ios::binary);
    dataOut << input.rdbuf();
    headOut << header << last << dataName << "\n";
    dataOut.close();
    headOut.close();
    if (!dataOut || !headOut || header.empty()) {
        throw std::runtime_error("the disk may be full");
    }
    data.renameTo(target.parent_path() / dataName);
    head.renameTo(target);
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

template <typename T>
void writeTyped(const std::filesystem::path& name, const GridGeometry& geometry, std::span<const T> values) {
    const WrittenFormat format = formatOf(name);
    const std::filesystem::path path = outputFile(name);
    if (values.size() != geometry.voxelCount() || values.empty()) {
        fail(path, fmt::format("{} values for {} voxels", values.size(), geometry.voxelCount()),
             "a grid has one value for each voxel");
    }
    if (format == WrittenFormat::Nifti && isSheared(geometry)) {
        fail(path, "NIfTI cannot hold this grid, whose axes are not perpendicular", "write .nrrd or .mha");
    }
    if (format == WrittenFormat::Nifti &&
        std::max({geometry.dims.x, geometry.dims.y, geometry.dims.z}) > 32767) {
        fail(path, "NIfTI holds at most 32767 voxels along an axis", "write .nrrd or .mha");
    }
    std::error_code error;
    const auto folder = path.parent_path().empty() ? std::filesystem::path(".") : path.parent_path();
    if (!std::filesystem::is_directory(folder, error)) {
        fail(path, "its folder does not exist", "create it or choose another");
    }
    if (access(folder.c_str(), W_OK | X_OK) != 0) {
        fail(path, "it cannot be written there", "check the permissions of the folder");
    }
    try {
        const TemporaryFile file(path, format == WrittenFormat::MetaPair ? ".mha" : formatSuffix(name));
        itk::ImageIOBase::Pointer io;
        if (format == WrittenFormat::Nifti) {
            io = itk::NiftiImageIO::New();
        } else if (format == WrittenFormat::Nrrd) {
            io = itk::NrrdImageIO::New();
        } else {
            io = itk::MetaImageIO::New();
        }
        writeWith(*io, file.path(), geometry, componentOf<T>(), values.data());
        inspectWritten(file.path(), format);
        if (format == WrittenFormat::MetaPair) {
            publishPair(file, path);
        } else {
            file.renameTo(path);
        }
    } catch (const std::exception& failure) {
        fail(path, fmt::format("it could not be written ({})", shortReason(failure)),
             "check the free space and the permissions");
    }
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

void writeVolume(const std::filesystem::path& path, const Volume& volume) {
    visit(volume, [&](const auto* values) {
        writeTyped(path, volume.geometry, std::span(values, volume.geometry.voxelCount()));
    });
}

} // namespace vs::volume
