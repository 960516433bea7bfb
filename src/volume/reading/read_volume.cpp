// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/read_volume.h"

#include "volume/io/inspect.h"
#include "volume/reading/decoder_process.h"
#include "volume/reading/store_bricks.h"
#include "volume/reading/web_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

namespace vs::volume {

namespace {

// The level is fetched first, and read from where it then lies.
ReadResult readFromWeb(const std::filesystem::path& address, const ReadOptions& options) {
    const StoreBricks store(address, options);
    store.fetchLevel(options.level.value_or(0));
    const std::string folder = store.folder().string();
    const auto named = [&](std::string text) { // what is said is said of the address
        const auto at = text.find(folder);
        return at == std::string::npos ? text : text.replace(at, folder.size(), address.string());
    };
    try {
        ReadResult result = readVolume(store.folder(), options);
        result.volume.path = address;
        std::transform(result.notices.begin(), result.notices.end(), result.notices.begin(), named);
        return result;
    } catch (const ReadError& error) {
        throw ReadError("{}", named(error.what()));
    }
}

} // namespace

ReadResult readVolume(const std::filesystem::path& path, const ReadOptions& options) {
    if (isWebAddress(path)) {
        return readFromWeb(path, options);
    }
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
