// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"
#include "volume/grid/brick_source.h"
#include "volume/grid/reduced.h"

#include <optional>
#include <string>
#include <vector>

namespace vs::test {

// The volume and one of half its resolution, or less along some axes; bricks of the finer one can be made
// unreadable.
class TwoLevels : public volume::BrickSource {
public:
    explicit TwoLevels(const volume::Volume& fine, glm::ivec3 by = glm::ivec3(2))
        : fine_(fine), coarse_(volume::reduced(fine, by, volume::Reducing::Mean)), levels_{fine.geometry,
                                                                                           coarse_.geometry} {
    }

    [[nodiscard]] const std::vector<volume::GridGeometry>& levels() const override { return levels_; }
    [[nodiscard]] volume::ScalarType type() const override { return fine_.type; }
    [[nodiscard]] std::string name() const override { return "two levels"; }
    [[nodiscard]] std::vector<std::byte> read(int level, const Box3& box) const override {
        if (level == 0 && unreadable && box.lo == *unreadable) {
            throw ReadError("chunk {}.{}.{}: it is damaged", box.lo.x, box.lo.y, box.lo.z);
        }
        return valuesIn(level == 0 ? fine_ : coarse_, box);
    }
    [[nodiscard]] const volume::Volume& coarse() const { return coarse_; }

    std::optional<glm::ivec3> unreadable;

private:
    const volume::Volume& fine_;
    volume::Volume coarse_;
    std::vector<volume::GridGeometry> levels_;
};

} // namespace vs::test
