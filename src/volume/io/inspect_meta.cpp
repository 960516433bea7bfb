// SPDX-License-Identifier: Apache-2.0
#include "volume/io/inspect.h"

#include "base/lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <string_view>

namespace vs::volume {
namespace {

struct MetaHeader {
    std::map<std::string, std::string> fields; // names in lower case
    std::uint64_t bytes = 0;                   // up to and with the line that names the data file

    [[nodiscard]] std::string get(const std::string& name, const std::string& other = "") const {
        const auto found = fields.find(name);
        return found != fields.end() ? found->second : other;
    }
};

// What decides how a volume is read.
constexpr std::array<std::string_view, 20> kNames{"ObjectType",
                                                  "NDims",
                                                  "DimSize",
                                                  "ElementType",
                                                  "ElementSpacing",
                                                  "ElementSize",
                                                  "ElementNumberOfChannels",
                                                  "ElementByteOrderMSB",
                                                  "BinaryDataByteOrderMSB",
                                                  "BinaryData",
                                                  "CompressedData",
                                                  "CompressedDataSize",
                                                  "HeaderSize",
                                                  "TransformMatrix",
                                                  "Rotation",
                                                  "Orientation",
                                                  "Offset",
                                                  "Position",
                                                  "Origin",
                                                  "ElementDataFile"};

MetaHeader readMetaHeader(const std::filesystem::path& path) {
    constexpr std::streamoff longestHeader = 1 << 20;
    std::ifstream input(path, std::ios::binary);
    MetaHeader header;
    const auto refuseName = [&](const std::string& name, std::string_view wrong, std::string_view right) {
        refuse(path, fmt::format("its header {} \"{}\"", wrong, printable(name)), right);
    };
    for (std::string line; nextLine(input, line, path);) {
        if (trimmed(line).empty()) {
            continue;
        }
        if (line.find('\0') != std::string::npos) {
            refuse(path, "its header holds a zero byte", "a MetaImage header is text");
        }
        const auto equals = line.find('=');
        if (equals == std::string::npos || equals > 64 || input.tellg() > longestHeader) {
            refuse(path, fmt::format("its header holds \"{}\"", printable(line.substr(0, 24))),
                   "a MetaImage header has lines of \"Name = value\" and ends with ElementDataFile");
        }
        const auto written = trimmed(line.substr(0, equals));
        const auto name = lowerCase(written);
        const auto known = std::find_if(kNames.begin(), kNames.end(),
                                        [&](std::string_view one) { return lowerCase(one) == name; });
        // The library that reads the rest of the header knows names in this spelling only.
        if (known != kNames.end() && written != *known) {
            refuseName(written, "says", fmt::format("it is spelled {}", *known));
        }
        if (!header.fields.emplace(name, trimmed(line.substr(equals + 1))).second && known != kNames.end()) {
            refuseName(written, "says twice", "once is enough");
        }
        if (name == "elementdatafile") {
            header.bytes = input.eof() ? std::filesystem::file_size(path) : std::uint64_t(input.tellg());
            return header;
        }
    }
    refuse(path, "its header names no ElementDataFile",
           "it must end with \"ElementDataFile = NAME\" or LOCAL");
}

StoredType storedType(const std::filesystem::path& path, const MetaHeader& header) {
    static const std::map<std::string, StoredType> types{
        {"met_char", StoredType::Int8},       {"met_uchar", StoredType::UInt8},
        {"met_short", StoredType::Int16},     {"met_ushort", StoredType::UInt16},
        {"met_int", StoredType::Int32},       {"met_uint", StoredType::UInt32},
        {"met_long", StoredType::Int32},      {"met_ulong", StoredType::UInt32},
        {"met_long_long", StoredType::Int64}, {"met_ulong_long", StoredType::UInt64},
        {"met_float", StoredType::Float32},   {"met_double", StoredType::Float64}};
    const auto found = types.find(lowerCase(header.get("elementtype")));
    if (found == types.end()) {
        refuse(path, fmt::format("its ElementType is \"{}\"", printable(header.get("elementtype"))),
               "it must be MET_UCHAR, MET_CHAR, MET_USHORT, MET_SHORT, MET_UINT, MET_INT, MET_FLOAT or "
               "MET_DOUBLE");
    }
    if (const auto channels = header.get("elementnumberofchannels", "1"); channels != "1") {
        refuse(path, fmt::format("it has {} channels", printable(channels)),
               "one number per voxel is needed");
    }
    return found->second;
}

std::vector<std::int64_t> readSizes(const std::filesystem::path& path, const MetaHeader& header) {
    const auto dimensions = header.get("ndims");
    std::vector<std::int64_t> sizes;
    for (const double size : parseNumbers(path, "DimSize", header.get("dimsize"))) {
        if (!std::isfinite(size) || size != std::floor(size) || std::abs(size) > 9e15) {
            refuse(path, fmt::format("DimSize holds {}", size), "it must be whole numbers");
        }
        sizes.push_back(std::int64_t(size));
    }
    if ((dimensions != "3" && dimensions != "4") || std::to_string(sizes.size()) != dimensions) {
        refuse(path,
               fmt::format("NDims is \"{}\" and DimSize has {} numbers", printable(dimensions), sizes.size()),
               "a volume has 3 of both, or 4 with --frame");
    }
    return sizes;
}

void checkPlace(const std::filesystem::path& path, const MetaHeader& header, std::size_t dimension) {
    for (const char* field : {"elementspacing", "elementsize"}) {
        if (const auto text = header.get(field); !text.empty()) {
            const auto spacing = parseNumbers(path, "ElementSpacing", text);
            if (spacing.size() != dimension) {
                refuse(path, fmt::format("ElementSpacing has {} numbers", spacing.size()),
                       "there must be one for each dimension");
            }
            for (std::size_t axis = 0; axis < 3; ++axis) {
                checkSpacing(path, spacing[axis]);
            }
        }
    }
    for (const char* field : {"transformmatrix", "rotation", "orientation"}) {
        if (const auto text = header.get(field); !text.empty()) {
            const auto matrix = parseNumbers(path, "TransformMatrix", text);
            if (matrix.size() != dimension * dimension) {
                refuse(path, fmt::format("TransformMatrix has {} numbers", matrix.size()),
                       fmt::format("it must have {}", dimension * dimension));
            }
            GridGeometry geometry;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                for (std::size_t row = 0; row < 3; ++row) {
                    geometry.worldFromVoxel[int(axis)][int(row)] = matrix[axis * dimension + row];
                }
            }
            checkGeometry(path, geometry);
        }
    }
    for (const char* field : {"offset", "position", "origin"}) {
        if (const auto text = header.get(field);
            !text.empty() && parseNumbers(path, "Offset", text).size() != dimension) {
            refuse(path, fmt::format("Offset is \"{}\"", printable(text)),
                   "there must be one number per dimension");
        }
    }
}

// The number of bytes that a field holds.
std::uint64_t bytesIn(const std::filesystem::path& path, const std::string& name, const std::string& text) {
    const auto numbers = parseNumbers(path, name, text);
    if (numbers.size() != 1 || !(numbers[0] >= 0 && numbers[0] < 1e15) ||
        numbers[0] != std::floor(numbers[0])) {
        refuse(path, fmt::format("{} is \"{}\"", name, printable(text)), "it must be a number of bytes");
    }
    return std::uint64_t(numbers[0]);
}

// A field that says yes or no.
bool isTrue(const std::filesystem::path& path, const MetaHeader& header, const std::string& name,
            bool otherwise) {
    const std::string text = header.get(lowerCase(name), otherwise ? "True" : "False");
    const std::string word = lowerCase(text);
    if (word == "true" || word == "t" || word == "1") {
        return true;
    }
    if (word != "false" && word != "f" && word != "0") {
        refuse(path, fmt::format("{} is \"{}\"", name, printable(text)), "it must be True or False");
    }
    return false;
}

// How many bytes compressed values take in the file. Some programs have written large numbers with six
// digits.
std::uint64_t storedBytes(const std::filesystem::path& path, const std::string& text,
                          const DataBlock& block) {
    constexpr std::uint64_t exact = 1'000'000;
    const std::uint64_t stated = bytesIn(path, "CompressedDataSize", text);
    if (stated < exact) {
        return stated;
    }
    const std::uint64_t more = stated + stated / (exact / 10);
    const std::uint64_t there = std::filesystem::file_size(block.file) - block.offset;
    return there >= stated - (more - stated) ? std::min(more, there) : stated;
}

// Moves the block's beginning behind what HeaderSize says is before it in the file.
void skipHeader(const std::filesystem::path& path, const MetaHeader& header, DataBlock& block) {
    const auto text = header.get("headersize", "0");
    if (text == "-1") { // the values are the last bytes of the file
        const auto size = std::filesystem::file_size(block.file);
        const bool isLast = block.encoding == Encoding::Raw && size > block.bytes();
        block.offset = isLast ? size - block.bytes() : block.offset;
        return;
    }
    const std::uint64_t skip = bytesIn(path, "HeaderSize", text);
    if (skip > 0 && (block.encoding != Encoding::Raw || block.file == path)) {
        refuse(path,
               fmt::format("HeaderSize is {} for values {}", skip,
                           block.file == path ? "in the same file" : "that are not plain bytes"),
               "it is for files of plain bytes beside the header");
    }
    block.offset += skip;
}

} // namespace

