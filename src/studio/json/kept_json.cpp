// SPDX-License-Identifier: Apache-2.0
#include "studio/json/kept_json.h"

#include "base/described_json.h"
#include "base/error.h"
#include "field/field.h"
#include "studio/json/operation_json.h"

#include <memory>
#include <utility>

namespace vs::studio {

// --- changes of the sculpture

Json stored(StateWriter& file, const sculpt::BrickDelta& delta) {
    return {{"bricks", file.list(delta.bricks())},
            {"ends", file.list(delta.ends())},
            {"voxels", delta.changedVoxels()},
            {"held", file.block(delta.held())}};
}

sculpt::BrickDelta readDelta(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    const std::size_t most = Box3{glm::ivec3(0), divideUp(dims, field::kBrick)}.volume();
    auto bricks = file.list<Box3>(from.member("bricks"), most);
    auto ends = file.list<std::size_t>(from.member("ends"), most);
    const auto voxels = std::size_t(from.member("voxels").integerBetween(0, kAnyNumber));
    try {
        return sculpt::BrickDelta::from(std::move(bricks), file.block(from.member("held")), std::move(ends),
                                        voxels, dims);
    } catch (const SessionError&) {
        throw;
    } catch (const Error& error) {
        from.fail(error.what());
    }
}

// --- small things

Json stored(const SavedParts& parts) {
    Json list = Json::array();
    for (const SavedParts::Part& part : parts.parts) {
        Json json = vs::write(static_cast<const PartInfo&>(part), Rule());
        list.push_back({{"part", std::move(json)}, {"from", part.from}, {"upTo", part.upTo}});
    }
    return {
        {"places", vs::write(parts.places, kPlacements)}, {"parts", std::move(list)}, {"last", parts.last}};
}

SavedParts readParts(const JsonReader& from) {
    constexpr long mostPastes = 1 << 20;
    SavedParts parts;
    vs::read(from.member("places"), parts.places, kPlacements);
    forEachIn(from.member("parts"), [&](const JsonReader& one) {
        SavedParts::Part& part = parts.parts.emplace_back();
        vs::read(one.member("part"), static_cast<PartInfo&>(part), Rule());
        part.from = int(one.member("from").integerBetween(-1, mostPastes));
        part.upTo = int(one.member("upTo").integerBetween(-1, mostPastes));
    });
    parts.last = int(from.member("last").integerBetween(-1, mostPastes));
    return parts;
}

Json stored(const volume::GridGeometry& geometry) {
    Json json = Json::array();
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            json.push_back(geometry.worldFromVoxel[column][row]);
        }
    }
    return json;
}

volume::GridGeometry readGeometry(const JsonReader& from, glm::ivec3 dims) {
    from.expectSize(12);
    volume::GridGeometry geometry{dims, glm::dmat4(1)};
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            geometry.worldFromVoxel[column][row] = from.at(std::size_t(3 * column + row)).number();
        }
    }
    if (!(geometry.voxelMm3() > 0)) {
        from.fail("must be a grid with some volume");
    }
    return geometry;
}

Json stored(const Measurements& measurements) { return vs::write(*measurements, Rule()); }

Measurements readMeasurements(const JsonReader& from) {
    std::vector<Measure> list;
    vs::read(from, list, {.mostCount = kMostMeasurements});
    for (const Measure& measure : list) {
        if (measure.kind == Measure::Kind::Vessel && measure.centreline.empty()) {
            from.fail("a vessel must have a centreline");
        }
    }
    return std::make_shared<const std::vector<Measure>>(std::move(list));
}

} // namespace vs::studio
