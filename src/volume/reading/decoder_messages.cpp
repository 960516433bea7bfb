// SPDX-License-Identifier: Apache-2.0
#include "volume/reading/decoder_messages.h"

#include "base/cbor.h"
#include "base/error.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <utility>

namespace vs::volume {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostBytes = std::size_t(1) << 26; // of a message: notices about thousands of files

Json packed(const glm::ivec3& v) { return Json::array({v.x, v.y, v.z}); }
Json packed(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }
Json packed(const glm::dvec2& v) { return Json::array({v.x, v.y}); }
template <typename T>
Json packed(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}

// A whole number that T can hold.
template <std::integral T>
T wholeOf(const Json& json) {
    const bool fits = json.is_number_unsigned()  ? std::in_range<T>(json.get<std::uint64_t>())
                      : json.is_number_integer() ? std::in_range<T>(json.get<std::int64_t>())
                                                 : false;
    if (!fits) {
        throw Error("{} where a whole number should be", json.type_name());
    }
    return json.get<T>();
}

glm::ivec3 ivec3Of(const Json& json) {
    return {wholeOf<int>(json.at(0)), wholeOf<int>(json.at(1)), wholeOf<int>(json.at(2))};
}
glm::dvec3 dvec3Of(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}
template <typename T>
std::optional<T> optionalOf(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional(json.get<T>());
}
std::optional<int> optionalWholeOf(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional(wholeOf<int>(json));
}

Json packed(const ReadOptions& options) {
    Json json{{"series", packed(options.series)},
              {"frame", packed(options.frame)},
              {"level", packed(options.level)},
              {"channel", packed(options.channel)}};
    if (options.slices) {
        json["slices"] = Json::array({options.slices->first, options.slices->count});
    }
    if (options.raw) {
        json["raw"] = {{"dims", packed(options.raw->dims)},
                       {"type", int(options.raw->type)},
                       {"spacing", packed(options.raw->spacing)},
                       {"offset", options.raw->offsetBytes}};
    }
    return json;
}

ScalarType typeOf(const Json& json) {
    const int type = wholeOf<int>(json);
    if (type < 0 || type > int(ScalarType::Float32)) {
        throw Error("there is no type {}", type);
    }
    return ScalarType(type);
}

ReadOptions optionsOf(const Json& json) {
    ReadOptions options;
    options.series = optionalOf<std::string>(json.at("series"));
    options.frame = optionalWholeOf(json.at("frame"));
    options.level = optionalWholeOf(json.at("level"));
    options.channel = optionalWholeOf(json.at("channel"));
    if (json.contains("slices")) {
        const Json& slices = json.at("slices");
        options.slices = {wholeOf<int>(slices.at(0)), wholeOf<int>(slices.at(1))};
    }
    if (json.contains("raw")) {
        const Json& raw = json.at("raw");
        options.raw = {ivec3Of(raw.at("dims")), typeOf(raw.at("type")), dvec3Of(raw.at("spacing")),
                       wholeOf<std::size_t>(raw.at("offset"))};
    }
    return options;
}

Json packed(const SeriesChoice& choice) {
    return {{"uid", choice.uid},
            {"description", choice.description},
            {"modality", choice.modality},
            {"size", Json::array({choice.size.x, choice.size.y})},
            {"pixelSpacing", choice.pixelSpacing ? packed(*choice.pixelSpacing) : Json()},
            {"sliceSpacing", packed(choice.sliceSpacing)},
            {"images", choice.images}};
}

SeriesChoice choiceOf(const Json& json) {
    SeriesChoice choice;
    choice.uid = json.at("uid").get<std::string>();
    choice.description = json.at("description").get<std::string>();
    choice.modality = json.at("modality").get<std::string>();
    choice.size = {wholeOf<int>(json.at("size").at(0)), wholeOf<int>(json.at("size").at(1))};
    if (const Json& spacing = json.at("pixelSpacing"); !spacing.is_null()) {
        choice.pixelSpacing = {spacing.at(0).get<double>(), spacing.at(1).get<double>()};
    }
    choice.sliceSpacing = optionalOf<double>(json.at("sliceSpacing"));
    choice.images = wholeOf<int>(json.at("images"));
    return choice;
}

Json packed(const ScanDetails& details) {
    return {{"format", details.format},     {"patient", details.patient},
            {"study", details.study},       {"series", details.series},
            {"modality", details.modality}, {"isAngiography", details.isAngiography},
            {"slope", details.slope},       {"intercept", details.intercept},
            {"frame", details.frame},       {"frames", details.frames},
            {"slices", details.slices},     {"interpolated", details.interpolated}};
}

ScanDetails detailsOf(const Json& json) {
    ScanDetails details;
    details.format = json.at("format").get<std::string>();
    details.patient = json.at("patient").get<std::string>();
    details.study = json.at("study").get<std::string>();
    details.series = json.at("series").get<std::string>();
    details.modality = json.at("modality").get<std::string>();
    details.isAngiography = json.at("isAngiography").get<bool>();
    details.slope = json.at("slope").get<double>();
    details.intercept = json.at("intercept").get<double>();
    details.frame = wholeOf<int>(json.at("frame"));
    details.frames = wholeOf<int>(json.at("frames"));
    details.slices = wholeOf<int>(json.at("slices"));
    for (const Json& slice : json.at("interpolated")) {
        details.interpolated.push_back(wholeOf<int>(slice));
    }
    return details;
}

Json packed(const GridGeometry& geometry) {
    Json matrix = Json::array();
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            matrix.push_back(geometry.worldFromVoxel[column][row]);
        }
    }
    return {{"dims", packed(geometry.dims)}, {"worldFromVoxel", std::move(matrix)}};
}

