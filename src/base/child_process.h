// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

// Other programs that this one starts. Errors are told in words by whoever starts them, who knows what for.
namespace vs {

// A file descriptor that is closed in the end.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;

    void close();
    [[nodiscard]] int number() const { return number_; } // -1: closed, which poll() passes over

private:
    int number_;
};

struct DescriptorPair {
    Descriptor ours;
    Descriptor theirs;
};
// Two connected sockets. Sockets and no pipe where a program is written to: sending can be had without
// SIGPIPE, and it can be said that there is no more although another child holds a copy. Throws Error.
DescriptorPair socketPair();
// A pipe from them to us, from which we read without waiting. Throws Error.
DescriptorPair pipeFromThem();

// Another program that runs in a process group of its own, so that interrupting this one at a terminal does
// not reach it. It is ended with this object, and all that it started with it.
class ChildProcess {
public:
    // A descriptor that the program gets under a number. The standard streams that are not among them lead
    // nowhere.
    struct Handed {
        int ours = -1;
        int theirs = -1;
    };

    // Starts a program by its name, which is looked for in PATH, or by its path, with its arguments. Null
    // when there is no such program; throws Error when it cannot be started.
    static std::unique_ptr<ChildProcess> start(const std::vector<std::string>& command,
                                               std::span<const Handed> handed);
    ~ChildProcess() { kill(); }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    [[nodiscard]] pid_t id() const { return process_; } // 0 when it has ended
    // Whether it has ended by now, of itself or by kill().
    [[nodiscard]] bool hasEnded();
    // Whether somebody has stopped it (SIGSTOP), as hasEnded() found.
    [[nodiscard]] bool isStopped() const { return isStopped_; }
    // How it has ended, as waitpid() says it.
    [[nodiscard]] int status() const { return status_; }
    // Ends it and all that it started, and waits for that; not for long where the system cannot end it yet.
    void kill();

private:
    explicit ChildProcess(pid_t process) : process_(process) {}

    pid_t process_; // 0: it has ended and was asked for its status
    int status_ = 0;
    bool isStopped_ = false;
};

// "it ended with status 3", "it was ended by signal 11 (Segmentation fault)".
std::string endingOf(int status);

} // namespace vs
