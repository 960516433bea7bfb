// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/fill/fill.h"
#include "field/sparse/brick_words.h"
#include "gl/block_layout.h"
#include "gl/buffer.h"

#include <array>
#include <vector>

namespace vs::field {

// What pictures show of a material, by its number less 1.
struct ShownMaterial {
    glm::vec3 colour{1}; // linear
    float value = 0;     // its intensity, in the scan's unit
    bool isSeen = true;
};
using ShownMaterials = std::vector<ShownMaterial>;

// Where material lies on the device and what it is; mirrors FillBlock in field/shaders/fill.glsl (std140).
struct FillBlock {
    glm::ivec4 fillBricks{0}; // xyz along each axis, w in which word the bricks begin
    glm::uvec4 fillSeen{0};   // x bit n: whether material n is seen
    std::array<glm::vec4, kMostMaterials + 1> materials{}; // by number: linear colour, w value
};
inline constexpr gl::BlockMember kFillBlockMembers[] = {VS_BLOCK_MEMBER(FillBlock, fillBricks),
                                                        VS_BLOCK_MEMBER(FillBlock, fillSeen),
                                                        VS_BLOCK_MEMBER(FillBlock, materials)};
inline constexpr gl::BlockLayout kFillBlockLayout{"FillBlock", sizeof(FillBlock), kFillBlockMembers};
static_assert(isWhole(kFillBlockLayout));

// A fill on the device, as field/shaders/fill.glsl reads it: words, for each brick of the grid one (where it
// lies; nothing; or that it is wholly of one material), and then the bricks.
class FillTexture {
public:
    FillTexture();
    // Whether a fill has room on the device.
    static bool hasRoomFor(const Fill& fill);
    // Brings what has changed since the last time to the device. Of a fill that has no room there nothing is
    // shown, and a notice says so.
    void show(const SharedFill& fill);
    [[nodiscard]] bool isEmpty() const { return shown_->isEmpty(); }
    [[nodiscard]] const SharedFill& shown() const { return shown_; }
    void bind(const ShownMaterials& materials) const;

private:
    [[nodiscard]] BrickWords::Changes changes(const Fill& before, const Fill& fill) const;

    SharedFill shown_ = std::make_shared<const Fill>();
    BrickWords words_;
    mutable gl::Buffer block_;
    bool hasComplained_ = false;
};

bool areAllSeen(const ShownMaterials& materials);

} // namespace vs::field
