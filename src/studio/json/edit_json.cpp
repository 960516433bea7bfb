// SPDX-License-Identifier: Apache-2.0
#include "studio/json/edit_json.h"

#include "base/described_json.h"
#include "studio/json/filled_json.h"
#include "studio/json/growth_json.h"
#include "studio/json/marks_json.h"
#include "studio/json/operation_json.h"
#include "volume/reading/label_map.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace vs::studio {

namespace {

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
    visit("marksBefore", edit.marksBefore);
    visit("marksAfter", edit.marksAfter);
    visit("filledBefore", edit.filledBefore);
    visit("filledAfter", edit.filledAfter);
}

Json writePart(StateWriter& file, const std::optional<sculpt::BrickDelta>& part) {
    return stored(file, *part);
}
Json writePart(StateWriter&, const std::optional<SavedParts>& part) { return stored(*part); }
Json writePart(StateWriter&, const std::optional<SegmentList>& part) { return vs::write(*part, Rule()); }
Json writePart(StateWriter&, const std::optional<volume::GridGeometry>& part) { return stored(*part); }
Json writePart(StateWriter&, const Measurements& part) { return stored(part); }
Json writePart(StateWriter& file, const field::SharedMarks& part) { return stored(file, part); }
Json writePart(StateWriter& file, const std::optional<Filled>& part) { return stored(file, *part); }

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
void readPart(StateReader& file, const JsonReader& from, glm::ivec3 dims, std::optional<Filled>& part) {
    part = readFilled(file, from, dims);
}
void readPart(StateReader& file, const JsonReader& from, glm::ivec3 dims, field::SharedMarks& part) {
    part = readMarks(file, from, dims);
}
void readPart(StateReader&, const JsonReader& from, glm::ivec3, Measurements& part) {
    part = readMeasurements(from);
}

// A label map that was opened: redo takes it from here, and the file may be gone by then.
Json storedLabels(StateWriter& file, const std::shared_ptr<const volume::LabelMap>& map) {
    Json looks = Json::array();
    for (const auto& [value, look] : map->looks) {
        Json json{{"value", value}, {"name", look.name}};
        if (look.colour) {
            json["colour"] = vs::write(*look.colour, Rule());
        }
        looks.push_back(std::move(json));
    }
    // Several steps may have the same one.
    const std::shared_ptr<const std::vector<std::uint8_t>> labels(map, &map->labels);
    return {{"voxels", file.shared(labels)}, {"values", map->values}, {"looks", std::move(looks)}};
}

long anyNumber(const JsonReader& from) {
    return from.integerBetween(std::numeric_limits<long>::min(), kAnyNumber);
}

std::shared_ptr<const volume::LabelMap> readLabels(StateReader& file, const JsonReader& from,
                                                   glm::ivec3 dims) {
    constexpr std::size_t mostLabels = 256;
    const std::size_t voxels = Box3{glm::ivec3(0), dims}.volume();
    auto map = std::make_shared<volume::LabelMap>();
    map->geometry.dims = dims;
    map->labels = *file.shared<std::uint8_t>(from.member("voxels"), voxels);
    forEachIn(from.member("values"), [&](const JsonReader& one) { map->values.push_back(anyNumber(one)); });
    const bool areLabels = std::all_of(map->labels.begin(), map->labels.end(),
                                       [&](std::uint8_t label) { return label < map->values.size(); });
    if (map->labels.size() != voxels || map->values.size() > mostLabels || !areLabels) {
        from.fail("must be a label map of the volume");
    }
    forEachIn(from.member("looks"), [&](const JsonReader& one) {
        auto& look = map->looks[anyNumber(one.member("value"))];
        look.name = one.member("name").text();
        one.ifHas("colour",
                  [&](const JsonReader& r) { vs::read(r, look.colour.emplace(), {.least = 0, .most = 1}); });
    });
    return map;
}

// Whether an operation says what only doing it for the first time finds.
bool canBeDoneAgain(const Operation& operation) {
    if (const auto* seed = std::get_if<Seed>(&operation)) {
        return seed->range && seed->canvas;
    }
    if (const auto* grow = std::get_if<Grow>(&operation)) {
        return grow->sculptureView.has_value();
    }
    if (const auto* edit = std::get_if<EditSegment>(&operation)) {
        const bool isOfIsland =
            edit->kind == EditSegment::Kind::KeepIsland || edit->kind == EditSegment::Kind::DropIsland;
        return !isOfIsland || edit->voxel || edit->finest;
    }
    const auto* labels = std::get_if<LoadLabels>(&operation);
    return labels == nullptr || labels->map;
}

