// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/dicom.h"

#include "base/progress.h"
#include "volume/dicom/dicom_decode.h"
#include "volume/dicom/dicom_segmentation.h"
#include "volume/io/formats.h"
#include "volume/io/inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vs::volume {
namespace {

// What one folder (or one file's series in it) holds.
struct Scan {
    std::vector<DicomSlice> slices;
    std::vector<std::string> skipped; // names of files without an image for us
    std::vector<std::string> notices;
    std::optional<UnsuitableImage> unsuitable;
};

std::vector<std::filesystem::path> filesOf(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it->is_regular_file(error)) {
            files.push_back(it->path());
        }
    }
    if (error) {
        refuse(folder, "the folder cannot be listed", "check its permissions");
    }
    std::sort(files.begin(), files.end());
    return files;
}

void addFile(Scan& scan, const std::filesystem::path& file) {
    try {
        DicomFile found = scanDicomFile(file);
        if (found.slices.empty()) {
            scan.skipped.push_back(file.filename().string());
        }
        std::move(found.slices.begin(), found.slices.end(), std::back_inserter(scan.slices));
        for (auto& notice : found.notices) {
            scan.notices.push_back(fmt::format("{}: {}", file.string(), notice));
        }
    } catch (const UnsuitableImage& error) {
        scan.skipped.push_back(file.filename().string());
        if (!scan.unsuitable) {
            scan.unsuitable = error;
        }
    }
}

Scan scanFolder(const std::filesystem::path& folder) {
    Scan scan;
    for (const auto& file : filesOf(folder)) {
        reportProgress();
        if (hasDicomMark(file)) {
            addFile(scan, file);
        } else {
            scan.skipped.push_back(file.filename().string());
        }
    }
    if (scan.slices.empty()) {
        if (scan.unsuitable) {
            throw *scan.unsuitable;
        }
        refuse(folder, "no DICOM images lie in this folder",
               "open the folder that holds the slices, not one above");
    }
    if (!scan.skipped.empty()) {
        constexpr std::size_t most = 5;
        const auto shown = std::min(scan.skipped.size(), most);
        scan.notices.push_back(
            fmt::format("{}: {} {} without a usable image skipped ({}{})", folder.string(),
                        scan.skipped.size(), scan.skipped.size() == 1 ? "file" : "files",
                        printable(fmt::format(
                            "{}", fmt::join(scan.skipped.begin(), scan.skipped.begin() + long(shown), ", "))),
                        scan.skipped.size() > most ? " ..." : ""));
    }
    return scan;
}

// Leaves out other files that are copies of the given one (re-encoded, for example): it was asked for by
// name.
void dropCopies(Scan& scan, const std::filesystem::path& file) {
    std::vector<DicomSlice> own;
    std::copy_if(scan.slices.begin(), scan.slices.end(), std::back_inserter(own),
                 [&](const DicomSlice& slice) { return slice.file == file; });
    const auto dropped = std::erase_if(scan.slices, [&](const DicomSlice& slice) {
        return slice.file != file && std::any_of(own.begin(), own.end(), [&](const DicomSlice& mine) {
                   return !mine.instanceUid.empty() && mine.instanceUid == slice.instanceUid &&
                          mine.frame == slice.frame && mine.position == slice.position;
               });
    });
    if (dropped > 0) {
        scan.notices.push_back(
            fmt::format("{}: {} images in other files with the same identifier and position were "
                        "left out",
                        file.string(), dropped));
    }
}

// The file and what lies beside it that names the same series.
Scan scanAround(const std::filesystem::path& file) {
    if (!hasDicomMark(file)) {
        refuse(file, "it is no DICOM file", "a DICOM file has the letters DICM at byte 128");
    }
    DicomFile own = scanDicomFile(file);
    if (own.slices.empty()) {
        refuse(file, fmt::format("it is {}", own.reason), "open a file with an image");
    }
    Scan scan;
    const auto uid = own.slices.front().seriesUid;
    const auto folder = file.parent_path().empty() ? std::filesystem::path(".") : file.parent_path();
    for (const auto& other : filesOf(folder)) {
        std::error_code error;
        if (std::filesystem::equivalent(other, file, error)) {
            addFile(scan, file);
            continue;
        }
        // Without an identifier nothing tells what belongs together; and a neighbour of another series, be it
        // damaged or not, is of no concern. The identifier stands in the first megabyte of any sane header.
        if (uid.empty() || !hasDicomMark(other)) {
            continue;
        }
        const auto start = readPrefix(other, 1 << 20);
        if (std::string_view(reinterpret_cast<const char*>(start.data()), start.size()).find(uid) !=
            std::string_view::npos) {
            addFile(scan, other);
        }
    }
    dropCopies(scan, file);
    return scan;
}

