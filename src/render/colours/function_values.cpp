// SPDX-License-Identifier: Apache-2.0
#include "render/colours/function_values.h"

#include <algorithm>

namespace vs::render {

ShapeInFiles::ShapeInFiles(const Shape& shape) : colour(shape.colour), opacity(shape.opacity) {
    if (const auto* trapezoid = std::get_if<Trapezoid>(&shape.form)) {
        form = trapezoid->base == trapezoid->top ? Form::Box : Form::Trapezoid;
        values = base = trapezoid->base;
        top = trapezoid->top;
        gradients = trapezoid->gradients;
        soft = trapezoid->soft;
        return;
    }
    const auto& painting = std::get<Painting>(shape.form);
    form = Form::Painting;
    values = painting.values;
    gradients = painting.gradients;
    for (int j = 0; j < painting.size.y; ++j) {
        const auto first = painting.cells.begin() + std::ptrdiff_t(j) * painting.size.x;
        cells.emplace_back(first, first + painting.size.x);
    }
}

Shape ShapeInFiles::value() && {
    if (form == Form::Painting) {
        Painting painting{values, gradients, {int(cells[0].size()), int(cells.size())}, {}};
        for (const std::vector<int>& row : cells) {
            painting.cells.insert(painting.cells.end(), row.begin(), row.end());
        }
        return {std::move(painting), colour, opacity};
    }
    const bool isBox = form == Form::Box;
    return {Trapezoid{isBox ? values : base, isBox ? values : top, gradients, soft}, colour, opacity};
}

Fault ShapeInFiles::faultOf() const {
    const auto differs = [&](const auto& row) { return row.size() != cells[0].size(); };
    const auto odd = std::find_if(cells.begin(), cells.end(), differs);
    if (odd == cells.end()) {
        return {};
    }
    return {fmt::format("cells[{}]", odd - cells.begin()),
            fmt::format("must be a list of {} numbers", cells[0].size())};
}

Fault TransferFunction::faultOf() const {
    const auto falls = [](const auto& a, const auto& b) { return b.position < a.position; };
    const auto before = std::adjacent_find(points.begin(), points.end(), falls);
    if (before == points.end()) {
        return {};
    }
    return {fmt::format("points[{}].at", before - points.begin() + 1),
            fmt::format("{} is below the point before it ({}); points must ascend", (before + 1)->position,
                        before->position)};
}

} // namespace vs::render

namespace vs {

void read(const JsonReader& reader, render::Colour& value, const Rule&) {
    const std::string text = reader.text();
    const bool isHex = text.size() == 7 && text[0] == '#' &&
                       text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!isHex) {
        reader.fail("'" + text + "' is no colour; write #rrggbb (hexadecimal, display sRGB)");
    }
    const unsigned long rgb = std::stoul(text.substr(1), nullptr, 16);
    value = {(rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255};
}
Json write(const render::Colour& value, const Rule&) {
    return fmt::format("#{:02x}{:02x}{:02x}", value.x, value.y, value.z);
}
Json schemaOf(Type<render::Colour>, const Rule& rule, Json&) {
    return {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}, {"description", rule.unit}};
}

} // namespace vs
