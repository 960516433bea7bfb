// SPDX-License-Identifier: Apache-2.0
#include "volume/io/inspect.h"

#include "base/lines.h"

#include <unistd.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace vs::volume {
namespace {

SizeListener& sizeListener() {
    static SizeListener listener;
    return listener;
}

} // namespace

void listenToSizes(SizeListener listener) { sizeListener() = std::move(listener); }

void announcePromised(std::uint64_t bytes) {
    if (sizeListener().promised) {
        sizeListener().promised(bytes);
    }
}

void announceStored(std::uint64_t bytes) {
    if (sizeListener().stored) {
        sizeListener().stored(bytes);
    }
}

void refuse(const std::filesystem::path& path, std::string_view wrong, std::string_view right) {
    throw ReadError("{}: {}; {}", path.string(), wrong, right);
}

std::string printable(std::string_view text) {
    constexpr std::size_t longest = 80;
    std::string result;
    for (const char c : text.substr(0, longest)) {
        result += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '?';
    }
    return text.size() > longest ? result + "..." : result;
}

std::string lowerCase(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result;
}

std::string trimmed(std::string_view text) {
    const std::string_view blanks(" \t\r\n\0", 5);
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) {
        return {};
    }
    return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

bool parseNumber(const std::string& text, double& value) {
    if (text.empty() || text.find_first_of("xX") != std::string::npos) { // no hexadecimal ones
        return false;
    }
    char* end = nullptr;
    value = std::strtod(text.c_str(), &end);
    return end == text.c_str() + text.size();
}

std::vector<double> parseNumbers(const std::filesystem::path& path, std::string_view what,
                                 const std::string& text) {
    std::vector<double> numbers;
    for (const std::string& word : words(text)) {
        double value = 0;
        if (!parseNumber(word, value)) {
            refuse(path, fmt::format("{} holds \"{}\"", what, printable(word)),
                   "it must be a list of numbers");
        }
        numbers.push_back(value);
    }
    return numbers;
}

std::uint64_t checkedBytes(const std::filesystem::path& path, const std::vector<std::int64_t>& sizes,
                           std::uint64_t bytesPerVoxel) {
    const auto pages = sysconf(_SC_PHYS_PAGES);
    const auto memoryPageBytes = sysconf(_SC_PAGE_SIZE);
    const std::uint64_t memory = pages > 0 && memoryPageBytes > 0
                                     ? std::uint64_t(pages) * std::uint64_t(memoryPageBytes)
                                     : std::uint64_t(1) << 40;
    std::uint64_t bytes = bytesPerVoxel;
    for (const auto size : sizes) {
        if (size < 1) {
            refuse(path, fmt::format("size {} along one axis", size), "every axis needs at least one voxel");
        }
        if (size > std::numeric_limits<int>::max() || bytes > memory / std::uint64_t(size)) {
            refuse(path,
                   fmt::format("the header asks for {} voxels, more than this machine's memory",
                               fmt::join(sizes, " x ")),
                   "check the sizes or crop the volume");
        }
        bytes *= std::uint64_t(size);
    }
    announcePromised(bytes);
    return bytes;
}

void checkSpacing(const std::filesystem::path& path, double spacing) {
    // From a micrometre's thousandth to ten metres: beyond lies a unit mistake or garbage.
    if (!std::isfinite(spacing) || spacing < 1e-6 || spacing > 1e4) {
        refuse(path, fmt::format("voxel spacing {}", spacing), "it must be a positive number of millimetres");
    }
}

void checkGeometry(const std::filesystem::path& path, const GridGeometry& geometry) {
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 3; ++r) {
            if (!std::isfinite(geometry.worldFromVoxel[c][r]) ||
                std::abs(geometry.worldFromVoxel[c][r]) > 1e6) {
                refuse(path, "the position or orientation is not finite",
                       "it must be numbers of millimetres");
            }
        }
    }
    const auto spacing = geometry.spacing();
    for (int axis = 0; axis < 3; ++axis) {
        checkSpacing(path, spacing[axis]);
    }
    if (geometry.voxelMm3() < 1e-3 * spacing.x * spacing.y * spacing.z) {
        refuse(path, "the directions of the axes lie in one plane",
               "three independent directions are needed");
    }
}

std::filesystem::path siblingFile(const std::filesystem::path& header, const std::string& name) {
    const std::filesystem::path relative(name);
    const bool leaves = relative.is_absolute() || relative.lexically_normal().string().starts_with("..");
    auto file = header.parent_path() / relative;
    std::error_code error;
    const auto folder =
        std::filesystem::weakly_canonical(header.parent_path().empty() ? "." : header.parent_path(), error);
    const auto target = std::filesystem::weakly_canonical(file, error);
    // A link inside the folder may point out of it just as a name with ".." does.
    if (leaves || name.empty() || target.lexically_relative(folder).string().starts_with("..")) {
        refuse(header, fmt::format("its data file \"{}\" lies outside the folder", printable(name)),
               "the data file must lie beside the header or below it");
    }
    if (!std::filesystem::is_regular_file(file, error)) {
        refuse(header, fmt::format("its data file \"{}\" is missing", printable(name)),
               "put it beside the header or correct the name");
    }
    announceStored(std::filesystem::file_size(file));
    return file;
}

int chosenFrame(const std::filesystem::path& path, std::int64_t frames, std::optional<int> frame) {
    if (frames > 1 && !frame) {
        refuse(path, fmt::format("it holds {} volumes (4D)", frames),
               fmt::format("choose one with --frame 0 to --frame {}", frames - 1));
    }
    if (frame && (*frame < 0 || *frame >= frames)) {
        refuse(path, fmt::format("it has no volume {}", *frame),
               frames > 1 ? fmt::format("choose one with --frame 0 to --frame {}", frames - 1)
                          : std::string("it holds one volume: leave out --frame"));
    }
    return frame.value_or(0);
}

int chosenChannel(const std::filesystem::path& path, int channels, std::optional<int> channel,
                  const std::string& names) {
    if (channel ? *channel >= 0 && *channel < channels : channels == 1) {
        return channel.value_or(0);
    }
    refuse(path,
           channel ? fmt::format("it has no channel {}", *channel)
                   : fmt::format("it has {} channels", channels),
           channels == 1 ? std::string("leave out --channel")
                         : fmt::format("choose one of 0 to {} with --channel{}", channels - 1, names));
}

std::vector<unsigned char> readPrefix(const std::filesystem::path& path, std::size_t count) {
    std::ifstream input(path, std::ios::binary);
    std::vector<unsigned char> prefix(count);
    input.read(reinterpret_cast<char*>(prefix.data()), static_cast<std::streamsize>(count));
    prefix.resize(static_cast<std::size_t>(input.gcount()));
    return prefix;
}

bool hasGzipMagic(const std::filesystem::path& path) {
    const auto start = readPrefix(path, 2);
    return start.size() == 2 && start[0] == 0x1f && start[1] == 0x8b;
}

} // namespace vs::volume
