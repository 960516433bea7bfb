// SPDX-License-Identifier: Apache-2.0
#include "base/json_reader.h"
#include "studio/json/operation_json.h"
#include "studio/json/operation_json_parts.h"
#include "studio/operations/operation_names.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace vs::studio {

using Json = nlohmann::ordered_json;

namespace {

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
    reader.allow({"op", "camera", "mode", "range", "sculptureView", "transferFunction", "pasted", "sampling",
                  "shadows", "hideAbove", "smoothSurface", "tintSegments"});
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
    reader.ifHas("shadows", [&](const JsonReader& r) { op.shadows = r.boolean(); });
    reader.ifHas("hideAbove", [&](const JsonReader& r) { op.hidesAbove = r.boolean(); });
    reader.ifHas("smoothSurface", [&](const JsonReader& r) {
        op.surfaceSmoothing = r.numberBetween(0, kMostSurfaceSmoothing);
    });
    reader.ifHas("tintSegments", [&](const JsonReader& r) { op.tintsSegments = r.boolean(); });
    reader.ifHas("sampling",
                 [&](const JsonReader& r) { op.sampling = r.choice<field::Sampling>(kSamplings); });
    return op;
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
    readLaser,
    readSweep,
    readScissors,
    readClip,
    readKeepConnected,
    readPaste,
    readMovePart,
    readSeed,
    readGrow,
    readRewind,
    readShowGeneration,
    readGrowthRules,
    readAbsorb,
    readUseSegment,
    readLoadLabels,
    readRemoveSegment,
    readEditSegment,
    readBrushSegment,
    readPaintSegment,
    readCutSegment,
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
