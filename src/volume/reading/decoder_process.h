// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/child_process.h"
#include "volume/reading/decoder_messages.h"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vs::volume {

// Where the decoder lies: what VOLUME_STUDIO_DECODER names, else beside this program, else where it is
// installed.
std::filesystem::path decoderProgram();

// The decoder at work on one request. Ends with this object. Internal to this folder.
class DecoderProcess {
public:
    // Starts it. Throws Error when it is not there.
    explicit DecoderProcess(const DecodeRequest& request);

    // Waits for its next answer and reports progress meanwhile; GivenUp is thrown from there. Nothing when it
    // has ended without one, or does nothing any more: whyItEnded() tells then.
    std::optional<DecoderAnswer> answer();
    [[nodiscard]] const std::string& whyItEnded() const { return why_; }
    // The voxels that it left. Throws Error where they are not as many bytes.
    [[nodiscard]] std::vector<std::byte> voxels(std::size_t bytes) const;

private:
    bool send(std::span<const std::uint8_t> bytes);
    bool receive();
    void waitFor(short events);
    [[nodiscard]] bool isStuck();

    Descriptor messages_;
    Descriptor voxels_;
    std::unique_ptr<ChildProcess> process_;
    MessageCollector collected_;
    std::string why_;
    // When it was last seen to do something: its processor time then.
    std::chrono::steady_clock::time_point lastSeen_ = std::chrono::steady_clock::now();
    std::chrono::nanoseconds lastTime_{-1};
};

} // namespace vs::volume
