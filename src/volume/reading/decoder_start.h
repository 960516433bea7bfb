// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/child_process.h"

#include <sys/stat.h>

#include <filesystem>
#include <memory>

namespace vs::volume {

// Where the decoder lies: what VOLUME_STUDIO_DECODER names, else beside this program, else where it is
// installed.
std::filesystem::path decoderProgram();

// A decoder that was started and waits for what it is to do. Internal to this folder.
class StartedDecoder {
public:
    // Starts it. Throws Error when it is not there.
    StartedDecoder();

    // Whether it can be asked still: it runs, and is what would be started now.
    [[nodiscard]] bool isUsable();

    Descriptor socket;
    std::unique_ptr<ChildProcess> process;

private:
    std::filesystem::path program_;
    struct stat file_ {};
};

// The decoder that waits already (decoder_at_hand.h) if there is one that can be used, else one that is
// started now. Throws Error when there is none.
StartedDecoder takeDecoder();

// Ends it, beside whoever calls where the next one is started there too.
void endDecoder(StartedDecoder&& used);

} // namespace vs::volume
