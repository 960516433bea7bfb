// SPDX-License-Identifier: Apache-2.0
#include "image/film_sink.h"

#include "base/error.h"

namespace vs::image {

void cannotWrite(const std::filesystem::path& path, const std::string& reason) {
    throw WriteError("{}: cannot be written ({}); choose a folder that can be written to", path.string(),
                     reason);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

} // namespace vs::image
