// SPDX-License-Identifier: Apache-2.0
// volume-studio-decoder: reads one volume or picture for another program of Volume Studio, or makes a DICOM
// segmentation that names a series. That program starts it with a socket and a file in memory
// (volume/reading/decoder_messages.h). Whatever a file does to the libraries that decode it, it does here
// (decision 0030).
#include "decoding_limits.h"
#include "sandbox.h"

#include "base/error.h"
#include "base/progress.h"
#include "image/image.h"
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
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <variant>

namespace {

using namespace vs;
using namespace vs::volume;

// What was asked for. Throws where nobody asks.
DecoderRequest receiveRequest() {
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

// Leaves bytes for whoever asked.
void leave(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = write(kDecoderVoxels, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) {
            throw std::bad_alloc();
        }
        bytes = bytes.subspan(std::size_t(std::max<ssize_t>(count, 0)));
    }
}

// Leaves voxels piece by piece, each given back at once, so that they are not there twice.
void leaveVoxels(std::vector<std::byte>& voxels) {
    constexpr std::size_t piece = std::size_t(64) << 20;
    constexpr std::size_t page = 4096;
    for (std::size_t written = 0; written < voxels.size();) {
        const std::size_t wanted = std::min(piece, voxels.size() - written);
        leave(std::span(voxels).subspan(written, wanted));
        written += wanted;
        void* begin = voxels.data();
        std::size_t space = written; // from where the system gave it in pages of its own
        if (std::align(page, page, begin, space) != nullptr) {
            madvise(begin, space / page * page, MADV_DONTNEED);
        }
    }
}

// The labels that whoever asked has left.
std::span<const std::uint8_t> labelsOf(std::size_t count) {
    void* labels = mmap(nullptr, count, PROT_READ, MAP_SHARED, kDecoderVoxels, 0);
    if (labels == MAP_FAILED) {
        throw std::bad_alloc();
    }
    return {static_cast<const std::uint8_t*>(labels), count};
}

// Does what is asked for.
class Work {
public:
    explicit Work(decoder::Limits& limits) : limits_(limits) {}

    DecoderAnswer operator()(const DecodeRequest& request) const {
        DecodedVolume decoded{decodeVolume(request.path, request.options)};
        leaveVoxels(decoded.result.volume.bytes);
        return decoded;
    }
    DecoderAnswer operator()(const PictureRequest& request) const {
        std::error_code error;
        const auto status = std::filesystem::status(request.path, error);
        if (!std::filesystem::is_regular_file(status)) {
            throw ReadError("{}: {}; give a PNG file", request.path.string(),
                            std::filesystem::exists(status) ? "is no file" : "there is no such file");
        }
        const image::Image picture =
            image::readPng(request.path, [&](std::size_t bytes) { limits_.promise(bytes); });
        leave(std::as_bytes(std::span(picture.rgba)));
        return DecodedPicture{{picture.width, picture.height}};
    }
    DecoderAnswer operator()(const SegmentationRequest& request) const {
        const std::size_t voxels = request.order.geometry.voxelCount();
        // The labels are the program's own: what is made of them is a bit a voxel and segment at most.
        limits_.addFile(voxels * (2 + request.order.segments.size() / 2));
        MadeSegmentation made;
        made.sources = makeDicomSegmentation(request.order, labelsOf(voxels), [&](auto bytes) {
            leave(bytes);
            made.bytes += bytes.size();
        });
        return made;
    }

private:
    decoder::Limits& limits_;
};

// The file that a request is about; of a segmentation the series that it names, if there is one.
std::filesystem::path pathOf(const DecoderRequest& request) {
    if (const auto* segmentation = std::get_if<SegmentationRequest>(&request)) {
        return segmentation->order.source;
    }
    const auto* picture = std::get_if<PictureRequest>(&request);
    return picture != nullptr ? picture->path : std::get<DecodeRequest>(request).path;
}

DecoderAnswer answerTo(const DecoderRequest& request, decoder::Limits& limits) {
    const std::string path = pathOf(request).string();
    try {
        return std::visit(Work(limits), request);
    } catch (const SeveralSeries& several) {
        return DecodeRefusal{several.what(), false, several.choices()};
    } catch (const UsageError& error) {
        return DecodeRefusal{error.what(), true};
    } catch (const Error& error) {
        return DecodeRefusal{error.what()};
    } catch (const std::bad_alloc&) {
        return DecodeRefusal{
            fmt::format("{}: it does not fit into memory; crop it or use a machine with more", path)};
    } catch (const std::exception& error) {
        return DecodeRefusal{
            fmt::format("{}: it cannot be read ({}); check the file", path, printable(error.what()))};
    }
}

} // namespace

int main() {
    prctl(PR_SET_PDEATHSIG, SIGKILL); // with whoever waits for it
    try {
        const DecoderRequest request = receiveRequest();
        decoder::Limits limits(pathOf(request));
        listenToSizes({[&](std::uint64_t bytes) { limits.promise(bytes); },
                       [&](std::uint64_t bytes) { limits.addFile(bytes); }});
        decoder::closeSandbox();
        const ProgressListener listener((Telling()));
        send(answerTo(request, limits));
    } catch (const std::exception& error) {
        fmt::print(stderr, "volume-studio-decoder: {}; it is started by Volume Studio\n", error.what());
        _exit(2);
    }
    _exit(0); // there is nothing to tidy up that the system does not
}
