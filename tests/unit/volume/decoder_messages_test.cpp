// SPDX-License-Identifier: Apache-2.0
// What the program and its decoder say to one another.
#include "base/error.h"
#include "property.h"
#include "volume/reading/decoder_messages.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>

namespace vs::volume {
namespace {

ReadResult anyResult() {
    ReadResult result;
    Volume& volume = result.volume;
    volume.geometry = makeGeometry({3, 4, 5}, {0.1, 1.0 / 3, 7e-5});
    volume.geometry.worldFromVoxel[3] = glm::dvec4(1e-300, -123456.789, 1e6, 1);
    volume.type = ScalarType::Int32;
    volume.range = {-1e30, 3.25};
    volume.nonFiniteCount = 17;
    volume.name = "a\n\xff";
    volume.unit = "HU";
    volume.details.patient = "M\xc3\xbcller";
    volume.details.isAngiography = true;
    volume.details.slope = 0.1;
    volume.details.interpolated = {1, 4, 9};
    result.notices = {"one", ""};
    return result;
}

TEST(DecoderMessages, ComeBackAsTheyWere) {
    const ReadResult result = anyResult();
    const auto bytes = pack(DecoderAnswer(DecodedVolume{result}));
    const auto back = std::get<DecodedVolume>(unpackAnswer(bytes)).result;
    EXPECT_EQ(back.volume.geometry, result.volume.geometry);
    EXPECT_EQ(back.volume.range.lo, result.volume.range.lo);
    EXPECT_EQ(back.volume.nonFiniteCount, 17U);
    EXPECT_EQ(back.volume.name, result.volume.name);
    EXPECT_EQ(back.volume.details.patient, result.volume.details.patient);
    EXPECT_EQ(back.volume.details.slope, 0.1);
    EXPECT_EQ(back.volume.details.interpolated, result.volume.details.interpolated);
    EXPECT_EQ(back.notices, result.notices);

    DecodeRequest request{"/a/\xff", {}};
    request.options.raw = parseRawLayout("4x5x6:int16:1,2,3:7");
    request.options.series = "1.2.3";
    request.options.frame = 4;
    const auto asked = std::get<DecodeRequest>(unpackRequest(pack(DecoderRequest(request))));
    EXPECT_EQ(asked.path, request.path);
    EXPECT_EQ(asked.options.raw->dims, request.options.raw->dims);
    EXPECT_EQ(asked.options.raw->offsetBytes, 7U);
    EXPECT_EQ(asked.options.series, "1.2.3");
    EXPECT_EQ(asked.options.frame, 4);

    const auto picture =
        std::get<PictureRequest>(unpackRequest(pack(DecoderRequest(PictureRequest{"/b.png"}))));
    EXPECT_EQ(picture.path, "/b.png");
    SegmentationRequest order{
        {makeGeometry({2, 3, 4}, {1, 2, 3}), {{7, "Leber", {0.1, 0.2, 0.3}}}, "/c", {}}};
    order.order.reading.series = "2";
    const auto made = std::get<SegmentationRequest>(unpackRequest(pack(DecoderRequest(order)))).order;
    EXPECT_EQ(made.geometry, order.order.geometry);
    ASSERT_EQ(made.segments.size(), 1U);
    EXPECT_EQ(made.segments[0].label, 7);
    EXPECT_EQ(made.segments[0].name, "Leber");
    EXPECT_EQ(made.segments[0].colour, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_EQ(made.source, "/c");
    EXPECT_EQ(made.reading.series, "2");
    EXPECT_EQ(std::get<DecodedPicture>(unpackAnswer(pack(DecoderAnswer(DecodedPicture{{5, 6}})))).size,
              glm::ivec2(5, 6));
    EXPECT_THROW(unpackAnswer(pack(DecoderAnswer(DecodedPicture{{5, 0}}))), Error);
    EXPECT_EQ(std::get<MadeSegmentation>(unpackAnswer(pack(DecoderAnswer(MadeSegmentation{9, 2})))).sources,
              2);

    DecodeRefusal refusal{
        "a: b; c", false, {SeriesChoice{"1.2", "d", "CT", {3, 4}, glm::dvec2(1, 2), {}, 7}}};
    const auto refused = std::get<DecodeRefusal>(unpackAnswer(pack(DecoderAnswer(refusal))));
    EXPECT_EQ(refused.message, refusal.message);
    ASSERT_EQ(refused.choices.size(), 1U);
    EXPECT_EQ(refused.choices[0].pixelSpacing, glm::dvec2(1, 2));
    EXPECT_FALSE(refused.choices[0].sliceSpacing);
}

TEST(DecoderMessages, NumbersThatAreNotWholeOrTooLargeAreDeclined) {
    using Json = nlohmann::json;
    const auto answer = [](const Json& width) {
        return unpackAnswer(Json::to_cbor({{"picture", Json::array({width, 6})}}));
    };
    EXPECT_EQ(std::get<DecodedPicture>(answer(5)).size, glm::ivec2(5, 6));
    for (const Json& width : {Json(5.5), Json(5.8e257), Json(std::int64_t(1) << 33), Json(-1), Json(true)}) {
        EXPECT_THROW(answer(width), Error) << width;
    }
}

// A decoder that was taken over can say anything: messages that are changed anywhere are declined or
// harmless.
TEST(DecoderMessages, AnyBytes) {
    const auto bytes = pack(DecoderAnswer(DecodedVolume{anyResult()}));
    test::checkProperty(2000, [&] {
        auto changed = bytes;
        const int count = *rc::gen::inRange(1, 6);
        for (int i = 0; i < count; ++i) {
            changed[*rc::gen::inRange<std::size_t>(0, changed.size())] =
                std::uint8_t(*rc::gen::inRange(0, 256));
        }
        changed.resize(*rc::gen::inRange<std::size_t>(0, changed.size() + 1));
        try {
            const auto answer = unpackAnswer(changed);
            if (const auto* decoded = std::get_if<DecodedVolume>(&answer)) {
                const Volume& volume = decoded->result.volume;
                RC_ASSERT(volume.geometry.dims.x > 0 && int(volume.type) <= int(ScalarType::Float32));
            }
        } catch (const Error&) {
        }
    });
}

TEST(DecoderMessages, WhatFollowsOneIsTakenAsItIs) {
    const MessageBytes message = pack(DecoderAnswer(DecodeShare{0.5}));
    MessageBytes bytes = framed(message);
    bytes.insert(bytes.end(), {255, 255, 255}); // no message
    MessageCollector collected;
    collected.add(bytes);
    EXPECT_EQ(collected.next(), message);
    std::array<std::byte, 2> two{};
    EXPECT_EQ(collected.take(two), 2U);
    EXPECT_EQ(two[1], std::byte(255));
    EXPECT_EQ(collected.take(two), 1U);
    EXPECT_EQ(collected.take(two), 0U);
}

} // namespace
} // namespace vs::volume
