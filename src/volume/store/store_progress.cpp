// SPDX-License-Identifier: Apache-2.0
#include "volume/store/store_progress.h"

#include "base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace vs::volume {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = ".volume-studio-unfinished";

void syncFolder(const fs::path& folder) {
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file >= 0) {
        ::syncfs(file);
        ::close(file);
    }
}

} // namespace

StoreProgress::StoreProgress(const fs::path& store, const std::string& what)
    : store_(store), file_(store / kFile) {
    std::error_code error;
    if (!fs::exists(file_, error)) {
        if (fs::exists(store, error) && !fs::is_empty(store, error)) {
            throw WriteError("{}: there is something already; remove it, or give another name",
                             store.string());
        }
        fs::create_directories(store, error);
        std::ofstream stream(file_);
        stream << what << '\n';
        if (!stream.flush()) {
            throw WriteError("{}: nothing can be written there; name another place", store.string());
        }
        return;
    }
    std::ifstream stream(file_);
    std::string line;
    std::getline(stream, line);
    if (line != what) {
        throw WriteError("{}: something else was begun there ({}); remove it, or give another name",
                         store.string(), line);
    }
    while (std::getline(stream, line)) {
        std::istringstream numbers(line);
        int level = 0;
        int slab = 0;
        std::string end;
        if (numbers >> level >> slab >> end && end == ";") { // or the line was torn
            done_.insert({level, slab});
        }
    }
}

void StoreProgress::note(int level, int slab) {
    syncFolder(store_);
    std::ofstream stream(file_, std::ios::app);
    stream << '\n' << level << ' ' << slab << " ;\n";
    if (!stream.flush()) {
        throw WriteError("{}: it cannot be written to; make room, and do it again to go on", file_.string());
    }
    done_.insert({level, slab});
}

void StoreProgress::finish() {
    syncFolder(store_);
    std::error_code error;
    fs::remove(file_, error);
}

void requireFinished(const fs::path& store) {
    std::error_code error;
    if (fs::exists(store / kFile, error)) {
        throw ReadError("{}: it is not finished; write it again to go on where it stopped", store.string());
    }
}

} // namespace vs::volume
