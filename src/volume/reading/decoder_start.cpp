// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/decoder_start.h"

#include "base/error.h"
#include "volume/reading/decoder_messages.h"

#include <sys/socket.h>

#include <array>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace vs::volume {
namespace {

std::filesystem::path ownFolder() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

} // namespace

std::filesystem::path decoderProgram() {
    if (const char* named = std::getenv("VOLUME_STUDIO_DECODER"); named != nullptr && *named != '\0') {
        return named;
    }
    constexpr const char* name = "volume-studio-decoder";
    const auto folder = ownFolder();
    std::error_code error;
    for (const auto& place : {folder, folder.parent_path() / VOLUME_STUDIO_LIBEXEC}) {
        if (std::filesystem::exists(place / name, error)) {
            return place / name;
        }
    }
    return folder / name;
}

StartedDecoder::StartedDecoder() : program_(decoderProgram()) {
    stat(program_.c_str(), &file_);
    DescriptorPair sockets = socketPair();
    // As much at a time as the system allows: each time that one side waits for the other takes a while.
    constexpr int most = 1 << 22;
    setsockopt(sockets.theirs.number(), SOL_SOCKET, SO_SNDBUF, &most, sizeof most);
    const std::array<ChildProcess::Handed, 1> handed{{{sockets.theirs.number(), kDecoderSocket}}};
    process = ChildProcess::start({program_.string()}, handed);
    if (!process) {
        throw Error("{}: the program that reads scans is not there; install Volume Studio again",
                    program_.string());
    }
    socket = std::move(sockets.ours);
}

bool StartedDecoder::isUsable() {
    struct stat file {};
    return !process->hasEnded() && !process->isStopped() && program_ == decoderProgram() &&
           stat(program_.c_str(), &file) == 0 && file.st_dev == file_.st_dev && file.st_ino == file_.st_ino &&
           file.st_mtim.tv_sec == file_.st_mtim.tv_sec && file.st_mtim.tv_nsec == file_.st_mtim.tv_nsec;
}

} // namespace vs::volume
