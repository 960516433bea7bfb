// SPDX-License-Identifier: Apache-2.0
#include "studio/json/state_json.h"

#include "base/described_json.h"
#include "base/error.h"
#include "field/field.h"
#include "studio/json/growth_json.h"
#include "studio/json/operation_json.h"
#include "studio/json/session_json.h"

#include <limits>

namespace vs::studio {

namespace {

constexpr long kAnyNumber = std::numeric_limits<long>::max();

// Runs through a list of JSON.
template <typename Read>
void forEachIn(const JsonReader& list, Read read) {
    for (std::size_t i = 0; i < list.size(); ++i) {
        read(list.at(i));
    }
}

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
    return std::make_shared<const std::vector<Measure>>(std::move(list));
}

View readView(const JsonReader& from) {
    const Operation operation = operationFromJson(from.json(), from.place());
    if (const auto* view = std::get_if<SetView>(&operation)) {
        return changed({}, *view);
    }
    from.fail("must be a view");
}

// --- steps of undo

// Calls `visit` with the name and the value of each member of an edit that need not be there.
template <typename E, typename Visit>
void forEachPart(E& edit, Visit visit) {
    visit("cut", edit.cut);
    visit("trim", edit.trim);
    visit("partsBefore", edit.partsBefore);
    visit("partsAfter", edit.partsAfter);
    visit("segmentsBefore", edit.segmentsBefore);
    visit("segmentsAfter", edit.segmentsAfter);
    visit("geometryBefore", edit.geometryBefore);
    visit("geometryAfter", edit.geometryAfter);
    visit("measurementsBefore", edit.measurementsBefore);
    visit("measurementsAfter", edit.measurementsAfter);
}

Json writePart(StateWriter& file, const std::optional<sculpt::BrickDelta>& part) {
    return stored(file, *part);
}
Json writePart(StateWriter&, const std::optional<SavedParts>& part) { return stored(*part); }
Json writePart(StateWriter&, const std::optional<SegmentList>& part) { return vs::write(*part, Rule()); }
Json writePart(StateWriter&, const std::optional<volume::GridGeometry>& part) { return stored(*part); }
Json writePart(StateWriter&, const Measurements& part) { return stored(part); }

void readPart(StateReader& file, const JsonReader& from, glm::ivec3 dims,
              std::optional<sculpt::BrickDelta>& part) {
    part = readDelta(file, from, dims);
}
void readPart(StateReader&, const JsonReader& from, glm::ivec3, std::optional<SavedParts>& part) {
    part = readParts(from);
}
void readPart(StateReader&, const JsonReader& from, glm::ivec3, std::optional<SegmentList>& part) {
    vs::read(from, part.emplace(), Rule());
}
void readPart(StateReader&, const JsonReader& from, glm::ivec3 dims,
              std::optional<volume::GridGeometry>& part) {
    part = readGeometry(from, dims);
}
void readPart(StateReader&, const JsonReader& from, glm::ivec3, Measurements& part) {
    part = readMeasurements(from);
}

Json stored(StateWriter& file, const SavedEdit& edit) {
    Json json{{"operation", toJson(*edit.operation)},
              {"limited", edit.isLimited},
              {"changesSegments", edit.changesSegments}};
    forEachPart(edit, [&](const char* name, const auto& part) {
        if (part) {
            json[name] = writePart(file, part);
        }
    });
    Json growth = Json::array();
    for (const segment::GrowthUndo& undo : edit.growth) {
        growth.push_back(stored(file, undo));
    }
    json["growth"] = std::move(growth);
    return json;
}

SavedEdit readEdit(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    SavedEdit edit;
    const JsonReader operation = from.member("operation");
    edit.operation =
        std::make_shared<const Operation>(operationFromJson(operation.json(), operation.place()));
    edit.isLimited = from.member("limited").boolean();
    edit.changesSegments = from.member("changesSegments").boolean();
    forEachPart(edit, [&](const char* name, auto& part) {
        from.ifHas(name, [&](const JsonReader& r) { readPart(file, r, dims, part); });
    });
    forEachIn(from.member("growth"),
              [&](const JsonReader& one) { edit.growth.push_back(readGrowthUndo(file, one, dims)); });
    return edit;
}

Json stored(StateWriter& file, const std::vector<SavedEdit>& edits) {
    Json list = Json::array();
    for (const SavedEdit& edit : edits) {
        list.push_back(stored(file, edit));
    }
    return list;
}

std::vector<SavedEdit> readEdits(StateReader& file, const JsonReader& from, glm::ivec3 dims) {
    std::vector<SavedEdit> edits;
    forEachIn(from, [&](const JsonReader& one) { edits.push_back(readEdit(file, one, dims)); });
    return edits;
}

// Each record of growth undoes what the segments are once all later ones are undone.
void checkGrowth(const JsonReader& from, const DocumentState& state) {
    std::map<std::uint8_t, int> extents;
    int label = 1;
    if (state.growth) {
        label = state.growth->label;
        extents[state.growth->label] = state.growth->atWork.state.extent;
        for (const auto& [other, run] : state.growth->others) {
            extents[other] = run.state.extent;
        }
    }
    for (auto edit = state.done.rbegin(); edit != state.done.rend(); ++edit) {
        for (auto undo = edit->growth.rbegin(); undo != edit->growth.rend(); ++undo) {
            const auto& held = undo->content();
            if (!state.growth || held.labelAfter != label || held.extentAfter != extents[held.labelAfter]) {
                from.fail("undo does not fit what the segments are");
            }
            label = held.labelBefore;
            extents[held.labelBefore] = held.before.extent;
        }
    }
}

} // namespace

