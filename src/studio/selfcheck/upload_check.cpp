// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "gl/buffer.h"

#include <cmath>
#include <limits>

namespace vs::studio {

namespace {

template <typename Texel>
std::vector<double> uploadedValues(const field::Field& field, const Box3& box, double unit) {
    const auto bytes = field.texels.download(box);
    std::vector<Texel> texels(bytes.size() / sizeof(Texel));
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<std::byte*>(texels.data()));
    std::vector<double> values;
    for (const Texel texel : texels) {
        const double value =
            double(texel) / unit * (unit > 1 ? double(field.valueScale) : 1) + double(field.valueOffset);
        values.push_back(field.isIntegral ? std::round(value) : value);
    }
    return values;
}

std::vector<double> uploadedValues(const field::Field& field, const Box3& box) {
    switch (field.texels.format()) {
    case gl::Format::R8:
        return uploadedValues<std::uint8_t>(field, box, 255);
    case gl::Format::R16:
        return uploadedValues<std::uint16_t>(field, box, 65535);
    default:
        return uploadedValues<float>(field, box, 1);
    }
}

// The least and the greatest value of a type that a float holds exactly.
template <typename T>
std::pair<int, int> exactEnds() {
    constexpr std::int64_t most = 1 << 24;
    return {int(std::max<std::int64_t>(std::numeric_limits<T>::min(), -most)),
            int(std::min<std::int64_t>(std::numeric_limits<T>::max(), most))};
}

std::pair<int, int> exactEnds(volume::ScalarType type) {
    using enum volume::ScalarType;
    switch (type) {
    case UInt8:
        return exactEnds<std::uint8_t>();
    case Int8:
        return exactEnds<std::int8_t>();
    case UInt16:
        return exactEnds<std::uint16_t>();
    case Int16:
        return exactEnds<std::int16_t>();
    case UInt32:
        return exactEnds<std::uint32_t>();
    case Int32:
    case Float32:
        break;
    }
    return exactEnds<std::int32_t>();
}

void compareUploaded(Tally& tally, const volume::Volume& volume, const field::Field& field, const Box3& box) {
    std::vector<double> expected;
    forEachVoxel(box, [&](glm::ivec3 v, std::size_t) { expected.push_back(volume.at(v)); });
    const auto found = uploadedValues(field, box);
    tally.compareAll(std::span<const double>(found), std::span<const double>(expected));
}

void checkQuadTexels(Tally& tally, const volume::Volume& volume, const field::Field& field) {
    const auto texels = field.texels.downloadAll<std::uint16_t>();
    const auto quads = field.quads.buffer().read<std::uint16_t>(4 * texels.size());
    const glm::ivec3 dims = volume.geometry.dims;
    forEachVoxel(volume.geometry.box(), [&](glm::ivec3 v, std::size_t n) {
        for (int corner = 0; corner < 4; ++corner) {
            const glm::ivec3 there = glm::min(v + glm::ivec3(corner & 1, corner >> 1, 0), dims - 1);
            tally.compare(quads[4 * n + std::size_t(corner)], texels[indexOf(there, dims)]);
        }
    });
}

void checkBuffer(Tally& tally) {
    std::vector<std::uint32_t> words(1000);
    std::mt19937 random(5);
    for (auto& word : words) {
        word = random();
    }
    gl::Buffer buffer(words.size() * sizeof(std::uint32_t), "self check words");
    buffer.write(std::span<const std::uint32_t>(words));
    buffer.clear(400, 200);
    std::fill(words.begin() + 100, words.begin() + 150, 0U);
    const auto found = buffer.read<std::uint32_t>(words.size());
    tally.compareAll(std::span<const std::uint32_t>(found), std::span<const std::uint32_t>(words));
}

} // namespace

void checkUpload(Tally& tally) {
    constexpr glm::ivec3 dims(37, 21, 19);
    for (const auto type : volume::kScalarTypes) {
        const auto [lo, hi] = exactEnds(type);
        const auto volume = makeNoise(dims, type, lo, hi);
        const auto field = field::uploadVolume(volume);
        tally.about(std::string("values of ") + name(type));
        compareUploaded(tally, volume, field, volume.geometry.box());
        compareUploaded(tally, volume, field, {{3, 5, 7}, {20, 6, 19}});
        if (field.quads && field.texels.format() == gl::Format::R16) {
            tally.about("texels of quads");
            checkQuadTexels(tally, volume, field);
        }
    }
    auto holed = makeNoise(dims, volume::ScalarType::Float32, 0, 9);
    reinterpret_cast<float*>(holed.bytes.data())[40] = std::numeric_limits<float>::quiet_NaN();
    volume::computeRange(holed);
    tally.about("stand-ins for values that are no numbers");
    tally.compare(field::uploadVolume(holed).texels.downloadAll<float>()[40], double(field::kNonFinite));
    tally.about("words of a buffer");
    checkBuffer(tally);
}

} // namespace vs::studio
