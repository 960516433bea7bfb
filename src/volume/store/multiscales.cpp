// SPDX-License-Identifier: Apache-2.0
#include "volume/store/multiscales.h"

#include "volume/io/length_units.h"
#include "volume/store/store_json.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vs::volume {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLevels = 32;
constexpr const char* kOurs = "volumeStudio";

struct Axis {
    std::string name;
    std::string type;
    double millimetres = 1; // of one of its units
};

std::vector<Axis> readAxes(const JsonReader& image, Multiscales& store) {
    std::vector<Axis> axes;
    const JsonReader all = image.member("axes");
    for (std::size_t n = 0; n < all.size(); ++n) {
        const JsonReader one = all.at(n);
        Axis axis;
        axis.name = one.isText() ? one.text() : one.member("name").text(); // version 0.3 has only names
        if (!one.isText()) {
            one.ifHas("type", [&](const JsonReader& type) { axis.type = type.text(); });
            one.ifHas("unit", [&](const JsonReader& unit) {
                const auto known = millimetresOf(unit.text());
                if (known) {
                    axis.millimetres = *known;
                } else if (axis.type == "space") {
                    store.notices.push_back(
                        fmt::format("{}: the unit '{}' of axis {} is not known; millimetres "
                                    "are taken for it",
                                    store.path.string(), printable(unit.text()), printable(axis.name)));
                }
            });
        }
        if (axis.type.empty()) {
            axis.type = axis.name == "t" ? "time" : axis.name == "c" ? "channel" : "space";
        }
        axes.push_back(axis);
    }
    return axes;
}

// Which axis is which: by their names, or of three others z, y and x in this order.
void assignAxes(const JsonReader& image, const std::vector<Axis>& axes, Multiscales& store) {
    std::vector<int> others;
    const auto take = [&](int& place, int n) {
        if (place >= 0) {
            image.member("axes").fail("two axes are of the same kind");
        }
        place = n;
    };
    for (int n = 0; n < int(axes.size()); ++n) {
        const auto& [name, type, millimetres] = axes[std::size_t(n)];
        if (type == "time") {
            take(store.timeAxis, n);
        } else if (type == "channel") {
            take(store.channelAxis, n);
        } else if (name == "x" || name == "y" || name == "z") {
            take(store.spatial[std::size_t(name[0] - 'x')], n);
        } else {
            others.push_back(n);
        }
    }
    for (std::size_t i = 0; i < others.size() && others.size() <= 3; ++i) {
        take(store.spatial[others.size() - 1 - i], others[i]);
    }
    if (store.spatial[0] < 0 || store.spatial[1] < 0 || others.size() > 3) {
        image.member("axes").fail("a volume needs axes of space: x, y and z");
    }
}

struct Placement {
    std::vector<double> scale;
    std::vector<double> translation;
};

// One after the other: what a level says, then what is said for all.
void addTransforms(const JsonReader& from, Placement& place) {
    from.ifHas("coordinateTransformations", [&](const JsonReader& all) {
        for (std::size_t n = 0; n < all.size(); ++n) {
            const JsonReader one = all.at(n);
            const std::string type = one.member("type").text();
            if (type != "scale" && type != "translation" && type != "identity") {
                one.member("type").fail("must be scale, translation or identity");
            }
            for (std::size_t axis = 0; type != "identity" && axis < place.scale.size(); ++axis) {
                const JsonReader numbers = one.member(type.c_str());
                if (numbers.size() != place.scale.size()) {
                    numbers.fail(fmt::format("must be {} numbers, one for each axis", place.scale.size()));
                }
                const double number = numbers.at(axis).number();
                if (type == "scale") {
                    place.scale[axis] *= number;
                    place.translation[axis] *= number;
                } else {
                    place.translation[axis] += number;
                }
            }
        }
    });
}

// Scale and translation of the three axes of space, in millimetres.
struct Spacing {
    glm::dvec3 scale{1};
    glm::dvec3 translation{0};
};

