// SPDX-License-Identifier: Apache-2.0
#include "base/child_process.h"

#include "base/error.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

namespace vs {
namespace {

// What is done in the child before the program begins: its descriptors are put in place.
class ChildActions {
public:
    explicit ChildActions(std::span<const ChildProcess::Handed> handed) {
        posix_spawn_file_actions_init(&actions_);
        int last = STDERR_FILENO;
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
            posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null",
                                             stream == STDIN_FILENO ? O_RDONLY : O_WRONLY, 0);
        }
        for (const auto& [ours, theirs] : handed) {
            posix_spawn_file_actions_adddup2(&actions_, ours, theirs);
            last = std::max(last, theirs);
        }
        posix_spawn_file_actions_addclosefrom_np(&actions_, last + 1); // what libraries have left open
    }
    ~ChildActions() { posix_spawn_file_actions_destroy(&actions_); }
    ChildActions(const ChildActions&) = delete;
    ChildActions& operator=(const ChildActions&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

// How the child stands to signals: in a group of its own, and with none blocked or ignored because we block
// or ignore it.
class ChildAttributes {
public:
    ChildAttributes() {
        sigset_t none;
        sigset_t usual;
        sigemptyset(&none);
        sigemptyset(&usual);
        sigaddset(&usual, SIGPIPE);
        sigaddset(&usual, SIGCHLD); // one that waits for its own children must not have it ignored
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

// The descriptors with numbers that none is put under, so that putting one in place overwrites no other.
class OutOfTheWay {
public:
    explicit OutOfTheWay(std::span<const ChildProcess::Handed> handed) {
        constexpr int beyond = 10;
        for (const auto& [ours, theirs] : handed) {
            copies_.emplace_back(fcntl(ours, F_DUPFD_CLOEXEC, beyond));
            if (copies_.back().number() < 0) {
                throw Error("{}", std::strerror(errno));
            }
            handed_.push_back({copies_.back().number(), theirs});
        }
    }
    [[nodiscard]] std::span<const ChildProcess::Handed> handed() const { return handed_; }

private:
    std::vector<Descriptor> copies_;
    std::vector<ChildProcess::Handed> handed_;
};

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

DescriptorPair socketPair() {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        throw Error("{}", std::strerror(errno));
    }
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

DescriptorPair pipeFromThem() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw Error("{}", std::strerror(errno));
    }
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

std::unique_ptr<ChildProcess> ChildProcess::start(const std::vector<std::string>& command,
                                                  std::span<const Handed> handed) {
    const OutOfTheWay apart(handed);
    const ChildActions actions(apart.handed());
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
    return std::unique_ptr<ChildProcess>(new ChildProcess(process));
}

bool ChildProcess::hasEnded() {
    int status = 0;
    while (process_ != 0) {
        const pid_t found = waitpid(process_, &status, WNOHANG | WUNTRACED);
        if (found == process_ && WIFSTOPPED(status)) {
            isStopped_ = true;
        } else if (found == process_) {
            process_ = 0;
            status_ = status;
        } else if (found < 0 && errno != EINTR) { // somebody else has asked for its status
            process_ = 0;
            status_ = 255 << 8;
        }
        if (found == 0) {
            break;
        }
    }
    return process_ == 0;
}

void ChildProcess::kill() {
    if (process_ == 0) {
        return;
    }
    ::kill(-process_, SIGKILL);
    // Can be read from when it has ended. The C library's own function cannot be called from C++ everywhere.
    const Descriptor end(int(syscall(SYS_pidfd_open, process_, 0)));
    const int lookMs = end.number() < 0 ? 5 : 1000;
    for (int waited = 0; waited < 1000 && !hasEnded(); waited += lookMs) {
        pollfd wait{end.number(), POLLIN, 0};
        poll(&wait, 1, lookMs);
    }
    if (!hasEnded()) { // it waits for a disk or a network that is gone; nobody else has to
        std::thread([process = process_] { waitpid(process, nullptr, 0); }).detach();
        process_ = 0;
        status_ = SIGKILL;
    }
}

std::string endingOf(int status) {
    if (!WIFSIGNALED(status)) {
        return fmt::format("it ended with status {}", WEXITSTATUS(status));
    }
    const char* name = sigdescr_np(WTERMSIG(status));
    return fmt::format("it was ended by signal {}{}", WTERMSIG(status),
                       name == nullptr ? "" : fmt::format(" ({})", name));
}

} // namespace vs
