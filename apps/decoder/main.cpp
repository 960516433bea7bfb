// SPDX-License-Identifier: Apache-2.0
// volume-studio-decoder: reads one volume for another program of Volume Studio, which starts it with a socket
// and a file in memory (volume/reading/decoder_messages.h). Whatever a file does to the libraries that decode
// it, it does here (decision 0030).
#include "decoding_limits.h"
#include "sandbox.h"

#include "base/error.h"
#include "base/progress.h"
#include "volume/io/decode.h"
#include "volume/io/inspect.h"
#include "volume/reading/decoder_messages.h"

#include <fmt/format.h>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace {

using namespace vs;
using namespace vs::volume;

// What was asked for. Throws where nobody asks.
DecodeRequest receiveRequest() {
    MessageCollector collected;
    std::array<std::uint8_t, 4096> bytes{};
    while (true) {
        if (const auto message = collected.next()) {
            return unpackRequest(*message);
        }
        const ssize_t count = recv(kDecoderMessages, bytes.data(), bytes.size(), 0);
        if (count == 0 || (count < 0 && errno != EINTR)) {
            throw std::runtime_error("nobody asks");
        }
        collected.add(std::span(bytes.data(), std::size_t(std::max<ssize_t>(count, 0))));
    }
}

void send(const DecoderAnswer& answer) {
    const MessageBytes bytes = framed(pack(answer));
    for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t count =
            ::send(kDecoderMessages, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (count < 0 && errno != EINTR) {
            _exit(1); // nobody listens any more
        }
        sent += std::size_t(std::max<ssize_t>(count, 0));
    }
}

// Tells now and then how far reading is.
class Telling {
public:
    bool operator()(std::optional<double> share) {
        const auto now = std::chrono::steady_clock::now();
        if (share && now - last_ > std::chrono::milliseconds(50)) {
            send(DecodeShare{share});
            last_ = now;
        }
        return true;
    }

private:
    std::chrono::steady_clock::time_point last_{};
};

// Leaves voxels for whoever asked, piece by piece, each given back at once, so that they are not there twice.
void leaveVoxels(std::vector<std::byte>& voxels) {
    constexpr std::size_t piece = std::size_t(64) << 20;
    constexpr std::size_t page = 4096;
    for (std::size_t written = 0; written < voxels.size();) {
        const std::size_t wanted = std::min(piece, voxels.size() - written);
        const ssize_t count = write(kDecoderVoxels, voxels.data() + written, wanted);
        if (count < 0 && errno != EINTR) {
            throw std::bad_alloc();
        }
        written += std::size_t(std::max<ssize_t>(count, 0));
        void* begin = voxels.data();
        std::size_t space = written; // from where the system gave it in pages of its own
        if (std::align(page, page, begin, space) != nullptr) {
            madvise(begin, space / page * page, MADV_DONTNEED);
        }
    }
}

DecoderAnswer answerTo(const DecodeRequest& request) {
    try {
        DecodedVolume decoded{decodeVolume(request.path, request.options)};
        leaveVoxels(decoded.result.volume.bytes);
        return decoded;
    } catch (const SeveralSeries& several) {
        return DecodeRefusal{several.what(), false, several.choices()};
    } catch (const UsageError& error) {
        return DecodeRefusal{error.what(), true};
    } catch (const Error& error) {
        return DecodeRefusal{error.what()};
    } catch (const std::bad_alloc&) {
        return DecodeRefusal{fmt::format(
            "{}: it does not fit into memory; crop it or use a machine with more", request.path.string())};
    } catch (const std::exception& error) {
        return DecodeRefusal{fmt::format("{}: it cannot be read ({}); check the file", request.path.string(),
                                         printable(error.what()))};
    }
}

} // namespace

int main() {
    prctl(PR_SET_PDEATHSIG, SIGKILL); // with whoever waits for it
    try {
        const DecodeRequest request = receiveRequest();
        decoder::Limits limits(request.path);
        listenToSizes({[&](std::uint64_t bytes) { limits.promise(bytes); },
                       [&](std::uint64_t bytes) { limits.addFile(bytes); }});
        decoder::closeSandbox();
        const ProgressListener listener((Telling()));
        send(answerTo(request));
    } catch (const std::exception& error) {
        fmt::print(stderr, "volume-studio-decoder: {}; it is started by Volume Studio\n", error.what());
        _exit(2);
    }
    _exit(0); // there is nothing to tidy up that the system does not
}
