// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/web_store.h"

#include "base/child_process.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/progress.h"
#include "base/user_folders.h"
#include "volume/io/inspect.h"
#include "volume/reading/read_volume.h"

#include <fmt/format.h>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace vs::volume {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostCached = std::uintmax_t(10) << 30; // bytes of all stores in the cache
constexpr std::size_t kAtOnce = 1000;                            // files that one curl is asked for
constexpr const char* kMissing = ".volume-studio-missing";

fs::path cacheOfStores() { return cacheFolder() / "volume-studio" / "stores"; }

std::string hashOf(const std::string& text) {
    Hash64 hash;
    hash.add(std::as_bytes(std::span(text)));
    return hash.text();
}

// A name as an address has it.
std::string encoded(const std::string& name) {
    std::string text;
    for (const char c : name) {
        const bool isPlain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                             std::string_view("-._~/").find(c) != std::string_view::npos;
        text += isPlain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return text;
}

bool leadsOut(const fs::path& name) {
    return name.empty() || name.is_absolute() ||
           std::any_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".."; });
}

// In a file of options that curl reads.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        out += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    }
    return out + "\"";
}

// For how many seconds a server may do nothing. VOLUME_STUDIO_WEB_SECONDS says otherwise, for tests.
std::string patience() {
    const char* said = std::getenv("VOLUME_STUDIO_WEB_SECONDS");
    return said != nullptr ? said : "20";
}

// What a program writes to its standard output until it ends. Throws GivenUp.
std::string outputOf(const std::vector<std::string>& command) {
    DescriptorPair pipe{pipeFromThem()};
    const ChildProcess::Handed handed{pipe.theirs.number(), STDOUT_FILENO};
    const auto process = ChildProcess::start(command, std::span(&handed, 1));
    if (process == nullptr) {
        throw ReadError("the program curl is needed to read from web servers; install it (package curl)");
    }
    pipe.theirs.close();
    std::string output;
    std::array<char, 65536> bytes{};
    while (true) {
        pollfd ready{pipe.ours.number(), POLLIN, 0};
        poll(&ready, 1, 50);
        reportProgress();
        const ssize_t count = ::read(pipe.ours.number(), bytes.data(), bytes.size());
        if (count == 0) {
            return output;
        }
        output.append(bytes.data(), std::size_t(std::max<ssize_t>(count, 0)));
    }
}

std::uintmax_t sizeOfFolder(const fs::path& folder) {
    std::error_code error;
    std::uintmax_t bytes = 0;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        bytes += it->is_regular_file(ignored) ? it->file_size(ignored) : 0;
    }
    return bytes;
}

// Removes the stores that were opened longest ago, but not `kept`, until all are within bounds.
void tidyCache(const fs::path& kept) {
    std::error_code error;
    std::multimap<fs::file_time_type, fs::path> byAge;
    std::uintmax_t bytes = 0;
    for (fs::directory_iterator it(cacheOfStores(), error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        byAge.emplace(fs::last_write_time(it->path(), ignored), it->path());
        bytes += sizeOfFolder(it->path());
    }
    for (const auto& [age, folder] : byAge) {
        if (bytes <= kMostCached) {
            return;
        }
        if (folder != kept) {
            const std::uintmax_t size = sizeOfFolder(folder);
            std::error_code ignored;
            fs::remove_all(folder, ignored);
            bytes -= std::min(bytes, size);
        }
    }
}

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// What curl says of one file: "CODE EXIT NUMBER".
struct Answer {
    int code = 0; // of HTTP; 0: none came
    int exit = 0; // of curl
    std::size_t number = 0;
};

std::vector<Answer> answersOf(const std::string& output) {
    std::vector<Answer> answers;
    std::istringstream lines(output);
    for (Answer answer; lines >> answer.code >> answer.exit >> answer.number;) {
        answers.push_back(answer);
    }
    return answers;
}

std::string whyNot(const Answer& answer) {
    switch (answer.exit) {
    case 0:
        return fmt::format("the server answers with {}", answer.code);
    case 6:
        return "there is no such server";
    case 7:
        return "the server cannot be reached";
    case 18:
    case 56:
        return "the connection ended in the middle of a file";
    case 28:
        return "the server does not answer in time";
    default:
        return fmt::format("it cannot be fetched (curl {})", answer.exit);
    }
}

} // namespace

bool isWebAddress(const fs::path& path) {
    const std::string text = path.string();
    return text.starts_with("http://") || text.starts_with("https://");
}

fs::path absolutePath(const fs::path& path) { return isWebAddress(path) ? path : fs::absolute(path); }