GridGeometry geometryOf(const Json& json) {
    GridGeometry geometry;
    geometry.dims = ivec3Of(json.at("dims"));
    if (glm::any(glm::lessThan(geometry.dims, glm::ivec3(1)))) {
        throw Error("a volume without voxels");
    }
    for (std::size_t i = 0; i < 16; ++i) {
        const double number = json.at("worldFromVoxel").at(i).get<double>();
        if (!std::isfinite(number)) {
            throw Error("a place that is not finite");
        }
        geometry.worldFromVoxel[int(i / 4)][int(i % 4)] = number;
    }
    return geometry;
}

Json packed(const SegmentationOrder& order) {
    Json segments = Json::array();
    for (const DicomSegment& segment : order.segments) {
        segments.push_back(
            {{"label", segment.label}, {"name", segment.name}, {"colour", packed(segment.colour)}});
    }
    return {{"grid", packed(order.geometry)},
            {"segments", std::move(segments)},
            {"source", order.source.string()},
            {"reading", packed(order.reading)}};
}

SegmentationOrder orderOf(const Json& json) {
    SegmentationOrder order{
        geometryOf(json.at("grid")), {}, json.at("source").get<std::string>(), optionsOf(json.at("reading"))};
    for (const Json& segment : json.at("segments")) {
        order.segments.push_back({wholeOf<std::uint8_t>(segment.at("label")),
                                  segment.at("name").get<std::string>(), dvec3Of(segment.at("colour"))});
    }
    return order;
}

Json packed(const Volume& volume) {
    return {{"grid", packed(volume.geometry)},
            {"type", int(volume.type)},
            {"range", Json::array({volume.range.lo, volume.range.hi})},
            {"usual", Json::array({volume.usual.lo, volume.usual.hi})},
            {"nonFinite", volume.nonFiniteCount},
            {"name", volume.name},
            {"unit", volume.unit},
            {"details", packed(volume.details)}};
}

Volume volumeOf(const Json& json) {
    Volume volume;
    volume.geometry = geometryOf(json.at("grid"));
    volume.type = typeOf(json.at("type"));
    volume.range = {json.at("range").at(0).get<double>(), json.at("range").at(1).get<double>()};
    volume.usual = {json.at("usual").at(0).get<double>(), json.at("usual").at(1).get<double>()};
    volume.nonFiniteCount = wholeOf<std::size_t>(json.at("nonFinite"));
    volume.name = json.at("name").get<std::string>();
    volume.unit = json.at("unit").get<std::string>();
    volume.details = detailsOf(json.at("details"));
    return volume;
}

