// SPDX-License-Identifier: Apache-2.0
#include "studio/json/value_json.h"

#include "render/colours/transfer_function_json.h"

#include <fmt/ranges.h>

namespace vs {

using studio::Clip;
using studio::kPixels;

namespace {

constexpr double kMostTilt = 60; // degrees
constexpr Rule kPressure{.least = 0, .most = 1};
constexpr Rule kTilt{.least = -kMostTilt, .most = kMostTilt, .unit = "degrees"};

} // namespace

void read(const JsonReader& reader, Clip::Box& value, const Rule& rule) {
    if (reader.size() != 2) {
        reader.fail("must be a list of two places, the lower and the upper corner, in voxels");
    }
    read(reader.at(0), value.lo, rule);
    read(reader.at(1), value.hi, rule);
}
Json write(const Clip::Box& value, const Rule& rule) {
    return Json::array({write(value.lo, rule), write(value.hi, rule)});
}
Json schemaOf(Type<Clip::Box>, const Rule& rule, Json& definitions) {
    return listSchema(schemaOf(Type<glm::dvec3>(), rule, definitions), {.leastCount = 2, .mostCount = 2});
}

void read(const JsonReader& reader, sculpt::PenPoint& value, const Rule&) {
    if (reader.size() != 3 && reader.size() != 5) {
        reader.fail("must be a list of 3 numbers, x, y and pressure, or of 5 with the pen's tilt in x and y");
    }
    for (int i = 0; i < 2; ++i) {
        read(reader.at(std::size_t(i)), value.pixel[i], kPixels);
    }
    read(reader.at(2), value.pressure, kPressure);
    for (int i = 0; i < 2 && reader.size() == 5; ++i) {
        read(reader.at(std::size_t(3 + i)), value.tiltDegrees[i], kTilt);
    }
}
Json write(const sculpt::PenPoint& value, const Rule&) {
    Json point = Json::array({value.pixel.x, value.pixel.y, value.pressure});
    if (value.tiltDegrees != glm::dvec2(0)) {
        point.push_back(value.tiltDegrees.x);
        point.push_back(value.tiltDegrees.y);
    }
    return point;
}
Json schemaOf(Type<sculpt::PenPoint>, const Rule&, Json& definitions) {
    const auto of = [&](const Rule& rule) { return schemaOf(Type<double>(), rule, definitions); };
    return {
        {"description", "x, y, pressure and, if known, the pen's tilt to the right and towards the person"},
        {"type", "array"},
        {"prefixItems", Json::array({of(kPixels), of(kPixels), of(kPressure), of(kTilt), of(kTilt)})},
        {"minItems", 3},
        {"maxItems", 5}};
}

void read(const JsonReader& reader, render::TransferFunction& value, const Rule&) {
    if (!reader.isText()) {
        value = render::transferFunctionFromJson(reader.json(), reader.place());
        return;
    }
    const auto preset = render::findPreset(reader.text());
    if (!preset) {
        reader.fail(fmt::format("there is no preset of that name; there are {}",
                                fmt::join(render::presetNames(), ", ")));
    }
    value = *preset;
}
Json write(const render::TransferFunction& value, const Rule&) {
    for (const std::string& name : render::presetNames()) {
        if (render::findPreset(name) == value) {
            return name;
        }
    }
    return render::toJson(value);
}

void read(const JsonReader& reader, render::Background& value, const Rule&) {
    try {
        value = render::backgroundFromName(reader.text());
    } catch (const UsageError& error) {
        reader.fail(error.what());
    }
}
Json write(const render::Background& value, const Rule&) { return render::name(value); }
Json schemaOf(Type<render::Background>, const Rule&, Json&) {
    return {{"type", "string"},
            {"pattern", "^(studio|white|black|transparent|#[0-9A-Fa-f]{6}(:#[0-9A-Fa-f]{6})?)$"}};
}

} // namespace vs
