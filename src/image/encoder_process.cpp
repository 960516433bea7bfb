// SPDX-License-Identifier: Apache-2.0
#include "image/encoder_process.h"

#include "base/error.h"
#include "base/progress.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace vs::image {

namespace {

constexpr int kMomentMs = 20;            // between looks whether a program has ended that does not speak
constexpr int kAnswerMs = 100;           // between looks whether anybody still wants the film
constexpr std::size_t kMostSaid = 16384; // bytes; more than the last lines need

bool isTelling(const std::string& line) {
    return !line.empty() && line != "Conversion failed!" && !line.starts_with("Error opening output files");
}

} // namespace

std::unique_ptr<EncoderProcess> EncoderProcess::start(const std::vector<std::string>& command) {
    DescriptorPair input = socketPair();
    DescriptorPair errors = pipeFromThem();
    const std::array<ChildProcess::Handed, 2> handed{
        {{input.theirs.number(), STDIN_FILENO}, {errors.theirs.number(), STDERR_FILENO}}};
    auto process = ChildProcess::start(command, handed);
    if (!process) {
        return nullptr;
    }
    return std::unique_ptr<EncoderProcess>(
        new EncoderProcess(std::move(process), std::move(input.ours), std::move(errors.ours)));
}

EncoderProcess::EncoderProcess(std::unique_ptr<ChildProcess> process, Descriptor input, Descriptor errors)
    : process_(std::move(process)), input_(std::move(input)), errors_(std::move(errors)) {}

bool EncoderProcess::give(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = send(input_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent >= 0) {
            bytes = bytes.subspan(std::size_t(sent));
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            waitFor(POLLOUT, kAnswerMs);
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

EncoderProcess::Ending EncoderProcess::finish(std::optional<std::chrono::milliseconds> patience) {
    const auto begin = std::chrono::steady_clock::now();
    shutdown(input_.number(), SHUT_WR);
    while (!process_->hasEnded()) {
        if (patience && std::chrono::steady_clock::now() - begin > *patience) {
            process_->kill();
            said_ += said_.empty() ? "it takes no more frames" : "";
            break;
        }
        waitFor(0, kMomentMs);
    }
    listen();
    // A socket whose other end was closed with something in it knows that this was lost.
    int lost = 0;
    socklen_t bytes = sizeof(lost);
    getsockopt(input_.number(), SOL_SOCKET, SO_ERROR, &lost, &bytes);
    Ending ending{.isGood = process_->status() == 0 && lost == 0, .said = lastTellingLine(said_)};
    if (ending.said.empty()) {
        ending.said = process_->status() == 0 ? "it ended before the film did" : endingOf(process_->status());
    }
    return ending;
}

// Waits until the program takes input (if `inputEvents` asks for that) or says something, but not much longer
// than `most` milliseconds. Throws GivenUp.
void EncoderProcess::waitFor(short inputEvents, int most) {
    // A closed input is always an event: one that is not asked for must not cut the wait short.
    std::array<pollfd, 2> waits{pollfd{inputEvents != 0 ? input_.number() : -1, inputEvents, 0},
                                pollfd{errors_.number(), POLLIN, 0}};
    poll(waits.data(), waits.size(), most);
    listen();
    reportProgress();
}

// Takes what the program has said, so that it never waits for us to listen.
void EncoderProcess::listen() {
    std::array<char, 4096> bytes{};
    constexpr int mostReads = 64; // one that never stops speaking must not keep us here
    for (int reads = 0; reads < mostReads && errors_.number() >= 0; ++reads) {
        const ssize_t count = read(errors_.number(), bytes.data(), bytes.size());
        if (count > 0) {
            said_.append(bytes.data(), std::size_t(count));
            said_.erase(0, said_.size() - std::min(said_.size(), kMostSaid));
        } else if (count == 0) {
            errors_.close(); // it says no more, though it may still work
        } else if (errno != EINTR) {
            return;
        }
    }
}

std::string lastTellingLine(const std::string& said) {
    std::string last;
    std::string line;
    for (const char c : said + '\n') {
        if (c != '\n' && c != '\r') {
            line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
            continue;
        }
        // "[libx264 @ 0x55d0c8b1e5c0] what is wrong"
        const std::size_t beyond = line.find("] ");
        if (line.starts_with('[') && line.find(" @ 0x") < beyond && beyond != std::string::npos) {
            line.erase(0, beyond + 2);
        }
        last = isTelling(line) ? line : last;
        line.clear();
    }
    return last;
}

} // namespace vs::image
