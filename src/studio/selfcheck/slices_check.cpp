// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "gl/context.h"
#include "reference/trilinear.h"
#include "render/slices/slice_renderer.h"

#include <cmath>
#include <memory>

namespace vs::studio {

namespace {

constexpr Range kGreyWindow{20, 180}; // from black to white
constexpr glm::dvec3 kBesideGrid = 255.0 * glm::dvec3(0.043, 0.051, 0.059);

// Compares a slice with the values that lie under its pixels, each in a grey of the window.
void compareSlice(Tally& tally, const volume::Volume& volume, const field::Field& field,
                  const render::SliceView& view, bool isSmooth, field::Detail* detail = nullptr) {
    render::SliceFrame frame;
    frame.scene.data = &field;
    frame.scene.displayedRange = volume.range;
    frame.window = kGreyWindow;
    frame.view = view;
    frame.isSmooth = isSmooth;
    frame.detail = detail;
    render::SliceRenderer renderer;
    renderer.render(frame);
    const auto picture = renderer.readPicture();
    const glm::ivec3 dims = volume.geometry.dims;
    const render::SliceGeometry geometry(volume.geometry, view.kind);
    tally.about(std::string(isSmooth ? "smooth grey levels, " : "grey levels of voxels, ") + name(view.kind));
    for (int y = 0; y < view.size.y; ++y) {
        for (int x = 0; x < view.size.x; ++x) {
            const glm::dvec3 p = geometry.voxelAt(view.placeAt({x + 0.5, y + 0.5}), view.index);
            const glm::dvec3 fromBorder = glm::abs(glm::fract(p) - 0.5);
            if (fromBorder[geometry.acrossAxis()] < 1e-3 || fromBorder[geometry.downAxis()] < 1e-3) {
                continue; // rounding decides which voxel it is, or whether it is one
            }
            const bool isInGrid = glm::all(glm::greaterThan(p, glm::dvec3(-0.5))) &&
                                  glm::all(glm::lessThan(p, glm::dvec3(dims) - 0.5));
            const double value =
                isSmooth ? reference::trilinearAt(volume, p)
                         : volume.at(glm::clamp(glm::ivec3(glm::floor(p + 0.5)), glm::ivec3(0), dims - 1));
            const double grey = 255 * std::clamp((value - kGreyWindow.lo) / kGreyWindow.width(), 0.0, 1.0);
            for (int c = 0; c < 3; ++c) {
                // Rounding to 8 bits, and smooth values of a filter that knows places to 8 bits only.
                tally.compare(picture.pixel(x, y)[c], isInGrid ? grey : kBesideGrid[c],
                              isSmooth && !gl::Context::isSoftware() ? 5 : 1);
            }
        }
    }
}

} // namespace

void checkSlices(Tally& tally) {
    for (const auto type :
         {volume::ScalarType::UInt8, volume::ScalarType::Int16, volume::ScalarType::Float32}) {
        auto volume = makeNoise({23, 17, 12}, type, 0, type == volume::ScalarType::UInt8 ? 200 : 220);
        turnOblique(volume);
        const auto field = field::uploadVolume(volume);
        for (const auto kind : render::kSliceKinds) {
            const render::SliceGeometry geometry(volume.geometry, kind);
            const double all = render::pixelMmToShowAll(geometry, {67, 45});
            for (const bool isSmooth : {false, true}) {
                compareSlice(tally, volume, field, {kind, 0, {0, 0}, all, {67, 45}}, isSmooth);
                compareSlice(tally, volume, field,
                             {kind, geometry.count() / 2, {1.3, -2.1}, 0.3 * all, {67, 45}}, isSmooth);
            }
        }
    }
}

// Slices again, but from bricks: of a volume's own level, which must look the same.
void checkBricks(Tally& tally) {
    for (const auto type :
         {volume::ScalarType::UInt8, volume::ScalarType::Int16, volume::ScalarType::Float32}) {
        auto volume = makeNoise({23, 17, 12}, type, 0, type == volume::ScalarType::UInt8 ? 200 : 220);
        turnOblique(volume);
        const auto field = field::uploadVolume(volume);
        field::DetailOptions options;
        options.side = 8;
        options.hasOwnLevel = true;
        options.deviceBytes = std::size_t(1) << 20;
        field::Detail detail(std::make_shared<volume::VolumeBricks>(volume, volume.geometry), volume.geometry,
                             options);
        for (const auto kind : render::kSliceKinds) {
            const render::SliceGeometry geometry(volume.geometry, kind);
            const double all = render::pixelMmToShowAll(geometry, {67, 45});
            compareSlice(tally, volume, field, {kind, geometry.count() / 2, {1.3, -2.1}, 0.3 * all, {67, 45}},
                         true, &detail);
        }
    }
}

} // namespace vs::studio
