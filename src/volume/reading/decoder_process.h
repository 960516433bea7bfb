// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/child_process.h"
#include "base/error.h"
#include "volume/reading/decoder_messages.h"
#include "volume/reading/rest_clock.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vs::volume {

// Where the decoder lies: what VOLUME_STUDIO_DECODER names, else beside this program, else where it is
// installed.
std::filesystem::path decoderProgram();

// The decoder at work on one request. Ends with this object. Internal to this folder.
class DecoderProcess {
public:
    // Starts it, with what it is to find in the file in memory. Throws Error when it is not there.
    explicit DecoderProcess(const DecoderRequest& request, std::span<const std::byte> content = {});

    // Waits for its next answer and reports progress meanwhile; GivenUp is thrown from there. Nothing when it
    // has ended without one, or does nothing any more: whyItEnded() tells then.
    std::optional<DecoderAnswer> answer();
    [[nodiscard]] const std::string& whyItEnded() const { return why_; }
    // What it ends with, an `Answer`, reporting meanwhile how far it is. Throws what it refuses with
    // (ReadError, UsageError, SeveralSeries), or ReadError naming `path` where it gave up.
    template <typename Answer>
    Answer finalAnswer(const std::filesystem::path& path);

    // What it left in the file in memory behind the first `skip` bytes. Throws Error where that are not as
    // many bytes.
    [[nodiscard]] std::vector<std::byte> content(std::size_t bytes, std::size_t skip = 0) const;

private:
    DecoderAnswer lastAnswer(const std::filesystem::path& path);
    bool send(std::span<const std::uint8_t> bytes);
    bool receive();
    void waitFor(short events);
    [[nodiscard]] bool isStuck();

    Descriptor messages_;
    Descriptor voxels_;
    std::unique_ptr<ChildProcess> process_;
    MessageCollector collected_;
    std::string why_;
    RestClock rest_; // how long it has done nothing
};

template <typename Answer>
Answer DecoderProcess::finalAnswer(const std::filesystem::path& path) {
    auto answer = lastAnswer(path);
    if (auto* wanted = std::get_if<Answer>(&answer)) {
        return std::move(*wanted);
    }
    throw ReadError("{}: its decoder answered with something else; get an intact copy of the file",
                    path.string());
}

} // namespace vs::volume