Spacing spacingOf(const Placement& place, const std::vector<Axis>& axes, const Multiscales& store) {
    Spacing out;
    for (int i = 0; i < 3; ++i) {
        if (const int axis = store.spatial[std::size_t(i)]; axis >= 0) {
            const double unit = axes[std::size_t(axis)].millimetres;
            out.scale[i] = place.scale[std::size_t(axis)] * unit;
            out.translation[i] = place.translation[std::size_t(axis)] * unit;
        }
    }
    return out;
}

glm::dmat4 matrixOf(const Spacing& spacing) {
    return glm::scale(glm::translate(glm::dmat4(1), spacing.translation), spacing.scale);
}

// What is said by stores of our own, or else by none: how the finest level lies in the patient.
glm::dmat4 finestToWorld(const JsonReader& attributes, const Spacing& finest, Multiscales& store) {
    if (!attributes.has(kOurs)) {
        store.notices.push_back(fmt::format(
            "{}: how it lies in a patient is not said; its axes are taken to lead to the left (x), to "
            "the back (y) and up (z)",
            store.path.string()));
        return matrixOf(finest);
    }
    const JsonReader ours = attributes.member(kOurs);
    ours.ifHas("unit", [&](const JsonReader& unit) { store.unit = printable(unit.text()); });
    const JsonReader numbers = ours.member("worldFromVoxel");
    glm::dmat4 world(1);
    for (int n = 0; n < 12; ++n) {
        world[n % 4][n / 4] = numbers.at(std::size_t(n)).number();
    }
    return world;
}

glm::ivec3 dimsOf(const ZarrArray& array, const Multiscales& store) {
    glm::ivec3 dims(1);
    for (int i = 0; i < 3; ++i) {
        const int axis = store.spatial[std::size_t(i)];
        dims[i] = axis < 0 ? 1 : int(array.shape[std::size_t(axis)]);
    }
    return dims;
}

// Some programs write folders and do not say so.
void findSeparator(ZarrArray& array) {
    const std::vector<std::int64_t> first(array.shape.size(), 0);
    const auto nested = array.folder / "0";
    std::error_code error;
    if (array.separator == '.' && array.shape.size() > 1 && !fs::exists(array.chunkFile(first), error) &&
        fs::is_directory(nested, error)) {
        array.separator = '/';
    }
}

// The array that a level names; a name must not lead out of the store.
ZarrArray arrayOf(const JsonReader& level, std::size_t axes, const Multiscales& store) {
    const JsonReader name = level.member("path");
    const fs::path inside = fs::path(name.text()).lexically_normal();
    if (inside.empty() || inside.is_absolute() || *inside.begin() == "..") {
        name.fail("must be the name of a folder in the store");
    }
    ZarrArray array = openZarrArray(store.path / inside);
    findSeparator(array);
    if (array.shape.size() != axes) {
        refuse(array.folder / ".zarray",
               fmt::format("the array has {} axes, and the store's description {}", array.shape.size(), axes),
               "they must agree; get another copy of the store");
    }
    return array;
}

void expectCoarser(const Multiscales& store) {
    for (std::size_t n = 1; n < store.levels.size(); ++n) {
        const auto& finer = store.levels[n - 1];
        const auto& coarser = store.levels[n];
        const auto areAlike = [&](int axis) {
            return axis < 0 || finer.array.shape[std::size_t(axis)] == coarser.array.shape[std::size_t(axis)];
        };
        if (!areAlike(store.channelAxis) || !areAlike(store.timeAxis)) {
            refuse(store.path, fmt::format("level {} has other channels or times than the one before", n),
                   "they must be the same in all levels; get another copy of the store");
        }
        if (glm::any(glm::greaterThan(coarser.geometry.dims, finer.geometry.dims)) ||
            coarser.array.type != finer.array.type) {
            refuse(store.path,
                   fmt::format("level {} has more voxels than the one before, or other values", n),
                   "levels must become coarser; get another copy of the store");
        }
    }
}

