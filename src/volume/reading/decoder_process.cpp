// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/decoder_process.h"

#include "base/error.h"
#include "base/large_pages.h"
#include "base/progress.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <utility>

namespace vs::volume {
namespace {

constexpr int kAnswerMs = 50; // between looks whether anybody still wants the volume

// A disk or a network may keep a decoder waiting for long, which whoever waits can give up; without end it is
// stuck.
constexpr std::chrono::seconds kLongestRest{120};

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

DecoderProcess::DecoderProcess(const DecoderRequest& request, std::span<const std::byte> content)
    : decoder_(takeDecoder()) {
    const MessageBytes message = framed(pack(request));
    // A program that ended already takes nothing; answer() finds that.
    if (send(std::as_bytes(std::span(message)))) {
        send(content);
    }
}

void DecoderProcess::ask(const DecoderRequest& request) {
    const MessageBytes message = framed(pack(request));
    send(std::as_bytes(std::span(message))); // answer() finds that it has ended
}

DecoderProcess::~DecoderProcess() { endDecoder(std::move(decoder_)); }

std::optional<DecoderAnswer> DecoderProcess::answer() {
    while (true) {
        try {
            if (const auto message = collected_.next()) {
                return unpackAnswer(*message);
            }
        } catch (const Error& error) {
            why_ = fmt::format("it answered with {}", error.what());
            decoder_.process->kill();
            return {};
        }
        std::array<std::byte, 65536> bytes{};
        if (const std::size_t count = receive(bytes); count > 0) {
            collected_.add({reinterpret_cast<const std::uint8_t*>(bytes.data()), count});
        } else if (!await(POLLIN)) {
            return {};
        }
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

std::vector<std::byte> DecoderProcess::content(std::size_t bytes) {
    constexpr std::size_t piece = std::size_t(256) << 10; // stays in the processor's cache while it is filled
    std::vector<std::byte> content;
    reserveInLargePages(content, bytes);
    while (content.size() < bytes) {
        const std::size_t at = content.size();
        content.resize(std::min(bytes, at + piece));
        const auto wanted = std::span(content).subspan(at);
        std::size_t count = collected_.take(wanted);
        count = count > 0 ? count : receive(wanted);
        content.resize(at + count);
        if (count == 0 && !await(POLLIN)) {
            throw Error("{} bytes instead of {} ({})", at, bytes, why_);
        }
    }
    return content;
}

// False when the decoder takes no more.
bool DecoderProcess::send(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent =
            ::send(decoder_.socket.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent >= 0) {
            bytes = bytes.subspan(std::size_t(sent));
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            if (!await(POLLOUT)) {
                return false;
            }
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

// Takes what has come and returns how much that was.
std::size_t DecoderProcess::receive(std::span<std::byte> bytes) {
    const ssize_t count = recv(decoder_.socket.number(), bytes.data(), bytes.size(), MSG_DONTWAIT);
    return std::size_t(std::max<ssize_t>(count, 0));
}

// Waits until more has come than was received (POLLIN), or more can be sent (POLLOUT). False when that will
// never be, and why_ tells why.
bool DecoderProcess::await(short events) {
    ChildProcess& process = *decoder_.process;
    if (process.hasEnded()) {
        std::byte last{}; // before it ended it may have sent more
        if (recv(decoder_.socket.number(), &last, 1, MSG_DONTWAIT | MSG_PEEK) == 1) {
            return true;
        }
        if (why_.empty()) {
            why_ = vs::volume::whyItEnded(process.status());
        }
        return false;
    }
    if (process.isStopped() || isStuck()) {
        why_ = process.isStopped() ? "it was stopped" : "it does nothing any more";
        process.kill();
        return false;
    }
    waitFor(events);
    return true;
}

void DecoderProcess::waitFor(short events) {
    pollfd wait{decoder_.socket.number(), events, 0};
    poll(&wait, 1, kAnswerMs);
    if ((wait.revents & POLLHUP) != 0) { // it is about to end: that need not be looked for without a rest
        constexpr timespec moment{0, 1'000'000};
        nanosleep(&moment, nullptr);
    }
    reportProgress();
}

// Whether it has not worked for very long.
bool DecoderProcess::isStuck() {
    return rest_.look(std::chrono::steady_clock::now(), processorTimeOf(decoder_.process->id())) >
           kLongestRest;
}

} // namespace vs::volume
