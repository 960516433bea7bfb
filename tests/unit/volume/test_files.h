// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace vs::volume {

// A folder of its own for each test, gone afterwards.
class TemporaryFolder {
public:
    TemporaryFolder()
        : path_(std::filesystem::temp_directory_path() / fmt::format("test_volume_{}_{}", getpid(), next())) {
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code error;
        std::filesystem::remove_all(path_, error);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    static int next() {
        static int count = 0;
        return ++count;
    }
    std::filesystem::path path_;
};

inline void writeFile(const std::filesystem::path& path, const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
}

inline std::string readFile(const std::filesystem::path& path) {
    std::ifstream input(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
}

// Real data that is not part of the repository; empty if it is not there.
inline std::filesystem::path testData() {
    const char* given = std::getenv("VOLUME_STUDIO_TEST_DATA");
    const std::filesystem::path path =
        given != nullptr ? given : std::filesystem::path(VOLUME_STUDIO_SOURCE_DIR) / ".." / "shared" / "data";
    return std::filesystem::exists(path / "bad" / "expected.tsv") ? path : std::filesystem::path();
}

} // namespace vs::volume
