// SPDX-License-Identifier: Apache-2.0
#include "base/progress.h"
#include "volume/io/formats.h"
#include "volume/io/take_values.h"
#include "volume/tiff/tiff_file.h"
#include "volume/tiff/tiff_metadata.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cctype>

namespace vs::volume {

namespace {

namespace fs = std::filesystem;

// As people number: "slice2" before "slice10".
bool isBefore(const std::string& a, const std::string& b) {
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        if (!isDigit(a[i]) || !isDigit(b[j])) {
            if (a[i] != b[j]) {
                return a[i] < b[j];
            }
            ++i;
            ++j;
            continue;
        }
        const auto endOf = [&](const std::string& text, std::size_t from) {
            while (from < text.size() && isDigit(text[from])) {
                ++from;
            }
            return from;
        };
        const auto withoutZeros = [](std::string_view digits) {
            digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
            return digits;
        };
        const auto endA = endOf(a, i);
        const auto endB = endOf(b, j);
        const auto numberA = withoutZeros(std::string_view(a).substr(i, endA - i));
        const auto numberB = withoutZeros(std::string_view(b).substr(j, endB - j));
        if (numberA != numberB) {
            return numberA.size() != numberB.size() ? numberA.size() < numberB.size() : numberA < numberB;
        }
        i = endA;
        j = endB;
    }
    return a.size() - i < b.size() - j;
}

// The pages of one file, or of a folder's files with one page each.
class Stack {
public:
    explicit Stack(const fs::path& path) : path_(path), files_(filesOf(path)), first_(files_.front()) {
        page_ = first_.page(0);
        metadata_ = readTiffMetadata(first_.description(), first_.resolution(), first_.isPerCentimetre());
        pages_ = files_.size() > 1 ? std::int64_t(files_.size()) : first_.pages();
        if (pages_ == 1 && metadata_.isImageJ && metadata_.images > 1) {
            plainOffset_ = first_.plainOffset(); // stacks of 4 GB and more: one page tells of all
            std::error_code error;
            const auto left = plainOffset_ == 0 ? 0 : fs::file_size(path, error) - plainOffset_;
            if (plainOffset_ == 0 || left / page_.bytes() < std::uint64_t(metadata_.images)) {
                refuse(path, fmt::format("ImageJ wrote {} pictures, and fewer are there", metadata_.images),
                       "get a complete copy of the file");
            }
            pages_ = metadata_.images;
        }
        placePages();
    }

    [[nodiscard]] const TiffPage& page() const { return page_; }
    [[nodiscard]] const TiffMetadata& metadata() const { return metadata_; }
    [[nodiscard]] int slices() const { return int(metadata_.slices); }
    [[nodiscard]] std::vector<std::string>& notices() { return notices_; }

