// SPDX-License-Identifier: Apache-2.0
#include "studio/json/state_json.h"

#include "base/described_json.h"
#include "studio/json/edit_json.h"
#include "studio/json/filled_json.h"
#include "studio/json/growth_json.h"
#include "studio/json/kept_json.h"
#include "studio/json/marks_json.h"
#include "studio/json/operation_json.h"
#include "studio/json/session_json.h"

namespace vs::studio {

namespace {

View readView(const JsonReader& from) {
    const Operation operation = operationFromJson(from.json(), from.place());
    if (const auto* view = std::get_if<SetView>(&operation)) {
        return changed({}, *view);
    }
    from.fail("must be a view");
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
    if (!state.marks->isEmpty()) {
        json["marks"] = stored(file, state.marks);
    }
    if (!state.filled.materials->empty()) {
        json["filled"] = stored(file, state.filled);
    }
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
    from.ifHas("marks", [&](const JsonReader& r) { state.marks = readMarks(file, r, dims); });
    state.filled = Filled(dims);
    from.ifHas("filled", [&](const JsonReader& r) { state.filled = readFilled(file, r, dims); });
    from.ifHas("trimmed", [&](const JsonReader& r) { state.trimmed = readDelta(file, r, dims); });
    forEachIn(from.member("pastes"),
              [&](const JsonReader& one) { state.pastes.push_back(readDelta(file, one, dims)); });
    from.ifHas("growth", [&](const JsonReader& r) { state.growth = readGrowth(file, r, dims); });
    state.done = readEdits(file, from.member("done"), dims, true);
    state.undone = readEdits(file, from.member("undone"), dims, false);
    checkUndo(from.member("done"), state);
    return state;
}

} // namespace vs::studio
