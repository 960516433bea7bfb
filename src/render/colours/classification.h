// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "field/gradient.h"
#include "gl/block_layout.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texel_buffer.h"
#include "render/colours/classification_tables.h"

namespace vs::render {

// What shaders need to look a value up; mirrors ClassificationBlock in render/shaders/classification.glsl
// (std140).
struct ClassificationBlock {
    glm::vec4 valueAxis{
        0}; // x scale, y offset to a table coordinate 0..1; z lowest value that counts, w columns
    glm::vec4 gradientAxis{
        0}; // x scale, y offset to a table coordinate 0..1; zw the same for values, to columns
    glm::vec4 lightingOfFunction{0}; // x amount, y gloss, z opacity per step that a pen meets, w gradient
                                     // magnitude that is kept as 1
};
inline constexpr gl::BlockMember kClassificationBlockMembers[] = {
    VS_BLOCK_MEMBER(ClassificationBlock, valueAxis), VS_BLOCK_MEMBER(ClassificationBlock, gradientAxis),
    VS_BLOCK_MEMBER(ClassificationBlock, lightingOfFunction)};
inline constexpr gl::BlockLayout kClassificationBlockLayout{
    "ClassificationBlock", sizeof(ClassificationBlock), kClassificationBlockMembers};
static_assert(isWhole(kClassificationBlockLayout));

// The tables of one transfer function on the device, resolved against one field. Shaders include
// "render/shaders/classification.glsl" with what addDefines() adds. Textures 5, 7 and 10 and uniform block 2
// are taken while it is bound. For functions of gradients the magnitudes at all voxels are kept on the device
// for as long as the field stays the same, where it has room for them.
class Classification {
public:
    Classification();

    // Uploads the tables if function or field are others than last time; true if so. Relative positions are
    // measured on the device, once for each field. `others` are values that are asked for too, of material
    // that was added to the scan.
    bool update(const TransferFunction& function, const field::Field& field,
                std::span<const double> others = {});

    // A function with absolute positions on a field: what update() would upload.
    TransferFunction resolved(const TransferFunction& function, const field::Field& field) {
        return resolve(function, anchorsFor(function, field));
    }

    void bind() const;

    [[nodiscard]] FunctionKind kind() const { return function_.kind; }
    // TF_KIND (0, 1, 2 for Intensity, Gradient, TwoD) and TF_GRADIENTS where it is to be defined.
    void addDefines(gl::Defines& defines) const;
    // Smallest and largest gradient magnitude of each macrocell, where the function goes by them and they are
    // kept; else null.
    [[nodiscard]] const gl::Texture* gradientCells() const;
    // A number that moves whenever update() changed something: what was derived from the tables is stale
    // then.
    [[nodiscard]] int version() const { return version_; }
    // The function with absolute positions, as the tables hold it.
    [[nodiscard]] const TransferFunction& resolved() const { return resolved_; }
    // Everything sent to the device by update() so far.
    [[nodiscard]] std::size_t uploadedBytes() const { return uploadedBytes_; }

private:
    Anchors anchorsFor(const TransferFunction& function, const field::Field& field);
    double gradientTop(const field::Field& field);
    void keepGradients(const field::Field& field, double unit);
    void forgetOthers(const field::Field& field);
    void upload(gl::Texture& texture, glm::ivec2 size, gl::Format format, gl::Filter filter,
                const char* label, std::span<const std::byte> texels);
    void uploadTables(const ClassificationTables& tables);
    void writeBlock(const ClassificationTables& tables, const field::Field& field);

    gl::Buffer block_;
    gl::Texture main_;
    gl::TexelBuffer spans_;
    gl::Texture visibleBefore_;

    TransferFunction function_;
    TransferFunction resolved_;
    // What functions are anchored to, in the field with this serial number, and its gradients; measured when
    // one first needs it.
    std::uint64_t anchorsSerial_ = 0;
    std::optional<Range> robustValues_;
    std::optional<field::Landmarks> landmarks_;
    std::optional<double> gradientTop_;
    std::optional<field::GradientField> gradients_;
    bool hasNoRoom_ = false; // for gradients_

    std::uint64_t serial_ = 0; // of the field that the tables were made for
    Range values_;             // of the tables
    int version_ = 0;
    bool isWhole_ = false; // what was thrown in the midst of an update leaves some of it as it was
    std::size_t uploadedBytes_ = 0;
};

} // namespace vs::render
