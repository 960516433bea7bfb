// SPDX-License-Identifier: Apache-2.0
#include "render/colours/transfer_function_json.h"

#include "base/json_reader.h"
#include "render/colours/colour_map.h"

#include <nlohmann/json.hpp>

namespace vs::render {

using Json = nlohmann::ordered_json;

namespace {

// The texts that stand for enumerators, in the enumerators' order.
constexpr std::array<const char*, 3> kKinds{"intensity", "gradient", "two-dimensional"};
constexpr std::array<const char*, 3> kPositions{"absolute", "relative", "robust"};
constexpr std::array<const char*, 2> kCombines{"over", "max"};
enum class Form { Box, Trapezoid, Painting };
constexpr std::array<const char*, 3> kForms{"box", "trapezoid", "painting"};

constexpr int kVersion = 1;
constexpr std::size_t kMostPoints = 4096;
constexpr std::size_t kMostShapes = 256;
constexpr std::size_t kMostCells = 256; // along either side of a painting

// --- reading

double readPosition(const JsonReader& reader) {
    constexpr double farthest = 1e12;
    return reader.numberBetween(-farthest, farthest);
}

Range readRange(const JsonReader& reader) {
    reader.expectSize(2);
    const Range range{readPosition(reader.at(0)), readPosition(reader.at(1))};
    if (range.lo > range.hi) {
        reader.fail("its first number must not be above its second");
    }
    return range;
}

Colour readColour(const JsonReader& reader) {
    const std::string text = reader.text();
    const bool isHex = text.size() == 7 && text[0] == '#' &&
                       text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!isHex) {
        reader.fail("'" + text + "' is no colour; write #rrggbb (hexadecimal, display sRGB)");
    }
    const unsigned long rgb = std::stoul(text.substr(1), nullptr, 16);
    return {(rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255};
}

SpreadColours readSpreadColours(const JsonReader& reader) {
    reader.allow({"name", "range"});
    SpreadColours colours;
    const JsonReader name = reader.member("name");
    colours.map = name.text();
    if (findColourMap(colours.map) == nullptr) {
        name.fail("'" + colours.map + "' is not known; choose one of " + colourMapNames());
    }
    colours.range = readRange(reader.member("range"));
    return colours;
}

std::size_t sizeBetween(const JsonReader& reader, std::size_t least, std::size_t most, const char* what) {
    const std::size_t size = reader.size();
    if (size < least || size > most) {
        reader.fail(fmt::format("has {} {}; {} to {} are allowed", size, what, least, most));
    }
    return size;
}

void readPoints(const JsonReader& reader, TransferFunction& function) {
    const std::size_t count = sizeBetween(reader, 1, kMostPoints, "points");
    for (std::size_t i = 0; i < count; ++i) {
        const JsonReader point = reader.at(i);
        ControlPoint out;
        if (function.colours) {
            point.allow({"at", "opacity"}); // colours come from the map
        } else {
            point.allow({"at", "opacity", "colour"});
            out.colour = readColour(point.member("colour"));
        }
        out.position = readPosition(point.member("at"));
        out.opacity = point.member("opacity").numberBetween(0, 1);
        if (i > 0 && out.position < function.points.back().position) {
            point.member("at").fail(fmt::format("{} is below the point before it ({}); points must ascend",
                                                out.position, function.points.back().position));
        }
        function.points.push_back(out);
    }
}

Trapezoid readTrapezoid(const JsonReader& reader, Form form) {
    Trapezoid out;
    if (form == Form::Box) {
        reader.allow({"shape", "values", "gradients", "soft", "colour", "opacity"});
        out.base = out.top = readRange(reader.member("values"));
    } else {
        reader.allow({"shape", "base", "top", "gradients", "soft", "colour", "opacity"});
        out.base = readRange(reader.member("base"));
        out.top = readRange(reader.member("top"));
    }
    out.gradients = readRange(reader.member("gradients"));
    reader.ifHas("soft", [&](const JsonReader& r) {
        r.expectSize(2);
        out.soft = {r.at(0).numberBetween(0, 1), r.at(1).numberBetween(0, 1)};
    });
    return out;
}

Painting readPainting(const JsonReader& reader) {
    reader.allow({"shape", "values", "gradients", "cells", "colour", "opacity"});
    Painting out;
    out.values = readRange(reader.member("values"));
    out.gradients = readRange(reader.member("gradients"));
    const JsonReader rows = reader.member("cells");
    out.size.y = int(sizeBetween(rows, 1, kMostCells, "rows"));
    out.size.x = int(sizeBetween(rows.at(0), 1, kMostCells, "cells"));
    for (std::size_t j = 0; j < std::size_t(out.size.y); ++j) {
        const JsonReader row = rows.at(j);
        row.expectSize(std::size_t(out.size.x));
        for (std::size_t i = 0; i < std::size_t(out.size.x); ++i) {
            out.cells.push_back(std::uint8_t(row.at(i).integerBetween(0, 255)));
        }
    }
    return out;
}

Shape readShape(const JsonReader& reader) {
    const Form form = reader.member("shape").choice<Form>(kForms);
    Shape out;
    if (form == Form::Painting) {
        out.form = readPainting(reader);
    } else {
        out.form = readTrapezoid(reader, form);
    }
    out.colour = readColour(reader.member("colour"));
    out.opacity = reader.member("opacity").numberBetween(0, 1);
    return out;
}

void checkVersion(const JsonReader& root) {
    const JsonReader version = root.member("volumeStudioTransferFunction");
    if (version.integerBetween(1, 1 << 20) > kVersion) {
        version.fail(fmt::format("made by a newer Volume Studio (this program knows version {}); update it",
                                 kVersion));
    }
}

Lighting readLighting(const JsonReader& reader) {
    reader.allow({"amount", "gloss"});
    Lighting out;
    reader.ifHas("amount", [&](const JsonReader& r) { out.amount = r.numberBetween(0, 1); });
    reader.ifHas("gloss", [&](const JsonReader& r) { out.gloss = r.numberBetween(0, 1); });
    return out;
}

} // namespace

TransferFunction transferFunctionFromJson(const Json& json, const std::string& where) {
    const JsonReader root(json, where);
    TransferFunction out;
    checkVersion(root);
    out.kind = root.member("kind").choice<FunctionKind>(kKinds);
    if (out.kind == FunctionKind::TwoD) {
        root.allow({"volumeStudioTransferFunction", "name", "description", "kind", "positions", "unitMm",
                    "lighting", "combine", "shapes"});
    } else {
        root.allow({"volumeStudioTransferFunction", "name", "description", "kind", "positions", "unitMm",
                    "lighting", "colourMap", "points"});
    }
    root.ifHas("name", [&](const JsonReader& r) { out.name = r.text(); });
    root.ifHas("description", [&](const JsonReader& r) { out.description = r.text(); });
    root.ifHas("positions", [&](const JsonReader& r) { out.positions = r.choice<Positions>(kPositions); });
    root.ifHas("unitMm", [&](const JsonReader& r) { out.unitMm = r.numberBetween(1e-6, 1e6); });
    root.ifHas("lighting", [&](const JsonReader& r) { out.lighting = readLighting(r); });
    if (out.kind != FunctionKind::TwoD) {
        root.ifHas("colourMap", [&](const JsonReader& r) { out.colours = readSpreadColours(r); });
        readPoints(root.member("points"), out);
        return out;
    }
    root.ifHas("combine", [&](const JsonReader& r) { out.combine = r.choice<Combine>(kCombines); });
    const JsonReader shapes = root.member("shapes");
    const std::size_t count = sizeBetween(shapes, 1, kMostShapes, "shapes");
    for (std::size_t i = 0; i < count; ++i) {
        out.shapes.push_back(readShape(shapes.at(i)));
    }
    return out;
}

// --- writing

namespace {

Json jsonOf(const Range& range) { return Json::array({range.lo, range.hi}); }

Json jsonOf(Colour c) { return fmt::format("#{:02x}{:02x}{:02x}", c.x, c.y, c.z); }

Json jsonOf(const ControlPoint& point, bool withColour) {
    Json json{{"at", point.position}, {"opacity", point.opacity}};
    if (withColour) {
        json["colour"] = jsonOf(point.colour);
    }
    return json;
}

Json jsonOf(const Trapezoid& trapezoid) {
    Json json;
    if (trapezoid.base == trapezoid.top) {
        json = {{"shape", kForms[0]}, {"values", jsonOf(trapezoid.base)}};
    } else {
        json = {{"shape", kForms[1]}, {"base", jsonOf(trapezoid.base)}, {"top", jsonOf(trapezoid.top)}};
    }
    json["gradients"] = jsonOf(trapezoid.gradients);
    json["soft"] = {trapezoid.soft.x, trapezoid.soft.y};
    return json;
}

Json jsonOf(const Painting& painting) {
    Json rows = Json::array();
    for (int j = 0; j < painting.size.y; ++j) {
        const auto first = painting.cells.begin() + std::ptrdiff_t(j) * painting.size.x;
        rows.push_back(std::vector<int>(first, first + painting.size.x));
    }
    return {{"shape", kForms[2]},
            {"values", jsonOf(painting.values)},
            {"gradients", jsonOf(painting.gradients)},
            {"cells", rows}};
}

Json jsonOf(const Shape& shape) {
    Json json = std::visit([](const auto& form) { return jsonOf(form); }, shape.form);
    json["colour"] = jsonOf(shape.colour);
    json["opacity"] = shape.opacity;
    return json;
}

} // namespace

Json toJson(const TransferFunction& f) {
    Json json{{"volumeStudioTransferFunction", kVersion},
              {"name", f.name},
              {"description", f.description},
              {"kind", kKinds[std::size_t(f.kind)]},
              {"positions", kPositions[std::size_t(f.positions)]}};
    if (f.unitMm) {
        json["unitMm"] = *f.unitMm;
    }
    json["lighting"] = {{"amount", f.lighting.amount}, {"gloss", f.lighting.gloss}};
    if (f.kind == FunctionKind::TwoD) {
        json["combine"] = kCombines[std::size_t(f.combine)];
        json["shapes"] = Json::array();
        for (const Shape& shape : f.shapes) {
            json["shapes"].push_back(jsonOf(shape));
        }
        return json;
    }
    if (f.colours) {
        json["colourMap"] = {{"name", f.colours->map}, {"range", jsonOf(f.colours->range)}};
    }
    json["points"] = Json::array();
    for (const ControlPoint& point : f.points) {
        json["points"].push_back(jsonOf(point, !f.colours));
    }
    return json;
}

} // namespace vs::render
