// SPDX-License-Identifier: Apache-2.0
#include "image/encoder_process.h"

#include "base/error.h"
#include "base/progress.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace vs::image {

namespace {

constexpr int kMomentMs = 20;            // between looks whether a program has ended that does not speak
constexpr int kAnswerMs = 100;           // between looks whether anybody still wants the film
constexpr std::size_t kMostSaid = 16384; // bytes; more than the last lines need

struct Pair {
    Descriptor ours;
    Descriptor theirs;
};

// A socket and no pipe, since two things can only be done to sockets: sending without SIGPIPE, and saying
// that there is no more although a child that was forked meanwhile (volume/dicom/isolated_decode.h) holds a
// copy.
Pair inputPair() {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        throw Error("{}", std::strerror(errno));
    }
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Pair errorsPair() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw Error("{}", std::strerror(errno));
    }
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

// What is done in the child before the program begins: its standard streams are put in place.
class ChildActions {
public:
    ChildActions(int input, int errors) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    }
    ~ChildActions() { posix_spawn_file_actions_destroy(&actions_); }
    ChildActions(const ChildActions&) = delete;
    ChildActions& operator=(const ChildActions&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

// How the child stands to signals: in a group of its own (interrupting us from the terminal does not reach
// it), and with none blocked or ignored because we block or ignore it.
class ChildAttributes {
public:
    ChildAttributes() {
        sigset_t none;
        sigset_t usual;
        sigemptyset(&none);
        sigemptyset(&usual);
        sigaddset(&usual, SIGPIPE);
        posix_spawnattr_init(&attributes_);
        posix_spawnattr_setflags(&attributes_,
                                 POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
        posix_spawnattr_setpgroup(&attributes_, 0);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setsigdefault(&attributes_, &usual);
    }
    ~ChildAttributes() { posix_spawnattr_destroy(&attributes_); }
    ChildAttributes(const ChildAttributes&) = delete;
    ChildAttributes& operator=(const ChildAttributes&) = delete;

    [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

private:
    posix_spawnattr_t attributes_{};
};

std::string endOf(int status) {
    return WIFSIGNALED(status) ? fmt::format("it was ended by signal {}", WTERMSIG(status))
                               : fmt::format("it ended with status {}", WEXITSTATUS(status));
}

bool isTelling(const std::string& line) {
    return !line.empty() && line != "Conversion failed!" && !line.starts_with("Error opening output files");
}

} // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
}

void Descriptor::close() {
    if (number_ >= 0) {
        ::close(std::exchange(number_, -1));
    }
}

std::unique_ptr<EncoderProcess> EncoderProcess::start(const std::vector<std::string>& command) {
    Pair input = inputPair();
    Pair errors = errorsPair();
    const ChildActions actions(input.theirs.number(), errors.theirs.number());
    const ChildAttributes attributes;
    std::vector<char*> arguments;
    for (const std::string& argument : command) {
        arguments.push_back(const_cast<char*>(argument.c_str())); // posix_spawnp changes none
    }
    arguments.push_back(nullptr);
    pid_t process = 0;
    const int fault =
        posix_spawnp(&process, arguments[0], actions.get(), attributes.get(), arguments.data(), environ);
    if (fault == ENOENT || fault == ENOTDIR) {
        return nullptr;
    }
    if (fault != 0) {
        throw Error("{} cannot be started ({})", command[0], std::strerror(fault));
    }
    return std::unique_ptr<EncoderProcess>(
        new EncoderProcess(process, std::move(input.ours), std::move(errors.ours)));
}

EncoderProcess::EncoderProcess(pid_t process, Descriptor input, Descriptor errors)
    : process_(process), input_(std::move(input)), errors_(std::move(errors)) {}

EncoderProcess::~EncoderProcess() { kill(); }

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
    while (!hasEnded()) {
        if (patience && std::chrono::steady_clock::now() - begin > *patience) {
            kill();
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
    Ending ending{.isGood = status_ == 0 && lost == 0, .said = lastTellingLine(said_)};
    if (ending.said.empty()) {
        ending.said = status_ == 0 ? "it ended before the film did" : endOf(status_);
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

bool EncoderProcess::hasEnded() {
    if (process_ != 0) {
        const pid_t ended = waitpid(process_, &status_, WNOHANG);
        if (ended == process_) {
            process_ = 0;
        } else if (ended < 0 && errno != EINTR) { // somebody else has asked for its status
            process_ = 0;
            status_ = 255 << 8;
        }
    }
    return process_ == 0;
}

void EncoderProcess::kill() {
    if (process_ == 0) {
        return;
    }
    ::kill(-process_, SIGKILL);
    while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
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
