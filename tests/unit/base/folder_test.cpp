// SPDX-License-Identifier: Apache-2.0
#include "base/folder.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace vs {
namespace {

TEST(Folder, HasEntries) {
    const auto folder = std::filesystem::temp_directory_path() / ("vs_folder_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder / "inner");
    std::ofstream(folder / ".hidden") << "x";
    std::ofstream(folder / "inner" / "deep") << "x";
    auto entries = entriesOf(folder);
    std::sort(entries.begin(), entries.end());
    EXPECT_EQ(entries, (std::vector<std::filesystem::path>{folder / ".hidden", folder / "inner"}));
    std::error_code fault;
    EXPECT_TRUE(entriesOf(folder / ".hidden", fault).empty());
    EXPECT_EQ(fault, std::errc::not_a_directory);
    std::filesystem::remove_all(folder);
}

TEST(Folder, IsRemovedWithWhatIsInItAndNoMore) {
    const auto folder = std::filesystem::temp_directory_path() / ("vs_removed_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder / "removed" / "inner");
    std::filesystem::create_directories(folder / "stays");
    std::ofstream(folder / "stays" / "file") << "x";
    std::ofstream(folder / "removed" / "inner" / "file") << "x";
    std::filesystem::create_directory_symlink(folder / "stays", folder / "removed" / "link");
    removeAll(folder / "removed");
    EXPECT_FALSE(std::filesystem::exists(folder / "removed"));
    EXPECT_TRUE(std::filesystem::exists(folder / "stays" / "file"));
    removeAll(folder);
    EXPECT_FALSE(std::filesystem::exists(folder));
    removeAll(folder); // which is nothing
}

} // namespace
} // namespace vs
