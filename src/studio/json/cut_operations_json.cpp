// SPDX-License-Identifier: Apache-2.0
#include "studio/json/operation_json_parts.h"
#include "studio/operations/operation_names.h"

namespace vs::studio {

namespace {

constexpr double kMostSteps = 4096; // of a depth
constexpr double kFarthest = 1e5;   // voxels or millimetres
constexpr double kMostTilt = 60;    // degrees

int readRadius(const JsonReader& reader) { return int(reader.integerBetween(2, 4)); }

// Members that most tools have.
template <typename Cut>
void readCommon(const JsonReader& reader, Cut& op) {
    reader.ifHas("radius", [&](const JsonReader& r) { op.radius = readRadius(r); });
    reader.ifHas("restore", [&](const JsonReader& r) { op.restores = r.boolean(); });
    if constexpr (requires { op.canvas; }) {
        reader.ifHas("canvas", [&](const JsonReader& r) { op.canvas = readCanvas(r); });
    }
}

template <typename Cut>
void writeCommon(Json& j, const Cut& op) {
    j["radius"] = op.radius;
    if (op.restores) {
        j["restore"] = true;
    }
    if constexpr (requires { op.canvas; }) {
        addIfSet(j, "canvas", op.canvas);
    }
}

sculpt::PenPoint readPen(const JsonReader& reader) {
    if (reader.size() != 3 && reader.size() != 5) {
        reader.fail("must be a list of 3 numbers, x, y and pressure, or of 5 with the pen's tilt in x and y");
    }
    sculpt::PenPoint pen{{readCoordinate(reader.at(0)), readCoordinate(reader.at(1))},
                         reader.at(2).numberBetween(0, 1)};
    if (reader.size() == 5) {
        pen.tiltDegrees = {reader.at(3).numberBetween(-kMostTilt, kMostTilt),
                           reader.at(4).numberBetween(-kMostTilt, kMostTilt)};
    }
    return pen;
}

void readPenCut(const JsonReader& reader, PenCut& op) {
    readCommon(reader, op);
    op.mask = readSketch(reader.member("mask"));
    reader.ifHas("depthMax", [&](const JsonReader& r) { op.depthMax = r.numberBetween(0, kMostSteps); });
    reader.ifHas("keepDigging", [&](const JsonReader& r) { op.keepsDigging = r.boolean(); });
    reader.ifHas("stroke", [&](const JsonReader& r) {
        for (std::size_t i = 0; i < r.size(); ++i) {
            op.stroke.push_back(readPen(r.at(i)));
        }
    });
}

void writePenCut(Json& j, const PenCut& op) {
    j["depthMax"] = op.depthMax;
    j["mask"] = toJson(op.mask);
    Json stroke = Json::array();
    for (const auto& pen : op.stroke) {
        Json point = Json::array({pen.pixel.x, pen.pixel.y, pen.pressure});
        if (pen.tiltDegrees != glm::dvec2(0)) {
            point.push_back(pen.tiltDegrees.x);
            point.push_back(pen.tiltDegrees.y);
        }
        stroke.push_back(std::move(point));
    }
    j["stroke"] = stroke;
    if (op.keepsDigging) {
        j["keepDigging"] = true;
    }
    writeCommon(j, op);
}

std::vector<glm::dvec3> readPlaces(const JsonReader& reader) {
    std::vector<glm::dvec3> places;
    for (std::size_t i = 0; i < reader.size(); ++i) {
        places.push_back(readVector(reader.at(i), kFarthest));
    }
    return places;
}

SweepPath readPath(const JsonReader& reader) {
    reader.allow({"kind", "stroke", "points", "radius", "turns"});
    SweepPath path;
    path.kind = reader.member("kind").choice<SweepPath::Kind>(kPathKinds);
    if (path.isDrawn()) {
        const JsonReader stroke = reader.member("stroke");
        for (std::size_t i = 0; i < stroke.size(); ++i) {
            const JsonReader point = stroke.at(i);
            point.expectSize(2);
            path.stroke.emplace_back(readCoordinate(point.at(0)), readCoordinate(point.at(1)));
        }
        return path;
    }
    const JsonReader points = reader.member("points");
    path.points = readPlaces(points);
    const bool isOpen = path.kind == SweepPath::Kind::Polyline || path.kind == SweepPath::Kind::Spline;
    if (isOpen ? path.points.size() < 2 : path.points.size() != 2) {
        points.fail(isOpen ? "at least two places are wanted" : "exactly two places are wanted");
    }
    if (path.kind == SweepPath::Kind::Standing && path.points[0] == path.points[1]) {
        points.fail("the mask must face another place than it stands on");
    }
    if (path.kind == SweepPath::Kind::Helix) {
        path.helixRadius = reader.member("radius").numberBetween(0, kMostSteps);
        path.turns = reader.member("turns").numberBetween(-1000, 1000);
    }
    return path;
}

Json pathJson(const SweepPath& path) {
    Json json{{"kind", kPathKinds[std::size_t(path.kind)]}};
    if (path.isDrawn()) {
        Json stroke = Json::array();
        for (const auto& p : path.stroke) {
            stroke.push_back(pair(p.x, p.y));
        }
        json["stroke"] = stroke;
        return json;
    }
    Json points = Json::array();
    for (const auto& p : path.points) {
        points.push_back(toJson(p));
    }
    json["points"] = points;
    if (path.kind == SweepPath::Kind::Helix) {
        json["radius"] = path.helixRadius;
        json["turns"] = path.turns;
    }
    return json;
}

void readFilter(const JsonReader& reader, Sweep& op) {
    reader.allow({"sampling", "reconstruction", "width", "seed", "subdivision", "levels"});
    reader.ifHas("sampling", [&](const JsonReader& r) {
        op.filter.sampling = r.choice<sculpt::Sampling>(sculpt::kMaskSamplings);
    });
    reader.ifHas("reconstruction", [&](const JsonReader& r) {
        op.filter.reconstruction = r.choice<sculpt::Reconstruction>(sculpt::kReconstructions);
    });
    reader.ifHas("width", [&](const JsonReader& r) { op.filter.width = int(r.integerBetween(4, 400)); });
    reader.ifHas("seed", [&](const JsonReader& r) {
        op.filter.seed = std::uint32_t(r.integerBetween(0, 0xFFFFFFFFL));
    });
    reader.ifHas("subdivision", [&](const JsonReader& r) {
        op.subdivision = r.choice<sculpt::Subdivision>(sculpt::kSubdivisions);
    });
    reader.ifHas("levels", [&](const JsonReader& r) { op.subdivisionLevels = int(r.integerBetween(0, 8)); });
}

Json filterJson(const Sweep& op) {
    Json json{{"sampling", sculpt::kMaskSamplings[std::size_t(op.filter.sampling)]},
              {"reconstruction", sculpt::kReconstructions[std::size_t(op.filter.reconstruction)]},
              {"width", op.filter.width},
              {"seed", op.filter.seed}};
    if (op.subdivisionLevels > 0) {
        json["subdivision"] = sculpt::kSubdivisions[std::size_t(op.subdivision)];
        json["levels"] = op.subdivisionLevels;
    }
    return json;
}

} // namespace

Operation readPeel(const JsonReader& reader) {
    reader.allow({"op", "layers", "radius", "restore", "mask", "canvas"});
    Peel op;
    op.layers = reader.member("layers").numberBetween(0, kMostSteps);
    op.mask = readSketch(reader.member("mask"));
    readCommon(reader, op);
    return op;
}

void write(Json& j, const Peel& op) {
    j["layers"] = op.layers;
    j["mask"] = toJson(op.mask);
    writeCommon(j, op);
}

Operation readDrill(const JsonReader& reader) {
    reader.allow(
        {"op", "depthMax", "radius", "restore", "keepDigging", "followTilt", "mask", "stroke", "canvas"});
    Drill op;
    readPenCut(reader, op);
    reader.ifHas("followTilt", [&](const JsonReader& r) { op.followsTilt = r.boolean(); });
    return op;
}

void write(Json& j, const Drill& op) {
    if (op.followsTilt) {
        j["followTilt"] = true;
    }
    writePenCut(j, op);
}

Operation readLaser(const JsonReader& reader) {
    reader.allow({"op", "depthMax", "radius", "restore", "keepDigging", "mask", "stroke", "canvas"});
    Laser op;
    readPenCut(reader, op);
    return op;
}

void write(Json& j, const Laser& op) { writePenCut(j, op); }

Operation readSweep(const JsonReader& reader) {
    reader.allow({"op", "mask", "path", "frame", "filter", "pitch", "radius", "energy", "method", "restore",
                  "canvas"});
    Sweep op;
    op.mask = readSketch(reader.member("mask"));
    op.path = readPath(reader.member("path"));
    reader.ifHas("frame", [&](const JsonReader& r) { op.frame = r.choice<sculpt::FrameKind>(kFrames); });
    reader.ifHas("filter", [&](const JsonReader& r) { readFilter(r, op); });
    reader.ifHas("pitch", [&](const JsonReader& r) { op.pitch = r.numberBetween(0.05, 64); });
    reader.ifHas("energy", [&](const JsonReader& r) {
        enum class Energy { Calibrated, Raw };
        op.isRaw = r.choice<Energy>(kEnergies) == Energy::Raw;
    });
    reader.ifHas("method", [&](const JsonReader& r) { op.method = r.choice<Sweep::Method>(kMethods); });
    readCommon(reader, op);
    return op;
}

void write(Json& j, const Sweep& op) {
    j["mask"] = toJson(op.mask);
    j["path"] = pathJson(op.path);
    j["frame"] = kFrames[std::size_t(op.frame)];
    j["filter"] = filterJson(op);
    j["pitch"] = op.pitch;
    j["energy"] = kEnergies[op.isRaw ? 1 : 0];
    j["method"] = kMethods[std::size_t(op.method)];
    writeCommon(j, op);
}

Operation readScissors(const JsonReader& reader) {
    reader.allow({"op", "outline", "outside", "depth", "radius", "restore", "canvas"});
    Scissors op;
    op.outline = readSketch(reader.member("outline"));
    reader.ifHas("outside", [&](const JsonReader& r) { op.cutsOutside = r.boolean(); });
    reader.ifHas("depth", [&](const JsonReader& r) { op.depth = r.numberBetween(0, kMostSteps); });
    readCommon(reader, op);
    return op;
}

void write(Json& j, const Scissors& op) {
    j["outline"] = toJson(op.outline);
    j["outside"] = op.cutsOutside;
    if (op.depth) {
        j["depth"] = *op.depth;
    }
    writeCommon(j, op);
}

Operation readClip(const JsonReader& reader) {
    reader.allow({"op", "box", "planes", "inside", "radius", "restore"});
    Clip op;
    reader.ifHas("box", [&](const JsonReader& r) {
        if (r.size() != 2) {
            r.fail("must be a list of two places, the lower and the upper corner, in voxels");
        }
        op.box = Clip::Box{readVector(r.at(0), kFarthest), readVector(r.at(1), kFarthest)};
        if (glm::any(glm::greaterThan(op.box->lo, op.box->hi))) {
            r.fail("its first corner must not lie above its second along any axis");
        }
    });
    reader.ifHas("planes", [&](const JsonReader& r) {
        constexpr std::size_t most = 24;
        if (r.size() > most) {
            r.fail(fmt::format("at most {} planes", most));
        }
        for (std::size_t i = 0; i < r.size(); ++i) {
            const JsonReader plane = r.at(i);
            plane.allow({"point", "normal"});
            op.planes.push_back({readVector(plane.member("point"), kFarthest),
                                 readVector(plane.member("normal"), kFarthest)});
            if (glm::length(op.planes.back().normal) < 1e-9) {
                plane.fail("its normal must have a length");
            }
        }
    });
    if (!op.box && op.planes.empty()) {
        reader.fail("needs 'box' or 'planes'");
    }
    reader.ifHas("inside", [&](const JsonReader& r) { op.cutsInside = r.boolean(); });
    readCommon(reader, op);
    return op;
}

void write(Json& j, const Clip& op) {
    if (op.box) {
        j["box"] = Json::array({toJson(op.box->lo), toJson(op.box->hi)});
    }
    if (!op.planes.empty()) {
        Json planes = Json::array();
        for (const auto& plane : op.planes) {
            planes.push_back({{"point", toJson(plane.point)}, {"normal", toJson(plane.normal)}});
        }
        j["planes"] = planes;
    }
    j["inside"] = op.cutsInside;
    writeCommon(j, op);
}

Operation readKeepConnected(const JsonReader& reader) {
    reader.allow({"op", "pixel", "voxel", "connectivity", "canvas"});
    KeepConnected op;
    reader.ifHas("pixel", [&](const JsonReader& r) {
        r.expectSize(2);
        op.pixel = {readCoordinate(r.at(0)), readCoordinate(r.at(1))};
    });
    reader.ifHas("voxel", [&](const JsonReader& r) {
        r.expectSize(3);
        const auto index = [&](std::size_t i) { return int(r.at(i).integerBetween(0, 1 << 20)); };
        op.voxel = glm::ivec3(index(0), index(1), index(2));
    });
    if (!reader.json().contains("pixel") && !op.voxel) {
        reader.fail("needs 'pixel' or 'voxel'");
    }
    reader.ifHas("connectivity", [&](const JsonReader& r) {
        op.connectivity = int(r.integerBetween(6, 26));
        if (op.connectivity != 6 && op.connectivity != 26) {
            r.fail("must be 6 or 26");
        }
    });
    reader.ifHas("canvas", [&](const JsonReader& r) { op.canvas = readCanvas(r); });
    return op;
}

void write(Json& j, const KeepConnected& op) {
    j["pixel"] = pair(op.pixel.x, op.pixel.y);
    if (op.voxel) {
        j["voxel"] = Json::array({op.voxel->x, op.voxel->y, op.voxel->z});
    }
    j["connectivity"] = op.connectivity;
    addIfSet(j, "canvas", op.canvas);
}

Operation readPaste(const JsonReader& reader) {
    reader.allow({"op", "move", "turn", "scale"});
    return Paste{readPlacement(reader)};
}

void write(Json& j, const Paste& op) { j.update(toJson(op.place)); }

Operation readMovePart(const JsonReader& reader) {
    reader.allow({"op", "part", "move", "turn", "scale"});
    return MovePart{int(reader.member("part").integerBetween(0, 15)), readPlacement(reader)};
}

void write(Json& j, const MovePart& op) {
    j["part"] = op.part;
    j.update(toJson(op.place));
}

} // namespace vs::studio
