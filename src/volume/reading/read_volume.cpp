// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/read_volume.h"

#include "volume/io/inspect.h"
#include "volume/reading/decoder_process.h"

#include <fmt/format.h>

#include <new>
#include <utility>

namespace vs::volume {

ReadResult readVolume(const std::filesystem::path& path, const ReadOptions& options) {
    DecoderProcess decoder(DecodeRequest{path, options});
    ReadResult result = decoder.finalAnswer<DecodedVolume>(path).result;
    Volume& volume = result.volume;
    volume.path = path;
    try {
        const auto dims = volume.geometry.dims;
        volume.bytes = decoder.content(checkedBytes(path, {dims.x, dims.y, dims.z}, sizeOf(volume.type)));
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
