// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/read_volume.h"

#include "base/progress.h"
#include "volume/io/inspect.h"
#include "volume/reading/decoder_process.h"

#include <fmt/format.h>

#include <new>
#include <utility>

namespace vs::volume {
namespace {

[[noreturn]] void throwRefusal(DecodeRefusal refusal) {
    if (refusal.isUsage) {
        throw UsageError("{}", refusal.message);
    }
    if (!refusal.choices.empty()) {
        throw SeveralSeries(refusal.message, std::move(refusal.choices));
    }
    throw ReadError("{}", refusal.message);
}

// What the decoder ends with, told meanwhile how far it is.
DecodedVolume finalAnswer(DecoderProcess& decoder, const std::filesystem::path& path) {
    while (auto answer = decoder.answer()) {
        if (auto* share = std::get_if<DecodeShare>(&*answer)) {
            reportProgress(share->share);
        } else if (auto* refusal = std::get_if<DecodeRefusal>(&*answer)) {
            throwRefusal(std::move(*refusal));
        } else {
            return std::move(std::get<DecodedVolume>(*answer));
        }
    }
    refuse(path, fmt::format("its decoder gave up ({})", decoder.whyItEnded()),
           "get an intact copy of the file");
}

} // namespace

ReadResult readVolume(const std::filesystem::path& path, const ReadOptions& options) {
    DecoderProcess decoder({path, options});
    ReadResult result = finalAnswer(decoder, path).result;
    Volume& volume = result.volume;
    volume.path = path;
    try {
        const auto dims = volume.geometry.dims;
        volume.bytes = decoder.voxels(checkedBytes(path, {dims.x, dims.y, dims.z}, sizeOf(volume.type)));
    } catch (const std::bad_alloc&) {
        refuse(path, "it does not fit into memory", "crop it or use a machine with more");
    } catch (const ReadError&) {
        throw;
    } catch (const Error& error) {
        refuse(path, fmt::format("its decoder gave {}", error.what()), "get an intact copy of the file");
    }
    return result;
}

} // namespace vs::volume
