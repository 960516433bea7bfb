// SPDX-License-Identifier: Apache-2.0
// Headers of scans, and the whole way from a scan's file to its values.
#include "target.h"

#include "base/math.h"
#include "volume/dicom/dicom.h"
#include "volume/dicom/dicom_elements.h"
#include "volume/io/decode.h"
#include "volume/io/inspect.h"
#include "volume/reading/decoder_messages.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

namespace vs::fuzz {
namespace {

using namespace volume;

// What headers may name beside themselves, so that they get further than to its being missing.
void putSiblings() {
    static const bool areThere = [] {
        constexpr std::size_t bytes = 4096;
        std::string values(bytes, '\0');
        std::iota(values.begin(), values.end(), '\0');
        for (const char* name : {"values.bin", "values.raw", "scan.img"}) {
            fileWith(name, std::string_view(values));
        }
        return true;
    }();
    require(areThere, "the files beside a header must be there");
}

bool hasAt(Input input, std::size_t at, std::string_view mark) {
    return input.size() >= at + mark.size() && std::equal(mark.begin(), mark.end(), input.begin() + long(at));
}

// The input as a file with the extension that goes with its first bytes, where a reader looks at that.
std::filesystem::path scanWith(Input input, const char* extension) {
    putSiblings();
    const bool isPair = hasAt(input, 344, "ni1");
    return fileWith(hasAt(input, 0, "\x1f\x8b") ? "scan.nii.gz"
                    : isPair                    ? "scan.hdr"
                                                : std::string("scan") + extension,
                    input);
}

void requirePlace(const GridGeometry& geometry) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            require(std::isfinite(geometry.worldFromVoxel[column][row]), "a place must be finite");
        }
    }
    require(geometry.voxelMm3() > 0, "a grid must have some volume");
}

// Sizes that go together with the block of values, which lies in its file, and values that can be read from
// it.
void requireSound(Inspection inspection) {
    std::uint64_t count = 1;
    for (const std::int64_t size : inspection.sizes) {
        require(size >= 1 && size <= std::numeric_limits<int>::max(), "a size of {}", size);
        count *= std::uint64_t(size);
    }
    DataBlock& block = inspection.block;
    require(inspection.sizes.size() == 3 || inspection.sizes.size() == 4, "{} sizes",
            inspection.sizes.size());
    require(block.count == count, "{} values for {} voxels", block.count, count);
    const auto there = std::filesystem::file_size(block.file);
    require(block.offset <= there, "values that begin behind the file's end");
    require(block.encoding != Encoding::Raw || block.bytes() <= there - block.offset,
            "values that are not there");
    for (const std::string& notice : inspection.notices) {
        requireOneLine(notice);
    }
    const std::uint64_t volume =
        count / (inspection.sizes.size() > 3 ? std::uint64_t(inspection.sizes[3]) : 1);
    const auto values = readValues(block, count - volume, volume); // of the last frame
    require(values.size() == volume * bytesOf(block.type), "{} bytes of values", values.size());
}

void nifti(Input input) {
    const auto path = scanWith(input, ".nii");
    const auto found = unlessRefused([&] {
        auto inspection = inspectNifti(path);
        checkGeometry(path, inspection.geometry);
        return inspection;
    });
    if (found) {
        requireSound(*found);
        requirePlace(found->geometry);
        require(std::isfinite(found->slope) && found->slope != 0 && std::isfinite(found->intercept),
                "a scaling");
    }
}

void nrrd(Input input) {
    if (const auto found = unlessRefused([&] { return inspectNrrd(scanWith(input, ".nrrd")); })) {
        requireSound(*found);
    }
}

void meta(Input input) {
    if (const auto found = unlessRefused([&] { return inspectMeta(scanWith(input, ".mha")); })) {
        requireSound(*found);
    }
}

void vtk(Input input) {
    const auto path = scanWith(input, ".vtk");
    const auto found = unlessRefused([&] {
        auto inspection = inspectVtk(path);
        checkGeometry(path, inspection.geometry);
        return inspection;
    });
    if (found) {
        requireSound(*found);
        requirePlace(found->geometry);
    }
}