    void read(std::int64_t slice, std::int64_t channel, std::int64_t time, std::span<std::byte> values) {
        const std::int64_t number = metadata_.pageOf(slice, channel, time);
        if (plainOffset_ > 0) {
            first_.readPlain(plainOffset_ + std::uint64_t(number) * page_.bytes(), values);
        } else if (files_.size() > 1) {
            TiffFile file(files_[std::size_t(number)]);
            if (!file.isSinglePage()) {
                refuse(files_[std::size_t(number)], "it has several pages, and is one of several files",
                       "open one file of pages by itself, or a folder of files with one page each");
            }
            expectAlike(files_[std::size_t(number)], file.page(0));
            file.read(0, values);
        } else {
            expectAlike(path_, first_.page(number));
            first_.read(number, values);
        }
    }

private:
    static std::vector<fs::path> filesOf(const fs::path& path) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            return {path};
        }
        std::vector<fs::path> files;
        for (fs::directory_iterator it(path, error), end; !error && it != end; it.increment(error)) {
            std::error_code unknown;
            if (isTiffName(it->path()) && it->is_regular_file(unknown) &&
                !it->path().filename().string().starts_with('.')) {
                files.push_back(it->path());
            }
        }
        std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
            return isBefore(a.filename().string(), b.filename().string());
        });
        return files;
    }

    // Makes what is said of slices, channels and times agree with how many pages there are.
    void placePages() {
        const auto& [slices, channels, times, order, spacing, isImageJ, images] = metadata_;
        const bool isSaid = slices > 0 && slices <= pages_ && channels <= pages_ / slices &&
                            times <= pages_ / slices / channels && slices * channels * times == pages_;
        const bool isOneFileOfMany = files_.size() > 1; // each may tell of all, or of itself
        if (!isSaid) {
            if (isImageJ && !isOneFileOfMany && images > pages_) {
                refuse(path_, fmt::format("ImageJ wrote {} pictures, and {} are there", images, pages_),
                       "get a complete copy of the file");
            }
            if (slices > 0 && !isOneFileOfMany) {
                notices_.push_back(
                    fmt::format("{}: it tells of {} slices, {} channels and {} times, and has {} "
                                "pages; they are taken for slices",
                                path_.string(), slices, channels, times, pages_));
            }
            if (isImageJ && channels * times > 1 && pages_ % (channels * times) == 0) {
                metadata_.slices = pages_ / (channels * times); // it says nothing of a single slice
                return;
            }
            metadata_.slices = pages_;
            metadata_.channels = 1;
            metadata_.times = 1;
        }
    }

    void expectAlike(const fs::path& file, const TiffPage& other) const {
        if (!(other == page_)) {
            refuse(file,
                   fmt::format("a picture of {} x {} is among those of {} x {}, or has other values",
                               other.width, other.height, page_.width, page_.height),
                   "all pictures of a stack must be alike");
        }
    }

    fs::path path_;
    std::vector<fs::path> files_;
    TiffFile first_;
    TiffPage page_;
    TiffMetadata metadata_;
    std::int64_t pages_ = 0;
    std::uint64_t plainOffset_ = 0; // 0: libtiff reads the pages
    std::vector<std::string> notices_;
};

GridGeometry geometryOf(const fs::path& path, Stack& stack, Slices part) {
    glm::dvec3 spacing = stack.metadata().spacingMm;
    if (spacing == glm::dvec3(0)) {
        spacing = glm::dvec3(1);
        stack.notices().push_back(
            fmt::format("{}: how large its voxels are is not said; 1 x 1 x 1 mm is taken", path.string()));
    } else if (spacing.z == 0) {
        spacing.z = spacing.x;
        if (stack.slices() > 1) {
            stack.notices().push_back(
                fmt::format("{}: how far apart its slices are is not said; {:.6g} mm is taken, as far as its "
                            "pixels",
                            path.string(), spacing.z));
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        checkSpacing(path, spacing[axis]);
    }
    auto geometry = makeGeometry({int(stack.page().width), int(stack.page().height), part.count}, spacing);
    geometry.worldFromVoxel[3].z = part.first * spacing.z;
    return geometry;
}

} // namespace

ReadResult readTiff(const fs::path& path, const ReadOptions& options) {
    Stack stack(path);
    const int channel = chosenChannel(path, int(stack.metadata().channels), options.channel, "");
    const int time = chosenFrame(path, stack.metadata().times, options.frame);
    const int last = options.slices ? std::min(options.slices->first + options.slices->count, stack.slices())
                                    : stack.slices();
    const Slices part{options.slices ? options.slices->first : 0,
                      last - (options.slices ? options.slices->first : 0)};
    if (part.first < 0 || part.count < 1) {
        refuse(path, fmt::format("it has no slice {}", part.first), fmt::format("it has {}", stack.slices()));
    }
    const TiffPage page = stack.page();
    const std::uint64_t bytes =
        checkedBytes(path, {page.width, page.height, std::int64_t(part.count)}, bytesOf(page.type));
    ReadResult result;
    std::vector<std::byte> values(bytes);
    for (int slice = 0; slice < part.count; ++slice) {
        reportProgress(double(slice) / part.count);
        stack.read(part.first + slice, channel, time,
                   std::span(values).subspan(std::size_t(slice) * page.bytes(), page.bytes()));
    }
    result.volume.geometry = geometryOf(path, stack, part);
    result.notices = stack.notices();
    if (takeValues(result.volume, page.type, std::move(values))) {
        result.notices.push_back(
            fmt::format("{}: 64-bit values were rounded to 32-bit floats; some changed", path.string()));
    }
    result.volume.details.format = "TIFF";
    result.volume.details.frame = time;
    result.volume.details.frames = int(stack.metadata().times);
    result.volume.details.slices = stack.slices();
    return result;
}

} // namespace vs::volume
