// SPDX-License-Identifier: Apache-2.0
#include "base/atomic_file.h"

#include "base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

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

void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path&)>& write) {
    const std::filesystem::path target = outputFile(path);
    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
        throw WriteError("{}: the folder {} does not exist; make it or choose another", path.string(),
                         folder.string());
    }
    const std::filesystem::path temporary = temporaryIn(folder, path);
    try {
        write(temporary);
        syncFile(temporary);
        std::filesystem::rename(temporary, target);
    } catch (const std::exception& error) {
        std::filesystem::remove(temporary, ignored);
        std::string reason = error.what();
        for (char& c : reason) {
            c = c == '\n' ? ' ' : c;
        }
        throw WriteError("{}: cannot be written ({}); choose a folder that can be written to", path.string(),
                         reason);
    }
}

void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> content) {
    writeAtomically(path, [&](const std::filesystem::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        out.write(reinterpret_cast<const char*>(content.data()), std::streamsize(content.size()));
        out.close();
        if (!out) {
            throw WriteError("{}", std::strerror(errno));
        }
    });
}

void writeFileAtomically(const std::filesystem::path& path, const std::string& content) {
    writeFileAtomically(path, std::as_bytes(std::span(content)));
}

} // namespace vs
