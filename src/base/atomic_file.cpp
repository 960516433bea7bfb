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

// ".nii.gz" counts as one extension.
std::filesystem::path temporaryFor(const std::filesystem::path& path) {
    std::string stem = path.filename().string();
    std::string extension = path.extension().string();
    stem.resize(stem.size() - extension.size());
    if (extension == ".gz") {
        const std::string inner = std::filesystem::path(stem).extension().string();
        stem.resize(stem.size() - inner.size());
        extension = inner + extension;
    }
    return path.parent_path() / ("." + stem + ".part" + std::to_string(getpid()) + extension);
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

void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path&)>& write) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
        throw WriteError("{}: the folder {} does not exist; make it or choose another", path.string(),
                         folder.string());
    }
    const std::filesystem::path temporary = temporaryFor(path);
    try {
        write(temporary);
        syncFile(temporary);
        std::filesystem::rename(temporary, path);
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
