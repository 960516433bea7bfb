// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/decoder_process.h"

#include "base/error.h"
#include "base/progress.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <utility>

namespace vs::volume {
namespace {

constexpr int kAnswerMs = 50; // between looks whether anybody still wants the volume

// A disk or a network may keep a decoder waiting for long, which whoever waits can give up; without end it is
// stuck.
constexpr std::chrono::seconds kLongestRest{120};

Descriptor fileInMemory() {
    Descriptor file(memfd_create("voxels", MFD_CLOEXEC));
    if (file.number() < 0) {
        throw Error("there is no memory for voxels ({})", std::strerror(errno));
    }
    return file;
}

std::filesystem::path ownFolder() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

// What a process has used of the processor; nothing when that cannot be told.
std::optional<std::chrono::nanoseconds> processorTimeOf(pid_t process) {
    clockid_t clock = 0;
    timespec time{};
    if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) {
        return {};
    }
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

std::string whyItEnded(int status) {
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGPROF || WTERMSIG(status) == SIGXCPU)) {
        return "it takes far more time than a file of its size should";
    }
    return endingOf(status);
}

[[noreturn]] void throwRefusal(DecodeRefusal refusal) {
    if (refusal.isUsage) {
        throw UsageError("{}", refusal.message);
    }
    if (!refusal.choices.empty()) {
        throw SeveralSeries(refusal.message, std::move(refusal.choices));
    }
    throw ReadError("{}", refusal.message);
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

DecoderProcess::DecoderProcess(const DecoderRequest& request, std::span<const std::byte> content)
    : voxels_(fileInMemory()) {
    while (!content.empty()) {
        const ssize_t count = write(voxels_.number(), content.data(), content.size());
        if (count < 0 && errno != EINTR) {
            throw Error("there is no memory for {} bytes ({})", content.size(), std::strerror(errno));
        }
        content = content.subspan(std::size_t(std::max<ssize_t>(count, 0)));
    }
    DescriptorPair sockets = socketPair();
    messages_ = std::move(sockets.ours);
    const std::array<ChildProcess::Handed, 2> handed{
        {{sockets.theirs.number(), kDecoderMessages}, {voxels_.number(), kDecoderVoxels}}};
    const auto program = decoderProgram();
    process_ = ChildProcess::start({program.string()}, handed);
    if (!process_) {
        throw Error("{}: the program that reads scans is not there; install Volume Studio again",
                    program.string());
    }
    sockets.theirs.close();
    // A program that ended already takes nothing; answer() finds that.
    send(framed(pack(request)));
}

std::optional<DecoderAnswer> DecoderProcess::answer() {
    while (true) {
        try {
            if (const auto message = collected_.next()) {
                return unpackAnswer(*message);
            }
        } catch (const Error& error) {
            why_ = fmt::format("it answered with {}", error.what());
            process_->kill();
            return {};
        }
        const bool hasEnded = process_->hasEnded(); // before the last look at what it said
        if (receive()) {
            continue;
        }
        if (hasEnded) {
            why_ = vs::volume::whyItEnded(process_->status());
            return {};
        }
        if (process_->isStopped() || isStuck()) {
            why_ = process_->isStopped() ? "it was stopped" : "it does nothing any more";
            process_->kill();
            return {};
        }
        waitFor(POLLIN);
    }
}

DecoderAnswer DecoderProcess::lastAnswer(const std::filesystem::path& path) {
    while (auto next = answer()) {
        if (const auto* share = std::get_if<DecodeShare>(&*next)) {
            reportProgress(share->share);
        } else if (auto* refusal = std::get_if<DecodeRefusal>(&*next)) {
            throwRefusal(std::move(*refusal));
        } else {
            return std::move(*next);
        }
    }
    throw ReadError("{}: its decoder gave up ({}); get an intact copy of the file", path.string(), why_);
}

std::vector<std::byte> DecoderProcess::content(std::size_t bytes, std::size_t skip) const {
    struct stat status {};
    if (fstat(voxels_.number(), &status) != 0 || std::size_t(status.st_size) != skip + bytes) {
        throw Error("{} bytes instead of {}", status.st_size, skip + bytes);
    }
    // Piece by piece, each given back at once, so that they are not there twice.
    constexpr std::size_t piece = std::size_t(64) << 20;
    std::vector<std::byte> voxels;
    voxels.reserve(bytes);
    while (voxels.size() < bytes) {
        const std::size_t at = voxels.size();
        const std::size_t wanted = std::min(piece, bytes - at);
        voxels.resize(at + wanted);
        const ssize_t count = pread(voxels_.number(), voxels.data() + at, wanted, off_t(skip + at));
        if (count == 0 || (count < 0 && errno != EINTR)) {
            throw Error("bytes that cannot be read");
        }
        voxels.resize(at + std::size_t(std::max<ssize_t>(count, 0)));
        fallocate(voxels_.number(), FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, off_t(skip + at), count);
    }
    return voxels;
}

// False when the decoder takes no more.
bool DecoderProcess::send(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent =
            ::send(messages_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent >= 0) {
            bytes = bytes.subspan(std::size_t(sent));
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            waitFor(POLLOUT);
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

// Takes what has come; false when that was nothing.
bool DecoderProcess::receive() {
    std::array<std::uint8_t, 65536> bytes{};
    const ssize_t count = recv(messages_.number(), bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (count <= 0) {
        return false;
    }
    collected_.add(std::span(bytes.data(), std::size_t(count)));
    return true;
}

void DecoderProcess::waitFor(short events) {
    pollfd wait{messages_.number(), events, 0};
    poll(&wait, 1, kAnswerMs);
    if ((wait.revents & POLLHUP) != 0) { // it is about to end: that need not be looked for without a rest
        constexpr timespec moment{0, 1'000'000};
        nanosleep(&moment, nullptr);
    }
    reportProgress();
}

// Whether it has not worked for very long.
bool DecoderProcess::isStuck() {
    return rest_.look(std::chrono::steady_clock::now(), processorTimeOf(process_->id())) > kLongestRest;
}

} // namespace vs::volume
