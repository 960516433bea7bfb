// SPDX-License-Identifier: Apache-2.0
// volume-studio-decoder: reads one volume or picture for another program of Volume Studio, or makes a DICOM
// segmentation that names a series. That program starts it with a socket, often long before it asks
// (volume/reading/decoder_messages.h, decoder_at_hand.h). Whatever a file does to the libraries that decode
// it, it does here (decision 0030).
#include "decoding_limits.h"
#include "sandbox.h"

#include "base/error.h"
#include "base/large_pages.h"
#include "base/progress.h"
#include "image/image.h"
#include "volume/io/decode.h"
#include "volume/io/inspect.h"
#include "volume/reading/decoder_messages.h"
#include "volume/store/store_levels.h"

#include <fmt/format.h>

#include <malloc.h>
#include <poll.h>
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
#include <utility>
#include <variant>
#include <vector>

namespace {

using namespace vs;
using namespace vs::volume;

struct NobodyAsks : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// What has come by now, or comes next. Throws where nobody asks any more.
std::size_t receive(std::span<std::byte> bytes) {
    ssize_t count = -1;
    do {
        count = recv(kDecoderSocket, bytes.data(), bytes.size(), 0);
    } while (count < 0 && errno == EINTR);
    if (count <= 0) {
        throw NobodyAsks("nobody asks");
    }
    return std::size_t(count);
}

// What was asked for, as soon as it is. What follows it is left in `collected`.
DecoderRequest receiveRequest(MessageCollector& collected) {
    std::array<std::byte, 4096> bytes{};
    while (true) {
        if (const auto message = collected.next()) {
            return unpackRequest(*message);
        }
        const std::size_t count = receive(bytes);
        collected.add({reinterpret_cast<const std::uint8_t*>(bytes.data()), count});
    }
}

void sendBytes(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::send(kDecoderSocket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count < 0 && errno != EINTR) {
            _exit(1); // nobody listens any more
        }
        bytes = bytes.subspan(std::size_t(std::max<ssize_t>(count, 0)));
    }
}

void send(const DecoderAnswer& answer) {
    const MessageBytes message = framed(pack(answer));
    sendBytes(std::as_bytes(std::span(message)));
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

// Sends voxels piece by piece, each given back at once, so that they are not there twice: the program takes
// the memory that was just freed here.
void sendVoxels(std::span<std::byte> voxels) {
    constexpr std::size_t piece = std::size_t(4) << 20;
    constexpr std::size_t page = std::size_t(2) << 20; // of memory, at most: none is given back in parts
    for (std::size_t sent = 0; sent < voxels.size();) {
        const std::size_t wanted = std::min(piece, voxels.size() - sent);
        sendBytes(voxels.subspan(sent, wanted));
        sent += wanted;
        void* begin = voxels.data();
        std::size_t space = sent; // from where the system gave it in pages of its own
        if (sent < voxels.size() && std::align(page, page, begin, space) != nullptr) {
            madvise(begin, space / page * page, MADV_DONTNEED);
        }
    }
}

// Does what is asked for and sends it.
class Work {
public:
    Work(decoder::Limits& limits, MessageCollector& collected) : limits_(limits), collected_(collected) {}

    void operator()(const DecodeRequest& request) const {
        DecodedVolume decoded{decodeVolume(request.path, request.options)};
        auto voxels = std::move(decoded.result.volume.bytes);
        send(std::move(decoded));
        sendVoxels(voxels);
    }
    void operator()(const PictureRequest& request) const {
        std::error_code error;
        const auto status = std::filesystem::status(request.path, error);
        if (!std::filesystem::is_regular_file(status)) {
            throw ReadError("{}: {}; give a PNG file", request.path.string(),
                            std::filesystem::exists(status) ? "is no file" : "there is no such file");
        }
        const image::Image picture =
            image::readPng(request.path, [&](std::size_t bytes) { limits_.promise(bytes); });
        send(DecodedPicture{{picture.width, picture.height}});
        sendBytes(std::as_bytes(std::span(picture.rgba)));
    }
    void operator()(const SegmentationRequest& request) const {
        const std::size_t voxels = request.order.geometry.voxelCount();
        // The labels are the program's own: what is made of them is a bit a voxel and segment at most.
        limits_.addFile(voxels * (2 + request.order.segments.size() / 2));
        const std::vector<std::uint8_t> labels = receiveLabels(voxels);
        std::vector<std::byte> file;
        MadeSegmentation made;
        made.sources = makeDicomSegmentation(
            request.order, labels, [&](auto bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); });
        made.bytes = file.size();
        send(made);
        sendBytes(file);
    }

    // Goes on until nobody asks any more.
    void operator()(const LevelsRequest& request) const {
        const StoreLevels store(request.path, request.options);
        send(OpenedLevels{store.levels(), store.type()});
        while (true) {
            const auto next = nextRequest();
            if (!next) {
                return;
            }
            try {
                if (const auto* box = std::get_if<BoxRequest>(&*next)) {
                    const auto values = store.read(box->level, box->box);
                    send(SentValues{values.size(), store.type()});
                    sendBytes(values);
                } else if (const auto* wanted = std::get_if<ExtremesRequest>(&*next)) {
                    auto known = store.extremes();
                    if (!known && wanted->isAllHere) {
                        known = store.extremesByMissing();
                    }
                    const CellExtremes extremes = std::move(known).value_or(CellExtremes());
                    send(SentValues{extremes.ranges.size(), extremes.type, extremes.side, extremes.cells});
                    sendBytes(extremes.ranges);
                } else if (const auto* files = std::get_if<FilesRequest>(&*next)) {
                    send(FileNames{files->isOfExtremes ? store.filesOfExtremes()
                                                       : store.filesOf(files->of.level, files->of.box)});
                } else {
                    return;
                }
            } catch (const Error& error) {
                send(DecodeRefusal{error.what()}); // what else it has can be had still
            }
        }
    }
    void operator()(const BoxRequest& /*request*/) const { throw ReadError("no store has been opened"); }
    void operator()(const ExtremesRequest& /*request*/) const { throw ReadError("no store has been opened"); }
    void operator()(const FilesRequest& /*request*/) const { throw ReadError("no store has been opened"); }
    void operator()(const DescriptionRequest& request) const {
        send(FileNames{descriptionFiles(request.path)});
    }

private:
    // Nothing: nobody asks any more.
    [[nodiscard]] std::optional<DecoderRequest> nextRequest() const {
        try {
            return receiveRequest(collected_);
        } catch (const NobodyAsks&) {
            return {};
        }
    }
    [[nodiscard]] std::vector<std::uint8_t> receiveLabels(std::size_t count) const {
        std::vector<std::uint8_t> labels(count);
        auto missing = std::as_writable_bytes(std::span(labels));
        missing = missing.subspan(collected_.take(missing));
        while (!missing.empty()) {
            missing = missing.subspan(receive(missing));
        }
        return labels;
    }

    decoder::Limits& limits_;
    MessageCollector& collected_;
};

