// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"

#include <filesystem>

namespace vs::volume {

// Reads a PNG that a person gives, such as a mask, in the decoder as volumes are read. Throws ReadError
// naming the file; GivenUp ends the decoder.
image::Image readPicture(const std::filesystem::path& path);

} // namespace vs::volume
