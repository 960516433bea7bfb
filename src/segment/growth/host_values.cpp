// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/host_values.h"

#include <algorithm>
#include <vector>

namespace vs::segment {

namespace {

using volume::ScalarType;

// The type of which the field's texels are the values, less an offset for signed ones.
ScalarType typeOf(const field::Field& field) {
    if (field.step > 0) {
        return ScalarType::Float32;
    }
    const bool isSigned = field.valueOffset < 0;
    switch (field.texels.format()) {
    case gl::Format::R8:
        return isSigned ? ScalarType::Int8 : ScalarType::UInt8;
    case gl::Format::R16:
        return isSigned ? ScalarType::Int16 : ScalarType::UInt16;
    default:
        return ScalarType::Float32;
    }
}

// Texels that are 2^7 or 2^15 more than the value differ from it in their highest bit.
void takeOffsetAway(volume::Volume& volume) {
    const bool isSigned = volume.type == ScalarType::Int8 || volume.type == ScalarType::Int16;
    const std::size_t size = volume::sizeOf(volume.type);
    for (std::size_t i = size - 1; isSigned && i < volume.bytes.size(); i += size) {
        volume.bytes[i] ^= std::byte(0x80);
    }
}

// Texels that count steps become values.
template <typename Texel>
std::vector<std::byte> scaled(const std::vector<std::byte>& texels, const field::Field& field) {
    std::vector<std::byte> values(texels.size() / sizeof(Texel) * sizeof(float));
    const auto* from = reinterpret_cast<const Texel*>(texels.data());
    std::transform(from, from + texels.size() / sizeof(Texel), reinterpret_cast<float*>(values.data()),
                   [&](Texel steps) { return float(field.valueOffset + steps * field.step); });
    return values;
}
void scale(volume::Volume& volume, const field::Field& field) {
    volume.bytes = field.texels.format() == gl::Format::R8 ? scaled<std::uint8_t>(volume.bytes, field)
                                                           : scaled<std::uint16_t>(volume.bytes, field);
}

} // namespace

const volume::Volume& HostValues::get() {
    if (field_->onHost != nullptr) {
        return *field_->onHost;
    }
    if (!isRead_) {
        read_.geometry = field_->geometry;
        read_.type = typeOf(*field_);
        read_.bytes = field_->texels.download({glm::ivec3(0), field_->geometry.dims});
        if (field_->step > 0) {
            scale(read_, *field_);
        } else {
            takeOffsetAway(read_);
        }
        isRead_ = true;
    }
    return read_;
}

} // namespace vs::segment
