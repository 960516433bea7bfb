// SPDX-License-Identifier: Apache-2.0
// vstudio export: segments, or what is left of a volume, as files of other programs.
#include "arguments/parse.h"
#include "arguments/storage_argument.h"
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/label_map.h"
#include "reports/long_work.h"
#include "sessions/replay.h"

#include "base/error.h"
#include "base/progress.h"
#include "gl/context.h"
#include "studio/exports/exports.h"
#include "studio/json/session.h"
#include "volume/store/write_store.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>

namespace vs::cli {
namespace {

using What = studio::ExportSettings::What;

struct ExportOptions {
    std::string input; // a session, a label map, or a volume
    std::string output;
    std::string what = "segments";
    VolumeArgument volume;
    StorageArgument storage;
    std::vector<std::string> segments; // names, or values of labels; empty: all
    std::string range;
    std::optional<double> level;
    std::optional<int> smoothing;
    std::size_t mostTriangles = 0;
    studio::ExportSettings settings;
};

bool isSession(const ExportOptions& options) { return options.input.ends_with(".json"); }

// Those of `all` that are asked for, in that order.
std::vector<studio::ExportedSegment> chosen(std::vector<studio::ExportedSegment> all,
                                            const ExportOptions& options) {
    if (options.segments.empty()) {
        return all;
    }
    std::vector<studio::ExportedSegment> found;
    for (const std::string& wanted : options.segments) {
        const auto segment = std::find_if(all.begin(), all.end(), [&](const auto& one) {
            return one.name == wanted || std::to_string(one.value) == wanted;
        });
        if (segment == all.end()) {
            std::string names;
            for (const auto& one : all) {
                names += fmt::format("{}{}", names.empty() ? "" : ", ",
                                     one.name.empty() ? std::to_string(one.value) : one.name);
            }
            throw UsageError("--segment {}: {} has no such segment with voxels; it has {}", wanted,
                             options.input, names.empty() ? "none" : names);
        }
        found.push_back(*segment);
    }
    return found;
}

// What is exported, and what it lies in.
struct Input {
    std::unique_ptr<volume::Volume> volume; // of a label map
    std::unique_ptr<gl::Context> context;
    std::unique_ptr<studio::Document> document;
    studio::ExportSource source;
    Range range; // displayed
};

void readFromDocument(Input& input, const ExportOptions& options) {
    studio::ExportReader reader(*input.document, options.settings.what,
                                chosen(studio::exportable(*input.document), options));
    reader.readSome(std::numeric_limits<double>::infinity());
    input.source = reader.take();
    input.range = input.document->view().range;
    input.context->requireNoErrors();
}

Input readSession(const ExportOptions& options) {
    Input input;
    studio::Session session = studio::loadSession(options.input);
    // First: how much is worked on follows what its device has.
    input.context = std::make_unique<gl::Context>(gl::Context::createHeadless());
    SessionScan scan = loadSessionScan(session, options.input, options.volume, options.storage);
    input.document = openDocument(session, options.input, std::move(scan), *input.context);
    readFromDocument(input, options);
    if (options.volume.path.empty()) {
        if (!session.series.empty()) {
            input.source.reading.series = session.series;
        }
        input.source.reading.frame = session.frame;
        input.source.reading.level = session.level;
        input.source.reading.channel = session.channel;
    } else {
        input.source.reading = readOptions(options.volume);
    }
    return input;
}

Input readVolume(const ExportOptions& options) {
    Input input;
    VolumeArgument argument = options.volume;
    argument.path = options.input;
    auto volume = loadVolume(argument).volume;
    input.context = std::make_unique<gl::Context>(gl::Context::createHeadless());
    input.document = std::make_unique<studio::Document>(std::move(volume));
    readFromDocument(input, options);
    return input;
}

// Segments in the colours that the file has for them, or else those that new segments get.
Input readLabels(const ExportOptions& options) {
    Input input;
    if (!options.volume.path.empty()) {
        input.volume = std::make_unique<volume::Volume>(loadVolume(options.volume).volume);
    }
    LabelMap map = readLabelMap(options.input, input.volume ? &input.volume->geometry : nullptr);
    if (input.volume) {
        requireSameGrid(map, input.volume->geometry, input.volume->path);
    } else if (options.output.ends_with(".csv")) {
        throw UsageError("--volume is required: a label map does not say which volume it lies on");
    }
    studio::SegmentList fresh;
    std::vector<studio::ExportedSegment> all;
    for (std::size_t n = 1; n < map.values.size(); ++n) {
        const auto look = map.looks.find(map.values[n]);
        const bool hasLook = look != map.looks.end();
        const std::string plain = fmt::format("Label {}", map.values[n]);
        const auto& info = n == 1 ? fresh.segments.front() : fresh.add(plain);
        all.push_back({std::uint8_t(n), map.values[n],
                       hasLook && !look->second.name.empty() ? look->second.name : plain,
                       hasLook ? look->second.colour.value_or(info.colour) : info.colour, 1});
    }
    if (all.empty()) {
        throw Error("{}: holds no label; a label map has voxels other than 0", options.input);
    }
    input.source.segments = chosen(std::move(all), options);
    input.source.volume = input.volume.get();
    input.source.reading = readOptions(options.volume);
    input.source.geometry = map.geometry;
    input.source.labels = std::move(map.labels);
    return input;
}

// What can be wrong is said before anything is read.
void understand(ExportOptions& options) {
    options.settings.what = options.what == "volume" ? What::Volume : What::Segments;
    options.settings.refinement.smoothing = options.smoothing.value_or(
        options.settings.what == What::Segments ? studio::ExportSettings::kUsualSmoothing : 0);
    if (options.mostTriangles > 0) {
        options.settings.refinement.mostTriangles = options.mostTriangles;
    }
    if (!options.range.empty()) {
        options.settings.range = parseRange(options.range);
    }
    try {
        studio::checkExportName(options.output, options.settings);
    } catch (const WriteError& error) {
        throw UsageError("{}", error.what());
    }
}

// Libraries that work on surfaces must not be thrown through: they ask whether to go on.
bool goesOn(double share) {
    try {
        reportProgress(share);
        return true;
    } catch (const GivenUp&) {
        return false;
    }
}

// With its progress shown.
std::vector<std::string> writeTold(const ExportOptions& options, const studio::ExportSource& source) {
    const LongWork work("writing " + options.output);
    try {
        return studio::writeExport(options.output, source, options.settings, goesOn);
    } catch (const GivenUp&) {
        if (volume::isStoreName(options.output)) { // all else is there when it is complete
            std::filesystem::remove_all(options.output);
        }
        throw GivenUp("{}: given up; nothing is left of it", options.output);
    }
}

void runExport(ExportOptions options) {
    understand(options);
    const bool isVolume = options.settings.what == What::Volume;
    if (options.level && !isVolume) {
        throw UsageError(
            "--level {}: it is the value of a volume's surface, with --what volume; the level of a store "
            "is --store-level",
            *options.level);
    }
    Input input = isSession(options) ? readSession(options)
                  : isVolume         ? readVolume(options)
                                     : readLabels(options);
    if (options.range.empty()) {
        options.settings.range = input.range;
    }
    if (options.level) {
        options.settings.range = {*options.level, std::numeric_limits<double>::infinity()};
    }
    for (const auto& line : writeTold(options, input.source)) {
        fmt::print("{}\n", line);
    }
}

void addSurfaceOptions(CLI::App& command, ExportOptions& options) {
    auto* level = command.add_option("--level", options.level,
                                     "With --what volume: the surface of values from this one on");
    command
        .add_option("--range", options.range,
                    "With --what volume: LO:HI, the surface of values in this range; without, the displayed "
                    "range")
        ->excludes(level);
    command
        .add_option("--smooth", options.smoothing,
                    "Passes of windowed sinc smoothing of surfaces: without, 10 for segments and 0 for the "
                    "volume; more for thick slices; 0 leaves the surface where it is drawn")
        ->check(CLI::Range(0, mesh::kMostSmoothing));
    auto* share = command
                      .add_option("--keep", options.settings.refinement.share,
                                  "Which share of a surface's triangles to keep, 0.01 to 1")
                      ->check(between(0.01, 1));
    command.add_option("--triangles", options.mostTriangles, "At most so many triangles for each surface")
        ->check(CLI::Range(std::size_t(100), std::size_t(1) << 40))
        ->excludes(share);
    command.add_flag("--each", options.settings.isEachAlone,
                     "A file for each segment's surface, named FILE-SEGMENT");
}

} // namespace

void addExportCommand(CLI::App& app) {
    auto* command = app.add_subcommand(
        "export", "Write segments or the sculpted volume for other programs: surfaces, DICOM, label maps");
    const auto options = std::make_shared<ExportOptions>();
    command
        ->add_option("INPUT", options->input,
                     "A session (.json), which is replayed without writing its files; or a label map; or, "
                     "with --what volume, a volume")
        ->required();
    command
        ->add_option(
            "-o,--output", options->output,
            "File to write. Surfaces: .stl .ply .obj .glb. Segments also: .dcm (DICOM SEG), .nrrd "
            ".nii .nii.gz .mha .mhd (label map), .zarr (label map, a store), .csv (table). The volume "
            "also: .nrrd ... .zarr")
        ->required();
    command->add_option("--what", options->what, "segments, or volume: what is left of it after cutting")
        ->check(CLI::IsMember({"segments", "volume"}))
        ->capture_default_str();
    command
        ->add_option("--segment", options->segments,
                     "Name or number of a segment; may be repeated. Without it all are exported")
        ->take_all()
        ->expected(1);
    addSurfaceOptions(*command, *options);
    command->add_option("--fill", options->settings.fill,
                        "With --what volume: the value where it was cut; without, its least value");
    command->add_option("--volume", options->volume.path,
                        "The volume that a label map lies on; of a session, to be used instead of its own");
    addReadOptions(*command, options->volume, "--store-level"); // --level is a value here
    addStorageOptions(*command, options->storage);
    command->callback([options] { runExport(*options); });
}

} // namespace vs::cli
