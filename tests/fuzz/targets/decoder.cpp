// SPDX-License-Identifier: Apache-2.0
// What the decoder says to the programs and they to it: a decoder that a file has taken over says anything.
// And what else is read of strangers' files beside voxels: names and colours of labels, pictures.
#include "target.h"

#include "base/text.h"
#include "image/image.h"
#include "volume/reading/decoder_messages.h"
#include "volume/reading/label_looks.h"

#include <cmath>
#include <sstream>

namespace vs::fuzz {
namespace {

using namespace volume;

void requireSound(const GridGeometry& geometry) {
    require(glm::all(glm::greaterThanEqual(geometry.dims, glm::ivec3(1))), "a grid without voxels");
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            require(std::isfinite(geometry.worldFromVoxel[column][row]), "a place must be finite");
        }
    }
}

struct AnswerCheck {
    void operator()(const DecodeShare&) const {}
    void operator()(const DecodeRefusal& refusal) const { requireOneLine(refusal.message); }
    void operator()(const DecodedVolume& decoded) const {
        const Volume& volume = decoded.result.volume;
        requireSound(volume.geometry);
        require(volume.type >= ScalarType::UInt8 && volume.type <= ScalarType::Float32, "an unknown type");
        require(volume.bytes.empty(), "voxels go another way");
    }
    void operator()(const DecodedPicture& picture) const {
        require(picture.size.x >= 1 && picture.size.y >= 1, "a picture without pixels");
    }
    void operator()(const MadeSegmentation&) const {}
    void operator()(const OpenedLevels& opened) const {
        require(!opened.grids.empty(), "a store without levels");
        for (const GridGeometry& grid : opened.grids) {
            requireSound(grid);
        }
        require(opened.type >= ScalarType::UInt8 && opened.type <= ScalarType::Float32, "an unknown type");
    }
    void operator()(const SentValues&) const {} // StoreBricks compares them with what was asked for
    void operator()(const FileNames&) const {}  // and these with what may be fetched
};

struct RequestCheck {
    void operator()(const DecodeRequest&) const {}
    void operator()(const PictureRequest&) const {}
    void operator()(const SegmentationRequest& request) const { requireSound(request.order.geometry); }
    void operator()(const LevelsRequest&) const {}
    void operator()(const BoxRequest&) const {} // StoreLevels refuses boxes that lead out of a level
    void operator()(const ExtremesRequest&) const {}
    void operator()(const DescriptionRequest&) const {}
    void operator()(const FilesRequest&) const {}
};

// A message that is taken is sound, and says the same when it is written again.
template <typename Unpack, typename Check>
void checkMessage(Input message, Unpack unpack, Check check) {
    if (const auto found = unlessRefused([&] { return unpack(message); })) {
        std::visit(check, *found);
        const auto again = pack(*found);
        require(pack(unpack(again)) == again, "a message must come back as it was");
    }
}

void answer(Input input) { checkMessage(input, unpackAnswer, AnswerCheck()); }

void request(Input input) { checkMessage(input, unpackRequest, RequestCheck()); }

// A stream of messages: the first byte says in pieces of how many bytes it comes, which must not matter.
void stream(Input input) {
    const auto messagesIn = [](Input bytes, std::size_t piece) {
        std::vector<MessageBytes> found;
        MessageCollector collector;
        try {
            while (!bytes.empty()) {
                const std::size_t count = std::min(piece, bytes.size());
                collector.add(bytes.first(count));
                bytes = bytes.subspan(count);
                while (auto message = collector.next()) {
                    found.push_back(std::move(*message));
                }
            }
        } catch (const Error& error) {
            requireOneLine(error.what());
        }
        return found;
    };
    if (input.empty()) {
        return;
    }
    const auto bytes = input.subspan(1);
    const auto whole = messagesIn(bytes, std::max<std::size_t>(1, bytes.size()));
    require(messagesIn(bytes, std::size_t(1) + input[0]) == whole,
            "pieces of another size make other messages");
    for (const MessageBytes& message : whole) {
        answer(message);
    }
}

void labels(Input input) {
    std::istringstream file(std::string(input.begin(), input.end()));
    for (const auto& [value, look] : labelLooksIn(file)) {
        constexpr std::size_t longest = 200;
        require(look.name.size() <= longest, "a name of {} characters", look.name.size());
        if (!look.name.empty()) {
            requireOneLine(look.name);
        }
        require(look.name == readableName(look.name, longest), "a name must be UTF-8");
        if (look.colour) {
            for (int i = 0; i < 3; ++i) {
                require((*look.colour)[i] >= 0 && (*look.colour)[i] <= 1, "a colour of {}",
                        (*look.colour)[i]);
            }
        }
    }
}

void picture(Input input) {
    const auto path = fileWith("picture.png", input);
    // The decoder ends with what takes more than it was allowed; here that is refused.
    const auto allow = [](std::size_t bytes) {
        constexpr std::size_t most = std::size_t(64) << 20;
        if (bytes > most) {
            throw ReadError("a picture of {} bytes; 64 MB are enough here", bytes);
        }
    };
    if (const auto found = unlessRefused([&] { return image::readPng(path, allow); })) {
        require(found->width >= 1 && found->height >= 1, "{} x {} pixels", found->width, found->height);
        require(found->rgba.size() == std::size_t(4) * std::size_t(found->width) * std::size_t(found->height),
                "{} bytes of pixels", found->rgba.size());
    }
}

} // namespace

std::vector<Target> decoderTargets() {
    return {{"answer", answer},
            {"request", request},
            {"stream", stream},
            {"labels", labels},
            {"picture", picture}};
}

} // namespace vs::fuzz
