// SPDX-License-Identifier: Apache-2.0
#include "render/space/macrocells.h"

#include "gl/pass.h"
#include "render/shaders/bindings.h"

#include <atomic>

namespace vs::render {

namespace {

// Of cells; mirrors shaders/cell_bits.glsl.
constexpr glm::ivec3 kBlock{32, 4, 1};

std::uint64_t nextVersion() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

// Those of voxel centres bound only what trilinear samples have.
const gl::Texture* gradientCells(const Macrocells::Input& input) {
    return input.classification != nullptr && input.sampling == field::Sampling::Trilinear
               ? input.classification->gradientCells()
               : nullptr;
}

gl::Defines definesFor(const Macrocells::Input& input) {
    // In probe view nothing is seen while nothing is cut.
    const bool isSculpted = input.view == field::SculptureView::Probe ||
                            (input.sculptureCells != nullptr && input.view == field::SculptureView::Cut);
    return gl::switchesOn({{"VS_DATA", input.drawsData},
                           {"VS_BY_FUNCTION", input.classification != nullptr},
                           {"VS_GRADIENTS", gradientCells(input) != nullptr},
                           {"VS_SEGMENTATION", input.segmentationCells != nullptr},
                           {"VS_SCULPTURE", isSculpted}});
}

} // namespace

Macrocells::Macrocells()
    : spreadInPlane_("render/shaders/spread_cells.comp"),
      spreadAlongZ_("render/shaders/spread_cells.comp", {{"VS_ALONG_Z", "1"}}),
      countSteps_("render/shaders/count_steps.comp"),
      empty_(glm::ivec3(1), gl::Format::RG32F, gl::Filter::Nearest, "no cells") {}

void Macrocells::bind() const {
    distances_.bindTexture(kCellDistancesTexture);
    dataCells_->bindTexture(kDataCellRangesTexture);
}

void Macrocells::copyFrom(const Macrocells& other) {
    const glm::ivec3 size = other.distances_.size();
    if (distances_.size() != size) {
        distances_ = gl::Texture(size, gl::Format::R32UI, gl::Filter::Nearest, "cell distances");
        planes_ = {};
    }
    dataCells_ = other.dataCells_;
    dilated_ = other.dilated_;
    dilatedFrom_ = other.dilatedFrom_;
    distances_.copyFrom(other.distances_, {glm::ivec3(0), size}, glm::ivec3(0));
    version_ = nextVersion();
}

const gl::Texture& Macrocells::dilated(const gl::Texture& dataCells) {
    if (dilatedFrom_ == &dataCells && dilated_->size() == dataCells.size()) {
        return *dilated_;
    }
    auto dilated = std::make_shared<gl::Texture>(dataCells.size(), gl::Format::RG32F, gl::Filter::Nearest,
                                                 "dilated cell ranges");
    dataCells.bindTexture(kRangesTexture);
    dilated->bindImage(kDilatedImage, gl::Access::Write);
    dilate_.with({}).dispatchOver(dilated->size(), gl::Barrier::Texture);
    dilated_ = std::move(dilated);
    dilatedFrom_ = &dataCells;
    return *dilated_;
}

// One step of one plane of bits into another.
void Macrocells::spread(glm::ivec3 blocks, int from, int to, gl::Program& program) {
    program.set("from", from).set("to", to);
    program.dispatchOver(blocks, gl::Barrier::All);
}

void Macrocells::rebuild(const Input& input) {
    const gl::Pass pass("macrocells");
    const glm::ivec3 cells = input.dataCells->size();
    dataCells_ = input.sampling == field::Sampling::Tricubic ? &dilated(*input.dataCells) : input.dataCells;
    const glm::ivec3 blocks = (cells + kBlock - 1) / kBlock;
    if (distances_.size() != cells || !planes_) {
        const auto perPlane = std::size_t(blocks.x) * std::size_t(blocks.y) * std::size_t(blocks.z) + 1;
        planes_ = gl::TexelBuffer(perPlane * (kFar + 1), gl::Format::RGBA32UI, "cells within reach");
        distances_ = gl::Texture(cells, gl::Format::R32UI, gl::Filter::Nearest, "cell distances");
    }
    dataCells_->bindTexture(kDataCellsTexture);
    (input.sculptureCells != nullptr ? *input.sculptureCells : empty_).bindTexture(kSculptureCellsTexture);
    (input.segmentationCells != nullptr ? *input.segmentationCells : empty_)
        .bindTexture(kSegmentationCellsTexture);
    if (input.classification != nullptr) {
        input.classification->bind();
    }
    if (const gl::Texture* steepness = gradientCells(input)) {
        steepness->bindTexture(kGradientCellsTexture);
    }
    planes_.buffer().bindStorage(kPlanesStorage);
    gl::Program& classify = classify_.with(definesFor(input));
    classify.set("cells", cells)
        .set("displayedRange", glm::vec2(float(input.visibleRange.lo), float(input.visibleRange.hi)))
        .set("isProbe", input.view == field::SculptureView::Probe ? 1 : 0);
    classify.dispatchOver({blocks.x, cells.y, cells.z}, gl::Barrier::All);

    planes_.bindTexture(kPlanesBeforeTexture);
    constexpr int scratch = kFar;
    for (int r = 1; r < kFar; ++r) {
        spread(blocks, r - 1, scratch, spreadInPlane_.set("cells", cells));
        spread(blocks, scratch, r, spreadAlongZ_.set("cells", cells));
    }
    distances_.bindImage(kDistancesImage, gl::Access::Write);
    countSteps_.set("cells", cells).set("far", kFar);
    countSteps_.dispatchOver(blocks, gl::Barrier::All); // the planes are storage again when cells are rebuilt
    version_ = nextVersion();
}

} // namespace vs::render
