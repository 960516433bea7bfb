// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/cell_ranges.h"
#include "render/rays/picker.h"
#include "render/rays/ray_caster.h"

namespace vs::test {

// One volume and one view of it: enough for pictures and surface points.
struct Still {
    Still(volume::Volume v, Range range, const render::Camera& camera, glm::ivec2 size,
          field::Sampling sampling = field::Sampling::Trilinear)
        : volume(std::move(v)), field(field::uploadVolume(volume)), cells(field::computeCellRanges(field)) {
        frame.scene.data = &field;
        frame.scene.displayedRange = range;
        frame.scene.greyWindow = field.range;
        frame.scene.sampling = sampling;
        frame.macrocells = &macrocells;
        frame.rays = render::viewRays(camera, volume.geometry, size);
        input.dataCells = &cells.cells;
        input.visibleRange = field::withTolerance(range, field);
        input.view = frame.scene.view;
        input.sampling = sampling;
        macrocells.rebuild(input);
    }
    Still(const Still&) = delete;
    Still& operator=(const Still&) = delete;

    // From now on nothing is skipped: plain marching.
    void skipNothing() {
        input.visibleRange = {-1e9, 1e9};
        macrocells.rebuild(input);
    }

    image::Image picture(render::Mode mode) {
        frame.mode = mode;
        caster.render(frame);
        return caster.readPicture();
    }

    volume::Volume volume;
    field::Field field;
    field::CellRanges cells;
    render::Macrocells::Input input;
    render::Macrocells macrocells;
    render::RayCaster caster;
    render::Picker picker;
    render::Frame frame;
};

} // namespace vs::test
