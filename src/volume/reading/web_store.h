// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace vs::volume {

// A store on a web server, as a folder on the disk in which its files appear when they are asked for, and
// stay: the next time they need not be fetched. Files are fetched by the program `curl`, several at once;
// what the server does not have is remembered. Threads may call it at once. Internal to this folder.
class WebStore {
public:
    // Fetches nothing yet, but forgets what was kept of a store whose description `description` (a file of
    // it) has become another. Throws ReadError.
    WebStore(std::string address, const std::string& description);

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    // Sees to it that these files, by their names in the store, are in the folder, as far as the server has
    // them. Throws ReadError where it does not answer, or with something else, and for names that lead out of
    // the store.
    void fetch(const std::vector<std::string>& names);

private:
    void fetchAll(const std::vector<std::string>& names);
    void forget();
    void readMissing();
    void noteMissing(const std::vector<std::string>& names);

    std::string address_; // without a slash at its end
    std::filesystem::path folder_;
    std::mutex mutex_;
    std::set<std::string> missing_; // files that the server does not have
};

} // namespace vs::volume
