// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "volume/reading/decoder_messages.h"
#include "volume/reading/decoder_start.h"
#include "volume/reading/rest_clock.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vs::volume {

// The decoder at work on one request. Ends with this object. Internal to this folder.
class DecoderProcess {
public:
    // Asks one that waits already, or starts one, and sends what belongs to the request behind it. Throws
    // Error when there is none.
    explicit DecoderProcess(const DecoderRequest& request, std::span<const std::byte> content = {});
    ~DecoderProcess();
    DecoderProcess(const DecoderProcess&) = delete;
    DecoderProcess& operator=(const DecoderProcess&) = delete;

    // Waits for its next answer and reports progress meanwhile; GivenUp is thrown from there. Nothing when it
    // has ended without one, or does nothing any more: whyItEnded() tells then.
    std::optional<DecoderAnswer> answer();
    [[nodiscard]] const std::string& whyItEnded() const { return why_; }
    // What it ends with, an `Answer`, reporting meanwhile how far it is. Throws what it refuses with
    // (ReadError, UsageError, SeveralSeries), or ReadError naming `path` where it gave up.
    template <typename Answer>
    Answer finalAnswer(const std::filesystem::path& path);

    // Asks it for something else that belongs to the request.
    void ask(const DecoderRequest& request);

    // What it sends behind its answer. Throws Error where that are not as many bytes.
    std::vector<std::byte> content(std::size_t bytes);

private:
    DecoderAnswer lastAnswer(const std::filesystem::path& path);
    bool send(std::span<const std::byte> bytes);
    std::size_t receive(std::span<std::byte> bytes);
    bool await(short events);
    void waitFor(short events);
    [[nodiscard]] bool isStuck();

    StartedDecoder decoder_;
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
