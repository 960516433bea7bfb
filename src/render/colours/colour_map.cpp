// SPDX-License-Identifier: Apache-2.0
#include "render/colours/colour_map.h"

#include "base/phrase.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vs::render {

namespace {

// A place that a map passes: lightness 0 to 1, chroma in OKLab, hue in degrees.
struct Stop {
    double lightness;
    double chroma;
    double hueDegrees;
};

struct Recipe {
    const char* name;
    std::string_view description;
    std::vector<Stop> stops; // evenly spread; in a diverging map the middle one stands twice
    bool isDiverging = false;
};

std::vector<Recipe> recipes() {
    return {
        {VS_TEXT("library", "grey"), VS_TEXT("library", "black to white"), {{0, 0, 0}, {1, 0, 0}}},
        {VS_TEXT("library", "ivory"),
         VS_TEXT("library", "bone: umber shadows to ivory"),
         {{0.20, 0.040, 50}, {0.46, 0.075, 62}, {0.72, 0.070, 78}, {0.97, 0.022, 95}}},
        {VS_TEXT("library", "ember"),
         VS_TEXT("library", "night, embers, flame"),
         {{0.12, 0.050, 300}, {0.33, 0.125, 355}, {0.54, 0.175, 30}, {0.75, 0.155, 62}, {0.95, 0.090, 100}}},
        {VS_TEXT("library", "marine"),
         VS_TEXT("library", "deep sea to foam"),
         {{0.15, 0.070, 275},
          {0.36, 0.115, 258},
          {0.57, 0.100, 225},
          {0.77, 0.090, 190},
          {0.96, 0.035, 175}}},
        {VS_TEXT("library", "flesh"),
         VS_TEXT("library", "muscle to pale skin"),
         {{0.22, 0.080, 20}, {0.46, 0.125, 27}, {0.70, 0.095, 40}, {0.94, 0.030, 65}}},
        {VS_TEXT("library", "vessel"),
         VS_TEXT("library", "dark blood to bright blood"),
         {{0.20, 0.080, 20}, {0.43, 0.165, 25}, {0.62, 0.200, 30}, {0.78, 0.120, 50}, {0.95, 0.045, 80}}},
        {VS_TEXT("library", "tide"),
         VS_TEXT("library", "blue below, orange above, pale in the middle"),
         {{0.38, 0.110, 260},
          {0.66, 0.105, 250},
          {0.95, 0, 245},
          {0.95, 0, 65},
          {0.66, 0.115, 60},
          {0.38, 0.095, 48}},
         true},
    };
}

glm::dvec3 oklabOf(double lightness, double chroma, double hueDegrees) {
    const double hue = hueDegrees * std::numbers::pi / 180;
    return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

bool canBeShown(glm::dvec3 oklab) {
    const glm::dvec3 c = linearFromOklab(oklab);
    return std::min({c.x, c.y, c.z}) >= 0 && std::max({c.x, c.y, c.z}) <= 1;
}

// The colour with as much of its chroma as a display can show.
glm::dvec3 shown(glm::dvec3 oklab) {
    if (canBeShown(oklab)) {
        return oklab;
    }
    double inside = 0;
    double outside = 1;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (inside + outside);
        (canBeShown({oklab.x, middle * oklab.y, middle * oklab.z}) ? inside : outside) = middle;
    }
    return {oklab.x, inside * oklab.y, inside * oklab.z};
}

// The recipe's path, finely: lightness linear between stops, chroma and hue along a spline (Catmull-Rom),
// which has no corners where hue changes its pace.
std::vector<glm::dvec3> pathOf(const std::vector<Stop>& stops) {
    constexpr int perPart = 512;
    const auto spline = [](double a, double b, double c, double d, double t) {
        return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
    };
    const int parts = int(stops.size()) - 1;
    const auto stop = [&](int i) { return stops[std::size_t(std::clamp(i, 0, parts))]; };
    // The short way round the circle of hues.
    const auto hueNear = [](double hue, double reference) {
        return reference + std::remainder(hue - reference, 360.0);
    };
    std::vector<glm::dvec3> path;
    for (int i = 0; i <= parts * perPart; ++i) {
        const int part = std::min(i / perPart, parts - 1);
        const double t = double(i - part * perPart) / perPart;
        const Stop a = stop(part - 1);
        const Stop b = stop(part);
        const Stop c = stop(part + 1);
        const Stop d = stop(part + 2);
        const double hueC = hueNear(c.hueDegrees, b.hueDegrees);
        path.push_back(shown(oklabOf(b.lightness + t * (c.lightness - b.lightness),
                                     std::max(spline(a.chroma, b.chroma, c.chroma, d.chroma, t), 0.0),
                                     spline(hueNear(a.hueDegrees, b.hueDegrees), b.hueDegrees, hueC,
                                            hueNear(d.hueDegrees, hueC), t))));
    }
    return path;
}

// The same path, passed at constant speed.
std::vector<glm::dvec3> evenly(const std::vector<glm::dvec3>& path, int count) {
    std::vector<double> along{0};
    for (std::size_t i = 1; i < path.size(); ++i) {
        along.push_back(along.back() + glm::distance(path[i - 1], path[i]));
    }
    std::vector<glm::dvec3> out;
    std::size_t i = 1;
    for (int k = 0; k < count; ++k) {
        const double wanted = along.back() * k / (count - 1);
        while (i + 1 < path.size() && along[i] < wanted) {
            ++i;
        }
        out.push_back(glm::mix(path[i - 1], path[i], (wanted - along[i - 1]) / (along[i] - along[i - 1])));
    }
    return out;
}

std::vector<ColourMap> makeMaps() {
    constexpr int count = 257; // odd: a diverging map has a middle
    std::vector<ColourMap> maps;
    for (const Recipe& recipe : recipes()) {
        ColourMap map{recipe.name, recipe.description, recipe.isDiverging, {}};
        if (recipe.isDiverging) { // each half on its own, so that the middle stays the middle
            const auto middle = recipe.stops.begin() + std::ptrdiff_t(recipe.stops.size() / 2);
            map.oklab = evenly(pathOf({recipe.stops.begin(), middle}), count / 2 + 1);
            const auto rest = evenly(pathOf({middle, recipe.stops.end()}), count / 2 + 1);
            map.oklab.insert(map.oklab.end(), rest.begin() + 1, rest.end());
        } else {
            map.oklab = evenly(pathOf(recipe.stops), count);
        }
        maps.push_back(std::move(map));
    }
    return maps;
}

} // namespace

glm::dvec3 ColourMap::at(double place) const {
    const double position = std::clamp(place, 0.0, 1.0) * double(oklab.size() - 1);
    const std::size_t i = std::min(std::size_t(position), oklab.size() - 2);
    return glm::mix(oklab[i], oklab[i + 1], position - double(i));
}

std::span<const ColourMap> colourMaps() {
    static const std::vector<ColourMap> maps = makeMaps();
    return maps;
}

const ColourMap* findColourMap(std::string_view name) {
    const auto maps = colourMaps();
    const auto found = std::find_if(maps.begin(), maps.end(), [&](const auto& m) { return m.name == name; });
    return found == maps.end() ? nullptr : &*found;
}

std::span<const char* const> colourMapNames() {
    static const std::vector<const char*> names = [] {
        std::vector<const char*> all;
        for (const Recipe& recipe : recipes()) {
            all.push_back(recipe.name);
        }
        return all;
    }();
    return names;
}

} // namespace vs::render
