// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/coded_size.h"
#include "volume/dicom/dicom.h"
#include "volume/dicom/dicom_elements.h"
#include "volume/dicom/dicom_text.h"
#include "volume/io/inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace vs::volume {
namespace {

[[noreturn]] void refuseUnsuitable(const std::filesystem::path& path, std::string_view wrong,
                                   std::string_view right) {
    throw UnsuitableImage("{}: {}; {}", path.string(), wrong, right);
}

std::optional<double> number(const DicomDataSet& set, std::uint32_t tag) {
    const auto values = set.numbers(tag);
    return values.empty() ? std::nullopt : std::optional(values[0]);
}

// Functional groups of one frame: its own first, then those that all frames share, then the file's top level.
class FrameAttributes {
public:
    FrameAttributes(const DicomDataSet& file, int frame) : file_(file) {
        for (const auto& [tag, item] :
             {std::pair(0x52009230U, std::size_t(frame)), std::pair(0x52009229U, std::size_t(0))}) {
            const auto* sequence = file.find(tag);
            if (sequence != nullptr && item < sequence->items.size()) {
                groups_.push_back(&sequence->items[item]);
            }
        }
    }

    // `macro` is the functional group's sequence that holds the attribute.
    [[nodiscard]] std::vector<double> get(std::uint32_t macro, std::uint32_t tag) const {
        for (const DicomDataSet* group : groups_) {
            const auto* sequence = group->find(macro);
            if (sequence != nullptr && !sequence->items.empty()) {
                if (auto values = sequence->items.front().numbers(tag); !values.empty()) {
                    return values;
                }
            }
        }
        return file_.numbers(tag);
    }
    // Whether a functional group, not only the top level, speaks of this.
    [[nodiscard]] bool hasOwn(std::uint32_t macro) const {
        return std::any_of(groups_.begin(), groups_.end(),
                           [&](const DicomDataSet* group) { return group->find(macro) != nullptr; });
    }

private:
    const DicomDataSet& file_;
    std::vector<const DicomDataSet*> groups_;
};

void takeOrientation(const std::filesystem::path& path, const std::vector<double>& values,
                     DicomSlice& slice) {
    if (values.size() != 6) {
        return;
    }
    const glm::dvec3 columns(values[0], values[1], values[2]);
    const glm::dvec3 rows(values[3], values[4], values[5]);
    const double lengths = glm::length(columns) * glm::length(rows);
    // Directions are written with few digits; beyond a degree or so they are damaged.
    if (!(std::abs(lengths - 1) < 0.05) || std::abs(glm::dot(columns, rows)) > 0.02) {
        refuse(path, "its image orientation is not two perpendicular directions",
               "correct ImageOrientationPatient");
    }
    slice.alongColumns = glm::normalize(columns);
    slice.alongRows = glm::normalize(rows);
    slice.hasOrientation = true;
}

// CT is in Hounsfield units unless the file states another unit (PS3.3, C.11.1: Rescale Type "US" is none).
std::string unitOf(const DicomDataSet& set) {
    const auto stated = printable(set.text(0x00281054));
    if (set.text(0x00080060) == "CT" && (stated.empty() || stated == "HU")) {
        return "HU";
    }
    return stated == "US" ? "" : stated;
}

// What all frames of a file have in common.
DicomSlice fileAttributes(const std::filesystem::path& path, const DicomDataSet& set, DicomFile& file) {
    DicomSlice slice;
    slice.file = path;
    slice.instanceUid = set.text(0x00080018);
    slice.seriesUid = set.text(0x0020000E);
    slice.description = printable(set.text(0x0008103E));
    slice.details = detailsOf(set);
    slice.size = {set.unsignedShort(0x00280011, 0), set.unsignedShort(0x00280010, 0)};
    slice.photometric = set.text(0x00280004);
    slice.unit = unitOf(set);
    if (slice.size.x < 1 || slice.size.y < 1) {
        refuse(path, fmt::format("its image has {} x {} pixels", slice.size.x, slice.size.y),
               "Rows and Columns must be 1 or more");
    }
    const int samples = set.unsignedShort(0x00280002, 1);
    if (samples != 1 || !slice.photometric.starts_with("MONOCHROME")) {
        refuseUnsuitable(
            path,
            fmt::format("it holds colours ({}, {} samples per pixel)", printable(slice.photometric), samples),
            "one grey value per pixel is needed");
    }
    for (const std::uint32_t tag : {0x00281053, 0x00281052}) {
        if (const auto stated = set.text(tag); !stated.empty() && set.numbers(tag).empty()) {
            refuse(path, fmt::format("its rescale slope or intercept is \"{}\"", printable(stated)),
                   "it must be a number");
        }
    }
    if (number(set, 0x00281053).value_or(1) == 0) {
        refuse(path, "its rescale slope is 0", "it must be another number");
    }
    if (slice.photometric == "MONOCHROME1") {
        file.notices.push_back(
            "its values are meant to be shown inverted (MONOCHROME1); they were left as stored");
    }
    const int bits = set.unsignedShort(0x00280100, 0);
    if (bits != 8 && bits != 16 && bits != 32) {
        refuseUnsuitable(path, fmt::format("it has {} bits per pixel", bits), "8, 16 or 32 are needed");
    }
    // Taken for 0 where they are missing, and values would be of one bit.
    const auto said = [](int n) { return n < 0 ? std::string("missing") : std::to_string(n); };
    const int stored = set.unsignedShort(0x00280101, -1);
    const int high = set.unsignedShort(0x00280102, -1);
    if (stored < 1 || stored > bits || high < stored - 1 || high >= bits) {
        refuse(path, fmt::format("its BitsStored is {} and its HighBit {}", said(stored), said(high)),
               fmt::format("of {} bits, 1 or more are stored, up to the high bit", bits));
    }
    if (set.text(0x00080008).find("MOSAIC") != std::string::npos) {
        refuseUnsuitable(path, "it is a mosaic (all slices side by side in one image)",
                         "export it as single slices or as an enhanced multi-frame image");
    }
    const auto frames = set.text(0x00280008);
    const double count = number(set, 0x00280008).value_or(frames.empty() ? 1 : 0);
    // Slices, and volumes of slices; of images that are hardly any, fewer.
    constexpr int smallPixels = 1024;
    const double mostFrames = std::int64_t(slice.size.x) * slice.size.y < smallPixels ? 65536 : 1e6;
    if (!(count >= 1 && count <= mostFrames) || count != std::floor(count)) {
        refuse(path, fmt::format("NumberOfFrames is \"{}\"", printable(frames)),
               fmt::format("it must be a number of 1 to {}", mostFrames));
    }
    slice.frameCount = int(count);
    (void)checkedBytes(path, {slice.size.x, slice.size.y, slice.frameCount}, std::uint64_t(bits / 8));
    return slice;
}

// Stacks frames that have no positions of their own by the offsets (RT dose) or the spacing that the file
// states.
void stackFrames(const DicomDataSet& set, std::vector<DicomSlice>& slices, DicomFile& file) {
    const auto offsets = set.numbers(0x3004000C);
    const bool hasOffsets = offsets.size() == slices.size();
    const double step = slices[0].sliceSpacing.value_or(1.0);
    const glm::dvec3 first = slices[0].position.value_or(glm::dvec3(0));
    const glm::dvec3 normal = slices[0].normal();
    for (std::size_t i = 0; i < slices.size(); ++i) {
        slices[i].position = first + normal * (hasOffsets ? offsets[i] - offsets[0] : double(i) * step);
    }
    if (!hasOffsets) {
        file.notices.push_back(
            fmt::format("its frames state no positions; they were placed {} mm apart", step));
    }
}

void takeFrames(const std::filesystem::path& path, const DicomDataSet& set, const DicomSlice& common,
                DicomFile& file) {
    constexpr std::uint32_t plane = 0x00209113;
    bool ownPositions = true;
    for (int frame = 0; frame < common.frameCount; ++frame) {
        const FrameAttributes attributes(set, frame);
        DicomSlice slice = common;
        slice.frame = frame;
        ownPositions = ownPositions && attributes.hasOwn(plane);
        if (const auto p = attributes.get(plane, 0x00200032); p.size() == 3) {
            slice.position = glm::dvec3(p[0], p[1], p[2]);
        }
        takeOrientation(path, attributes.get(0x00209116, 0x00200037), slice);
        constexpr std::uint32_t measures = 0x00289110;
        auto spacing = attributes.get(measures, 0x00280030);
        if (spacing.empty()) { // at the detector: the best that projections and scanned film have
            spacing = attributes.get(measures, 0x00181164);
        }
        if (spacing.size() == 2) { // stated as distance between rows, then between columns
            checkSpacing(path, spacing[0]);
            checkSpacing(path, spacing[1]);
            slice.pixelSpacing = glm::dvec2(spacing[1], spacing[0]);
        }
        for (const std::uint32_t tag : {0x00180088, 0x00180050}) {
            if (const auto mm = attributes.get(measures, tag);
                !slice.sliceSpacing && !mm.empty() && mm[0] > 1e-6) {
                slice.sliceSpacing = mm[0];
            }
        }
        constexpr std::uint32_t transform = 0x00289145;
        const auto slope = attributes.get(transform, 0x00281053);
        const auto intercept = attributes.get(transform, 0x00281052);
        slice.scale = {slope.empty() ? 1.0 : slope[0], intercept.empty() ? 0.0 : intercept[0]};
        if (attributes.hasOwn(transform) && slice.scale.x != 0) {
            slice.frameScale = slice.scale;
        }
        if (const auto dose = number(set, 0x3004000E); dose && *dose > 0) { // RT dose: stored values to Gray
            slice.scale = {*dose, 0};
            slice.frameScale = slice.scale;
        }
        file.slices.push_back(slice);
    }
    if (common.frameCount > 1 && !ownPositions) {
        stackFrames(set, file.slices, file);
    }
}

// Bits per value of a JPEG 2000 stream, 0 for other streams.
int jpeg2000Bits(const unsigned char* data, std::size_t size, bool& isSigned) {
    // SIZ follows the start mark of a JPEG 2000 stream; Ssiz is its byte 40 and has the sign in its top bit.
    if (size > 43 && data[0] == 0xFF && data[1] == 0x4F && data[2] == 0xFF && data[3] == 0x51) {
        isSigned = (data[42] & 0x80) != 0;
        return (data[42] & 0x7F) + 1;
    }
    return 0;
}

// Compressed frames hold as many pixels as the header says.
void checkCodedSizes(const std::filesystem::path& path, const std::string& syntax, const DicomElement& pixels,
                     const DicomSlice& common, std::size_t bytesEach) {
    // One piece a frame, as nearly all files have it; else only where the first begins is known.
    const std::size_t known =
        pixels.fragments.size() == std::size_t(common.frameCount) ? pixels.fragments.size() : 1;
    for (std::size_t i = 0; i < known; ++i) {
        const auto frame = pixels.fragments[i];
        if (isJpegSyntax(syntax)) {
            const auto size = codedSize(frame);
            // A stream in pieces need not have its size in the first, and may tell its rows at its end.
            const bool isOther =
                size && (size->x != common.size.x || (size->y != 0 && size->y != common.size.y));
            if (isOther || (!size && known == pixels.fragments.size())) {
                refuse(path,
                       size ? fmt::format("its compressed image has {} x {} pixels, its header says {} x {}",
                                          size->x, size->y, common.size.x, common.size.y)
                            : std::string("its compressed pixels are not what its header says"),
                       "Rows and Columns must be the image's own");
            }
        } else if (isRunLengthSyntax(syntax) && known == pixels.fragments.size() &&
                   !isRunLengthOf(frame, common.size, bytesEach)) {
            refuse(path,
                   fmt::format("its compressed image does not have the {} x {} pixels of its header",
                               common.size.x, common.size.y),
                   "Rows and Columns must be the image's own");
        }
    }
}

// Enough bytes for all pixels; compressed frames complete and of the size and sign that the header states.
void checkPixels(const std::filesystem::path& path, const std::string& syntax, const DicomDataSet& set,
                 const DicomElement& pixels, const DicomSlice& common) {
    if (!pixels.isEncapsulated) {
        const std::uint64_t expected = std::uint64_t(common.size.x) * std::uint64_t(common.size.y) *
                                       std::uint64_t(common.frameCount) *
                                       std::uint64_t(set.unsignedShort(0x00280100, 8) / 8);
        if (pixels.value.size() < expected) {
            refuse(
                path,
                fmt::format("its pixels take {} bytes, but only {} are there", expected, pixels.value.size()),
                "the file is cut short or its sizes are wrong");
        }
        return;
    }
    if (pixels.fragments.size() < std::size_t(common.frameCount)) {
        refuse(path,
               fmt::format("{} compressed pieces for {} frames", pixels.fragments.size(), common.frameCount),
               "the file is cut short");
    }
    checkCodedSizes(path, syntax, pixels, common, std::size_t(set.unsignedShort(0x00280100, 8) / 8));
    const auto first = pixels.fragments.front();
    const auto last = pixels.fragments.back();
    bool isSigned = false;
    if (jpeg2000Bits(first.data(), first.size(), isSigned) > 0 &&
        isSigned != (set.unsignedShort(0x00280103, 0) == 1)) {
        refuse(path,
               fmt::format("its JPEG 2000 stream holds {} values, its header says otherwise",
                           isSigned ? "signed" : "unsigned"),
               "correct PixelRepresentation");
    }
    // The marks that begin and end every kind of JPEG stream; padding may follow.
    const std::string_view tail(reinterpret_cast<const char*>(last.data()), last.size());
    const bool isJpeg = first.size() > 2 && first[0] == 0xFF;
    if (isJpeg && tail.find("\xFF\xD9", tail.size() > 64 ? tail.size() - 64 : 0) == std::string_view::npos) {
        refuse(path, "its compressed pixels have no end", "the file is cut short");
    }
}

} // namespace

