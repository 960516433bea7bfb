// SPDX-License-Identifier: Apache-2.0
#include "render/macrocells.h"

#include "gl/pass.h"

#include <atomic>

namespace vs::render {

namespace {

std::uint64_t nextVersion() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

} // namespace

Macrocells::Macrocells()
    : classify_("render/shaders/classify_cells.comp"), spread_("render/shaders/spread_distance.comp"),
      empty_(glm::ivec3(1), gl::Format::RG32F, gl::Filter::Nearest, "no cells") {}

void Macrocells::bind() const {
    distances_.bindTexture(3);
    dataCells_->bindTexture(4);
}

void Macrocells::copyFrom(const Macrocells& other) {
    const glm::ivec3 size = other.distances_.size();
    if (distances_.size() != size) {
        distances_ = gl::Texture(size, gl::Format::R32UI, gl::Filter::Nearest, "cell distances");
        scratch_ = {};
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
    if (!dilate_) {
        dilate_ = gl::Program("render/shaders/dilate_ranges.comp");
    }
    dilated_ = std::make_shared<gl::Texture>(dataCells.size(), gl::Format::RG32F, gl::Filter::Nearest,
                                             "dilated cell ranges");
    dilatedFrom_ = &dataCells;
    dataCells.bindTexture(0);
    dilated_->bindImage(0, gl::Access::Write);
    dilate_.dispatchOver(dilated_->size(), gl::Barrier::Texture);
    return *dilated_;
}

void Macrocells::rebuild(const Input& input) {
    const gl::Pass pass("macrocells");
    const glm::ivec3 cells = input.dataCells->size();
    dataCells_ = input.sampling == field::Sampling::Tricubic ? &dilated(*input.dataCells) : input.dataCells;
    if (distances_.size() != cells || scratch_.size() != cells) {
        distances_ = gl::Texture(cells, gl::Format::R32UI, gl::Filter::Nearest, "cell distances");
        scratch_ = gl::Texture(cells, gl::Format::R32UI, gl::Filter::Nearest, "cell distances scratch");
    }
    dataCells_->bindTexture(0);
    (input.sculptureCells != nullptr ? *input.sculptureCells : empty_).bindTexture(1);
    (input.segmentationCells != nullptr ? *input.segmentationCells : empty_).bindTexture(2);
    distances_.bindImage(0, gl::Access::Write);
    classify_
        .set(0, glm::vec2(float(input.displayedRange.lo - input.valueTolerance),
                          float(input.displayedRange.hi + input.valueTolerance)))
        .set(1, input.sculptureCells != nullptr || input.view == field::SculptureView::Probe ? int(input.view)
                                                                                             : 0)
        .set(2, (input.drawsData ? 1 : 0) | (input.segmentationCells != nullptr ? 2 : 0))
        .set(3, kFar)
        .set(4, input.classification != nullptr ? 1 : 0);
    if (input.classification != nullptr) {
        input.classification->bind();
    }
    classify_.dispatchOver(cells, gl::Barrier::Texture);

    // Chebyshev distance separates: along x, then y, then z, each taking max(offset, distance so far).
    for (int axis = 0; axis < 3; ++axis) {
        distances_.bindTexture(0);
        scratch_.bindImage(0, gl::Access::Write);
        glm::ivec3 direction(0);
        direction[axis] = 1;
        spread_.set(0, direction).set(1, kFar);
        spread_.dispatchOver(cells, gl::Barrier::Texture);
        std::swap(distances_, scratch_);
    }
    version_ = nextVersion();
}

} // namespace vs::render
