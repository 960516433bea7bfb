// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/dicom/dicom_segmentation.h"
#include "volume/io/read.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

// What this program and its decoder (apps/decoder) say to each other: messages in CBOR, each behind its
// length in four bytes. CBOR and no JSON, since names of files need not be text. Internal to reading and the
// decoder.
namespace vs::volume {

// The descriptors that the decoder is given: a socket for messages and a file in memory for voxels, pixels,
// labels.
inline constexpr int kDecoderMessages = 3;
inline constexpr int kDecoderVoxels = 4;

using MessageBytes = std::vector<std::uint8_t>;

// A volume is wanted.
struct DecodeRequest {
    std::filesystem::path path;
    ReadOptions options;
};
// A picture is wanted (PNG).
struct PictureRequest {
    std::filesystem::path path;
};
// A DICOM segmentation is to be made of the labels that lie in the file in memory.
struct SegmentationRequest {
    SegmentationOrder order;
};
using DecoderRequest = std::variant<DecodeRequest, PictureRequest, SegmentationRequest>;

// How far the decoder is; nothing: that is not known.
struct DecodeShare {
    std::optional<double> share;
};
// Why the file is not read: the line that ReadError, or the one that UsageError, is to say.
struct DecodeRefusal {
    std::string message;
    bool isUsage = false;
    std::vector<SeriesChoice> choices = {}; // some: as SeveralSeries has them
};
// The volume without its voxels, which lie in the file in memory, and without its path.
struct DecodedVolume {
    ReadResult result;
};
// A picture of this size without its pixels, which lie in the file in memory: rows from the top, red, green,
// blue and alpha.
struct DecodedPicture {
    glm::ivec2 size{0};
};
// A segmentation, whose file lies in the file in memory behind the labels.
struct MadeSegmentation {
    std::uint64_t bytes = 0;
    int sources = 0; // files of the series that it names
};
using DecoderAnswer =
    std::variant<DecodeShare, DecodeRefusal, DecodedVolume, DecodedPicture, MadeSegmentation>;

MessageBytes pack(const DecoderRequest& request);
MessageBytes pack(const DecoderAnswer& answer);
// Both throw Error where the bytes are no such message, or make no sense: sizes below one, a type that there
// is none of.
DecoderRequest unpackRequest(std::span<const std::uint8_t> bytes);
DecoderAnswer unpackAnswer(std::span<const std::uint8_t> bytes);

// Puts messages together of what comes from a socket in pieces.
class MessageCollector {
public:
    void add(std::span<const std::uint8_t> bytes);
    // The next message that is complete. Throws Error where one would be absurdly long.
    std::optional<MessageBytes> next();

private:
    MessageBytes bytes_;
};

// A message with its length before it.
MessageBytes framed(const MessageBytes& message);

} // namespace vs::volume
