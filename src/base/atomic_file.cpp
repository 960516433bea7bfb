// SPDX-License-Identifier: Apache-2.0
#include "base/atomic_file.h"

#include "base/error.h"
#include "base/hash.h"

#include <fcntl.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <new>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace vs {

namespace {

std::filesystem::path folderOf(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

constexpr std::string_view kPart = ".part"; // what temporary files have in their names, then pid@machine

// Tells machines that write to the same folder of a network apart.
std::string machine() {
    utsname names{};
    uname(&names);
    Hash64 hash;
    hash.add(std::as_bytes(std::span(names.nodename, std::strlen(names.nodename))));
    return hash.text().substr(0, 6);
}

std::string writerMark() { return std::to_string(getpid()) + "@" + machine(); }

// Whether a file's name is that of a temporary one whose writer has ended on this machine: it was killed.
bool isLeftover(const std::string& name) {
    const auto part = name.rfind(kPart);
    const auto at = name.find('@', part == std::string::npos ? name.size() : part);
    if (!name.starts_with('.') || at == std::string::npos ||
        name.substr(at + 1, machine().size()) != machine()) {
        return false;
    }
    pid_t writer = 0;
    const char* const first = name.data() + part + kPart.size();
    const auto read = std::from_chars(first, name.data() + at, writer);
    return read.ptr == name.data() + at && writer > 0 && kill(writer, 0) != 0 && errno == ESRCH;
}

// Runs that were killed left what they had begun to write.
void clearLeftovers(const std::filesystem::path& folder) {
    for (const auto& entry : entriesOf(folder)) {
        if (isLeftover(entry.filename().string())) {
            removeAll(entry);
        }
    }
}

// In that folder, with the name's extension; ".nii.gz" counts as one.
std::filesystem::path temporaryIn(const std::filesystem::path& folder, const std::filesystem::path& name) {
    std::string stem = name.filename().string();
    std::string extension = name.extension().string();
    stem.resize(stem.size() - extension.size());
    if (extension == ".gz") {
        const std::string inner = std::filesystem::path(stem).extension().string();
        stem.resize(stem.size() - inner.size());
        extension = inner + extension;
    }
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return char(std::tolower(letter)); });
    return folder / ("." + stem + std::string(kPart) + writerMark() + extension);
}

// Where `target` is to be, which the person calls `named`; cleared of what killed runs have left.
std::filesystem::path folderFor(const std::filesystem::path& target, const std::filesystem::path& named) {
    std::filesystem::path folder = folderOf(target);
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
        throw WriteError("{}: the folder {} does not exist; make it or choose another", named.string(),
                         folder.string());
    }
    clearLeftovers(folder);
    return folder;
}

void syncFile(const std::filesystem::path& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0 || fsync(file) != 0) {
        const std::string reason = std::strerror(errno);
        if (file >= 0) {
            close(file);
        }
        throw WriteError("{}", reason);
    }
    close(file);
}

void fill(const std::filesystem::path& path, std::span<const std::byte> content) {
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(content.data()), std::streamsize(content.size()));
    out.close();
    if (!out) {
        throw WriteError("{}", std::strerror(errno));
    }
}

// The new name itself must reach the disk too. Where folders cannot be synced the file is still whole.
void syncFolder(const std::filesystem::path& folder) {
    const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file >= 0) {
        fsync(file);
        close(file);
    }
}

// A temporary file that was filled and synced; gone in the end. publish() gives it its name, and what had
// that name the temporary one, so that takeBack() can undo it.
class FilledFile {
public:
    // `named`: what the person calls the file, or those that it belongs to.
    FilledFile(const FileWriting& file, const std::filesystem::path& named)
        : named_(named), target_(outputFile(file.path)) {
        temporary_ = temporaryIn(folderFor(target_, named), file.path);
        attempt([&] {
            file.write(temporary_);
            syncFile(temporary_);
        });
    }
    ~FilledFile() { remove(); }
    FilledFile(FilledFile&& other) noexcept = default;
    FilledFile(const FilledFile&) = delete;
    FilledFile& operator=(const FilledFile&) = delete;
    FilledFile& operator=(FilledFile&&) = delete;

