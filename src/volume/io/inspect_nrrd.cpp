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

struct NrrdHeader {
    std::map<std::string, std::string> fields; // names in lower case
    std::uint64_t bytes = 0;                   // up to and with the blank line
    bool ended = false;                        // by a blank line

    [[nodiscard]] std::string get(const std::string& name, const std::string& other = "") const {
        const auto found = fields.find(name);
        return found != fields.end() ? found->second : otherSpelling(name, other);
    }

private:
    // The format allows two spellings of some names.
    [[nodiscard]] std::string otherSpelling(const std::string& name, const std::string& other) const {
        const auto found = name == "data file"   ? fields.find("datafile")
                           : name == "line skip" ? fields.find("lineskip")
                           : name == "byte skip" ? fields.find("byteskip")
                                                 : fields.end();
        return found != fields.end() ? found->second : other;
    }
};

// What a field may be called, in lines. The library ends the program over unknown ones that are long.
bool isNrrdField(const std::string& name) {
    constexpr std::string_view names =
        "\n"
        "axis maxs\naxis mins\naxismaxs\naxismins\nblock size\nblocksize\nbyte skip\n"
        "byteskip\ncenterings\ncenters\ncontent\ndata file\ndatafile\ndimension\nencoding\n"
        "endian\nkinds\nlabels\nline skip\nlineskip\nmax\nmeasurement frame\nmin\nnumber\n"
        "old max\nold min\noldmax\noldmin\nsample units\nsampleunits\nsizes\nspace\n"
        "space dimension\nspace directions\nspace origin\nspace units\nspacings\n"
        "thicknesses\ntype\nunits\n";
    return names.find("\n" + name + "\n") != std::string_view::npos;
}

// The library ends the program over a long line that it does not understand; it always understands a content.
constexpr std::size_t kLongestField = 1000;

NrrdHeader readNrrdHeader(const std::filesystem::path& path) {
    constexpr std::size_t longestHeader = 1 << 20;
    std::ifstream input(path, std::ios::binary);
    std::string line;
    nextLine(input, line, path);
    if (line.size() > 16 || !line.starts_with("NRRD000")) {
        refuse(path, fmt::format("it starts with \"{}\"", printable(line.substr(0, 12))),
               "a NRRD file starts with NRRD0001 to NRRD0005");
    }
    NrrdHeader header;
    while (nextLine(input, line, path)) {
        if (!line.empty() && line.back() == '\r') {
            line.pop_back();
        }
        if (line.empty()) {
            header.ended = true;
            break;
        }
        if (line.starts_with('#') || line.find(":=") < line.find(": ")) {
            continue;
        }
        const auto colon = line.find(':');
        if (colon == std::string::npos || colon > 64 || input.tellg() > std::streamoff(longestHeader)) {
            refuse(path, fmt::format("its header holds \"{}\"", printable(line.substr(0, 24))),
                   "it must be lines of \"field: value\", then a blank line before the values");
        }
        const auto name = lowerCase(trimmed(line.substr(0, colon)));
        if (!isNrrdField(name)) {
            refuse(path, fmt::format("its header has the field \"{}\"", printable(name)),
                   "NRRD knows none of that name; a key of one's own is written \"key:=value\"");
        }
        if (line.size() > kLongestField && name != "content") {
            refuse(path, fmt::format("its {} has {} characters", name, line.size()),
                   fmt::format("{} at most are read", kLongestField));
        }
        header.fields[name] = trimmed(line.substr(colon + 1));
    }
    header.bytes = header.ended ? std::uint64_t(input.tellg()) : std::filesystem::file_size(path);
    return header;
}

StoredType storedType(const std::filesystem::path& path, const NrrdHeader& header) {
    static const std::map<std::string, StoredType> types{{"signed char", StoredType::Int8},
                                                         {"int8", StoredType::Int8},
                                                         {"int8_t", StoredType::Int8},
                                                         {"uchar", StoredType::UInt8},
                                                         {"unsigned char", StoredType::UInt8},
                                                         {"uint8", StoredType::UInt8},
                                                         {"uint8_t", StoredType::UInt8},
                                                         {"short", StoredType::Int16},
                                                         {"short int", StoredType::Int16},
                                                         {"signed short", StoredType::Int16},
                                                         {"signed short int", StoredType::Int16},
                                                         {"int16", StoredType::Int16},
                                                         {"int16_t", StoredType::Int16},
                                                         {"ushort", StoredType::UInt16},
                                                         {"unsigned short", StoredType::UInt16},
                                                         {"unsigned short int", StoredType::UInt16},
                                                         {"uint16", StoredType::UInt16},
                                                         {"uint16_t", StoredType::UInt16},
                                                         {"int", StoredType::Int32},
                                                         {"signed int", StoredType::Int32},
                                                         {"int32", StoredType::Int32},
                                                         {"int32_t", StoredType::Int32},
                                                         {"uint", StoredType::UInt32},
                                                         {"unsigned int", StoredType::UInt32},
                                                         {"uint32", StoredType::UInt32},
                                                         {"uint32_t", StoredType::UInt32},
                                                         {"longlong", StoredType::Int64},
                                                         {"long long", StoredType::Int64},
                                                         {"long long int", StoredType::Int64},
                                                         {"signed long long", StoredType::Int64},
                                                         {"int64", StoredType::Int64},
                                                         {"int64_t", StoredType::Int64},
                                                         {"ulonglong", StoredType::UInt64},
                                                         {"unsigned long long", StoredType::UInt64},
                                                         {"unsigned long long int", StoredType::UInt64},
                                                         {"uint64", StoredType::UInt64},
                                                         {"uint64_t", StoredType::UInt64},
                                                         {"float", StoredType::Float32},
                                                         {"double", StoredType::Float64}};
    const auto type = lowerCase(header.get("type"));
    const auto found = types.find(type);
    if (found == types.end()) {
        refuse(path,
               type.empty() ? std::string("its header has no type")
                            : fmt::format("the type \"{}\" is unknown", printable(type)),
               "use int8 to int64, uint8 to uint64, float or double");
    }
    return found->second;
}