Inspection inspectMeta(const std::filesystem::path& path, Inflated inflated) {
    const MetaHeader header = readMetaHeader(path);
    if (lowerCase(header.get("objecttype", "image")) != "image") {
        refuse(path, fmt::format("its ObjectType is \"{}\"", printable(header.get("objecttype"))),
               "it must be Image");
    }
    Inspection inspection;
    inspection.sizes = readSizes(path, header);
    const StoredType type = storedType(path, header);
    const std::uint64_t bytes = checkedBytes(path, inspection.sizes, bytesOf(type));
    checkPlace(path, header, inspection.sizes.size());

    DataBlock& block = inspection.block;
    block = {.file = path,
             .offset = header.bytes,
             .type = type,
             .isBigEndian = isTrue(path, header, "ElementByteOrderMSB",
                                   isTrue(path, header, "BinaryDataByteOrderMSB", false)),
             .count = bytes / bytesOf(type)};
    const auto name = header.get("elementdatafile");
    if (name.starts_with("LIST") || name.find('%') != std::string::npos) {
        refuse(path, "its values are spread over several files", "join them into one file");
    }
    if (lowerCase(name) != "local") {
        block.file = siblingFile(path, name);
        block.offset = 0;
    }
    const bool isText = !isTrue(path, header, "BinaryData", true);
    if (isTrue(path, header, "CompressedData", false)) {
        if (isText) {
            refuse(path, "its values are said to be both text and compressed", "they are one or the other");
        }
        block.encoding = Encoding::Deflated;
        if (const auto size = header.get("compresseddatasize"); !size.empty()) {
            block.mostStored = storedBytes(path, size, block);
        }
    } else if (isText) {
        block.encoding = Encoding::Ascii;
    }
    skipHeader(path, header, block);
    checkDataBlock(path, block, inspection.notices, keptOf(inspection, inflated));
    return inspection;
}

} // namespace vs::volume
