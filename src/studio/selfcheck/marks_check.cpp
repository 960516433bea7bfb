// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"
#include "studio/selfcheck/queries.h"

#include "field/marks/mark_texture.h"
#include "field/scene.h"
#include "render/colours/colour.h"

#include <random>

namespace vs::studio {

namespace {

constexpr int kMarkedPlaces = 1500;

field::Marks::Brick someBrick(std::mt19937& random) {
    const auto byte = [&random] { return std::uint8_t(random() % 256); };
    auto brick = std::make_shared<field::MarkBrick>();
    for (std::size_t i = 0; i < std::size_t(field::kMarkTexels); ++i) {
        const std::uint8_t coverage = random() % 3 == 0 ? std::uint8_t(0) : byte();
        brick->set(i, {byte(), byte(), byte(), byte(), coverage});
    }
    return brick;
}

void compareMarks(Tally& tally, const field::Marks& marks, std::span<const glm::vec4> places,
                  std::span<const glm::vec4> answers) {
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec4 expected = marks.colourAt(glm::dvec3(places[i]));
        // Opacity grows by three for each unit of coverage, which floats hold to some 1e-6.
        tally.compare(double(answers[i].w), expected.w, 1e-4);
        if (expected.w > 0.01) {
            const glm::dvec3 colour = render::linearFromDisplay(glm::dvec3(expected));
            tally.compare(glm::length(glm::dvec3(answers[i]) - colour), 0, 1e-4);
        }
    }
}

} // namespace

void checkMarks(Tally& tally) {
    gl::ProgramVariants programs("studio/shaders/sample_marks.comp");
    auto volume = makeNoise({23, 17, 11}, volume::ScalarType::UInt8, 0, 127);
    turnOblique(volume);
    const auto field = field::uploadVolume(volume);
    const field::MarkGrid grid = field::markGridOf(volume.geometry);
    const glm::ivec3 n = grid.bricks();
    std::mt19937 random(24);
    const auto places = placesIn(volume.geometry.dims, kMarkedPlaces);
    field::MarkTexture texture;
    field::Marks marks(grid, {});
    for (int edit = 0; edit < 4; ++edit) { // some come, some change, some go
        std::vector<field::Marks::Entry> changed;
        for (int place = 0; place < n.x * n.y * n.z; ++place) {
            if (random() % 2 == 0) {
                changed.emplace_back(std::uint32_t(place), random() % 3 == 0 ? nullptr : someBrick(random));
            }
        }
        marks = marks.with(std::move(changed));
        texture.show(std::make_shared<const field::Marks>(marks));
        if (texture.isEmpty()) {
            tally.note("this device has no room for marks");
            return;
        }
        field::SceneBinding binding;
        binding.bind(
            {.data = &field, .marks = &texture, .displayedRange = field.range, .greyWindow = field.range});
        compareMarks(tally, marks, places, answersOf(programs.with({}), places));
    }
}

} // namespace vs::studio
