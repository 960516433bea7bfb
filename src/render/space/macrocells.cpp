// SPDX-License-Identifier: Apache-2.0
#include "render/space/macrocells.h"

#include "gl/pass.h"
#include "render/shaders/bindings.h"

#include <atomic>
#include <utility>

namespace vs::render {

namespace {

// Of cells; mirrors shaders/cell_bits.glsl.
constexpr glm::ivec3 kBlock{32, 4, 1};

glm::ivec3 blocksOf(glm::ivec3 cells) { return (cells + kBlock - 1) / kBlock; }

std::uint64_t nextVersion() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

// The cells whose ranges may be others; each also has the values of the voxels that border on it.
Box3 changedCells(const Macrocells::Input& input) {
    const Box3 all{glm::ivec3(0), input.dataCells->size()};
    if (!input.changed) {
        return all;
    }
    const Box3 voxels = grow(*input.changed, 1);
    return input.changed->isEmpty()
               ? Box3{}
               : intersect({voxels.lo / field::kCell, divideUp(voxels.hi, field::kCell)}, all);
}

// Those of voxel centres bound only what trilinear samples have.
const gl::Texture* gradientCells(const Macrocells::Input& input) {
    return input.classification != nullptr && !input.isFiner && input.sampling == field::Sampling::Trilinear
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
                           {"VS_FINER_SEGMENTS", input.hasFinerSegments},
                           {"VS_SCULPTURE", isSculpted},
                           {"VS_FILLED", input.filledCells != nullptr}});
}

} // namespace

Macrocells::Macrocells()
    : spreadInPlane_("render/shaders/spread_cells.comp"),
      spreadAlongZ_("render/shaders/spread_cells.comp", {{"VS_ALONG_Z", "1"}}),
      countSteps_("render/shaders/count_steps.comp"), isOther_(sizeof(std::uint32_t), "other cells"),
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
    havePlanes_ = false;
    dataCells_ = other.dataCells_;
    dilated_ = other.dilated_;
    dilatedFrom_ = other.dilatedFrom_;
    dilatedSerial_ = other.dilatedSerial_;
    distances_.copyFrom(other.distances_, {glm::ivec3(0), size}, glm::ivec3(0));
    version_ = nextVersion();
}

const gl::Texture& Macrocells::dilated(const Input& input) {
    const gl::Texture& dataCells = *input.dataCells;
    if (dilatedFrom_ == &dataCells && dilatedSerial_ == input.dataSerial &&
        dilated_->size() == dataCells.size()) {
        return *dilated_;
    }
    auto dilated = std::make_shared<gl::Texture>(dataCells.size(), gl::Format::RG32F, gl::Filter::Nearest,
                                                 "dilated cell ranges");
    dataCells.bindTexture(kRangesTexture);
    dilated->bindImage(kDilatedImage, gl::Access::Write);
    dilate_.with({}).dispatchOver(dilated->size(), gl::Barrier::Texture);
    dilated_ = std::move(dilated);
    dilatedFrom_ = &dataCells;
    dilatedSerial_ = input.dataSerial;
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
    dataCells_ = input.sampling == field::Sampling::Tricubic ? &dilated(input) : input.dataCells;
    if (distances_.size() != cells || !planes_) {
        const glm::ivec3 blocks = blocksOf(cells);
        const auto perPlane = std::size_t(blocks.x) * std::size_t(blocks.y) * std::size_t(blocks.z) + 1;
        havePlanes_ = false;
        planes_ = gl::TexelBuffer(perPlane * (kFar + 1), gl::Format::RGBA32UI, "cells within reach");
        distances_ = gl::Texture(cells, gl::Format::R32UI, gl::Filter::Nearest, "cell distances");
    }
    const bool hadPlanes = std::exchange(havePlanes_, false); // until all is done
    if (classify(input, hadPlanes ? changedCells(input) : Box3{glm::ivec3(0), cells}) || !hadPlanes) {
        countDistances();
    }
    havePlanes_ = true;
    version_ = nextVersion();
}

// Marks the cells of a box that may hold something; returns whether they are others than those marked before.
bool Macrocells::classify(const Input& input, const Box3& box) {
    if (box.isEmpty()) {
        return false;
    }
    dataCells_->bindTexture(kDataCellsTexture);
    (input.sculptureCells != nullptr ? *input.sculptureCells : empty_).bindTexture(kSculptureCellsTexture);
    (input.segmentationCells != nullptr ? *input.segmentationCells : empty_)
        .bindTexture(kSegmentationCellsTexture);
    if (input.filledCells != nullptr) {
        input.filledCells->bindTexture(kFilledCellsTexture);
    }
    if (input.classification != nullptr) {
        input.classification->bind();
    }
    if (const gl::Texture* steepness = gradientCells(input)) {
        steepness->bindTexture(kGradientCellsTexture);
    }
    isOther_.clear();
    isOther_.bindStorage(kOtherPlaneStorage);
    planes_.buffer().bindStorage(kPlanesStorage);
    gl::Program& classify = classify_.with(definesFor(input));
    const glm::ivec3 first(box.lo.x / kBlock.x * kBlock.x, box.lo.y, box.lo.z); // rows are whole
    classify.set("cells", distances_.size())
        .set("firstRow", first)
        .set("endRow", box.hi)
        .set("displayedRange", glm::vec2(float(input.visibleRange.lo), float(input.visibleRange.hi)))
        .set("isProbe", input.view == field::SculptureView::Probe ? 1 : 0);
    const glm::ivec3 size = box.hi - first;
    classify.dispatchOver({divideUp(size.x, kBlock.x), size.y, size.z}, gl::Barrier::All);
    return isOther_.readValue<std::uint32_t>() != 0;
}

void Macrocells::countDistances() {
    const glm::ivec3 cells = distances_.size();
    const glm::ivec3 blocks = blocksOf(cells);
    planes_.buffer().bindStorage(kPlanesStorage);
    planes_.bindTexture(kPlanesBeforeTexture);
    constexpr int scratch = kFar;
    for (int r = 1; r < kFar; ++r) {
        spread(blocks, r - 1, scratch, spreadInPlane_.set("cells", cells));
        spread(blocks, scratch, r, spreadAlongZ_.set("cells", cells));
    }
    distances_.bindImage(kDistancesImage, gl::Access::Write);
    countSteps_.set("cells", cells).set("far", kFar);
    countSteps_.dispatchOver(blocks, gl::Barrier::All); // the planes are storage again when cells are rebuilt
}

} // namespace vs::render
