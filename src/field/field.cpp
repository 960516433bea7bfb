// SPDX-License-Identifier: Apache-2.0
#include "field/field.h"

#include "field/whole_steps.h"
#include "gl/pass.h"

#include <atomic>
#include <cmath>
#include <type_traits>

namespace vs::field {

namespace {

template <typename Texel>
void uploadSlab(Field& field, const Box3& box, std::span<const Texel> texels) {
    field.texels.upload(box, std::as_bytes(texels));
    if (field.quads) {
        fillQuads(texels, glm::ivec2(box.size()), box.lo.z, field.quads);
    }
}

// Uploads in slabs so that no copy of the whole volume is made. `convert` turns one stored value into one
// texel.
template <typename Texel, typename Stored, typename Convert>
void uploadSlabs(Field& field, const Stored* values, Convert convert) {
    const glm::ivec3 dims = field.texels.size();
    const std::size_t slice = std::size_t(dims.x) * std::size_t(dims.y);
    const int slab = std::max(1, int((std::size_t(8) << 20) / slice));
    std::vector<Texel> texels;
    for (int z = 0; z < dims.z; z += slab) {
        const int end = std::min(z + slab, dims.z);
        const std::size_t count = slice * std::size_t(end - z);
        const Stored* source = values + slice * std::size_t(z);
        const Box3 box{{0, 0, z}, {dims.x, dims.y, end}};
        if constexpr (std::is_same_v<Texel, Stored>) {
            uploadSlab(field, box, std::span(source, count));
        } else {
            texels.resize(count);
            std::transform(source, source + count, texels.begin(), convert);
            uploadSlab(field, box, std::span<const Texel>(texels));
        }
    }
}

} // namespace

double toleranceAt(double end, const Field& field) {
    // Eight weighted texels and the affine: a few units in the last place of the largest number involved. For
    // floats that is the value itself, whatever others there are in the volume; for scaled ones it may be
    // their offset.
    const double most = std::max(std::abs(field.range.lo), std::abs(field.range.hi));
    const bool isNormalised = field.texels.format() != gl::Format::R32F;
    const double ofSteps = field.step > 0 ? most : 0;
    return 5e-7 * (isNormalised ? double(field.valueScale) + ofSteps : std::min(std::abs(end), most));
}

Range withTolerance(const Range& displayed, const Field& field) {
    return {displayed.lo - toleranceAt(displayed.lo, field), displayed.hi + toleranceAt(displayed.hi, field)};
}

std::uint64_t nextSerial() {
    static std::atomic<std::uint64_t> serials = 0;
    return ++serials;
}

Field uploadVolume(const volume::Volume& volume) {
    const gl::Pass pass("upload volume");
    Field field;
    field.serial = nextSerial();
    field.geometry = volume.geometry;
    field.range = volume.range;
    field.usual = volume.usual;
    field.isHounsfield = volume.unit == "HU";
    volume::visit(volume, [&]<typename T>(const T* values) {
        const auto make = [&](gl::Format format) {
            field.texels =
                gl::Texture(volume.geometry.dims, format, gl::Filter::Linear, "data " + volume.name);
            field.quads = makeQuads(volume.geometry.dims, format);
        };
        field.isIntegral = std::is_integral_v<T>;
        if (const auto steps = wholeStepsOf(volume)) {
            const bool isByte = steps->count <= 256;
            make(isByte ? gl::Format::R8 : gl::Format::R16);
            field.step = steps->step();
            field.valueScale = float(steps->step() * (isByte ? 255 : 65535));
            field.valueOffset = float(volume.range.lo);
            if (isByte) {
                uploadSlabs<std::uint8_t>(field, values,
                                          [&](T v) { return std::uint8_t(steps->stepsTo(float(v))); });
            } else {
                uploadSlabs<std::uint16_t>(field, values,
                                           [&](T v) { return std::uint16_t(steps->stepsTo(float(v))); });
            }
            return;
        }
        if constexpr (sizeof(T) == 1) {
            make(gl::Format::R8);
            field.valueScale = 255;
            field.valueOffset = std::is_signed_v<T> ? -128 : 0;
            uploadSlabs<std::uint8_t>(
                field, values, [](T v) { return std::uint8_t(int(v) + (std::is_signed_v<T> ? 128 : 0)); });
        } else if constexpr (sizeof(T) == 2) {
            make(gl::Format::R16);
            field.valueScale = 65535;
            field.valueOffset = std::is_signed_v<T> ? -32768 : 0;
            uploadSlabs<std::uint16_t>(
                field, values, [](T v) { return std::uint16_t(int(v) + (std::is_signed_v<T> ? 32768 : 0)); });
        } else {
            make(gl::Format::R32F);
            uploadSlabs<float>(field, values, [](T v) {
                const float f = float(v);
                return std::isfinite(f) ? f : kNonFinite;
            });
            if constexpr (std::is_same_v<T, float>) {
                if (volume.nonFiniteCount > 0) { // the fast path above uploads floats as they are
                    std::vector<float> clean(values, values + volume.geometry.voxelCount());
                    std::replace_if(
                        clean.begin(), clean.end(), [](float f) { return !std::isfinite(f); }, kNonFinite);
                    uploadSlabs<float>(field, clean.data(), [](float f) { return f; });
                }
            }
        }
    });
    return field;
}

} // namespace vs::field
