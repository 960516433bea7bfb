// SPDX-License-Identifier: Apache-2.0
#include "volume/io/formats.h"

#include "volume/io/inspect.h"

#include <string_view>

namespace vs::volume {

Format recognise(const std::filesystem::path& path) {
    const auto start = readPrefix(path, 352);
    const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
    const auto mark = [&](std::size_t at, std::string_view expected) {
        return text.size() >= at + expected.size() && text.substr(at, expected.size()) == expected;
    };
    if (mark(0, "NRRD000")) {
        return Format::Nrrd;
    }
    if (mark(128, "DICM")) {
        return Format::Dicom;
    }
    constexpr std::size_t four = 4;
    for (const std::string_view magic : {std::string_view("II*\0", four), std::string_view("MM\0*", four),
                                         std::string_view("II+\0", four), std::string_view("MM\0+", four)}) {
        if (mark(0, magic)) {
            return Format::Tiff;
        }
    }
    if (mark(0, "# vtk DataFile")) {
        return Format::Vtk;
    }
    if (mark(344, "n+1") || mark(344, "ni1")) {
        return Format::Nifti;
    }
    const auto extension = lowerCase(path.extension().string());
    const auto stem = lowerCase(path.stem().extension().string());
    if (extension == ".nii" || extension == ".hdr" ||
        (extension == ".gz" && (stem == ".nii" || stem == ".hdr"))) {
        return Format::Nifti;
    }
    if (extension == ".nrrd" || extension == ".nhdr") {
        return Format::Nrrd;
    }
    if (extension == ".mhd" || extension == ".mha" || mark(0, "ObjectType") || mark(0, "NDims")) {
        return Format::Meta;
    }
    if (extension == ".vtk") {
        return Format::Vtk;
    }
    if (isTiffName(path)) {
        return Format::Tiff;
    }
    if (extension == ".dcm" || extension == ".ima" || extension == ".dicom") {
        return Format::Dicom;
    }
    return Format::Raw;
}

bool isHeaderless(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error) && recognise(path) == Format::Raw;
}

} // namespace vs::volume
