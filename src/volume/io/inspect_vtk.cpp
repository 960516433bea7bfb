// SPDX-License-Identifier: Apache-2.0
#include "volume/io/inspect.h"

#include "base/lines.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace vs::volume {
namespace {

struct VtkHeader {
    bool binary = false;
    std::string dataset;
    std::vector<double> dimensions;
    std::vector<double> spacing;
    std::vector<double> origin{0, 0, 0};
    double points = 0;
    std::string type;
    std::string components = "1";
    std::uint64_t bytes = 0;
};

std::string rest(std::istream& words) {
    std::string text;
    std::getline(words, text);
    return trimmed(text);
}

// Lines up to the one before the values.
VtkHeader readVtkHeader(const std::filesystem::path& path) {
    std::ifstream input(path, std::ios::binary);
    std::string line;
    VtkHeader header;
    for (int number = 0; number < 64 && nextLine(input, line, path) && line.size() < 1024; ++number) {
        std::istringstream words(line);
        std::string key;
        words >> key;
        key = lowerCase(key);
        if (number == 2) {
            header.binary = key == "binary";
            if (!header.binary && key != "ascii") {
                refuse(path, fmt::format("its third line is \"{}\"", printable(line)),
                       "it must be ASCII or BINARY");
            }
        } else if (number > 2 && key == "dataset") {
            header.dataset = lowerCase(rest(words));
        } else if (number > 2 && key == "dimensions") {
            header.dimensions = parseNumbers(path, "DIMENSIONS", rest(words));
        } else if (number > 2 && (key == "spacing" || key == "aspect_ratio")) {
            header.spacing = parseNumbers(path, "SPACING", rest(words));
        } else if (number > 2 && key == "origin") {
            header.origin = parseNumbers(path, "ORIGIN", rest(words));
        } else if (number > 2 && key == "point_data") {
            words >> header.points;
        } else if (number > 2 &&
                   (key == "scalars" || key == "color_scalars" || key == "vectors" || key == "tensors")) {
            std::string name;
            words >> name >> header.type;
            words >> header.components;
            header.components = key == "scalars" ? header.components : key;
        } else if (key == "lookup_table") {
            std::string table;
            if (!(words >> table) || !rest(words).empty()) {
                refuse(path, fmt::format("its header says \"{}\"", printable(line)),
                       "LOOKUP_TABLE has one word behind it");
            }
            header.bytes = std::uint64_t(input.tellg());
            return header;
        }
    }
    refuse(path, "its header names no scalars with a LOOKUP_TABLE line",
           "STRUCTURED_POINTS with SCALARS are needed");
}

StoredType storedType(const std::filesystem::path& path, const VtkHeader& header) {
    static const std::map<std::string, StoredType> types{
        {"unsigned_char", StoredType::UInt8},   {"char", StoredType::Int8},
        {"unsigned_short", StoredType::UInt16}, {"short", StoredType::Int16},
        {"unsigned_int", StoredType::UInt32},   {"int", StoredType::Int32},
        {"float", StoredType::Float32},         {"double", StoredType::Float64}};
    const auto found = types.find(lowerCase(header.type));
    if (found == types.end()) {
        refuse(path, fmt::format("the type \"{}\" is not read here", printable(header.type)),
               "use char, short, int (also unsigned_), float or double");
    }
    if (header.components != "1") {
        refuse(path, fmt::format("it holds {} per voxel", printable(header.components)),
               "one number per voxel is needed");
    }
    return found->second;
}

} // namespace

PlacedInspection inspectVtk(const std::filesystem::path& path) {
    const VtkHeader header = readVtkHeader(path);
    if (header.dataset != "structured_points") {
        refuse(path, fmt::format("its data set is \"{}\"", printable(header.dataset)),
               "it must be STRUCTURED_POINTS");
    }
    if (header.dimensions.size() != 3 || header.spacing.size() != 3 || header.origin.size() != 3) {
        refuse(path, "its dimensions, spacing or origin are not three numbers each", "a volume has 3 axes");
    }
    PlacedInspection inspection;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double size = header.dimensions[axis];
        if (!(size >= 1 && size <= 1e9) || size != std::floor(size)) {
            refuse(path, fmt::format("size {} along one axis", size), "every axis needs at least one voxel");
        }
        inspection.sizes.push_back(std::int64_t(size));
        checkSpacing(path, header.spacing[axis]);
        inspection.geometry.worldFromVoxel[int(axis)][int(axis)] = header.spacing[axis];
        inspection.geometry.worldFromVoxel[3][int(axis)] = header.origin[axis];
    }
    inspection.geometry.dims = inspection.dims();
    const StoredType type = storedType(path, header);
    const std::uint64_t count = checkedBytes(path, inspection.sizes, bytesOf(type)) / bytesOf(type);
    if (header.points != double(count)) {
        refuse(path, fmt::format("POINT_DATA says {}, its dimensions {}", header.points, count),
               "both must be the same");
    }
    inspection.block = {.file = path,
                        .offset = header.bytes,
                        .encoding = header.binary ? Encoding::Raw : Encoding::Ascii,
                        .type = type,
                        .isBigEndian = true,
                        .count = count};
    checkDataBlock(path, inspection.block, inspection.notices);
    return inspection;
}

} // namespace vs::volume
