// SPDX-License-Identifier: Apache-2.0
// Seeding, growing and the editing of segments in session files.
#include "studio/json/operation_json.h"
#include "studio/json/operation_json_parts.h"
#include "studio/operations/operation_names.h"

namespace vs::studio {

namespace {

constexpr int kMostGenerations = 1 << 30;
constexpr double kMostMm = 1e4;

std::string readName(const JsonReader& reader) {
    const std::string name = reader.text();
    if (name.empty() || name.size() > 200) {
        reader.fail("must be a name of 1 to 200 characters");
    }
    return name;
}

} // namespace

Operation readGrow(const JsonReader& reader) {
    reader.allow({"op", "generations", "sculptureView"});
    Grow op;
    reader.ifHas("generations",
                 [&](const JsonReader& r) { op.generations = int(r.integerBetween(0, kMostGenerations)); });
    reader.ifHas("sculptureView", [&](const JsonReader& r) {
        op.sculptureView = r.choice<field::SculptureView>(kSculptureViews);
    });
    return op;
}

void write(Json& j, const Grow& op) {
    if (op.generations) {
        j["generations"] = *op.generations;
    }
    if (op.sculptureView) {
        j["sculptureView"] = kSculptureViews[std::size_t(*op.sculptureView)];
    }
}

Operation readRewind(const JsonReader& reader) {
    reader.allow({"op", "generations"});
    return Rewind{int(reader.member("generations").integerBetween(0, kMostGenerations))};
}

void write(Json& j, const Rewind& op) { j["generations"] = op.generations; }

Operation readShowGeneration(const JsonReader& reader) {
    reader.allow({"op", "generation"});
    return ShowGeneration{int(reader.member("generation").integerBetween(0, kMostGenerations))};
}

void write(Json& j, const ShowGeneration& op) { j["generation"] = op.generation; }

Operation readGrowthRules(const JsonReader& reader) {
    reader.allow({"op", "range", "difference", "gradient", "gradientDifference", "connectivity", "live"});
    SetGrowthRules op;
    const auto rule = [&](const char* key, std::optional<std::optional<Range>>& into) {
        reader.ifHas(key, [&](const JsonReader& r) {
            into = r.isNull() ? std::optional<Range>() : std::optional<Range>(readRange(r));
        });
    };
    reader.ifHas("range", [&](const JsonReader& r) { op.range = readRange(r); });
    rule("difference", op.difference);
    rule("gradient", op.gradient);
    rule("gradientDifference", op.gradientDifference);
    reader.ifHas("connectivity", [&](const JsonReader& r) { op.connectivity = readConnectivity(r); });
    reader.ifHas("live", [&](const JsonReader& r) { op.isLive = r.boolean(); });
    return op;
}

void write(Json& j, const SetGrowthRules& op) {
    const auto rule = [&](const char* key, const std::optional<std::optional<Range>>& value) {
        if (value) {
            j[key] = *value ? studio::toJson(**value) : Json();
        }
    };
    addIfSet(j, "range", op.range);
    rule("difference", op.difference);
    rule("gradient", op.gradient);
    rule("gradientDifference", op.gradientDifference);
    if (op.connectivity) {
        j["connectivity"] = *op.connectivity;
    }
    if (op.isLive) {
        j["live"] = *op.isLive;
    }
}

Operation readUseSegment(const JsonReader& reader) {
    reader.allow({"op", "segment", "name", "colour", "opacity", "visible", "locked", "work", "first"});
    UseSegment op;
    op.segment = readName(reader.member("segment"));
    reader.ifHas("name", [&](const JsonReader& r) { op.name = readName(r); });
    reader.ifHas("colour", [&](const JsonReader& r) {
        r.expectSize(3);
        op.colour =
            glm::dvec3(r.at(0).numberBetween(0, 1), r.at(1).numberBetween(0, 1), r.at(2).numberBetween(0, 1));
    });
    reader.ifHas("opacity", [&](const JsonReader& r) { op.opacity = r.numberBetween(0.01, 1); });
    reader.ifHas("visible", [&](const JsonReader& r) { op.isVisible = r.boolean(); });
    reader.ifHas("locked", [&](const JsonReader& r) { op.isLocked = r.boolean(); });
    reader.ifHas("work", [&](const JsonReader& r) { op.goesToWork = r.boolean(); });
    reader.ifHas("first", [&](const JsonReader& r) { op.takesFirst = r.boolean(); });
    return op;
}

void write(Json& j, const UseSegment& op) {
    j["segment"] = op.segment;
    if (op.name) {
        j["name"] = *op.name;
    }
    addIfSet(j, "colour", op.colour);
    if (op.opacity) {
        j["opacity"] = *op.opacity;
    }
    if (op.isVisible) {
        j["visible"] = *op.isVisible;
    }
    if (op.isLocked) {
        j["locked"] = *op.isLocked;
    }
    if (!op.goesToWork) {
        j["work"] = false;
    }
    if (op.takesFirst) {
        j["first"] = *op.takesFirst;
    }
}

Operation readLoadLabels(const JsonReader& reader) {
    reader.allow({"op", "path", "checksum"});
    LoadLabels op;
    op.path = reader.member("path").fileName();
    reader.ifHas("checksum", [&](const JsonReader& r) { op.checksum = r.text(); });
    return op;
}

void write(Json& j, const LoadLabels& op) {
    j["path"] = op.path.string();
    if (!op.checksum.empty()) {
        j["checksum"] = op.checksum;
    }
}

Operation readRemoveSegment(const JsonReader& reader) {
    reader.allow({"op", "segment"});
    return RemoveSegment{readName(reader.member("segment"))};
}

void write(Json& j, const RemoveSegment& op) { j["segment"] = op.segment; }

Operation readEditSegment(const JsonReader& reader) {
    reader.allow({"op", "edit", "amount", "other", "pixel", "voxel", "canvas"});
    EditSegment op;
    op.kind = reader.member("edit").choice<EditSegment::Kind>(kSegmentEdits);
    reader.ifHas("amount", [&](const JsonReader& r) { op.amount = r.numberBetween(-kMostMm, kMostMm); });
    reader.ifHas("other", [&](const JsonReader& r) { op.other = readName(r); });
    reader.ifHas("pixel", [&](const JsonReader& r) { op.pixel = readPoint(r); });
    reader.ifHas("voxel", [&](const JsonReader& r) { op.voxel = readVoxel(r); });
    reader.ifHas("canvas", [&](const JsonReader& r) { op.canvas = readCanvas(r); });
    return op;
}

void write(Json& j, const EditSegment& op) {
    j["edit"] = kSegmentEdits[std::size_t(op.kind)];
    j["amount"] = op.amount;
    if (!op.other.empty()) {
        j["other"] = op.other;
    }
    if (op.pixel) {
        j["pixel"] = pair(op.pixel->x, op.pixel->y);
    }
    if (op.voxel) {
        j["voxel"] = toJson(*op.voxel);
    }
    addIfSet(j, "canvas", op.canvas);
}

Operation readBrushSegment(const JsonReader& reader) {
    reader.allow({"op", "adds", "stroke"});
    BrushSegment op;
    op.isToAdd = reader.member("adds").boolean();
    const JsonReader stroke = reader.member("stroke");
    const Operation drawn = operationFromJson(stroke.json(), stroke.place());
    const bool isKnown = std::visit(
        [&](const auto& one) {
            if constexpr (std::is_constructible_v<decltype(op.stroke), decltype(one)>) {
                op.stroke = one;
                return true;
            } else {
                return false;
            }
        },
        drawn);
    if (!isKnown) {
        stroke.fail("must be a peel, drill, laser or scissors");
    }
    return op;
}

void write(Json& j, const BrushSegment& op) {
    j["adds"] = op.isToAdd;
    j["stroke"] = std::visit([](const auto& stroke) { return toJson(Operation(stroke)); }, op.stroke);
}

Operation readCutSegment(const JsonReader& reader) {
    reader.allow({"op", "keeps", "margin"});
    CutSegment op;
    reader.ifHas("keeps", [&](const JsonReader& r) { op.keeps = r.boolean(); });
    reader.ifHas("margin", [&](const JsonReader& r) { op.marginMm = r.numberBetween(-kMostMm, kMostMm); });
    return op;
}

void write(Json& j, const CutSegment& op) {
    j["keeps"] = op.keeps;
    j["margin"] = op.marginMm;
}

} // namespace vs::studio