// Touches the memory that small scans are read into and keeps it at hand, if nobody asks yet: for the first
// time that takes a tenth of the time that reading one does.
void touchMemoryWhileWaiting() {
    pollfd asked{kDecoderSocket, POLLIN, 0};
    if (poll(&asked, 1, 0) != 0) {
        return;
    }
    constexpr std::size_t bytes = std::size_t(16) << 20;
    mallopt(M_MMAP_THRESHOLD, 2 * bytes); // less than that is taken from what was kept
    mallopt(M_TRIM_THRESHOLD, 4 * bytes); // so much is kept
    std::vector<std::byte> touched;
    reserveInLargePages(touched, bytes);
    touched.resize(bytes);
}

// The file that a request is about; of a segmentation the series that it names, if there is one.
std::filesystem::path pathOf(const DecoderRequest& request) {
    if (const auto* segmentation = std::get_if<SegmentationRequest>(&request)) {
        return segmentation->order.source;
    }
    if (const auto* levels = std::get_if<LevelsRequest>(&request)) {
        return levels->path;
    }
    if (const auto* description = std::get_if<DescriptionRequest>(&request)) {
        return description->path;
    }
    if (const auto* picture = std::get_if<PictureRequest>(&request)) {
        return picture->path;
    }
    const auto* volume = std::get_if<DecodeRequest>(&request);
    return volume != nullptr ? volume->path : std::filesystem::path();
}

void answer(const DecoderRequest& request, const Work& work) {
    const std::string path = pathOf(request).string();
    try {
        std::visit(work, request);
    } catch (const SeveralSeries& several) {
        send(DecodeRefusal{several.what(), false, several.choices()});
    } catch (const UsageError& error) {
        send(DecodeRefusal{error.what(), true});
    } catch (const Error& error) {
        send(DecodeRefusal{error.what()});
    } catch (const std::bad_alloc&) {
        send(DecodeRefusal{
            fmt::format("{}: it does not fit into memory; crop it or use a machine with more", path)});
    } catch (const std::exception& error) {
        send(DecodeRefusal{
            fmt::format("{}: it cannot be read ({}); check the file", path, printable(error.what()))});
    }
}

} // namespace

int main() {
    prctl(PR_SET_PDEATHSIG, SIGKILL); // with whoever waits for it
    try {
        decoder::closeSandbox();
        touchMemoryWhileWaiting();
        MessageCollector collected;
        const DecoderRequest request = receiveRequest(collected);
        decoder::Limits limits(pathOf(request));
        listenToSizes({[&](std::uint64_t bytes) { limits.promise(bytes); },
                       [&](std::uint64_t bytes) { limits.addFile(bytes); }});
        const ProgressListener listener((Telling()));
        answer(request, Work(limits, collected));
    } catch (const std::exception& error) {
        fmt::print(stderr, "volume-studio-decoder: {}; it is started by Volume Studio\n", error.what());
        _exit(2);
    }
    _exit(0); // there is nothing to tidy up that the system does not
}
