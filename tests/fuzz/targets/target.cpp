// SPDX-License-Identifier: Apache-2.0
#include "target.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

namespace vs::fuzz {
namespace {

int& errorOutput() {
    static int descriptor = STDERR_FILENO;
    return descriptor;
}

bool& areRefusalsTold() {
    static bool areTold = false;
    return areTold;
}

// The folder of this process. Forked children leave it alone: they end by _exit.
class OwnFolder {
public:
    OwnFolder() : path_(std::filesystem::temp_directory_path() / fmt::format("vs_fuzz_{}", getpid())) {
        std::filesystem::create_directories(path_);
    }
    ~OwnFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::filesystem::path inOwnFolder(const std::string& name) {
    static const OwnFolder folder;
    return folder.path() / name;
}

// A fault that fuzzing must find, and replaying too, or they would find no others: two bytes are soon
// guessed.
void planted(Input input) {
    require(input.size() < 2 || input[0] != '?' || input[1] != '!', "what was planted is not there");
}

std::vector<Target> allTargets() {
    std::vector<Target> all{{"planted", planted}};
    for (const auto& some : {scanTargets(), decoderTargets(), sessionTargets()}) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

} // namespace

Target targetNamed(std::string_view name) {
    const auto all = allTargets();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Target& one) { return one.name == name; });
    if (found == all.end()) {
        fmt::print(stderr, "there is no target '{}'; choose one of", name);
        for (const Target& one : all) {
            fmt::print(stderr, " {}", one.name);
        }
        fmt::print(stderr, "\n");
        std::exit(2);
    }
    return *found;
}

void keepErrorOutput() { errorOutput() = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0); }

void fail(const std::string& promise) {
    const std::string text = "a promise was not kept: " + promise + "\n";
    [[maybe_unused]] const ssize_t written = write(errorOutput(), text.data(), text.size());
    std::abort();
}

void requireOneLine(std::string_view text) {
    const auto isControl = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
    require(!text.empty() && std::none_of(text.begin(), text.end(), isControl),
            "one line without control characters, but \"{}\"", text);
}

void refused(std::string_view why) {
    requireOneLine(why);
    if (areRefusalsTold()) {
        fmt::print("  refused: {}\n", why);
    }
}

void tellRefusals() { areRefusalsTold() = true; }

std::filesystem::path fileWith(const std::string& name, Input content) {
    return fileWith(name, std::string_view(reinterpret_cast<const char*>(content.data()), content.size()));
}

std::filesystem::path fileWith(const std::string& name, std::string_view content) {
    auto path = inOwnFolder(name);
    std::ofstream file(path, std::ios::binary);
    file.write(content.data(), std::streamsize(content.size()));
    file.close();
    require(bool(file), "there must be room for {}", path.string());
    return path;
}

std::filesystem::path noFileYet(const std::string& name) {
    auto path = inOwnFolder(name);
    std::filesystem::remove(path);
    return path;
}

std::string contentOf(const std::filesystem::path& file) {
    std::ifstream input(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
}

} // namespace vs::fuzz