// Of stores of our own that have them: they must be of the finest level.
void readExtremes(const JsonReader& attributes, Multiscales& store) {
    if (!attributes.has(kOurs) || !attributes.member(kOurs).has("ranges")) {
        return;
    }
    const JsonReader ranges = attributes.member(kOurs).member("ranges");
    const auto& finest = store.levels.front();
    Multiscales::Extremes extremes{arrayOf(ranges, finest.array.shape.size() + 1, store),
                                   int(ranges.member("side").integerBetween(1, 1 << 20))};
    const glm::ivec3 cells = divideUp(finest.geometry.dims, extremes.side);
    const std::vector<std::int64_t> shape{cells.z, cells.y, cells.x, 2};
    const auto& chunks = extremes.array.chunks;
    if (extremes.array.shape != shape || extremes.array.type != finest.array.type || chunks[1] != cells.y ||
        chunks[2] != cells.x || chunks[3] != 2) {
        refuse(extremes.array.folder / ".zarray", "its ranges are not those of its finest level",
               "remove \"ranges\" from its .zattrs, or get another copy of the store");
    }
    store.extremes = std::move(extremes);
}

Multiscales readImage(const JsonReader& attributes, const fs::path& path) {
    Multiscales store;
    store.path = path;
    const JsonReader image = attributes.member("multiscales").at(0);
    const auto axes = readAxes(image, store);
    assignAxes(image, axes, store);
    const JsonReader levels = image.member("datasets");
    if (levels.size() == 0 || levels.size() > kMostLevels) {
        levels.fail(fmt::format("must be 1 to {} levels", kMostLevels));
    }
    glm::dmat4 world(1); // of the finest level
    glm::dmat4 voxelFromFinest(1);
    for (std::size_t n = 0; n < levels.size(); ++n) {
        Placement place{std::vector<double>(axes.size(), 1), std::vector<double>(axes.size(), 0)};
        addTransforms(levels.at(n), place);
        addTransforms(image, place);
        const Spacing spacing = spacingOf(place, axes, store);
        for (int i = 0; i < 3; ++i) {
            checkSpacing(path, spacing.scale[i]);
        }
        if (n == 0) {
            world = finestToWorld(attributes, spacing, store);
            voxelFromFinest = glm::inverse(matrixOf(spacing));
        }
        Multiscales::Level level{arrayOf(levels.at(n), axes.size(), store), {}};
        level.geometry = {dimsOf(level.array, store),
                          n == 0 ? world : world * (voxelFromFinest * matrixOf(spacing))};
        checkGeometry(path, level.geometry);
        store.levels.push_back(std::move(level));
    }
    expectCoarser(store);
    readExtremes(attributes, store);
    attributes.ifHas("omero", [&](const JsonReader& omero) {
        omero.ifHas("channels", [&](const JsonReader& channels) {
            for (std::size_t n = 0; n < std::min<std::size_t>(channels.size(), 1000); ++n) {
                std::string label;
                channels.at(n).ifHas("label",
                                     [&](const JsonReader& text) { label = printable(text.text()); });
                store.channelNames.push_back(label);
            }
        });
    });
    return store;
}

} // namespace

std::string Multiscales::levelsText() const {
    std::vector<std::string> all;
    for (std::size_t n = 0; n < levels.size(); ++n) {
        const glm::ivec3 dims = levels[n].geometry.dims;
        all.push_back(fmt::format("{} ({} x {} x {})", n, dims.x, dims.y, dims.z));
    }
    return fmt::format("{}", fmt::join(all, ", "));
}

std::string namesOf(const Multiscales& store) {
    std::string names;
    for (std::size_t n = 0; n < store.channelNames.size() && n < 20 && int(n) < store.channels(); ++n) {
        names += fmt::format("{}{} {}", n == 0 ? ": " : ", ", n, store.channelNames[n]);
    }
    return names;
}

