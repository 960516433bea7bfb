// SPDX-License-Identifier: Apache-2.0
#include "volume/io/take_values.h"

#include <fmt/format.h>

#include <cstring>
#include <optional>
#include <utility>

namespace vs::volume {
namespace {

// Returns whether rounding changed any value that is not scaled anyway.
template <typename From>
bool toFloat(const std::vector<std::byte>& from, std::vector<std::byte>& to, const Scaling& scaling) {
    const std::size_t count = from.size() / sizeof(From);
    to.resize(count * sizeof(float));
    bool changed = false;
    for (std::size_t i = 0; i < count; ++i) {
        From value;
        std::memcpy(&value, from.data() + i * sizeof(From), sizeof(From));
        if (scaling.changes()) {
            const float scaled = scaling.of(double(value));
            std::memcpy(to.data() + i * sizeof(float), &scaled, sizeof(float));
            continue;
        }
        const float narrow = static_cast<float>(value);
        // Long double holds every 64-bit integer, so the comparison is exact for all types.
        changed = changed ||
                  (static_cast<long double>(narrow) != static_cast<long double>(value) && value == value);
        std::memcpy(to.data() + i * sizeof(float), &narrow, sizeof(float));
    }
    return changed;
}

void rescale(Volume& volume, const Scaling& scaling) {
    const std::size_t count = volume.bytes.size() / sizeOf(volume.type);
    std::vector<std::byte> scaled(count * sizeof(float));
    visit(volume, [&](const auto* values) {
        auto* out = reinterpret_cast<float*>(scaled.data());
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = scaling.of(double(values[i]));
        }
    });
    volume.type = ScalarType::Float32;
    volume.bytes = std::move(scaled);
}

} // namespace

bool takeValues(Volume& volume, StoredType type, std::vector<std::byte>&& bytes, const Scaling& scaling) {
    const auto keep = [&](ScalarType kept) {
        volume.type = kept;
        volume.bytes = std::move(bytes);
        if (scaling.changes()) {
            rescale(volume, scaling);
        }
        return false;
    };
    const auto convert = [&](auto example) {
        volume.type = ScalarType::Float32;
        return toFloat<decltype(example)>(bytes, volume.bytes, scaling);
    };
    switch (type) {
    case StoredType::UInt8:
        return keep(ScalarType::UInt8);
    case StoredType::Int8:
        return keep(ScalarType::Int8);
    case StoredType::UInt16:
        return keep(ScalarType::UInt16);
    case StoredType::Int16:
        return keep(ScalarType::Int16);
    case StoredType::UInt32:
        return keep(ScalarType::UInt32);
    case StoredType::Int32:
        return keep(ScalarType::Int32);
    case StoredType::Float32:
        return keep(ScalarType::Float32);
    case StoredType::UInt64:
        return convert(std::uint64_t(0));
    case StoredType::Int64:
        return convert(std::int64_t(0));
    case StoredType::Float64:
        break;
    }
    return convert(0.0);
}

void takeFrame(const std::filesystem::path& path, Inspection& inspection, int frame, ReadResult& result,
               const Scaling& scaling) {
    const std::uint64_t frames = inspection.sizes.size() > 3 ? std::uint64_t(inspection.sizes[3]) : 1;
    const std::uint64_t count = inspection.block.count / frames;
    auto values = readValues(inspection.block, count * std::uint64_t(frame), count);
    if (takeValues(result.volume, inspection.block.type, std::move(values), scaling)) {
        result.notices.push_back(
            fmt::format("{}: 64-bit values were rounded to 32-bit floats; some changed", path.string()));
    }
    result.volume.details.frame = frame;
    result.volume.details.frames = int(frames);
}

ReadResult readPlaced(const char* format, const std::filesystem::path& path, PlacedInspection&& inspection,
                      std::optional<int> frame, const Scaling& scaling) {
    const std::int64_t frames = inspection.sizes.size() > 3 ? inspection.sizes[3] : 1;
    const int picked = chosenFrame(path, frames, frame);
    ReadResult result;
    result.notices = inspection.notices;
    result.volume.geometry = inspection.geometry;
    takeFrame(path, inspection, picked, result, scaling);
    result.volume.details.format = format;
    result.volume.details.slope = scaling.slope;
    result.volume.details.intercept = scaling.intercept;
    return result;
}

} // namespace vs::volume