    void publish() {
        attempt([&] {
            std::error_code ignored;
            const bool isThere = std::filesystem::is_regular_file(target_, ignored);
            if (isThere &&
                renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
                before_ = Before::Kept;
            } else {
                std::filesystem::rename(temporary_, target_);
                before_ = isThere ? Before::Lost : Before::Nothing;
            }
        });
    }
    void takeBack() noexcept {
        std::error_code ignored;
        if (before_ == Before::Kept) {
            std::filesystem::rename(temporary_, target_, ignored);
        } else if (before_ == Before::Nothing) {
            std::filesystem::remove(target_, ignored);
        }
        before_.reset();
    }
    void syncName() const { syncFolder(folderOf(target_)); }

private:
    // Does what may fail, and says of which file that is.
    template <typename Work>
    void attempt(Work work) {
        try {
            work();
        } catch (const std::bad_alloc&) {
            remove();
            throw;
        } catch (const std::exception& error) {
            const std::string reason = reasonNotFilled(temporary_, error.what());
            remove();
            refuseToWrite(named_, reason);
        }
    }
    void remove() const {
        std::error_code ignored;
        if (!temporary_.empty()) {
            std::filesystem::remove(temporary_, ignored);
        }
    }

    std::filesystem::path named_;
    std::filesystem::path target_;
    std::filesystem::path temporary_; // what is in it now is not wanted in the end
    // What had the name before it was published: a file, which is the temporary one now, or is gone where the
    // file system cannot exchange names.
    enum class Before { Nothing, Kept, Lost };
    std::optional<Before> before_;
};

} // namespace

std::filesystem::path temporaryBeside(const std::filesystem::path& target,
                                      const std::filesystem::path& path) {
    return temporaryIn(folderFor(target, path), path);
}

std::string reasonNotFilled(const std::filesystem::path& temporary, std::string said) {
    std::replace(said.begin(), said.end(), '\n', ' ');
    const int file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NONBLOCK | O_CLOEXEC, 0600);
    if (file < 0) {
        return errno == EISDIR ? said : std::strerror(errno);
    }
    const std::vector<char> more(std::size_t(64) << 10U);
    errno = ENOSPC; // what it is when less is written than was given
    const bool isTaken = write(file, more.data(), more.size()) == ssize_t(more.size()) && fsync(file) == 0;
    const int error = errno;
    close(file);
    return isTaken ? said : std::strerror(error);
}

void refuseToWrite(const std::filesystem::path& path, const std::string& reason) {
    const bool isFull = reason == std::strerror(ENOSPC) || reason == std::strerror(EDQUOT);
    throw WriteError("{}: cannot be written ({}); {}", path.string(), reason,
                     isFull ? "make room there or choose another folder"
                            : "choose a folder that can be written to");
}

std::filesystem::path outputFile(const std::filesystem::path& path) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    if (std::filesystem::is_directory(status)) {
        throw WriteError("{}: is a folder; give the name of a file", path.string());
    }
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        throw WriteError("{}: is no regular file, and would be replaced by one; give another name",
                         path.string());
    }
    // Link by link, since the last one may point to what does not exist yet.
    std::filesystem::path target = path;
    for (int links = 0; std::filesystem::is_symlink(target, ignored); ++links) {
        constexpr int mostLinks = 40; // as many as Linux follows
        const auto next = std::filesystem::read_symlink(target, ignored);
        if (links == mostLinks || next.empty()) {
            throw WriteError("{}: is a link that leads nowhere; remove it or give another name",
                             path.string());
        }
        target = target.parent_path() / next; // just `next` if that is absolute
    }
    return target;
}

void writeAllAtomically(std::span<const FileWriting> files) {
    std::vector<FilledFile> filled;
    filled.reserve(files.size());
    for (const FileWriting& file : files) {
        filled.emplace_back(file, files.back().path);
    }
    try {
        for (FilledFile& file : filled) {
            file.publish();
        }
    } catch (...) {
        for (FilledFile& file : filled) {
            file.takeBack();
        }
        throw;
    }
    for (const FilledFile& file : filled) {
        file.syncName();
    }
}

void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path&)>& write) {
    const FileWriting file{path, write};
    writeAllAtomically(std::span(&file, 1));
}

std::function<void(const std::filesystem::path&)> writingOf(std::string content) {
    return [content = std::move(content)](const std::filesystem::path& temporary) {
        fill(temporary, std::as_bytes(std::span(content)));
    };
}

void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> content) {
    writeAtomically(path, [&](const std::filesystem::path& temporary) { fill(temporary, content); });
}

void writeFileAtomically(const std::filesystem::path& path, const std::string& content) {
    writeFileAtomically(path, std::as_bytes(std::span(content)));
}

} // namespace vs