std::int64_t wholeNumber(const std::filesystem::path& path, const std::string& field, double value) {
    if (!std::isfinite(value) || value != std::floor(value) || std::abs(value) > 9e15) {
        refuse(path, fmt::format("{} holds {}", field, value), "it must be whole numbers");
    }
    return std::int64_t(value);
}

std::vector<std::int64_t> readSizes(const std::filesystem::path& path, const NrrdHeader& header) {
    const auto dimension = parseNumbers(path, "dimension", header.get("dimension"));
    if (dimension.size() != 1 || (dimension[0] != 3 && dimension[0] != 4)) {
        refuse(path, fmt::format("its dimension is \"{}\"", printable(header.get("dimension"))),
               "a volume has 3, or 4 with --frame");
    }
    std::vector<std::int64_t> sizes;
    for (const double size : parseNumbers(path, "sizes", header.get("sizes"))) {
        sizes.push_back(wholeNumber(path, "sizes", size));
    }
    if (double(sizes.size()) != dimension[0]) {
        refuse(path, fmt::format("it has {} sizes for {} dimensions", sizes.size(), dimension[0]),
               "there must be one for each");
    }
    return sizes;
}

// Which axis is not one of space: by the kinds, or by "none" among the directions. Refused unless it is the
// slowest.
void checkAxes(const std::filesystem::path& path, const NrrdHeader& header, std::size_t dimension) {
    const std::vector<std::string> kinds = words(lowerCase(header.get("kinds")));
    for (std::size_t axis = 0; axis < kinds.size(); ++axis) {
        const std::string& kind = kinds[axis];
        const bool spatial = kind == "domain" || kind == "space" || kind == "none" || kind == "???";
        if (!spatial && (axis < 3 || dimension == 3)) {
            refuse(path, fmt::format("its axis {} holds a \"{}\" at every voxel", axis, printable(kind)),
                   "one number per voxel is needed");
        }
    }
    if (dimension == 4 && lowerCase(header.get("space directions")).starts_with("none")) {
        refuse(path, "it holds several values at every voxel", "one number per voxel is needed");
    }
}

// "(1,0,0) (0,1,0) none" as vectors; "none" is skipped.
std::vector<glm::dvec3> readVectors(const std::filesystem::path& path, const std::string& field,
                                    std::string text) {
    for (char& c : text) {
        c = c == ',' || c == '(' || c == ')' ? ' ' : c;
    }
    for (auto at = text.find("none"); at != std::string::npos; at = text.find("none")) {
        text.replace(at, 4, "    ");
    }
    const auto numbers = parseNumbers(path, field, text);
    if (numbers.size() % 3 != 0) {
        refuse(path, fmt::format("{} holds {} numbers", field, numbers.size()),
               "it must be vectors of three");
    }
    std::vector<glm::dvec3> vectors;
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
        vectors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    return vectors;
}

