// SPDX-License-Identifier: Apache-2.0
#include "field/cell_ranges.h"

#include "field/host_cell_ranges.h"
#include "field/shaders/bindings.h"
#include "gl/context.h"
#include "gl/pass.h"

#include <span>
#include <utility>

namespace vs::field {

glm::ivec3 cellDims(glm::ivec3 dims) { return glm::max(divideUp(dims - 1, kCell), glm::ivec3(1)); }

namespace {

constexpr const char* kShader = "field/shaders/summarize_cells.comp";

void summarize(gl::Program& program, const gl::Texture& texels, glm::vec2 valueScaleOffset,
               const Box3& cellBox, gl::Texture& cells) {
    texels.bindTexture(kValuesTexture);
    cells.bindImage(kCellsImage, gl::Access::Write);
    program.set("dims", texels.size())
        .set("cellLo", cellBox.lo)
        .set("cellHi", cellBox.hi)
        .set("valueScaleOffset", valueScaleOffset);
    program.dispatchOver(cellBox.size(), gl::Barrier::Texture);
}

gl::Texture rangesOf(const gl::Texture& texels, glm::vec2 valueScaleOffset) {
    const gl::Pass pass("cell ranges");
    const glm::ivec3 count = cellDims(texels.size());
    gl::Texture cells(count, gl::Format::RG32F, gl::Filter::Nearest, "cell ranges");
    gl::Program program(kShader);
    summarize(program, texels, valueScaleOffset, {glm::ivec3(0), count}, cells);
    return cells;
}

} // namespace

CellRanges computeCellRanges(const Field& field) {
    if (field.onHost != nullptr && gl::Context::isSoftware()) {
        if (const auto ranges = hostCellRanges(*field.onHost); !ranges.empty()) {
            const glm::ivec3 count = cellDims(field.geometry.dims);
            gl::Texture cells(count, gl::Format::RG32F, gl::Filter::Nearest, "cell ranges");
            cells.upload({glm::ivec3(0), count}, std::as_bytes(std::span(ranges)));
            return {std::move(cells)};
        }
    }
    return {rangesOf(field.texels, {field.valueScale, field.valueOffset})};
}

gl::Texture computeCellRanges(const gl::Texture& texels) { return rangesOf(texels, {1, 0}); }

CellRangeUpdater::CellRangeUpdater() : program_(kShader) {}

void CellRangeUpdater::update(const gl::Texture& texels, const Box3& voxels, gl::Texture& cells) {
    const gl::Pass pass("update cell ranges");
    // A voxel on a cell border belongs to both cells.
    const Box3 touched{(voxels.lo - 1) / kCell, (voxels.hi - 1) / kCell + 1};
    const Box3 box = intersect(touched, {glm::ivec3(0), cells.size()});
    if (!box.isEmpty()) {
        summarize(program_, texels, {1, 0}, box, cells);
    }
}

} // namespace vs::field
