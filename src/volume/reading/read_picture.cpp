// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/read_picture.h"

#include "base/error.h"
#include "volume/reading/decoder_process.h"

#include <cstring>

namespace vs::volume {

image::Image readPicture(const std::filesystem::path& path) {
    DecoderProcess decoder(PictureRequest{path});
    const glm::ivec2 size = decoder.finalAnswer<DecodedPicture>(path).size;
    try {
        const auto pixels = decoder.content(4 * std::size_t(size.x) * std::size_t(size.y));
        image::Image picture(size.x, size.y);
        std::memcpy(picture.rgba.data(), pixels.data(), pixels.size());
        return picture;
    } catch (const Error& error) {
        throw ReadError("{}: its decoder gave {}; get an intact copy of the file", path.string(),
                        error.what());
    }
}

} // namespace vs::volume
