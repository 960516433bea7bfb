// SPDX-License-Identifier: Apache-2.0
#include "studio/json/filled_json.h"

#include "base/described_json.h"

#include <algorithm>
#include <utility>

namespace vs::studio {

namespace {

using FilledJson = nlohmann::ordered_json;

constexpr std::size_t kNumbersOfBrick = 4; // place, and the three numbers of a shared list

// No fill has material in a voxel that is not filled, or none in one that is.
bool isPossible(const field::FillBrick& brick) {
    for (std::size_t i = 0; i < brick.filled.size(); ++i) {
        if ((brick.filled[i] > 0) != (brick.material[i] != 0)) {
            return false;
        }
    }
    return !brick.isEmpty();
}

std::size_t greatestMaterial(const field::Fill& fill) {
    std::size_t greatest = 0;
    for (const auto& [place, brick] : fill.bricks().entries()) {
        greatest = std::max<std::size_t>(greatest,
                                         *std::max_element(brick->material.begin(), brick->material.end()));
    }
    return greatest;
}

field::SharedFill readFill(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    return file.once<field::Fill>(from, [&] {
        constexpr std::size_t most = std::size_t(1) << 26;
        const auto numbers = file.list<std::uint64_t>(from, most);
        if (numbers.size() % kNumbersOfBrick != 0) {
            from.fail("must be a list of bricks of what is filled");
        }
        const field::Fill nothing(dims);
        const glm::ivec3 n = nothing.brickDims();
        const std::uint64_t places = std::uint64_t(n.x) * std::uint64_t(n.y) * std::uint64_t(n.z);
        std::vector<field::Fill::Bricks::Entry> bricks;
        for (std::size_t i = 0; i < numbers.size(); i += kNumbersOfBrick) {
            const std::uint64_t place = numbers[i];
            if (place >= places || (!bricks.empty() && place <= bricks.back().first)) {
                from.fail("must name bricks of the scan in their order");
            }
            const FilledJson block{numbers[i + 1], numbers[i + 2], numbers[i + 3]};
            const auto list = file.shared<field::FillBrick>(JsonReader(block, from.place()), 1);
            if (list->size() != 1 || !isPossible(list->front())) {
                from.fail("must be bricks in which something is filled");
            }
            bricks.emplace_back(std::uint32_t(place), field::Fill::Bricks::Brick(list, &list->front()));
        }
        return nothing.with(std::move(bricks));
    });
}

} // namespace

FilledJson stored(StateWriter& file, const Filled& filled) {
    const FilledJson fill = file.once(filled.fill, [&] {
        std::vector<std::uint64_t> numbers;
        for (const auto& [place, brick] : filled.fill->bricks().entries()) {
            const FilledJson block =
                file.once(brick, [&, b = brick] { return file.list(std::vector<field::FillBrick>{*b}); });
            numbers.push_back(place);
            for (std::size_t i = 0; i + 1 < kNumbersOfBrick; ++i) {
                numbers.push_back(block.at(i).get<std::uint64_t>());
            }
        }
        return file.list(numbers);
    });
    return {{"materials", vs::write(*filled.materials, Rule())}, {"fill", fill}};
}

Filled readFilled(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    Filled filled(dims);
    std::vector<Material> materials;
    vs::read(from.member("materials"), materials, {.mostCount = field::kMostMaterials});
    filled.fill = readFill(file, from.member("fill"), dims);
    if (greatestMaterial(*filled.fill) > materials.size()) {
        from.fail(
            "must be filled with materials of the list"); // others may share the fill, with longer lists
    }
    filled.materials = std::make_shared<const std::vector<Material>>(std::move(materials));
    return filled;
}

} // namespace vs::studio
