// SPDX-License-Identifier: Apache-2.0
#include "base/json_reader.h"
#include "render/transfer_function_json.h"
#include "studio/operation_json.h"
#include "studio/operation_names.h"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace vs::studio {

using Json = nlohmann::ordered_json;

namespace {

Range readRange(const JsonReader& reader) {
    const Range range{reader.at(0).number(), reader.at(1).number()};
    reader.expectSize(2);
    if (range.lo > range.hi) {
        reader.fail("its first number must not be above its second");
    }
    return range;
}

glm::dvec2 readPoint(const JsonReader& reader) {
    reader.expectSize(2);
    return {reader.at(0).number(), reader.at(1).number()};
}

render::Camera readCamera(const JsonReader& reader) {
    reader.allow({"azimuth", "elevation", "zoom", "pan", "projection"});
    render::Camera camera;
    reader.ifHas("azimuth", [&](const JsonReader& r) { camera.azimuthDegrees = r.number(); });
    reader.ifHas("elevation", [&](const JsonReader& r) { camera.elevationDegrees = r.number(); });
    reader.ifHas("zoom", [&](const JsonReader& r) { camera.zoom = r.numberBetween(1e-3, 1e3); });
    reader.ifHas("pan", [&](const JsonReader& r) { camera.panMm = readPoint(r); });
    reader.ifHas("projection", [&](const JsonReader& r) {
        camera.projection = r.choice<render::Projection>(kProjections);
    });
    return camera;
}

// One coordinate of a place on the viewport, or anywhere about it.
double readCoordinate(const JsonReader& reader) {
    constexpr double farthest = 1e6;
    return reader.numberBetween(-farthest, farthest);
}

Sketch readSketch(const JsonReader& reader) {
    reader.allow({"shape", "points"});
    Sketch sketch;
    sketch.shape = reader.member("shape").choice<Shape>(kShapes);
    const JsonReader points = reader.member("points");
    for (std::size_t i = 0; i < points.size(); ++i) {
        const JsonReader point = points.at(i);
        point.expectSize(2);
        sketch.points.emplace_back(readCoordinate(point.at(0)), readCoordinate(point.at(1)));
    }
    const bool isBox = sketch.shape != Shape::FreeForm && sketch.shape != Shape::Polyline;
    if (isBox && sketch.points.size() != 2) {
        points.fail("this shape takes exactly two points");
    }
    return sketch;
}

glm::ivec2 readSize(const JsonReader& reader) {
    reader.expectSize(2);
    return {int(reader.at(0).integerBetween(1, 16384)), int(reader.at(1).integerBetween(1, 16384))};
}

glm::dvec3 readVector(const JsonReader& reader, double largest) {
    reader.expectSize(3);
    glm::dvec3 v;
    for (int i = 0; i < 3; ++i) {
        v[i] = reader.at(std::size_t(i)).numberBetween(-largest, largest);
    }
    return v;
}

std::vector<render::Placement> readPlacements(const JsonReader& reader) {
    constexpr std::size_t most = 16;
    if (reader.size() > most) {
        reader.fail(fmt::format("at most {} parts can be drawn", most));
    }
    std::vector<render::Placement> places(reader.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const JsonReader place = reader.at(i);
        place.allow({"move", "turn", "scale"});
        place.ifHas("move", [&](const JsonReader& r) { places[i].moveMm = readVector(r, 1e6); });
        place.ifHas("turn", [&](const JsonReader& r) { places[i].turnDegrees = readVector(r, 360); });
        place.ifHas("scale", [&](const JsonReader& r) { places[i].scale = r.numberBetween(0.01, 100); });
    }
    return places;
}

std::optional<render::TransferFunction> readTransferFunction(const JsonReader& reader) {
    if (reader.isNull()) {
        return std::nullopt;
    }
    if (!reader.isText()) {
        return render::transferFunctionFromJson(reader.json(), reader.place());
    }
    const auto preset = render::findPreset(reader.text());
    if (!preset) {
        reader.fail(fmt::format("there is no preset of that name; there are {}",
                                fmt::join(render::presetNames(), ", ")));
    }
    return preset;
}

Canvas readCanvas(const JsonReader& reader) {
    reader.allow(
        {"viewport", "camera", "mode", "range", "sculptureView", "transferFunction", "pasted", "sampling"});
    Canvas canvas;
    canvas.viewport = readSize(reader.member("viewport"));
    canvas.view.camera = readCamera(reader.member("camera"));
    canvas.view.mode = reader.member("mode").choice<render::Mode>(kModes);
    canvas.view.range = readRange(reader.member("range"));
    canvas.view.sculptureView = reader.member("sculptureView").choice<field::SculptureView>(kSculptureViews);
    reader.ifHas("transferFunction",
                 [&](const JsonReader& r) { canvas.view.transferFunction = readTransferFunction(r); });
    reader.ifHas("pasted", [&](const JsonReader& r) { canvas.view.pasted = readPlacements(r); });
    reader.ifHas("sampling",
                 [&](const JsonReader& r) { canvas.view.sampling = r.choice<field::Sampling>(kSamplings); });
    return canvas;
}

// A file in the output folder: a plain relative path that stays inside.
std::string readFileName(const JsonReader& reader) {
    const std::filesystem::path path = reader.fileName();
    bool leaves = path.is_absolute();
    for (const auto& part : path) {
        leaves = leaves || part == "..";
    }
    if (leaves) {
        reader.fail("a file name inside the output folder is wanted");
    }
    if (!path.has_filename() || path.filename() == ".") {
        reader.fail("a file name is wanted, not a folder's");
    }
    if (path.lexically_normal() == "report.json") {
        reader.fail("report.json is what the replay itself writes; choose another name");
    }
    return path.string();
}

// --- one reader per operation

Operation readView(const JsonReader& reader) {
    reader.allow(
        {"op", "camera", "mode", "range", "sculptureView", "transferFunction", "pasted", "sampling"});
    SetView op;
    reader.ifHas("camera", [&](const JsonReader& r) { op.camera = readCamera(r); });
    reader.ifHas("mode", [&](const JsonReader& r) { op.mode = r.choice<render::Mode>(kModes); });
    reader.ifHas("range", [&](const JsonReader& r) { op.range = readRange(r); });
    reader.ifHas("sculptureView", [&](const JsonReader& r) {
        op.sculptureView = r.choice<field::SculptureView>(kSculptureViews);
    });
    reader.ifHas("transferFunction",
                 [&](const JsonReader& r) { op.transferFunction = readTransferFunction(r); });
    reader.ifHas("pasted", [&](const JsonReader& r) { op.pasted = readPlacements(r); });
    reader.ifHas("sampling",
                 [&](const JsonReader& r) { op.sampling = r.choice<field::Sampling>(kSamplings); });
    return op;
}

Operation readPeel(const JsonReader& reader) {
    reader.allow({"op", "layers", "radius", "mask", "canvas"});
    Peel op;
    op.layers = reader.member("layers").numberBetween(0, 4096);
    reader.ifHas("radius", [&](const JsonReader& r) { op.radius = int(r.integerBetween(2, 4)); });
    op.mask = readSketch(reader.member("mask"));
    reader.ifHas("canvas", [&](const JsonReader& r) { op.canvas = readCanvas(r); });
    return op;
}

Operation readDrill(const JsonReader& reader) {
    reader.allow({"op", "depthMax", "radius", "mask", "stroke", "canvas"});
    Drill op;
    reader.ifHas("depthMax", [&](const JsonReader& r) { op.depthMax = r.numberBetween(0, 4096); });
    reader.ifHas("radius", [&](const JsonReader& r) { op.radius = int(r.integerBetween(2, 4)); });
    op.mask = readSketch(reader.member("mask"));
    reader.ifHas("stroke", [&](const JsonReader& r) {
        for (std::size_t i = 0; i < r.size(); ++i) {
            const JsonReader pen = r.at(i);
            pen.expectSize(3);
            op.stroke.push_back(
                {{readCoordinate(pen.at(0)), readCoordinate(pen.at(1))}, pen.at(2).numberBetween(0, 1)});
        }
    });
    reader.ifHas("canvas", [&](const JsonReader& r) { op.canvas = readCanvas(r); });
    return op;
}

Operation readSeed(const JsonReader& reader) {
    reader.allow({"op", "width", "connectivity", "range", "strokes", "voxels", "canvas"});
    Seed op;
    reader.ifHas("width", [&](const JsonReader& r) { op.widthPixels = r.numberBetween(0.1, 1000); });
    reader.ifHas("connectivity", [&](const JsonReader& r) {
        op.connectivity = int(r.integerBetween(6, 26));
        if (op.connectivity != 6 && op.connectivity != 26) {
            r.fail("must be 6 or 26");
        }
    });
    reader.ifHas("range", [&](const JsonReader& r) { op.range = readRange(r); });
    reader.ifHas("strokes", [&](const JsonReader& r) {
        for (std::size_t i = 0; i < r.size(); ++i) {
            op.strokes.push_back(readSketch(r.at(i)));
        }
    });
    reader.ifHas("voxels", [&](const JsonReader& r) {
        for (std::size_t i = 0; i < r.size(); ++i) {
            const JsonReader v = r.at(i);
            v.expectSize(3);
            op.voxels.emplace_back(v.at(0).integerBetween(0, 1 << 20), v.at(1).integerBetween(0, 1 << 20),
                                   v.at(2).integerBetween(0, 1 << 20));
        }
    });
    if (op.strokes.empty() && op.voxels.empty()) {
        reader.fail("needs 'strokes' or 'voxels'");
    }
    reader.ifHas("canvas", [&](const JsonReader& r) { op.canvas = readCanvas(r); });
    return op;
}

Operation readGrow(const JsonReader& reader) {
    reader.allow({"op", "generations", "sculptureView"});
    Grow op;
    reader.ifHas("generations",
                 [&](const JsonReader& r) { op.generations = int(r.integerBetween(0, 1 << 30)); });
    reader.ifHas("sculptureView", [&](const JsonReader& r) {
        op.sculptureView = r.choice<field::SculptureView>(kSculptureViews);
    });
    return op;
}

Operation readRewind(const JsonReader& reader) {
    reader.allow({"op", "generations"});
    return Rewind{int(reader.member("generations").integerBetween(0, 1 << 30))};
}

Operation readGrowthRange(const JsonReader& reader) {
    reader.allow({"op", "range"});
    return SetGrowthRange{readRange(reader.member("range"))};
}

render::Background readBackground(const JsonReader& reader) {
    try {
        return render::backgroundFromName(reader.text());
    } catch (const UsageError& error) {
        reader.fail(error.what());
    }
}

Operation readPicture(const JsonReader& reader) {
    reader.allow({"op", "file", "size", "samples", "background", "annotations"});
    SavePicture op;
    op.file = readFileName(reader.member("file"));
    reader.ifHas("size", [&](const JsonReader& r) { op.size = readSize(r); });
    reader.ifHas("samples", [&](const JsonReader& r) { op.samples = int(r.integerBetween(1, 256)); });
    reader.ifHas("background", [&](const JsonReader& r) { op.background = readBackground(r); });
    reader.ifHas("annotations", [&](const JsonReader& r) { op.annotations = r.boolean(); });
    return op;
}

template <typename T>
Operation readFileOperation(const JsonReader& reader) {
    reader.allow({"op", "file"});
    return T{readFileName(reader.member("file"))};
}

template <typename T>
Operation readBare(const JsonReader& reader) {
    reader.allow({"op"});
    return T{};
}

using OperationReader = Operation (*)(const JsonReader&);
// In the order of the variant's alternatives, as in name().
constexpr std::array<OperationReader, std::variant_size_v<Operation>> kReaders{
    readView,
    readPeel,
    readDrill,
    readSeed,
    readGrow,
    readRewind,
    readGrowthRange,
    readBare<Undo>,
    readBare<Redo>,
    readBare<UnCut>,
    readBare<ReSeed>,
    readPicture,
    readFileOperation<SaveLabels>,
    readFileOperation<SaveSculpture>};

} // namespace

Operation operationFromJson(const Json& json, const std::string& where) {
    const JsonReader reader(json, where);
    enum class Kind : std::size_t {};
    const auto kind = reader.member("op").choice<Kind>(kOperationNames);
    return kReaders[std::size_t(kind)](reader);
}

} // namespace vs::studio
