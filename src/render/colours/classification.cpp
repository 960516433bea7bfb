// SPDX-License-Identifier: Apache-2.0
#include "render/colours/classification.h"

#include "field/gradient.h"
#include "field/histogram.h"
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

// From the 0.1st to the 99.9th percentile.
Range robustRange(const field::Field& field) {
    constexpr double odd = 0.001;
    const auto counts = field::intensityHistogram(field, 4096);
    return {field::percentile(counts, field.range, odd), field::percentile(counts, field.range, 1 - odd)};
}

} // namespace

Classification::Classification() : block_(sizeof(ClassificationBlock), "classification") {}

Anchors Classification::anchorsFor(const TransferFunction& function, const field::Field& field) {
    if (anchorsSerial_ != field.serial) {
        anchorsSerial_ = field.serial;
        robustValues_.reset();
        gradientTop_.reset();
    }
    if (function.positions == Positions::Robust && function.kind != FunctionKind::Gradient &&
        !robustValues_) {
        robustValues_ = robustRange(field);
    }
    if (function.positions != Positions::Absolute && function.kind != FunctionKind::Intensity &&
        !gradientTop_) {
        gradientTop_ = field::gradientRange(field).hi;
    }
    return {field.range, robustValues_.value_or(field.range), gradientTop_.value_or(0)};
}

bool Classification::update(const TransferFunction& function, const field::Field& field) {
    if (version_ > 0 && serial_ == field.serial && function == function_) {
        return false;
    }
    const gl::Pass pass("classification tables");
    function_ = function;
    serial_ = field.serial;
    resolved_ = resolve(function, anchorsFor(function, field));
    const auto tables = makeTables(resolved_, field.range, field.geometry.stepMm());
    uploadTables(tables);
    writeBlock(tables, field);
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
    // Thousands of texels along a curve need no interpolation, which on a software renderer costs three times
    // as much.
    const auto filter = tables.size.y > 1 ? gl::Filter::Linear : gl::Filter::Nearest;
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
    upload(visibleBefore_, {int(tables.visibleBefore.size()), 1}, gl::Format::R32UI, gl::Filter::Nearest,
           "visible values", std::as_bytes(std::span(tables.visibleBefore)));
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
    const int columns = int(tables.visibleBefore.size()) - 1;
    ClassificationBlock block;
    // Never below the data, so that the stand-in for non-finite voxels (which only float fields have), and
    // what is interpolated from it, stays clear.
    const double lowest =
        field.isIntegral ? double(field::kNonFinite) : field.range.lo - double(field::valueTolerance(field));
    block.valueAxis = glm::vec4(glm::dvec4(axisOf(tables.values, columns), lowest, columns));
    block.gradientAxis =
        glm::vec4(glm::dvec4(axisOf(tables.gradients, isGradient ? tables.size.x : tables.size.y),
                             double(columns) * axisOf(tables.values, columns)));
    block.lightingOfFunction = {float(resolved_.lighting.amount), float(resolved_.lighting.gloss),
                                touchable(tables), 0};
    block_.writeValue(block);
}

void Classification::bind() const {
    main_.bindTexture(kFunctionTableTexture);
    if (spans_) {
        spans_.bindTexture(kFunctionSpansTexture);
    }
    visibleBefore_.bindTexture(kVisibleBeforeTexture);
    block_.bindUniform(kClassificationBlock);
}

const char* Classification::kindDefine() const {
    constexpr const char* defines[] = {"0", "1", "2"};
    return defines[static_cast<int>(kind())];
}

} // namespace vs::render
