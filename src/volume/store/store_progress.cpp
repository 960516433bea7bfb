// SPDX-License-Identifier: Apache-2.0
#include "volume/store/store_progress.h"

#include "base/error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace vs::volume {

namespace {

namespace fs = std::filesystem;

// Throws where what was written may not be on the disk.
void syncFolder(const fs::path& folder) {
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const bool isSynced = file >= 0 && ::syncfs(file) == 0;
    const int why = errno;
    if (file >= 0) {
        ::close(file);
    }
    if (!isSynced) {
        throw WriteError("{}: it cannot be written to ({}); make room, and do it again to go on",
                         folder.string(), std::strerror(why));
    }
}

// What was being written when a run was killed.
void removeParts(const fs::path& store) {
    std::error_code error;
    for (fs::recursive_directory_iterator it(store, error), end; !error && it != end; it.increment(error)) {
        if (it->path().extension() == ".part") {
            std::error_code unknown;
            fs::remove(it->path(), unknown);
        }
    }
}

} // namespace

StoreProgress::StoreProgress(const fs::path& store, const std::string& what)
    : store_(store), file_(store / kUnfinishedStore) {
    std::error_code error;
    const bool isNew = !fs::exists(file_, error);
    if (isNew) {
        if (fs::exists(store, error) && !fs::is_empty(store, error)) {
            const bool isStore = fs::exists(store / ".zattrs", error);
            throw WriteError("{}: there is {} already; remove it, or give another name", store.string(),
                             isStore ? "a store that is finished" : "something");
        }
        fs::create_directories(store, error);
        std::ofstream stream(file_);
        stream << what << '\n';
        if (!stream.flush()) {
            throw WriteError("{}: nothing can be written there; name another place", store.string());
        }
    }
    lock_ = ::open(file_.c_str(), O_RDWR | O_CLOEXEC);
    if (lock_ < 0 || ::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
        const int why = errno;
        if (lock_ >= 0) {
            ::close(lock_);
        }
        throw WriteError("{}: {}; wait until it is done, or give another name", store.string(),
                         why == EWOULDBLOCK ? "another program is writing it" : std::strerror(why));
    }
    try {
        takeUp(what);
    } catch (...) {
        ::close(lock_);
        throw;
    }
}

StoreProgress::~StoreProgress() { ::close(lock_); }

void StoreProgress::takeUp(const std::string& what) {
    std::ifstream stream(file_);
    std::string line;
    std::getline(stream, line);
    if (line != what) {
        throw WriteError("{}: another volume, or this one with other settings, was begun there; remove it, "
                         "or give another name",
                         store_.string());
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
    removeParts(store_);
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
    if (!fs::remove(file_, error)) {
        throw WriteError("{}: it cannot be removed, and says that the store is not finished; remove it",
                         file_.string());
    }
}

void requireFinished(const fs::path& store) {
    std::error_code error;
    if (fs::exists(store / kUnfinishedStore, error)) {
        throw ReadError("{}: it is not finished; write it again to go on where it stopped", store.string());
    }
}

} // namespace vs::volume
