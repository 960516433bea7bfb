// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/cell_ranges.h"
#include "field/scene.h"
#include "gl/program.h"
#include "gl/texel_buffer.h"
#include "render/colours/classification.h"

#include <memory>
#include <optional>

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
        std::uint64_t dataSerial = 0;                   // of these ranges: others have another
        const gl::Texture* sculptureCells = nullptr;    // null: nothing cut
        const gl::Texture* segmentationCells = nullptr; // null: segmentation is not drawn
        const gl::Texture* filledCells = nullptr;       // field::FilledCells::filled(); null: no material
        Range visibleRange; // what is visible of the values, with field::withTolerance()
        field::SculptureView view = field::SculptureView::Cut;
        bool drawsData = true; // false: only the segmentation counts
        // The B-spline of tricubic sampling reaches a voxel further, into the cells around.
        field::Sampling sampling = field::Sampling::Trilinear;
        // Volume mode: its opacity says what can be seen, not the displayed range.
        const Classification* classification = nullptr;
        // Finer levels are drawn, whose gradients may be steeper than the scene's.
        bool isFiner = false;
        bool hasFinerSegments = false; // which are a little more or less than the scene's
        // The voxels outside of which all ranges are what they were at the last rebuild(), all else being the
        // same; nothing: anything may be different.
        std::optional<Box3> changed = {};
    };
    // Brings everything up to date: where the same cells may hold something as before, which is soon known,
    // nothing changes. The data's cells must outlive this and stay as they are.
    void rebuild(const Input& input);

    // Becomes what `other` is now.
    void copyFrom(const Macrocells& other);

    // R32UI: the distances.
    [[nodiscard]] const gl::Texture& distances() const { return distances_; }
    // How many cells there are along each axis.
    [[nodiscard]] glm::ivec3 size() const { return distances_.size(); }
    // A number that moves on with every change and is no other object's.
    [[nodiscard]] std::uint64_t version() const { return version_; }

    // Binds the distances as texture 3 and as texture 4 what samples in each cell can give: the data's cell
    // ranges, with tricubic sampling those of the cells around too (render/shaders/rays.glsl, maximum.glsl).
    void bind() const;

private:
    // The ranges that tricubic samples can have in each cell of `dataCells`, made when first asked for.
    const gl::Texture& dilated(const Input& input);

    bool classify(const Input& input, const Box3& box);
    void countDistances();
    void spread(glm::ivec3 blocks, int from, int to, gl::Program& program);

    gl::ProgramVariants classify_{"render/shaders/classify_cells.comp"};
    gl::Program spreadInPlane_;
    gl::Program spreadAlongZ_;
    gl::Program countSteps_;
    gl::Texture distances_;
    gl::TexelBuffer planes_;                 // see shaders/cell_bits.glsl
    bool havePlanes_ = false;                // the first of which is what the distances are from
    gl::Buffer isOther_;                     // whether a classification was another than the one before
    const gl::Texture* dataCells_ = nullptr; // what samples can give: the data's, or dilated_
    gl::ProgramVariants dilate_{"render/shaders/dilate_ranges.comp"};
    const gl::Texture* dilatedFrom_ = nullptr;
    std::uint64_t dilatedSerial_ = 0;      // of the ranges that it was made from
    std::shared_ptr<gl::Texture> dilated_; // shared with copies
    gl::Texture empty_;
    std::uint64_t version_ = 0;
};

} // namespace vs::render
