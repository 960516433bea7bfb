// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/cell_ranges.h"
#include "field/scene.h"
#include "gl/program.h"
#include "render/classification.h"

namespace vs::render {

// What can be seen in which macrocell: per 4^3 cell the Chebyshev distance, in cells, to the nearest one that
// may hold something visible (0: this one may; at most kFar). Knows displayed range or transfer function,
// sculpture and segmentation.
class Macrocells {
public:
    static constexpr int kFar = 24;

    Macrocells();

    struct Input {
        const gl::Texture* dataCells = nullptr;         // field::CellRanges::cells
        const gl::Texture* sculptureCells = nullptr;    // null: nothing cut
        const gl::Texture* segmentationCells = nullptr; // null: segmentation is not drawn
        Range displayedRange;
        double valueTolerance = 0; // field::valueTolerance
        field::SculptureView view = field::SculptureView::Cut;
        bool drawsData = true; // false: only the segmentation counts
        // Volume mode: its opacity says what can be seen, not the displayed range.
        const Classification* classification = nullptr;
    };
    // Recomputes everything. The data's cells must outlive this.
    void rebuild(const Input& input);

    // Becomes what `other` is now.
    void copyFrom(const Macrocells& other);

    // Binds the distances as texture 3 and the data's cell ranges as texture 4 (render/shaders/rays.glsl,
    // maximum.glsl).
    void bind() const;

private:
    gl::Program classify_;
    gl::Program spread_;
    gl::Texture distances_;
    gl::Texture scratch_;
    const gl::Texture* dataCells_ = nullptr;
    gl::Texture empty_;
};

} // namespace vs::render