struct Packer {
    Json operator()(const DecodeShare& answer) const { return {{"share", packed(answer.share)}}; }
    Json operator()(const DecodeRefusal& answer) const {
        Json choices = Json::array();
        for (const SeriesChoice& choice : answer.choices) {
            choices.push_back(packed(choice));
        }
        return {{"refused", answer.message}, {"usage", answer.isUsage}, {"choices", std::move(choices)}};
    }
    Json operator()(const DecodedVolume& answer) const {
        return {{"volume", packed(answer.result.volume)}, {"notices", answer.result.notices}};
    }
    Json operator()(const DecodedPicture& answer) const {
        return {{"picture", Json::array({answer.size.x, answer.size.y})}};
    }
    Json operator()(const MadeSegmentation& answer) const {
        return {{"segmentation", answer.bytes}, {"sources", answer.sources}};
    }
    Json operator()(const OpenedLevels& answer) const {
        Json grids = Json::array();
        for (const GridGeometry& grid : answer.grids) {
            grids.push_back(packed(grid));
        }
        return {{"levels", std::move(grids)}, {"type", int(answer.type)}};
    }
    Json operator()(const FileNames& answer) const {
        Json names = Json::array();
        for (const std::string& name : answer.names) {
            names.push_back(name);
        }
        return {{"files", std::move(names)}};
    }
    Json operator()(const SentValues& answer) const {
        return {{"values", answer.bytes},
                {"type", int(answer.type)},
                {"side", answer.side},
                {"cells", packed(answer.cells)}};
    }
};

struct RequestPacker {
    Json operator()(const DecodeRequest& request) const {
        return {{"path", request.path.string()}, {"options", packed(request.options)}};
    }
    Json operator()(const PictureRequest& request) const { return {{"picture", request.path.string()}}; }
    Json operator()(const SegmentationRequest& request) const {
        return {{"segmentation", packed(request.order)}};
    }
    Json operator()(const LevelsRequest& request) const {
        return {{"levels", request.path.string()}, {"options", packed(request.options)}};
    }
    Json operator()(const BoxRequest& request) const {
        return {{"box", request.level}, {"lo", packed(request.box.lo)}, {"hi", packed(request.box.hi)}};
    }
    Json operator()(const ExtremesRequest& request) const { return {{"extremes", request.isAllHere}}; }
    Json operator()(const DescriptionRequest& request) const {
        return {{"description", request.path.string()}};
    }
    Json operator()(const FilesRequest& request) const {
        Json json = (*this)(request.of);
        json["files"] = true;
        json["isOfExtremes"] = request.isOfExtremes;
        return json;
    }
};

DecoderRequest requestOf(const Json& json) {
    if (json.contains("picture")) {
        return PictureRequest{json.at("picture").get<std::string>()};
    }
    if (json.contains("segmentation")) {
        return SegmentationRequest{orderOf(json.at("segmentation"))};
    }
    if (json.contains("levels")) {
        return LevelsRequest{json.at("levels").get<std::string>(), optionsOf(json.at("options"))};
    }
    if (json.contains("description")) {
        return DescriptionRequest{json.at("description").get<std::string>()};
    }
    if (json.contains("box")) {
        const BoxRequest box{wholeOf<int>(json.at("box")), {ivec3Of(json.at("lo")), ivec3Of(json.at("hi"))}};
        if (json.contains("files")) {
            return FilesRequest{box, json.at("isOfExtremes").get<bool>()};
        }
        return box;
    }
    if (json.contains("extremes")) {
        return ExtremesRequest{json.at("extremes").get<bool>()};
    }
    return DecodeRequest{json.at("path").get<std::string>(), optionsOf(json.at("options"))};
}

DecodedPicture pictureOf(const Json& json) {
    const DecodedPicture picture{{wholeOf<int>(json.at(0)), wholeOf<int>(json.at(1))}};
    if (glm::any(glm::lessThan(picture.size, glm::ivec2(1)))) {
        throw Error("a picture without pixels");
    }
    return picture;
}

