// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/dicom/dicom_segmentation.h"
#include "volume/io/read.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

// What this program and its decoder (apps/decoder) say to each other: messages in CBOR, each behind its
// length in four bytes, and behind some of them what they tell of, byte by byte. CBOR and no JSON, since
// names of files need not be text. Internal to reading and the decoder.
namespace vs::volume {

// The descriptor that the decoder is given: a socket. Voxels go through it too, which costs a third of what
// memory that both have does (decision 0030).
inline constexpr int kDecoderSocket = 3;

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
// A DICOM segmentation is to be made of the labels that follow, a byte for each voxel of the grid.
struct SegmentationRequest {
    SegmentationOrder order;
};
// The levels of a store are wanted: what it has is answered, and then each of the two requests below, until
// nobody asks any more.
struct LevelsRequest {
    std::filesystem::path path;
    ReadOptions options; // `level` counts for nothing
};
// The values of a box of a level.
struct BoxRequest {
    int level = 0;
    Box3 box;
};
// The ranges of its CellExtremes.
struct ExtremesRequest {
    bool isAllHere = false; // a chunk without a file is empty, and not just somewhere else
};
// The names of files: those that describe the arrays of a store, of which nothing but .zattrs need be there;
// or, of a store whose levels were opened, those of a box, or of its extremes.
struct DescriptionRequest {
    std::filesystem::path path;
};
struct FilesRequest {
    BoxRequest of;
    bool isOfExtremes = false;
};
using DecoderRequest = std::variant<DecodeRequest, PictureRequest, SegmentationRequest, LevelsRequest,
                                    BoxRequest, ExtremesRequest, DescriptionRequest, FilesRequest>;

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
// The volume without its voxels, which follow, and without its path.
struct DecodedVolume {
    ReadResult result;
};
// A picture of this size without its pixels, which follow: rows from the top, red, green, blue and alpha.
struct DecodedPicture {
    glm::ivec2 size{0};
};
// A segmentation, whose file follows.
struct MadeSegmentation {
    std::uint64_t bytes = 0;
    int sources = 0; // files of the series that it names
};
// What a store has.
struct OpenedLevels {
    std::vector<GridGeometry> grids; // the finest first
    ScalarType type = ScalarType::UInt8;
};
// What a box or the extremes are, whose bytes follow: of extremes also how they lie (CellExtremes), or no
// bytes where the store has none.
struct SentValues {
    std::uint64_t bytes = 0;
    ScalarType type = ScalarType::UInt8;
    int side = 0;
    glm::ivec3 cells{0};
};
struct FileNames {
    std::vector<std::string> names;
};
using DecoderAnswer = std::variant<DecodeShare, DecodeRefusal, DecodedVolume, DecodedPicture,
                                   MadeSegmentation, OpenedLevels, SentValues, FileNames>;

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
    // What follows a message: moves as much of it as has come to the front of `out` and returns how much.
    std::size_t take(std::span<std::byte> out);

private:
    MessageBytes bytes_;
};

// A message with its length before it.
MessageBytes framed(const MessageBytes& message);

} // namespace vs::volume
