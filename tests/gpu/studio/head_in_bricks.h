// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/field/two_levels.h"
#include "gpu/studio/test_tools.h"
#include "studio/document/finer_levels.h"
#include "studio/state/region.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace vs::studio {

// The head, or another scan, worked on at a half of its resolution.
struct InBricks {
    explicit InBricks(int side = 16, int bricks = 400, volume::Volume scan = testHead())
        : fine(std::move(scan)), source(std::make_shared<test::TwoLevels>(fine)) {
        volume::Volume coarse = source->coarse();
        coarse.range = fine.range; // as a store says it of all its levels
        coarse.usual = fine.usual;
        document = std::make_unique<Document>(std::move(coarse));
        document->showView(testCanvas().view);
        FinerLevels levels;
        levels.source = source;
        levels.options.side = side;
        levels.options.deviceBytes =
            std::size_t(bricks) * std::size_t(side + 1) * std::size_t(side + 1) * std::size_t(side + 1) * 4;
        document->showFinerLevels(levels);
    }

    [[nodiscard]] std::vector<float> cuts() const {
        return sculpt::valuesOf(document->sculpture().finer()->texels(fine.geometry.box()),
                                sculpt::Precision::Bits16);
    }

    // Which segment each voxel of the finest level is shown in; empty: nothing has grown.
    [[nodiscard]] std::vector<std::uint8_t> labels() const {
        const segment::FineGrowth* grown = document->region().finest();
        return grown == nullptr ? std::vector<std::uint8_t>() : grown->labelMap(fine.geometry.box());
    }

    volume::Volume fine;
    std::shared_ptr<test::TwoLevels> source;
    std::unique_ptr<Document> document;
};

} // namespace vs::studio
