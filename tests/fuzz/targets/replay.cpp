// SPDX-License-Identifier: Apache-2.0
// fuzz_replay CORPUS: gives every file of CORPUS/TARGET/... to that target, as the fuzzer did that found it.
// Says which were refused and why, and ends at the first promise that is not kept.
#include "target.h"

#include <algorithm>
#include <cstdio>

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sorted(const fs::path& folder) {
    std::vector<fs::path> entries{fs::directory_iterator(folder), fs::directory_iterator()};
    std::sort(entries.begin(), entries.end());
    return entries;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2 || !fs::is_directory(argv[1])) {
        fmt::print(stderr, "usage: fuzz_replay CORPUS, a folder with a folder for each target\n");
        return 2;
    }
    vs::fuzz::keepErrorOutput();
    vs::fuzz::tellRefusals();
    int inputs = 0;
    for (const auto& folder : sorted(argv[1])) {
        const auto target = vs::fuzz::targetNamed(folder.filename().string());
        for (const auto& file : sorted(folder)) {
            fmt::print("{}/{}\n", target.name, file.filename().string());
            std::fflush(stdout); // before it may crash
            const std::string content = vs::fuzz::contentOf(file);
            target.read({reinterpret_cast<const std::uint8_t*>(content.data()), content.size()});
            ++inputs;
        }
    }
    fmt::print("{} inputs were read\n", inputs);
    return inputs > 0 ? 0 : 1;
}