Json storedEdit(StateWriter& file, const SavedEdit& edit) {
    Json json{{"operation", toJson(*edit.operation)},
              {"limited", edit.isLimited},
              {"changesSegments", edit.changesSegments}};
    forEachPart(edit, [&](const char* name, const auto& part) {
        if (part) {
            json[name] = writePart(file, part);
        }
    });
    if (edit.cutContent) {
        json["cutContent"] = *edit.cutContent;
    }
    Json growth = Json::array();
    for (const segment::GrowthUndo& undo : edit.growth) {
        growth.push_back(stored(file, undo));
    }
    json["growth"] = std::move(growth);
    if (const auto* labels = std::get_if<LoadLabels>(edit.operation.get()); labels && labels->map) {
        json["labels"] = storedLabels(file, labels->map);
    }
    return json;
}

SavedEdit readEdit(StateReader& file, const JsonReader& from, glm::ivec3 dims, bool isDone) {
    SavedEdit edit;
    const JsonReader place = from.member("operation");
    Operation operation = operationFromJson(place.json(), place.place());
    if (auto* labels = std::get_if<LoadLabels>(&operation)) {
        labels->map = readLabels(file, from.member("labels"), dims);
    }
    if (!canBeDoneAgain(operation)) {
        place.fail("must say all that doing it again needs");
    }
    edit.operation = std::make_shared<const Operation>(std::move(operation));
    edit.isLimited = from.member("limited").boolean();
    edit.changesSegments = from.member("changesSegments").boolean();
    forEachPart(edit, [&](const char* name, auto& part) {
        from.ifHas(name, [&](const JsonReader& r) { readPart(file, r, dims, part); });
    });
    from.ifHas("cutContent", [&](const JsonReader& r) {
        edit.cutContent = std::uint64_t(r.integerBetween(0, std::numeric_limits<long>::max()));
    });
    forEachIn(from.member("growth"),
              [&](const JsonReader& one) { edit.growth.push_back(readGrowthUndo(file, one, dims)); });
    if (isDone && edit.growth.empty() == edit.changesSegments) {
        from.member("changesSegments").fail("must be what its undo says");
    }
    return edit;
}

// What the segments are while undo goes back through its steps.
struct Rewinding {
    struct Run {
        int extent = 0;
        bool forbids = false;
    };
    std::map<std::uint8_t, Run> runs;
    std::uint8_t label = 1;

    explicit Rewinding(const std::optional<segment::GrowthSnapshot>& growth) {
        if (growth) {
            label = growth->label;
            add(growth->label, growth->atWork);
            for (const auto& [other, run] : growth->others) {
                add(other, run);
            }
        }
    }
    // Whether a record undoes what there is; afterwards that is undone.
    bool takesBack(const segment::GrowthUndo::Content& held) {
        if (held.labelAfter != label || held.extentAfter != runs[label].extent ||
            (!held.allowedAgain.empty() && !runs[label].forbids)) {
            return false;
        }
        label = held.labelBefore;
        Run& run = runs[label];
        run.extent = held.before.extent;
        run.forbids = held.changesForbidden ? !held.forbidden.empty() : run.forbids;
        return true;
    }

private:
    void add(std::uint8_t of, const segment::GrowthSnapshot::Run& run) {
        runs[of] = {run.state.extent, !run.forbidden.empty()};
    }
};

} // namespace

Json stored(StateWriter& file, const std::vector<SavedEdit>& edits) {
    Json list = Json::array();
    for (const SavedEdit& edit : edits) {
        list.push_back(storedEdit(file, edit));
    }
    return list;
}

std::vector<SavedEdit> readEdits(StateReader& file, const JsonReader& from, glm::ivec3 dims, bool areDone) {
    std::vector<SavedEdit> edits;
    forEachIn(from, [&](const JsonReader& one) { edits.push_back(readEdit(file, one, dims, areDone)); });
    return edits;
}

// Each record of growth undoes what the segments are once all later ones are undone, and trims are of what is
// trimmed.
void checkUndo(const JsonReader& from, const DocumentState& state) {
    Rewinding segments(state.growth);
    for (auto edit = state.done.rbegin(); edit != state.done.rend(); ++edit) {
        for (auto undo = edit->growth.rbegin(); undo != edit->growth.rend(); ++undo) {
            if (!state.growth || !segments.takesBack(undo->content())) {
                from.fail("undo does not fit what the segments are");
            }
        }
    }
    for (const auto* edits : {&state.done, &state.undone}) {
        for (const SavedEdit& edit : *edits) {
            if (edit.trim && !state.trimmed) {
                from.fail("undo changes what is trimmed, and nothing is");
            }
        }
    }
}

} // namespace vs::studio
