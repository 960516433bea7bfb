// SPDX-License-Identifier: Apache-2.0
#include "sculpt/mask/mask_image.h"

#include "base/error.h"
#include "base/math.h"

#include <algorithm>

namespace vs::sculpt {

namespace {

bool hasTransparency(const image::Image& picture) {
    for (std::size_t n = 3; n < picture.rgba.size(); n += 4) {
        if (picture.rgba[n] < 255) {
            return true;
        }
    }
    return false;
}

float coverage(const std::uint8_t* pixel, bool isAlpha) {
    const float value =
        isAlpha ? float(pixel[3])
                : 0.2126F * float(pixel[0]) + 0.7152F * float(pixel[1]) + 0.0722F * float(pixel[2]);
    return value / 255;
}

} // namespace

MaskRaster maskFromImage(const image::Image& picture, double width, double pitch) {
    if (picture.width < 1 || picture.height < 1) {
        throw Error("a picture of no pixels makes no mask");
    }
    const bool isAlpha = hasTransparency(picture);
    const double pixel = width / picture.width;
    const int block = std::clamp(int(pitch / pixel + 1e-6), 1, std::max(picture.width, picture.height));
    MaskRaster mask;
    mask.pitch = pixel * block;
    mask.size = {divideUp(picture.width, block) + 2, divideUp(picture.height, block) + 2};
    mask.values.assign(std::size_t(mask.size.x) * std::size_t(mask.size.y), 0.0F);
    // Element (1, 1) is the block of pixels in the picture's lower left corner.
    mask.origin = -0.5 * pixel * glm::dvec2(picture.width, picture.height) - 0.5 * mask.pitch;
    const float share = 1.0F / float(block * block);
    for (int y = 0; y < picture.height; ++y) {
        const std::size_t row = std::size_t((picture.height - 1 - y) / block + 1) * std::size_t(mask.size.x);
        for (int x = 0; x < picture.width; ++x) {
            mask.values[row + std::size_t(x / block + 1)] += share * coverage(picture.pixel(x, y), isAlpha);
        }
    }
    for (float& value : mask.values) {
        value = std::min(value, 1.0F);
    }
    return mask;
}

} // namespace vs::sculpt
