// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string_view>

// What compressed pixels themselves say of their size: decoders believe the DICOM header instead, and leave
// pixels as they were in memory, or scramble them, where it says otherwise. Internal to this folder.
namespace vs::volume {

// Columns and rows of a frame of JPEG, JPEG-LS (ITU-T T.81, T.87: the frame header) or JPEG 2000 (ITU-T
// T.800: the SIZ marker). Nothing where there is no such header.
std::optional<glm::ivec2> codedSize(std::span<const unsigned char> frame);

// Whether a frame in DICOM's run lengths (PS3.5, annex G) holds an image of so many columns and rows, of
// values of so many bytes.
bool isRunLengthOf(std::span<const unsigned char> frame, glm::ivec2 size, std::size_t bytesEach);

// Whether a transfer syntax (its UID) is one of run lengths; of the others that are read.
bool isRunLengthSyntax(std::string_view uid);
bool isJpegSyntax(std::string_view uid);

} // namespace vs::volume
