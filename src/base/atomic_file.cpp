// SPDX-License-Identifier: Apache-2.0
#include "base/atomic_file.h"

#include "base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

namespace vs {

namespace {

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
    return folder / ("." + stem + ".part" + std::to_string(getpid()) + extension);
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

// A temporary file that was filled and synced; gone in the end unless it was published.
class FilledFile {
public:
    explicit FilledFile(const FileWriting& file) : path_(file.path), target_(outputFile(file.path)) {
        const std::filesystem::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
        std::error_code ignored;
        if (!std::filesystem::is_directory(folder, ignored)) {
            throw WriteError("{}: the folder {} does not exist; make it or choose another", path_.string(),
                             folder.string());
        }
        temporary_ = temporaryIn(folder, path_);
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
        attempt([&] { std::filesystem::rename(temporary_, target_); });
        temporary_.clear();
    }

private:
    // Does what may fail, and says of which file that is.
    template <typename Work>
    void attempt(Work work) {
        try {
            work();
        } catch (const std::exception& error) {
            remove();
            std::string reason = error.what();
            std::replace(reason.begin(), reason.end(), '\n', ' ');
            throw WriteError("{}: cannot be written ({}); choose a folder that can be written to",
                             path_.string(), reason);
        }
    }
    void remove() const {
        std::error_code ignored;
        if (!temporary_.empty()) {
            std::filesystem::remove(temporary_, ignored);
        }
    }

    std::filesystem::path path_;
    std::filesystem::path target_;
    std::filesystem::path temporary_; // empty: it is no more
};

} // namespace

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
        filled.emplace_back(file);
    }
    for (FilledFile& file : filled) {
        file.publish();
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
