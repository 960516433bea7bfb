// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <thread>

namespace vs::volume {

// While it lives, a decoder is started before it is needed and waits: whoever reads a scan, a picture or a
// label map takes it instead of waiting for the start of one, which takes longer than reading a small scan.
// When that reading has ended another one is started. For programs that read again and again: there is one
// such object in the program, which lasts longer than all that is read meanwhile. Where no decoder can be
// started in advance nothing is said: whoever reads tries it again and says why it cannot be.
class DecoderAtHand {
public:
    DecoderAtHand();
    // Ends the decoder that waits.
    ~DecoderAtHand();
    DecoderAtHand(const DecoderAtHand&) = delete;
    DecoderAtHand& operator=(const DecoderAtHand&) = delete;

    // The process that waits; 0 where none does.
    [[nodiscard]] pid_t waiting() const;

private:
    std::jthread starter_;
};

} // namespace vs::volume
