// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/child_process.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vs::image {

// A program that is given bytes on its standard input and says on its standard error what goes wrong. Should
// this program end first, it finds the end of its input.
//
// Whoever waits for it reports progress without a share (base/progress.h); GivenUp is thrown from there.
class EncoderProcess {
public:
    // Starts a program by its name, which is looked for in PATH, or by its path, with its arguments. Null
    // when there is no such program; throws Error when it cannot be started.
    static std::unique_ptr<EncoderProcess> start(const std::vector<std::string>& command);
    // Waits until the program has taken the bytes. False when it takes no more of them, for it has ended or
    // closed its input.
    [[nodiscard]] bool give(std::span<const std::uint8_t> bytes);

    // How the program ended.
    struct Ending {
        bool isGood = false; // it took everything and ended with the status 0
        std::string said;    // what was wrong, in a line: the last that it said, or its status
    };
    // Says that there is no more input and waits for the program's end, if `patience` is given no longer than
    // that: it is killed then.
    [[nodiscard]] Ending finish(std::optional<std::chrono::milliseconds> patience = {});

private:
    EncoderProcess(std::unique_ptr<ChildProcess> process, Descriptor input, Descriptor errors);
    void waitFor(short inputEvents, int most);
    void listen();

    std::unique_ptr<ChildProcess> process_;
    Descriptor input_;  // our end of a pair of sockets
    Descriptor errors_; // our end of a pipe
    std::string said_;  // the end of what came through it
};

// The last line that says something about what went wrong, without what ffmpeg puts around it (the address of
// the part that speaks, that the conversion failed); empty if there is none.
std::string lastTellingLine(const std::string& said);

} // namespace vs::image
