// SPDX-License-Identifier: Apache-2.0
#include "base/json_file.h"

#include "base/error.h"
#include "base/input_file.h"

#include <fstream>
#include <utility>

namespace vs {

using Json = nlohmann::ordered_json;

namespace {

constexpr int kDeepest = 100; // of values in values; what is written here has some ten

// What the library says, without its own error number in front.
std::string reasonOf(const Json::exception& error) {
    const std::string text = error.what();
    const auto end = text.find("] ");
    return end == std::string::npos ? text : text.substr(end + 2);
}

// From a stream or a text.
template <typename Input>
Json parse(Input&& input, const std::string& where, const std::string& wanted,
           const std::string& documentation) {
    try {
        // What is nested without end would be read by calls without end.
        return Json::parse(std::forward<Input>(input), [&](int depth, Json::parse_event_t, const Json&) {
            if (depth > kDeepest) {
                throw SessionError("{}: is nested more than {} deep; {} is wanted ({})", where, kDeepest,
                                   wanted, documentation);
            }
            return true;
        });
    } catch (const Json::parse_error& error) {
        throw SessionError("{}: not valid JSON at byte {}; {} is wanted ({})", where, error.byte, wanted,
                           documentation);
    } catch (const Json::exception& error) { // a number beyond all bounds
        throw SessionError("{}: not valid JSON ({}); {} is wanted ({})", where, reasonOf(error), wanted,
                           documentation);
    }
}

} // namespace

Json readJsonFile(const std::filesystem::path& path, const std::string& wanted,
                  const std::string& documentation) {
    const std::string noFile = whyNoFile(path);
    std::ifstream file(noFile.empty() ? path : std::filesystem::path());
    if (!file) {
        throw SessionError("{}: {}; give {} (JSON)", path.string(),
                           noFile.empty() ? "cannot be read" : noFile, wanted);
    }
    return parse(file, path.string(), wanted, documentation);
}

Json parseJson(const std::string& text, const std::string& where, const std::string& wanted,
               const std::string& documentation) {
    return parse(text, where, wanted, documentation);
}

} // namespace vs
