// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/label_looks.h"

#include "base/json_file.h"
#include "base/lines.h"
#include "base/text.h"

#include <algorithm>
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
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        const auto attributes = path / ".zattrs";
        return std::filesystem::exists(attributes, error)
                   ? labelLooksInStore(readJsonFile(attributes, "a store of OME-Zarr", "OME-NGFF 0.4"))
                   : LabelLooks();
    }
    std::ifstream file(path, std::ios::binary);
    return labelLooksIn(file, path);
}

namespace {

using Attributes = nlohmann::ordered_json;

// Calls f(label, entry) with the entries of a list that name a label.
template <typename F>
void forEachLabel(const Attributes& of, const char* list, F&& f) {
    const auto found = of.find(list);
    if (found == of.end() || !found->is_array()) {
        return;
    }
    for (const Attributes& entry : *found) {
        const auto label = entry.is_object() ? entry.find("label-value") : entry.end();
        if (entry.is_object() && label != entry.end() && label->is_number_integer()) {
            f(label->get<std::int64_t>(), entry);
        }
    }
}

std::optional<glm::dvec3> colourOf(const Attributes& entry) {
    const auto rgba = entry.find("rgba");
    if (rgba == entry.end() || !rgba->is_array() || rgba->size() < 3) {
        return {};
    }
    glm::dvec3 colour{0};
    for (int n = 0; n < 3; ++n) {
        const Attributes& part = (*rgba)[std::size_t(n)];
        if (!part.is_number()) {
            return {};
        }
        colour[n] = std::clamp(part.get<double>() / 255, 0.0, 1.0);
    }
    return colour;
}

} // namespace

LabelLooks labelLooksInStore(const Attributes& attributes) {
    LabelLooks looks;
    const auto labels = attributes.is_object() ? attributes.find("image-label") : attributes.end();
    if (!attributes.is_object() || labels == attributes.end() || !labels->is_object()) {
        return looks;
    }
    forEachLabel(*labels, "colors",
                 [&](std::int64_t label, const Attributes& entry) { looks[label].colour = colourOf(entry); });
    forEachLabel(*labels, "properties", [&](std::int64_t label, const Attributes& entry) {
        const auto name = entry.find("name");
        if (name != entry.end() && name->is_string()) {
            looks[label].name = readableName(name->get<std::string>(), LabelLook::kLongestName);
        }
    });
    return looks;
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