std::vector<SeriesChoice> choicesOf(const std::vector<DicomGroup>& groups) {
    std::vector<SeriesChoice> choices;
    for (const DicomGroup& group : groups) {
        const auto& first = group.slices.front();
        choices.push_back({printable(first.seriesUid), first.description, first.details.modality, first.size,
                           first.pixelSpacing, first.sliceSpacing, int(group.slices.size())});
    }
    return choices;
}

std::string listChoices(const std::vector<DicomGroup>& groups) {
    constexpr std::size_t most = 20;
    std::vector<std::string> lines;
    for (const SeriesChoice& choice : choicesOf(groups)) {
        if (lines.size() < most) {
            lines.push_back(fmt::format("{}: {} \"{}\" {} {}x{}, {} slices", lines.size() + 1, choice.uid,
                                        choice.description, choice.modality, choice.size.x, choice.size.y,
                                        choice.images));
        }
    }
    return fmt::format("{}{}", fmt::join(lines, ", "), groups.size() > most ? " ..." : "");
}

DicomGroup chooseGroup(const std::filesystem::path& path, std::vector<DicomGroup>&& groups,
                       const std::optional<std::string>& series) {
    if (!series) {
        if (groups.size() > 1) {
            const bool oneUid = std::all_of(groups.begin(), groups.end(), [&](const auto& group) {
                return group.uid() == groups[0].uid();
            });
            throw SeveralSeries(fmt::format("{}: {} ({}); choose one with --series NUMBER or --series UID",
                                            path.string(),
                                            oneUid ? "its slices differ in size, spacing or orientation"
                                                   : "it holds several series",
                                            listChoices(groups)),
                                choicesOf(groups));
        }
        return std::move(groups.front());
    }
    std::vector<std::size_t> matches;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (*series == std::to_string(i + 1) || *series == groups[i].uid()) {
            matches.push_back(i);
        }
    }
    if (matches.size() != 1) {
        refuse(path,
               fmt::format("{} series match \"{}\" ({})", matches.empty() ? "no" : "several",
                           printable(*series), listChoices(groups)),
               "choose one with --series NUMBER");
    }
    return std::move(groups[matches[0]]);
}

// Sorted along the normal, one slice per position. Several per position are a 4D series: `frame` picks.
std::vector<DicomSlice> sortSlices(const std::filesystem::path& path, std::vector<DicomSlice> slices,
                                   std::optional<int> frame) {
    if (slices.size() > 1) {
        for (const auto& slice : slices) {
            if (!slice.position || !slice.hasOrientation || !std::isfinite(slice.offset())) {
                refuse(path,
                       fmt::format("{} states no position or orientation", slice.file.filename().string()),
                       "every slice of a series must say where it lies");
            }
        }
    }
    const glm::dvec3 normal = slices.front().normal();
    const auto offset = [&](const DicomSlice& s) { return s.position ? glm::dot(*s.position, normal) : 0.0; };
    std::stable_sort(slices.begin(), slices.end(),
                     [&](const auto& a, const auto& b) { return offset(a) < offset(b); });
    constexpr double samePosition = 0.005; // mm
    std::vector<std::vector<DicomSlice>> places;
    for (auto& slice : slices) {
        if (places.empty() || offset(slice) - offset(places.back().front()) > samePosition) {
            places.emplace_back();
        }
        places.back().push_back(std::move(slice));
    }
    const std::size_t volumes = places.front().size();
    for (const auto& place : places) {
        if (place.size() != volumes) {
            const auto& pair = place.size() > 1 ? place : places.front();
            refuse(path,
                   fmt::format("{} and {} lie at the same position", pair[0].file.filename().string(),
                               pair[1].file.filename().string()),
                   "every position must hold one slice, or all equally many (4D)");
        }
    }
    if ((volumes > 1 && !frame) || (frame && (*frame < 0 || *frame >= int(volumes)))) {
        refuse(path,
               fmt::format("it holds {} at each of {} positions",
                           volumes == 1 ? "one slice" : fmt::format("{} slices (4D)", volumes),
                           places.size()),
               volumes == 1 ? std::string("leave out --frame")
                            : fmt::format("choose one volume with --frame 0 to --frame {}", volumes - 1));
    }
    std::vector<DicomSlice> result;
    for (auto& place : places) {
        std::stable_sort(place.begin(), place.end(),
                         [](const auto& a, const auto& b) { return a.timeOrder < b.timeOrder; });
        result.push_back(std::move(place[std::size_t(frame.value_or(0))]));
        result.back().details.frame = frame.value_or(0);
        result.back().details.frames = int(volumes);
    }
    return result;
}