WebStore::WebStore(std::string address, const std::string& description) : address_(std::move(address)) {
    while (address_.ends_with('/')) {
        address_.pop_back();
    }
    // The last part of the address is what the store is called.
    folder_ = cacheOfStores() / hashOf(address_) / fs::path(address_).filename();
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) {
        throw ReadError("{}: it cannot be made ({}); what comes from web servers is kept there",
                        folder_.string(), error.message());
    }
    fs::last_write_time(folder_.parent_path(), fs::file_time_type::clock::now(), error);
    tidyCache(folder_.parent_path());
    const std::string before = contentOf(folder_ / description);
    fs::remove(folder_ / description, error);
    fetchAll({description});
    if (contentOf(folder_ / description) != before) {
        forget();
        fetchAll({description});
    }
    readMissing();
    if (!fs::exists(folder_ / description, error)) {
        refuse(address_, fmt::format("the server has no {} there", description),
               "give the address of a store of OME-Zarr 0.4");
    }
}

void WebStore::forget() {
    std::error_code error;
    fs::remove_all(folder_, error);
    fs::create_directories(folder_, error);
}

void WebStore::readMissing() {
    std::ifstream in(folder_ / kMissing);
    for (std::string name; std::getline(in, name);) {
        missing_.insert(name);
    }
}

void WebStore::noteMissing(const std::vector<std::string>& names) {
    const std::lock_guard lock(mutex_);
    std::ofstream out(folder_ / kMissing, std::ios::app);
    for (const std::string& name : names) {
        if (missing_.insert(name).second) {
            out << name << '\n';
        }
    }
}

void WebStore::fetch(const std::vector<std::string>& names) {
    std::vector<std::string> wanted;
    for (const std::string& name : names) {
        if (leadsOut(name)) {
            refuse(address_, fmt::format("'{}' in it leads out of it", printable(name)),
                   "get another copy of the store");
        }
        std::error_code error;
        const std::lock_guard lock(mutex_);
        if (!missing_.contains(name) && !fs::exists(folder_ / name, error)) {
            wanted.push_back(name);
        }
    }
    for (std::size_t first = 0; first < wanted.size(); first += kAtOnce) {
        const auto last = std::min(first + kAtOnce, wanted.size());
        fetchAll({wanted.begin() + std::ptrdiff_t(first), wanted.begin() + std::ptrdiff_t(last)});
    }
}

void WebStore::fetchAll(const std::vector<std::string>& names) {
    if (names.empty()) {
        return;
    }
    static std::atomic<int> calls = 0;
    const std::string suffix = fmt::format(".{}-{}.part", getpid(), ++calls);
    const auto partOf = [&](const std::string& name) { return (folder_ / name).string() + suffix; };
    const fs::path orders = folder_ / (".orders" + suffix);
    {
        std::ofstream out(orders);
        for (const std::string& name : names) {
            std::error_code error;
            fs::create_directories((folder_ / name).parent_path(), error);
            out << "url = " << quoted(address_ + "/" + encoded(name)) << "\noutput = " << quoted(partOf(name))
                << '\n';
        }
    }
    const auto answers = answersOf(outputOf({"curl",
                                             "--disable",
                                             "--silent",
                                             "--globoff",
                                             "--parallel",
                                             "--parallel-max",
                                             "16",
                                             "--proto",
                                             "=http,https",
                                             "--location",
                                             "--max-redirs",
                                             "5",
                                             "--proto-redir",
                                             "=http,https",
                                             "--connect-timeout",
                                             patience(),
                                             "--speed-limit",
                                             "1",
                                             "--speed-time",
                                             patience(),
                                             "--retry",
                                             "1",
                                             "--write-out",
                                             "%{http_code} %{exitcode} %{urlnum}\\n",
                                             "--config",
                                             orders.string()}));
    std::error_code ignored;
    fs::remove(orders, ignored);
    std::vector<std::string> missing;
    std::string wrong;
    std::vector<bool> isAnswered(names.size());
    for (const Answer& answer : answers) {
        if (answer.number >= names.size()) {
            continue;
        }
        const std::string& name = names[answer.number];
        isAnswered[answer.number] = true;
        std::error_code error;
        if (answer.code == 200 && answer.exit == 0) {
            // A file of no bytes is not written by curl.
            std::ofstream(partOf(name), std::ios::app).close();
            fs::rename(partOf(name), folder_ / name, error);
        } else {
            fs::remove(partOf(name), error);
            if (answer.exit == 0 && (answer.code == 404 || answer.code == 410)) {
                missing.push_back(name);
            } else if (wrong.empty()) {
                wrong = fmt::format("{}/{}: {}; try again later", address_, encoded(name), whyNot(answer));
            }
        }
    }
    noteMissing(missing);
    if (wrong.empty() && !std::all_of(isAnswered.begin(), isAnswered.end(), [](bool is) { return is; })) {
        wrong = fmt::format("{}: curl did not fetch all that was asked for; try again later", address_);
    }
    if (!wrong.empty()) {
        throw ReadError("{}", wrong);
    }
}

} // namespace vs::volume