OpenedLevels levelsOf(const Json& json) {
    OpenedLevels levels{{}, typeOf(json.at("type"))};
    for (const Json& grid : json.at("levels")) {
        levels.grids.push_back(geometryOf(grid));
    }
    if (levels.grids.empty()) {
        throw Error("a store without levels");
    }
    return levels;
}

DecoderAnswer answerOf(const Json& json) {
    if (json.contains("share")) {
        return DecodeShare{optionalOf<double>(json.at("share"))};
    }
    if (json.contains("refused")) {
        DecodeRefusal refusal{inOneLine(json.at("refused").get<std::string>()), json.at("usage").get<bool>()};
        for (const Json& choice : json.at("choices")) {
            refusal.choices.push_back(choiceOf(choice));
        }
        return refusal;
    }
    if (json.contains("picture")) {
        return pictureOf(json.at("picture"));
    }
    if (json.contains("segmentation")) {
        return MadeSegmentation{wholeOf<std::uint64_t>(json.at("segmentation")),
                                wholeOf<int>(json.at("sources"))};
    }
    if (json.contains("levels")) {
        return levelsOf(json);
    }
    if (json.contains("files")) {
        FileNames files;
        for (const Json& name : json.at("files")) {
            files.names.push_back(name.get<std::string>());
        }
        return files;
    }
    if (json.contains("values")) {
        return SentValues{wholeOf<std::uint64_t>(json.at("values")), typeOf(json.at("type")),
                          wholeOf<int>(json.at("side")), ivec3Of(json.at("cells"))};
    }
    DecodedVolume decoded{{volumeOf(json.at("volume")), {}}};
    for (const Json& notice : json.at("notices")) {
        decoded.result.notices.push_back(inOneLine(notice.get<std::string>()));
    }
    return decoded;
}

// What `unpack` makes of a message.
template <typename Unpack>
auto unpacked(std::span<const std::uint8_t> bytes, Unpack unpack) {
    const Json json = fromCbor(bytes);
    try {
        return unpack(json);
    } catch (const Json::exception&) {
        throw Error("a message that is none");
    }
}

} // namespace

MessageBytes pack(const DecoderRequest& request) {
    return Json::to_cbor(std::visit(RequestPacker(), request));
}

MessageBytes pack(const DecoderAnswer& answer) { return Json::to_cbor(std::visit(Packer(), answer)); }

DecoderRequest unpackRequest(std::span<const std::uint8_t> bytes) { return unpacked(bytes, requestOf); }

DecoderAnswer unpackAnswer(std::span<const std::uint8_t> bytes) { return unpacked(bytes, answerOf); }

void MessageCollector::add(std::span<const std::uint8_t> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<MessageBytes> MessageCollector::next() {
    constexpr std::size_t head = 4;
    if (bytes_.size() < head) {
        return {};
    }
    std::size_t length = 0;
    for (std::size_t i = 0; i < head; ++i) {
        length |= std::size_t(bytes_[i]) << (8 * i);
    }
    if (length > kMostBytes) {
        throw Error("a message of {} bytes", length);
    }
    if (bytes_.size() < head + length) {
        return {};
    }
    const auto begin = bytes_.begin() + head;
    MessageBytes message(begin, begin + std::ptrdiff_t(length));
    bytes_.erase(bytes_.begin(), begin + std::ptrdiff_t(length));
    return message;
}

std::size_t MessageCollector::take(std::span<std::byte> out) {
    const std::size_t count = std::min(out.size(), bytes_.size());
    std::copy_n(std::as_bytes(std::span(bytes_)).begin(), count, out.begin());
    bytes_.erase(bytes_.begin(), bytes_.begin() + std::ptrdiff_t(count));
    return count;
}

MessageBytes framed(const MessageBytes& message) {
    if (message.size() > kMostBytes) {
        throw Error("a message of {} bytes", message.size());
    }
    constexpr std::size_t head = 4;
    MessageBytes bytes(head + message.size());
    for (std::size_t i = 0; i < head; ++i) {
        bytes[i] = std::uint8_t(message.size() >> (8 * i));
    }
    std::copy(message.begin(), message.end(), bytes.begin() + head);
    return bytes;
}

} // namespace vs::volume