nlohmann::ordered_json stored(StateWriter& file, const DocumentState& state) {
    Json json{{"view", toJson(setViewTo(state.view))},
              {"geometry", stored(state.geometry)},
              {"precision", 8 << int(state.precision)},
              {"cut", stored(file, state.cut)},
              {"versions", {state.sculptureVersion, state.sculptureContentVersion}},
              {"parts", stored(state.parts)},
              {"segments", vs::write(state.segments, Rule())},
              {"measurements", stored(state.measurements)}};
    if (state.trimmed) {
        json["trimmed"] = stored(file, *state.trimmed);
    }
    Json pastes = Json::array();
    for (const sculpt::BrickDelta& paste : state.pastes) {
        pastes.push_back(stored(file, paste));
    }
    json["pastes"] = std::move(pastes);
    if (state.growth) {
        json["growth"] = stored(file, *state.growth);
    }
    json["done"] = stored(file, state.done);
    json["undone"] = stored(file, state.undone);
    return json;
}

DocumentState readState(StateReader& file, glm::ivec3 dims) {
    const JsonReader from = file.contents();
    DocumentState state;
    state.view = readView(from.member("view"));
    state.geometry = readGeometry(from.member("geometry"), dims);
    state.precision = readPrecision(from.member("precision"));
    state.cut = readDelta(file, from.member("cut"), dims);
    state.sculptureVersion = std::uint64_t(from.member("versions").at(0).integerBetween(0, kAnyNumber));
    state.sculptureContentVersion =
        std::uint64_t(from.member("versions").at(1).integerBetween(0, kAnyNumber));
    state.parts = readParts(from.member("parts"));
    vs::read(from.member("segments"), state.segments, Rule());
    state.measurements = readMeasurements(from.member("measurements"));
    from.ifHas("trimmed", [&](const JsonReader& r) { state.trimmed = readDelta(file, r, dims); });
    forEachIn(from.member("pastes"),
              [&](const JsonReader& one) { state.pastes.push_back(readDelta(file, one, dims)); });
    from.ifHas("growth", [&](const JsonReader& r) { state.growth = readGrowth(file, r, dims); });
    state.done = readEdits(file, from.member("done"), dims);
    state.undone = readEdits(file, from.member("undone"), dims);
    checkGrowth(from.member("done"), state);
    return state;
}

} // namespace vs::studio
