// SPDX-License-Identifier: Apache-2.0
#include "base/json_file.h"

#include "base/error.h"

#include <fstream>

namespace vs {

using Json = nlohmann::ordered_json;

namespace {

// What the library says, without its own error number in front.
std::string reasonOf(const Json::exception& error) {
    const std::string text = error.what();
    const auto end = text.find("] ");
    return end == std::string::npos ? text : text.substr(end + 2);
}

} // namespace

Json readJsonFile(const std::filesystem::path& path, const std::string& wanted,
                  const std::string& documentation) {
    std::ifstream file(path);
    if (!file || std::filesystem::is_directory(path)) {
        throw SessionError("{}: cannot be read; give {} (JSON)", path.string(), wanted);
    }
    try {
        return Json::parse(file);
    } catch (const Json::parse_error& error) {
        throw SessionError("{}: not valid JSON at byte {}; {} is wanted ({})", path.string(), error.byte,
                           wanted, documentation);
    } catch (const Json::exception& error) { // a number beyond all bounds
        throw SessionError("{}: not valid JSON ({}); {} is wanted ({})", path.string(), reasonOf(error),
                           wanted, documentation);
    }
}

} // namespace vs
