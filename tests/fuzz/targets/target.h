// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// What libFuzzer calls (fuzzer.cpp), and what every test run calls again with the inputs that it has kept
// (replay.cpp). A target gives an input to one of the program's readers, and ends the process where that does
// not keep what it promises; the sanitizers end it for all else.
namespace vs::fuzz {

using Input = std::span<const std::uint8_t>;

struct Target {
    const char* name; // as the folder of its inputs is called
    void (*read)(Input input);
};

// Each returns the targets of one part of the program.
std::vector<Target> scanTargets();
std::vector<Target> decoderTargets();
std::vector<Target> sessionTargets();

// The target of that name. Ends the process, listing all, where there is none.
Target targetNamed(std::string_view name);

// Makes the messages below heard whatever becomes of the error output later; libraries that read scans, and
// libFuzzer, close it for a while.
void keepErrorOutput();

// Says which promise was not kept, and ends the process as a crash does.
[[noreturn]] void fail(const std::string& promise);

template <typename... Args>
void require(bool isKept, fmt::format_string<Args...> promise, Args&&... args) {
    if (!isKept) {
        fail(fmt::format(promise, std::forward<Args>(args)...));
    }
}

// A text for people must be one line that every terminal shows as it is.
void requireOneLine(std::string_view text);

// Must be called with the message of every Error by which an input is refused: one line.
void refused(std::string_view why);
// Prints those messages from now on.
void tellRefusals();

// What `read` returns; nothing where it refuses the input as it may: by an Error that says why in one line.
template <typename Read>
auto unlessRefused(Read read) -> std::optional<decltype(read())> {
    try {
        return read();
    } catch (const Error& error) {
        refused(error.what());
        return {};
    }
}

// A file of that name with these bytes, in a folder that is this process's own and gone with it.
std::filesystem::path fileWith(const std::string& name, Input content);
std::filesystem::path fileWith(const std::string& name, std::string_view content);
// The path that such a file would have; there is none.
std::filesystem::path noFileYet(const std::string& name);
std::string contentOf(const std::filesystem::path& file);

} // namespace vs::fuzz
