// SPDX-License-Identifier: Apache-2.0
#include "studio/filling/fill_editor.h"

#include "base/error.h"
#include "render/colours/segment_palette.h"

#include <fmt/format.h>

#include <utility>

namespace vs::studio {

namespace {

const glm::dvec3 kFirstColour{0.38, 0.66, 0.86}; // of no tissue, nor of the first segment

// What a new material is like where nobody says.
Material usual(int number, const View& view, const Range& values) {
    Material material;
    material.name = fmt::format("Material {}", number);
    material.colour = number == 1 ? kFirstColour : render::segmentColour(number - 1);
    const Range seen = view.visibleRange(values);
    material.value = 0.5 * (std::max(seen.lo, values.lo) + std::min(seen.hi, values.hi));
    return material;
}

} // namespace

void FillEditor::remember(const Operation& operation, Filled after) {
    Edit edit{shared(operation), {}, {}};
    edit.filledBefore = contents_.filled;
    edit.filledAfter = after;
    contents_.remember(std::move(edit));
    contents_.filled = std::move(after);
}

Outcome FillEditor::run(SetMaterial& op) {
    std::vector<Material> list = *contents_.filled.materials;
    const auto count = int(list.size());
    if (op.number > field::kMostMaterials) {
        throw Error("number: there can be {} materials, and no number {}", field::kMostMaterials, op.number);
    }
    if (op.number > count + 1) {
        throw Error("number: there are {} materials, so that the next one is number {}, not {}", count,
                    count + 1, op.number);
    }
    const bool isNew = op.number == count + 1;
    if (isNew) {
        list.push_back(usual(op.number, contents_.view, contents_.scan.volume.range));
    }
    Material& material = list[std::size_t(op.number - 1)];
    material.name = op.name.value_or(material.name);
    material.colour = op.colour.value_or(material.colour);
    material.value = op.value.value_or(material.value);
    material.isVisible = op.isVisible.value_or(material.isVisible);
    if (isNew) { // again it is the same, whatever is seen then
        op.name = material.name;
        op.colour = material.colour;
        op.value = material.value;
    }
    Outcome outcome;
    if (isNew || list != *contents_.filled.materials) {
        Filled after = contents_.filled;
        after.materials = std::make_shared<const std::vector<Material>>(std::move(list));
        remember(op, std::move(after));
    }
    return outcome;
}

Outcome FillEditor::run(const RemoveFill& op) {
    const field::Fill& before = *contents_.filled.fill;
    Filled after = contents_.filled;
    after.fill = std::make_shared<const field::Fill>(
        op.material ? field::without(before, std::uint8_t(*op.material)) : field::Fill(before.dims()));
    Outcome outcome;
    outcome.voxelsTouched = field::changedVoxels(before, *after.fill);
    if (outcome.voxelsTouched == 0) {
        throw Error("material: nothing is filled that could be removed");
    }
    remember(op, std::move(after));
    return outcome;
}

} // namespace vs::studio
