// SPDX-License-Identifier: Apache-2.0
#include "render/colours/classification.h"

#include "base/error.h"
#include "field/histogram.h"
#include "field/landmarks.h"
#include "gl/context.h"
#include "gl/pass.h"
#include "render/shaders/bindings.h"

namespace vs::render {

namespace {

// Texture coordinate from a value, so that the ends of `span` fall on the centres of the outermost of `count`
// texels: x scale, y offset. A span of one value is all one texel.
glm::dvec2 axisOf(const Range& span, int count) {
    const double inner = double(count - 1) / count;
    const double scale = span.width() > 0 ? inner / span.width() : 0;
    return {scale, 0.5 / count - span.lo * scale};
}

bool goesByGradients(const TransferFunction& function) { return function.kind != FunctionKind::Intensity; }

// From the 0.1st to the 99.9th percentile.
Range robustRange(const field::Field& field) {
    constexpr double odd = 0.001;
    const auto counts = field::intensityHistogram(field, 4096);
    return {field::percentile(counts, field.usual, odd), field::percentile(counts, field.usual, 1 - odd)};
}

} // namespace

Classification::Classification() : block_(sizeof(ClassificationBlock), "classification") {}

void Classification::forgetOthers(const field::Field& field) {
    if (anchorsSerial_ != field.serial) {
        anchorsSerial_ = field.serial;
        robustValues_.reset();
        landmarks_.reset();
        gradientTop_.reset();
        gradients_.reset();
        hasNoRoom_ = false;
    }
}

double Classification::gradientTop(const field::Field& field) {
    if (!gradientTop_) {
        gradientTop_ = field::gradientRange(field).hi;
    }
    return *gradientTop_;
}

// What the function's positions ask for, each a pass over the voxels.
Anchors Classification::anchorsFor(const TransferFunction& function, const field::Field& field) {
    Anchors anchors;
    anchors.values = field.usual;
    anchors.stepMm = field.geometry.stepMm();
    if (function.positions == Positions::Robust) {
        robustValues_ = robustValues_ ? robustValues_ : robustRange(field);
        anchors.robustValues = *robustValues_;
    }
    if (function.positions == Positions::Landmarks ||
        (function.positions == Positions::Hounsfield && !field.isHounsfield)) {
        landmarks_ = landmarks_ ? landmarks_ : field::findLandmarks(field);
        anchors.landmarks = *landmarks_;
    }
    anchors.airAndWater =
        field.isHounsfield ? field::kAirAndWaterHu : field::findAirAndWater(anchors.landmarks, field.usual);
    if (goesByGradients(function)) {
        anchors.gradientTop = gradientTop(field);
    }
    return anchors;
}

// Without them shaders take differences of the data at each place, which is slower.
void Classification::keepGradients(const field::Field& field, double unit) {
    if (gradients_ || hasNoRoom_) {
        return;
    }
    try {
        gradients_ = field::computeGradients(field, unit);
    } catch (const GlError&) {
        hasNoRoom_ = true;
    }
}

bool Classification::update(const TransferFunction& function, const field::Field& field,
                            std::span<const double> others) {
    Range values = field.usual;
    for (const double value : others) {
        values = {std::min(values.lo, value), std::max(values.hi, value)};
    }
    if (isWhole_ && serial_ == field.serial && function == function_ && values == values_) {
        return false;
    }
    const gl::Pass pass("classification tables");
    isWhole_ = false;
    function_ = function;
    serial_ = field.serial;
    values_ = values;
    forgetOthers(field);
    if (goesByGradients(function)) {
        keepGradients(field, gradientTop(field));
    }
    resolved_ = resolve(function, anchorsFor(function, field));
    const auto tables = makeTables(resolved_, values, field.geometry.stepMm());
    uploadTables(tables);
    writeBlock(tables, field);
    isWhole_ = true;
    ++version_;
    return true;
}

void Classification::upload(gl::Texture& texture, glm::ivec2 size, gl::Format format, gl::Filter filter,
                            const char* label, std::span<const std::byte> texels) {
    if (texture.size() != glm::ivec3(size, 1)) {
        texture = gl::Texture(size, format, filter, label);
    }
    texture.upload({glm::ivec3(0), texture.size()}, texels);
    uploadedBytes_ += texels.size();
}

void Classification::uploadTables(const ClassificationTables& tables) {
    // Where the device has filters a plane gains from them; on a software renderer they cost three times as
    // much as the nearest texel.
    const bool isFiltered = tables.size.y > 1 && !gl::Context::isSoftware();
    const auto filter = isFiltered ? gl::Filter::Linear : gl::Filter::Nearest;
    upload(main_, tables.size, gl::Format::RGBA32F, filter, "transfer function",
           std::as_bytes(std::span(tables.main)));
    if (!tables.spans.empty()) {
        if (spans_.texels() != tables.spans.size()) {
            spans_ =
                gl::TexelBuffer(tables.spans.size(), gl::Format::RGBA32F, "transfer function over spans");
        }
        spans_.write(std::as_bytes(std::span(tables.spans)), 0);
        uploadedBytes_ += std::as_bytes(std::span(tables.spans)).size();
    }
    upload(visibleBefore_, tables.visibleSize, gl::Format::R32UI, gl::Filter::Nearest, "visible values",
           std::as_bytes(std::span(tables.visibleBefore)));
}

namespace {

// Opacity per step from which a pen meets something: little, but never more than there is.
float touchable(const ClassificationTables& tables) {
    float greatest = 0;
    for (const glm::vec4& texel : tables.main) {
        greatest = std::max(greatest, texel.w);
    }
    return std::min(0.05F, std::max(0.5F * greatest, 1e-6F));
}

} // namespace

void Classification::writeBlock(const ClassificationTables& tables, const field::Field& field) {
    const bool isGradient = resolved_.kind == FunctionKind::Gradient;
    const int columns = tables.visibleSize.x - 1;
    ClassificationBlock block;
    // Never below the data, so that the stand-in for non-finite voxels (which only float fields have), and
    // what is interpolated from it, stays clear.
    const double lowest = field.isIntegral ? double(field::kNonFinite)
                                           : field.range.lo - field::toleranceAt(field.range.lo, field);
    block.valueAxis = glm::vec4(glm::dvec4(axisOf(tables.values, columns), lowest, columns));
    block.gradientAxis =
        glm::vec4(glm::dvec4(axisOf(tables.gradients, isGradient ? tables.size.x : tables.size.y),
                             double(columns) * axisOf(tables.values, columns)));
    block.lightingOfFunction = {float(resolved_.lighting.amount), float(resolved_.lighting.gloss),
                                touchable(tables), gradients_ ? float(gradients_->most) : 0};
    block_.writeValue(block);
}

void Classification::bind() const {
    main_.bindTexture(kFunctionTableTexture);
    if (kind() == FunctionKind::Intensity) {
        spans_.bindTexture(kFunctionSpansTexture);
    } else if (gradients_ && gradients_->quads) {
        gradients_->quads.bindTexture(kGradientsTexture);
    } else if (gradients_) {
        gradients_->texels.bindTexture(kGradientsTexture);
    }
    visibleBefore_.bindTexture(kVisibleBeforeTexture);
    block_.bindUniform(kClassificationBlock);
}

void Classification::addDefines(gl::Defines& defines) const {
    defines.emplace_back("TF_KIND", std::to_string(static_cast<int>(kind())));
    if (gradientCells() != nullptr) {
        defines.emplace_back("TF_GRADIENTS", gradients_->quads ? "2" : "1");
    }
}

const gl::Texture* Classification::gradientCells() const {
    return gradients_ && kind() != FunctionKind::Intensity ? &gradients_->cells : nullptr;
}

} // namespace vs::render