void noteOddities(const std::filesystem::path& path, const std::vector<DicomSlice>& slices,
                  std::vector<std::string>& notices) {
    const auto& first = slices.front();
    if (!first.position || !first.hasOrientation) {
        notices.push_back(
            fmt::format("{}: the image states no position or orientation; left, right, front and back "
                        "are unknown",
                        path.string()));
    }
    if (!first.pixelSpacing) {
        notices.push_back(
            fmt::format("{}: the image states no pixel spacing; 1 mm was assumed", path.string()));
    }
    if (slices.size() == 1) {
        notices.push_back(fmt::format("{}: it holds a single slice", path.string()));
    }
    if (std::any_of(slices.begin(), slices.end(), [&](const auto& s) { return s.scale != first.scale; })) {
        notices.push_back(
            fmt::format("{}: slices differ in rescale slope or intercept; each was honoured", path.string()));
    }
}

// What is to be assembled, sorted along the normal.
std::vector<DicomSlice> chosenSlices(const std::filesystem::path& path, const ReadOptions& options,
                                     std::vector<std::string>& notices) {
    const bool folder = std::filesystem::is_directory(path);
    Scan scan = folder ? scanFolder(path) : scanAround(path);
    notices = std::move(scan.notices);
    auto groups = groupSlices(std::move(scan.slices));
    if (!folder) { // the part of the series that the file belongs to
        std::erase_if(groups, [&](const DicomGroup& group) {
            return std::none_of(group.slices.begin(), group.slices.end(),
                                [&](const DicomSlice& slice) { return slice.file == path; });
        });
    }
    return sortSlices(path, chooseGroup(path, std::move(groups), options.series).slices, options.frame);
}

} // namespace

ReadResult readDicom(const std::filesystem::path& path, const ReadOptions& options) {
    ReadResult result;
    const auto slices = chosenSlices(path, options, result.notices);
    const auto& first = slices.front();

    SliceStack stack;
    stack.alongColumns = first.alongColumns;
    // Exactly perpendicular, so that the grid is not sheared by rounded directions.
    stack.alongRows = glm::cross(first.normal(), first.alongColumns);
    stack.pixelSpacing = first.pixelSpacing.value_or(glm::dvec2(1));
    stack.sliceSpacing = first.sliceSpacing.value_or(std::min(stack.pixelSpacing.x, stack.pixelSpacing.y));
    for (const auto& slice : slices) {
        stack.positions.push_back(slice.position.value_or(glm::dvec3(0)));
    }
    noteOddities(path, slices, result.notices);
    stack.volume = decodeSlices(path, slices);
    makeRegular(path, stack, result.notices);
    result.volume = std::move(stack.volume);
    result.volume.unit = first.unit;
    ScanDetails details = first.details;
    details.slope = first.scale.x;
    details.intercept = first.scale.y;
    details.interpolated = std::move(result.volume.details.interpolated);
    result.volume.details = std::move(details);
    return result;
}

std::vector<std::filesystem::path> dicomFilesOf(const std::filesystem::path& path,
                                                const ReadOptions& options) {
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::is_directory(path) && !hasDicomMark(path)) {
        return files;
    }
    std::vector<std::string> notices; // heard when it was read
    for (const DicomSlice& slice : chosenSlices(path, options, notices)) {
        if (files.empty() || files.back() != slice.file) { // several frames lie in one file
            files.push_back(slice.file);
        }
    }
    return files;
}

} // namespace vs::volume
