// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/dicom_text.h"

#include "base/lines.h"
#include "volume/dicom/dcmtk_log.h"
#include "volume/io/inspect.h"

#include <fmt/format.h>

#include <dcmtk/dcmdata/dcspchrs.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace vs::volume {
namespace {

constexpr std::size_t kLongest = 200; // bytes of a text that is read

std::vector<std::string> parts(const std::string& text, char separator) {
    std::vector<std::string> result;
    for (const std::string& part : split(text, separator)) {
        result.push_back(trimmed(part));
    }
    return result;
}

// Those that are not empty, with `between` between them.
std::string joined(std::vector<std::string> texts, const char* between) {
    std::erase(texts, std::string());
    return fmt::format("{}", fmt::join(texts, between));
}

} // namespace

std::string textIn(const std::string& characterSet, const std::string& bytes) {
    silenceDcmtk();
    DcmSpecificCharacterSet converter;
    OFString text;
    const std::string start = bytes.substr(0, kLongest);
    const bool isConverted = converter.selectCharacterSet(OFString(characterSet.c_str())).good() &&
                             converter.convertString(OFString(start.c_str()), text, "^=\\").good();
    std::string result = isConverted ? std::string(text.c_str()) : printable(start);
    std::ranges::replace_if(
        result, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return result;
}

std::string readablePersonName(const std::string& name) {
    const auto components = parts(name.substr(0, name.find('=')), '^');
    if (components.empty()) {
        return {};
    }
    return joined({components[0], joined({components.begin() + 1, components.end()}, " ")}, ", ");
}

std::string readableDate(const std::string& date) {
    const bool isDate =
        date.size() == 8 && std::ranges::all_of(date, [](unsigned char c) { return std::isdigit(c) != 0; });
    return isDate ? date.substr(0, 4) + '-' + date.substr(4, 2) + '-' + date.substr(6) : std::string();
}

ScanDetails detailsOf(const DicomDataSet& set) {
    const std::string characters = set.text(0x00080005);
    const auto text = [&](std::uint32_t tag) { return textIn(characters, set.text(tag)); };
    ScanDetails details;
    details.format = "DICOM";
    const std::string number = text(0x00100020);
    details.patient = joined(
        {readablePersonName(text(0x00100010)), number.empty() ? number : fmt::format("({})", number)}, " ");
    details.study = joined({text(0x00081030), readableDate(set.text(0x00080020))}, ", ");
    details.series = joined({text(0x00200011), text(0x0008103E)}, ": ");
    details.modality = printable(set.text(0x00080060));
    // X-ray angiography, and MR that says of itself that it shows vessels (PS3.3, C.8.3.1: Angio Flag).
    details.isAngiography = details.modality == "XA" || printable(set.text(0x00180025)) == "Y";
    return details;
}

} // namespace vs::volume
