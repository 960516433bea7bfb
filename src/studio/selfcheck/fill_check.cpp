// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"
#include "studio/selfcheck/queries.h"

#include "field/fill/fill_texture.h"
#include "field/scene.h"

#include <random>

namespace vs::studio {

namespace {

constexpr int kFilledPlaces = 1500;
constexpr int kMaterials = 5;

field::Fill::Bricks::Brick someFilledBrick(std::mt19937& random) {
    if (random() % 4 == 0) {
        return field::wholeBrick(std::uint8_t(1 + random() % kMaterials));
    }
    auto brick = std::make_shared<field::FillBrick>();
    for (std::size_t i = 0; i < brick->filled.size(); ++i) {
        brick->filled[i] = random() % 3 == 0 ? std::uint16_t(0) : std::uint16_t(random() % 65536);
        brick->material[i] = brick->filled[i] > 0 ? std::uint8_t(1 + random() % kMaterials) : std::uint8_t(0);
    }
    return brick;
}

// How much a place is filled by anything, and by materials that are seen.
glm::dvec2 filledAt(const field::Fill& fill, const glm::dvec3& place,
                    const field::ShownMaterials& materials) {
    const glm::dvec3 q = glm::clamp(place, glm::dvec3(0), glm::dvec3(fill.dims() - 1));
    const glm::ivec3 first(glm::floor(q));
    const glm::dvec3 part = q - glm::dvec3(first);
    glm::dvec2 sum(0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 w = glm::mix(1.0 - part, part, glm::dvec3(offset));
        const field::Fill::Voxel voxel = fill.at(first + offset);
        const double weight = w.x * w.y * w.z * voxel.filled;
        const bool isSeen = voxel.material > 0 && materials[voxel.material - 1U].isSeen;
        sum += weight * glm::dvec2(1, isSeen ? 1 : 0);
    }
    return sum;
}

void compareFill(Tally& tally, const field::Fill& fill, const field::ShownMaterials& materials,
                 std::span<const glm::vec4> places, std::span<const glm::vec4> answers) {
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec3 place(places[i]);
        const glm::dvec2 expected = filledAt(fill, place, materials);
        tally.compare(double(answers[i].x), expected.x, 1e-5);
        tally.compare(double(answers[i].y), expected.y, 1e-5);
        // Two corners that count alike may be told apart either way.
        const std::uint8_t material = fill.materialAt(place);
        if (expected.y >= 0.501 && int(answers[i].z) == int(material)) {
            tally.compare(double(answers[i].w), double(materials[material - 1U].value), 1e-4);
        }
        tally.compare(expected.x >= 0.501 && answers[i].z < 1 ? 1.0 : 0.0, 0, 0);
    }
}

} // namespace

void checkFill(Tally& tally) {
    gl::ProgramVariants programs("studio/shaders/sample_fill.comp");
    const auto volume = makeNoise({35, 33, 18}, volume::ScalarType::UInt8, 0, 127);
    const auto field = field::uploadVolume(volume);
    std::mt19937 random(51);
    const auto places = placesIn(volume.geometry.dims, kFilledPlaces);
    field::FillTexture texture;
    field::Fill fill(volume.geometry.dims);
    const glm::ivec3 n = fill.brickDims();
    for (int edit = 0; edit < 4; ++edit) { // some come, some change, some go
        std::vector<field::Fill::Bricks::Entry> changed;
        for (int place = 0; place < n.x * n.y * n.z; ++place) {
            if (random() % 2 == 0) {
                changed.emplace_back(std::uint32_t(place),
                                     random() % 3 == 0 ? nullptr : someFilledBrick(random));
            }
        }
        fill = fill.with(std::move(changed));
        texture.show(std::make_shared<const field::Fill>(fill));
        if (texture.isEmpty()) {
            tally.note("this device has no room for material");
            return;
        }
        field::ShownMaterials materials;
        for (int m = 0; m < kMaterials; ++m) {
            materials.push_back({glm::vec3(0.1F * float(m)), float(200 + 10 * m), edit < 2 || m % 2 == 0});
        }
        field::Scene scene;
        scene.data = &field;
        scene.fill = &texture;
        scene.materials = materials;
        scene.displayedRange = field.range;
        scene.greyWindow = field.range;
        field::SceneBinding binding;
        binding.bind(scene);
        gl::Defines defines;
        field::addFill(scene, defines);
        compareFill(tally, fill, materials, places, answersOf(programs.with(defines), places));
    }
}

} // namespace vs::studio
