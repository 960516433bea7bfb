// SPDX-License-Identifier: Apache-2.0
#include "image/film_sink.h"

#include "base/error.h"

#include <fmt/format.h>
#include <unistd.h>

namespace vs::image {

std::filesystem::path temporaryBeside(const std::filesystem::path& target,
                                      const std::filesystem::path& path) {
    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
        throw WriteError("{}: the folder {} does not exist; make it or choose another", path.string(),
                         folder.string());
    }
    return folder /
           fmt::format(".{}.part{}{}", target.stem().string(), getpid(), target.extension().string());
}

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