void checkPlace(const std::filesystem::path& path, const NrrdHeader& header, std::size_t dimension) {
    if (const auto text = header.get("space dimension", "3"); text != "3") {
        refuse(path, fmt::format("its space dimension is {}", printable(text)), "it must be 3");
    }
    // Written with hyphens, blanks or neither.
    constexpr std::array<std::string_view, 9> spaces{
        "rightanteriorsuperior", "ras", "leftanteriorsuperior", "las",
        "leftposteriorsuperior", "lps", "scannerxyz",           "3drighthanded",
        "3dlefthanded"};
    auto space = lowerCase(header.get("space"));
    std::erase_if(space, [](char c) { return c == '-' || c == ' '; });
    if (!space.empty() && std::find(spaces.begin(), spaces.end(), space) == spaces.end()) {
        refuse(path, fmt::format("its space is \"{}\"", printable(header.get("space"))),
               "a space of three dimensions is needed, such as left-posterior-superior");
    }
    if (const auto text = header.get("space directions"); !text.empty()) {
        const auto vectors = readVectors(path, "space directions", lowerCase(text));
        if (vectors.size() != 3) {
            refuse(path, fmt::format("it has {} space directions", vectors.size()), "three are needed");
        }
        GridGeometry geometry;
        for (int axis = 0; axis < 3; ++axis) {
            geometry.worldFromVoxel[axis] = glm::dvec4(vectors[std::size_t(axis)], 0.0);
        }
        checkGeometry(path, geometry);
    }
    if (const auto text = header.get("space origin"); !text.empty()) {
        const auto origin = readVectors(path, "space origin", text);
        GridGeometry geometry;
        geometry.worldFromVoxel[3] = glm::dvec4(origin.empty() ? glm::dvec3(0) : origin[0], 1.0);
        checkGeometry(path, geometry);
    }
    if (const auto text = header.get("spacings"); !text.empty()) {
        const auto spacings = parseNumbers(path, "spacings", text);
        if (spacings.size() != dimension) {
            refuse(path, fmt::format("it has {} spacings for {} dimensions", spacings.size(), dimension),
                   "there must be one for each");
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            checkSpacing(path, spacings[axis]);
        }
    }
}

std::uint64_t skippedBytes(const std::filesystem::path& path, const NrrdHeader& header, DataBlock& block) {
    const auto number = [&](const std::string& field) {
        const auto values = parseNumbers(path, field, header.get(field, "0"));
        return values.size() == 1 ? wholeNumber(path, field, values[0]) : -2;
    };
    const std::int64_t lines = number("line skip");
    const std::int64_t bytes = number("byte skip");
    if (lines < 0 || lines > 100000 || bytes < -1 || (bytes == -1 && block.encoding != Encoding::Raw) ||
        (block.encoding == Encoding::Deflated && (lines > 0 || bytes > 0))) {
        refuse(path, fmt::format("it skips {} lines and {} bytes", lines, bytes),
               "both must be 0 or more, and 0 for compressed data");
    }
    std::ifstream input(block.file, std::ios::binary);
    input.seekg(static_cast<std::streamoff>(block.offset));
    std::string line;
    for (std::int64_t i = 0; i < lines; ++i) {
        nextLine(input, line, block.file);
    }
    if (!input) {
        refuse(path, fmt::format("it skips {} lines", lines), "its data file has fewer");
    }
    const auto start = std::uint64_t(input.tellg());
    if (bytes == -1) { // the values are the last bytes of the file
        const std::uint64_t size = std::filesystem::file_size(block.file);
        return size < block.bytes() ? start : size - block.bytes();
    }
    return start + std::uint64_t(bytes);
}

} // namespace

Inspection inspectNrrd(const std::filesystem::path& path, Inflated inflated) {
    const NrrdHeader header = readNrrdHeader(path);
    Inspection inspection;
    inspection.sizes = readSizes(path, header);
    const StoredType type = storedType(path, header);
    const std::uint64_t bytes = checkedBytes(path, inspection.sizes, bytesOf(type));
    checkAxes(path, header, inspection.sizes.size());
    checkPlace(path, header, inspection.sizes.size());

    const auto endian = lowerCase(header.get("endian"));
    DataBlock& block = inspection.block;
    block = {.file = path,
             .offset = header.bytes,
             .type = type,
             .isBigEndian = endian == "big",
             .count = bytes / bytesOf(type)};
    const auto encoding = lowerCase(header.get("encoding"));
    if (encoding == "gzip" || encoding == "gz") {
        block.encoding = Encoding::Deflated;
    } else if (encoding == "ascii" || encoding == "text" || encoding == "txt") {
        block.encoding = Encoding::Ascii;
    } else if (encoding != "raw") {
        refuse(path, fmt::format("its encoding \"{}\" is not read here", printable(encoding)),
               "it must be raw, gzip or ascii");
    }
    const bool needsEndian = block.encoding != Encoding::Ascii && bytesOf(type) > 1;
    if ((needsEndian || !endian.empty()) && endian != "little" && endian != "big") {
        refuse(path, fmt::format("its endian is \"{}\"", printable(endian)), "it must be little or big");
    }
    if (const auto name = header.get("data file"); !name.empty()) {
        if (name.starts_with("LIST") || name.find('%') != std::string::npos) {
            refuse(path, "its values are spread over several files", "join them into one file");
        }
        block.file = siblingFile(path, name);
        block.offset = 0;
    } else if (!header.ended) {
        refuse(path, "its header does not end", "a blank line must stand between the header and the values");
    }
    block.offset = skippedBytes(path, header, block);
    checkDataBlock(path, block, inspection.notices, keptOf(inspection, inflated));
    return inspection;
}

} // namespace vs::volume
