// SPDX-License-Identifier: Apache-2.0
#include "studio/json/marks_json.h"

#include <cmath>
#include <utility>

namespace vs::studio {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kHeader = 3;   // numbers: texels of a voxel along x, y, z
constexpr std::size_t kPerBrick = 4; // place, and the three numbers of a shared list

field::MarkGrid readGrid(const std::vector<std::uint64_t>& numbers, const JsonReader& from, glm::ivec3 dims) {
    field::MarkGrid grid;
    grid.dims = dims;
    double bricks = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint64_t n = numbers[std::size_t(axis)];
        if (n < 1 || n > std::uint64_t(field::kMostMarksPerVoxel)) {
            from.fail("must have 1 to 32 texels of marks in a voxel");
        }
        grid.perVoxel[axis] = int(n);
        bricks *= std::ceil(double(dims[axis]) * double(n) / field::kMarkBrick);
    }
    if (bricks > double(field::kMostMarkBricks)) {
        from.fail("must not divide the scan into more than 67108864 bricks of marks");
    }
    return grid;
}

} // namespace

Json stored(StateWriter& file, const field::SharedMarks& marks) {
    return file.once(marks, [&] {
        const field::MarkGrid& grid = marks->grid();
        std::vector<std::uint64_t> numbers;
        if (!marks->isEmpty()) {
            for (int axis = 0; axis < 3; ++axis) {
                numbers.push_back(std::uint64_t(grid.perVoxel[axis]));
            }
        }
        for (const auto& [place, brick] : marks->bricks()) {
            const Json block =
                file.once(brick, [&, b = brick] { return file.list(std::vector<field::MarkBrick>{*b}); });
            numbers.push_back(place);
            for (std::size_t i = 0; i + 1 < kPerBrick; ++i) {
                numbers.push_back(block.at(i).get<std::uint64_t>());
            }
        }
        return file.list(numbers);
    });
}

field::SharedMarks readMarks(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    return file.once<field::Marks>(from, [&] {
        constexpr std::size_t most = std::size_t(1) << 24;
        const auto numbers = file.list<std::uint64_t>(from, most);
        if (numbers.empty()) {
            return field::Marks();
        }
        if (numbers.size() < kHeader || (numbers.size() - kHeader) % kPerBrick != 0) {
            from.fail("must be a list of bricks of marks");
        }
        const field::MarkGrid grid = readGrid(numbers, from, dims);
        const glm::ivec3 n = grid.bricks();
        const std::uint64_t places = std::uint64_t(n.x) * std::uint64_t(n.y) * std::uint64_t(n.z);
        std::vector<field::Marks::Entry> bricks;
        for (std::size_t i = kHeader; i < numbers.size(); i += kPerBrick) {
            const std::uint64_t place = numbers[i];
            const bool isNext = bricks.empty() || place > bricks.back().first;
            if (place >= places || !isNext) {
                from.fail("must name bricks of the scan's marks in their order");
            }
            const Json block{numbers[i + 1], numbers[i + 2], numbers[i + 3]};
            const auto list = file.shared<field::MarkBrick>(JsonReader(block, from.place()), 1);
            if (list->size() != 1 || list->front().isEmpty()) {
                from.fail("must be bricks in which something is marked");
            }
            bricks.emplace_back(std::uint32_t(place), field::Marks::Brick(list, &list->front()));
        }
        return field::Marks(grid, std::move(bricks));
    });
}

} // namespace vs::studio