DicomFile scanDicomFile(const std::filesystem::path& path) {
    const DicomDocument document(path);
    const DicomDataSet& set = document.root();
    DicomFile file;
    const auto* pixels = set.find(0x7FE00010);
    if (pixels == nullptr) {
        const auto modality = printable(set.text(0x00080060));
        file.reason =
            fmt::format("a DICOM object without an image{}", modality.empty() ? "" : " (" + modality + ")");
        return file;
    }
    if (set.text(0x00080016) == "1.2.840.10008.5.1.4.1.1.66.4") {
        refuseUnsuitable(path, "it is a segmentation, not an image", "open the image that it belongs to");
    }
    const DicomSlice common = fileAttributes(path, set, file);
    checkPixels(path, document.transferSyntax(), set, *pixels, common);
    takeFrames(path, set, common, file);
    for (std::size_t i = 0; i < file.slices.size(); ++i) {
        // By time point, then echo, then acquisition and instance: whichever differs orders slices at one
        // position.
        const double time = number(set, 0x00200100).value_or(0);
        const double echo = number(set, 0x00180086).value_or(0);
        const double acquisition = number(set, 0x00200012).value_or(0);
        const double instance = number(set, 0x00200013).value_or(0);
        file.slices[i].timeOrder =
            ((time * 1e3 + echo) * 1e4 + acquisition) * 1e6 + instance + double(i) * 1e-3;
    }
    return file;
}

} // namespace vs::volume
