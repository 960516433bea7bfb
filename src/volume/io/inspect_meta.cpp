// SPDX-License-Identifier: Apache-2.0
#include "volume/io/inspect.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <map>
#include <optional>

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

MetaHeader readMetaHeader(const std::filesystem::path& path) {
    constexpr std::streamoff longestHeader = 1 << 20;
    std::ifstream input(path, std::ios::binary);
    MetaHeader header;
    for (std::string line; std::getline(input, line);) {
        if (trimmed(line).empty()) {
            continue;
        }
        const auto equals = line.find('=');
        if (equals == std::string::npos || equals > 64 || input.tellg() > longestHeader) {
            refuse(path, fmt::format("its header holds \"{}\"", printable(line.substr(0, 24))),
                   "a MetaImage header has lines of \"Name = value\" and ends with ElementDataFile");
        }
        const auto name = lowerCase(trimmed(line.substr(0, equals)));
        header.fields[name] = trimmed(line.substr(equals + 1));
        if (name == "elementdatafile") {
            header.bytes = input.eof() ? std::filesystem::file_size(path) : std::uint64_t(input.tellg());
            return header;
        }
    }
    refuse(path, "its header names no ElementDataFile",
           "it must end with \"ElementDataFile = NAME\" or LOCAL");
}

std::uint64_t voxelBytes(const std::filesystem::path& path, const MetaHeader& header) {
    static const std::map<std::string, std::uint64_t> types{
        {"met_char", 1},      {"met_uchar", 1},      {"met_short", 2}, {"met_ushort", 2},
        {"met_int", 4},       {"met_uint", 4},       {"met_long", 4},  {"met_ulong", 4},
        {"met_long_long", 8}, {"met_ulong_long", 8}, {"met_float", 4}, {"met_double", 8}};
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

bool isTrue(const std::string& text) {
    return !text.empty() && (text[0] == 'T' || text[0] == 't' || text[0] == '1');
}

} // namespace

Inspection inspectMeta(const std::filesystem::path& path) {
    const MetaHeader header = readMetaHeader(path);
    if (lowerCase(header.get("objecttype", "image")) != "image") {
        refuse(path, fmt::format("its ObjectType is \"{}\"", printable(header.get("objecttype"))),
               "it must be Image");
    }
    Inspection inspection;
    inspection.sizes = readSizes(path, header);
    const std::uint64_t bytesEach = voxelBytes(path, header);
    const std::uint64_t bytes = checkedBytes(path, inspection.sizes, bytesEach);
    checkPlace(path, header, inspection.sizes.size());

    DataBlock block{.file = path, .offset = header.bytes, .encoding = Encoding::Raw, .expected = bytes};
    const auto name = header.get("elementdatafile");
    if (name.starts_with("LIST") || name.find('%') != std::string::npos) {
        refuse(path, "its values are spread over several files", "join them into one file");
    }
    if (lowerCase(name) != "local") {
        block.file = siblingFile(path, name);
        block.offset = 0;
    }
    const auto skip = parseNumbers(path, "HeaderSize", header.get("headersize", "0"));
    if (skip.size() != 1 || !(skip[0] >= -1 && skip[0] < 1e15) || skip[0] != std::floor(skip[0])) {
        refuse(path, fmt::format("HeaderSize is \"{}\"", printable(header.get("headersize"))),
               "it must be a number of bytes, or -1");
    }
    if (isTrue(header.get("compresseddata"))) {
        block.encoding = Encoding::Deflated;
    } else if (!isTrue(header.get("binarydata", "True"))) {
        block.encoding = Encoding::Ascii;
        block.expected = bytes / bytesEach;
    } else if (skip[0] >= 0) {
        block.offset += std::uint64_t(skip[0]);
    } else if (const auto size = std::filesystem::file_size(block.file); size > bytes) {
        block.offset = size - bytes; // -1: the values are the last bytes of the file
    }
    checkDataBlock(path, block, inspection.notices);
    return inspection;
}

} // namespace vs::volume
