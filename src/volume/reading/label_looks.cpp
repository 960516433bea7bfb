// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/label_looks.h"

#include "base/lines.h"
#include "base/text.h"

#include <fstream>
#include <istream>
#include <sstream>

namespace vs::volume {
namespace {

// "Segment0" -> "Name" -> "Liver".
using SegmentFields = std::map<std::string, std::map<std::string, std::string>>;

SegmentFields fieldsIn(std::istream& header, const std::filesystem::path& path) {
    SegmentFields segments;
    std::string line;
    while (nextLine(header, line, path) && !line.empty() && line != "\r") {
        const std::size_t assigns = line.find(":=");
        const std::size_t underscore = line.find('_');
        if (line.rfind("Segment", 0) == 0 && assigns != std::string::npos && underscore < assigns) {
            const std::size_t end = line.find_last_not_of(" \r");
            const std::size_t begin = line.find_first_not_of(' ', assigns + 2);
            if (begin <= end && begin != std::string::npos) {
                segments[line.substr(0, underscore)][line.substr(underscore + 1, assigns - underscore - 1)] =
                    line.substr(begin, end - begin + 1);
            }
        }
    }
    return segments;
}

} // namespace

LabelLooks labelLooksOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return labelLooksIn(file, path);
}

LabelLooks labelLooksIn(std::istream& header, const std::filesystem::path& path) {
    LabelLooks looks;
    std::string line;
    if (!nextLine(header, line, path) || line.rfind("NRRD", 0) != 0) {
        return looks;
    }
    for (auto& [id, fields] : fieldsIn(header, path)) {
        std::istringstream value(fields["LabelValue"]);
        std::istringstream colour(fields["Color"]);
        std::int64_t label = 0;
        glm::dvec3 rgb{0};
        if (value >> label) {
            LabelLook& look = looks[label];
            look.name = readableName(fields["Name"], LabelLook::kLongestName);
            if (colour >> rgb.r >> rgb.g >> rgb.b) {
                look.colour = glm::clamp(rgb, 0.0, 1.0);
            }
        }
    }
    return looks;
}

} // namespace vs::volume