void dicom(Input input) {
    const auto path = fileWith("slice.dcm", input);
    if (!hasDicomMark(path)) {
        return;
    }
    const auto found = unlessRefused([&] { return scanDicomFile(path); });
    if (!found) {
        return;
    }
    require(!found->slices.empty() || !found->reason.empty(), "a file without slices must have a reason");
    for (const std::string& notice : found->notices) {
        requireOneLine(notice);
    }
    for (const DicomSlice& slice : found->slices) {
        require(slice.size.x >= 1 && slice.size.y >= 1, "a slice of {} x {}", slice.size.x, slice.size.y);
        const glm::dvec3 normal = slice.normal();
        require(std::abs(glm::length(normal) - 1) < 1e-6, "a slice that faces nowhere");
        require(!slice.position || std::isfinite(slice.offset()), "a slice at no place");
        require(!slice.pixelSpacing || (slice.pixelSpacing->x > 0 && slice.pixelSpacing->y > 0),
                "pixels apart");
        require(!slice.sliceSpacing || *slice.sliceSpacing > 0, "slices apart");
        require(std::isfinite(slice.scale.x) && std::isfinite(slice.scale.y), "a scaling");
    }
}

// What goes to the program that asked must arrive there as it was.
void requireSurvivesMessage(const ReadResult& result) {
    const auto message = pack(DecoderAnswer(DecodedVolume{result}));
    require(pack(unpackAnswer(message)) == message, "a volume's message must come back as it was");
}

// Reads a scan whose header may promise more than its file could hold; the decoder's limits are beyond that.
std::optional<ReadResult> decodedWithin(const std::filesystem::path& path, std::uint64_t most) {
    listenToSizes({.promised =
                       [most](std::uint64_t bytes) {
                           if (bytes > most) {
                               throw ReadError("a file: it promises {} bytes; give one that is smaller",
                                               bytes);
                           }
                       },
                   .stored = {}});
    auto found = unlessRefused([&] { return decodeVolume(path); });
    listenToSizes({});
    return found;
}

void requireSoundVolume(std::optional<ReadResult> found) {
    if (!found) {
        return;
    }
    Volume& volume = found->volume;
    const auto dims = volume.geometry.dims;
    require(dims.x >= 1 && dims.y >= 1 && dims.z >= 1, "{} x {} x {} voxels", dims.x, dims.y, dims.z);
    require(volume.bytes.size() == volume.geometry.voxelCount() * sizeOf(volume.type), "{} bytes of voxels",
            volume.bytes.size());
    requirePlace(volume.geometry);
    const bool hasValues = volume.nonFiniteCount < volume.geometry.voxelCount();
    require(!hasValues || volume.range.lo <= volume.range.hi, "values from {} to {}", volume.range.lo,
            volume.range.hi);
    require(!hasValues || (volume.range.lo <= volume.usual.lo && volume.usual.hi <= volume.range.hi),
            "usual values from {} to {}", volume.usual.lo, volume.usual.hi);
    for (const std::string& notice : found->notices) {
        requireOneLine(notice);
    }
    volume.bytes.clear(); // they go another way
    requireSurvivesMessage(*found);
}

constexpr std::uint64_t kMostPromised = std::uint64_t(32) << 20;

void volume(Input input) {
    requireSoundVolume(unlessRefused([&] { return decodeVolume(scanWith(input, "")); }));
}

void tiff(Input input) { requireSoundVolume(decodedWithin(fileWith("scan.tif", input), kMostPromised)); }

// A store of one level: what describes the image, what describes the array, and a chunk, with a zero between.
void store(Input input) {
    const auto folder = fileWith("beside", std::string_view()).parent_path() / "scan.zarr";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "0/0/0");
    const auto put = [&folder](const char* name, Input content) {
        std::ofstream(folder / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(content.data()), std::streamsize(content.size()));
    };
    const auto takePart = [&input] {
        const auto end = std::find(input.begin(), input.end(), 0);
        const auto part = input.first(std::size_t(end - input.begin()));
        input = input.subspan(std::min(part.size() + 1, input.size()));
        return part;
    };
    put(".zattrs", takePart());
    put("0/.zarray", takePart());
    put("0/0/0/0", input);
    put("0/0.0.0", input);
    requireSoundVolume(decodedWithin(folder, kMostPromised));
}

// What describes a file without a header on a command line or in a session.
void layout(Input input) {
    const std::string text(input.begin(), input.end());
    if (const auto found = unlessRefused([&] { return parseRawLayout(text); })) {
        require(found->dims.x >= 1 && found->dims.y >= 1 && found->dims.z >= 1, "a layout without voxels");
        require(found->spacing.x > 0 && found->spacing.y > 0 && found->spacing.z > 0, "voxels at one place");
    }
}

} // namespace

std::vector<Target> scanTargets() {
    return {{"nifti", nifti},   {"nrrd", nrrd},     {"meta", meta}, {"vtk", vtk},    {"dicom", dicom},
            {"volume", volume}, {"layout", layout}, {"tiff", tiff}, {"store", store}};
}

} // namespace vs::fuzz
