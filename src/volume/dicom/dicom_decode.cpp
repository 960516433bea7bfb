// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/dicom_decode.h"

#include "base/large_pages.h"
#include "base/progress.h"
#include "volume/dicom/isolated_decode.h"
#include "volume/io/inspect.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>
#include <type_traits>

namespace vs::volume {
namespace {

// The smallest integer type that holds all values of both, or Float32.
ScalarType commonType(ScalarType a, ScalarType b) {
    struct Limits {
        double lo;
        double hi;
    };
    constexpr std::array<Limits, 6> limits{{{0, 255},
                                            {-128, 127},
                                            {0, 65535},
                                            {-32768, 32767},
                                            {0, 4294967295.0},
                                            {-2147483648.0, 2147483647.0}}};
    if (a == b) {
        return a;
    }
    if (a == ScalarType::Float32 || b == ScalarType::Float32) {
        return ScalarType::Float32;
    }
    const auto& la = limits[std::size_t(a)];
    const auto& lb = limits[std::size_t(b)];
    for (std::size_t type = 0; type < limits.size(); ++type) {
        if (limits[type].lo <= std::min(la.lo, lb.lo) && limits[type].hi >= std::max(la.hi, lb.hi)) {
            return ScalarType(type);
        }
    }
    return ScalarType::Float32;
}

template <typename T>
using ValueOf = std::remove_cv_t<std::remove_pointer_t<T>>;

// The first `count` values of another type. The new type holds all values of the old one.
std::vector<std::byte> converted(const Volume& volume, std::size_t first, std::size_t count,
                                 ScalarType type) {
    Volume target;
    target.type = type;
    target.bytes.resize(count * sizeOf(type));
    visit(volume, [&](const auto* from) {
        visit(target, [&](const auto* typed) {
            using To = ValueOf<decltype(typed)>;
            auto* to = reinterpret_cast<To*>(target.bytes.data());
            for (std::size_t i = 0; i < count; ++i) {
                to[i] = static_cast<To>(from[first + i]);
            }
        });
    });
    return std::move(target.bytes);
}

// One frame as 32-bit floats with its own slope and intercept in place of those applied to the whole file.
Volume rescaledFrame(const DecodedFile& file, int frame, glm::dvec2 scale) {
    Volume result;
    result.type = ScalarType::Float32;
    const auto dims = file.values.geometry.dims;
    const std::size_t count = std::size_t(dims.x) * std::size_t(dims.y);
    result.bytes.resize(count * sizeof(float));
    auto* to = reinterpret_cast<float*>(result.bytes.data());
    visit(file.values, [&](const auto* from) {
        for (std::size_t i = 0; i < count; ++i) {
            const double stored =
                (double(from[std::size_t(frame) * count + i]) - file.scale.y) / file.scale.x;
            to[i] = float(stored * scale.x + scale.y);
        }
    });
    return result;
}

// 16 bits where the values allow it: rescaling asks for 32 whenever the header's limits could need them.
void narrow(Volume& volume) {
    if (volume.type != ScalarType::Int32 && volume.type != ScalarType::UInt32) {
        return;
    }
    computeRange(volume);
    for (const auto& [type, lo, hi] :
         {std::tuple(ScalarType::UInt16, 0.0, 65535.0), std::tuple(ScalarType::Int16, -32768.0, 32767.0)}) {
        if (volume.range.lo >= lo && volume.range.hi <= hi) {
            volume.bytes = converted(volume, 0, volume.geometry.voxelCount(), type);
            volume.type = type;
            return;
        }
    }
}

} // namespace

Volume decodeSlices(const std::filesystem::path& path, const std::vector<DicomSlice>& slices) {
    const glm::ivec2 size = slices.front().size;
    const std::size_t pixels = std::size_t(size.x) * std::size_t(size.y);
    Volume result;
    result.geometry.dims = {size, int(slices.size())};
    IsolatedDecoder decoder(path, slices);
    DecodedFile decoded;
    for (std::size_t k = 0; k < slices.size(); ++k) {
        reportProgress(glm::mix(IsolatedDecoder::kDecoding, 1.0, double(k) / double(slices.size())));
        const DicomSlice& slice = slices[k];
        if (decoded.file != slice.file) {
            decoded = decoder.take(slice);
        }
        const bool ownScale = slice.frameScale && decoded.scale.x != 0 && *slice.frameScale != decoded.scale;
        Volume rescaled;
        std::size_t first = std::size_t(slice.frame) * pixels;
        if (ownScale) {
            rescaled = rescaledFrame(decoded, slice.frame, *slice.frameScale);
            first = 0;
        }
        const Volume& source = ownScale ? rescaled : decoded.values;
        const ScalarType type = k == 0 ? source.type : commonType(result.type, source.type);
        if (k == 0) {
            result.type = type;
            const auto bytes =
                checkedBytes(path, {size.x, size.y, std::int64_t(slices.size())}, sizeOf(type));
            reserveInLargePages(result.bytes, bytes);
            result.bytes.resize(bytes);
        } else if (type != result.type) {
            result.bytes = converted(result, 0, pixels * slices.size(), type);
            result.type = type;
        }
        std::byte* to = result.bytes.data() + k * pixels * sizeOf(type);
        if (source.type == type) {
            std::memcpy(to, source.bytes.data() + first * sizeOf(type), pixels * sizeOf(type));
        } else {
            const auto bytes = converted(source, first, pixels, type);
            std::memcpy(to, bytes.data(), bytes.size());
        }
    }
    narrow(result);
    return result;
}

} // namespace vs::volume