std::vector<std::string> descriptionFiles(const fs::path& path) {
    return readStoreFile(path / ".zattrs", "the description of an image of OME-Zarr 0.4",
                         [&](const JsonReader& from) {
                             std::vector<std::string> files;
                             const auto add = [&](const JsonReader& array) {
                                 files.push_back(array.member("path").text() + "/.zarray");
                             };
                             const JsonReader levels = from.member("multiscales").at(0).member("datasets");
                             for (std::size_t n = 0; n < std::min(levels.size(), kMostLevels); ++n) {
                                 add(levels.at(n));
                             }
                             if (from.has(kOurs)) {
                                 from.member(kOurs).ifHas("ranges", add);
                             }
                             return files;
                         });
}

Multiscales openMultiscales(const fs::path& path) {
    std::error_code error;
    if (fs::exists(path / "zarr.json", error)) {
        refuse(path, "it is a store of Zarr 3 (OME-Zarr 0.5)", "save it as OME-Zarr 0.4, which has Zarr 2");
    }
    if (!fs::exists(path / ".zattrs", error)) {
        refuse(path, "it is a store of Zarr without an image of OME-Zarr (.zattrs with multiscales)",
               "open the folder in it that has one");
    }
    return readStoreFile(path / ".zattrs", "the description of an image of OME-Zarr 0.4",
                         [&](const JsonReader& from) { return readImage(from, path); });
}

nlohmann::ordered_json multiscalesJson(const StoreFacts& facts, const std::vector<GridGeometry>& levels,
                                       int extremesSide) {
    using Json = nlohmann::ordered_json;
    const auto ofAxes = [](glm::dvec3 v) { return Json{v.z, v.y, v.x}; };
    const glm::dvec3 spacing = facts.geometry.spacing();
    Json datasets = Json::array();
    for (std::size_t n = 0; n < levels.size(); ++n) {
        // A coarser level's first voxel lies between those that it stands for: whole or half voxels away.
        const glm::dmat4 finestFromVoxel = facts.geometry.voxelFromWorld() * levels[n].worldFromVoxel;
        const glm::dvec3 by =
            glm::round(glm::dvec3(finestFromVoxel[0][0], finestFromVoxel[1][1], finestFromVoxel[2][2]));
        const glm::dvec3 first = glm::round(2.0 * glm::dvec3(finestFromVoxel[3])) / 2.0;
        datasets.push_back({{"path", std::to_string(n)},
                            {"coordinateTransformations",
                             {{{"type", "scale"}, {"scale", ofAxes(by * spacing)}},
                              {{"type", "translation"}, {"translation", ofAxes(first * spacing)}}}}});
    }
    Json axes = Json::array();
    for (const char* name : {"z", "y", "x"}) {
        axes.push_back({{"name", name}, {"type", "space"}, {"unit", "millimeter"}});
    }
    Json world = Json::array();
    for (int n = 0; n < 12; ++n) {
        world.push_back(facts.geometry.worldFromVoxel[n % 4][n / 4]);
    }
    Json ours{{"worldFromVoxel", world}, {"unit", printable(facts.unit)}};
    if (extremesSide > 0) {
        ours["ranges"] = {{"path", "ranges"}, {"side", extremesSide}};
    }
    Json json{{"multiscales", Json::array({{{"version", "0.4"},
                                            {"name", printable(facts.name)},
                                            {"axes", axes},
                                            {"datasets", datasets},
                                            {"type", facts.reducing}}})},
              {kOurs, std::move(ours)}};
    if (!facts.labels.empty()) { // "image-label" of the format
        Json colours = Json::array();
        Json properties = Json::array();
        for (const StoreFacts::Label& label : facts.labels) {
            colours.push_back({{"label-value", label.value}, {"rgba", label.colour}});
            properties.push_back({{"label-value", label.value}, {"name", printable(label.name)}});
        }
        json["image-label"] = {{"version", "0.4"}, {"colors", colours}, {"properties", properties}};
    }
    return json;
}

} // namespace vs::volume
