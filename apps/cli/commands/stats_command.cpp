// SPDX-License-Identifier: Apache-2.0
// vstudio stats: what the labels of a label map, or the segments of a session, cover of a volume, as a table.
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/label_map.h"
#include "reports/measurements.h"
#include "reports/progress.h"
#include "sessions/replay.h"

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/error.h"
#include "gl/context.h"
#include "segment/measures/statistics.h"
#include "studio/document/document.h"
#include "studio/document/document_facts.h"
#include "studio/exports/segment_measures.h"
#include "studio/json/session.h"
#include "studio/state/region.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace vs::cli {
namespace {

struct StatsOptions {
    std::string labels; // or a session
    VolumeArgument volume;
    std::string csv;
    std::string measurements;
    std::string vessels;
};

std::vector<MeasuredSegment> measureLabels(const StatsOptions& options) {
    if (options.volume.path.empty()) {
        throw UsageError("--volume is required: a label map does not say which volume it lies on");
    }
    const volume::Volume volume = loadVolume(options.volume).volume;
    const LabelMap map = readLabelMap(options.labels, &volume.geometry);
    requireSameGrid(map, volume.geometry, volume.path);
    std::vector<MeasuredSegment> segments;
    for (const auto& statistics : segment::measure(volume, map.labels)) {
        segments.push_back({map.values[statistics.label], "", {}, statistics});
    }
    if (segments.empty()) {
        throw Error("{}: holds no label; a label map has voxels other than 0", options.labels);
    }
    return segments;
}

struct SessionFigures {
    std::vector<MeasuredSegment> segments;
    std::vector<studio::Measured> measurements;
    volume::GridGeometry geometry;
};

SessionFigures measureSession(const StatsOptions& options) {
    studio::Session session = studio::loadSession(options.labels);
    // First: how much is worked on follows what its device has.
    const auto context = gl::Context::createHeadless();
    SessionScan scan = loadSessionScan(session, options.labels, options.volume, {});
    const auto opened = openDocument(session, options.labels, std::move(scan), context);
    const studio::Document& document = *opened;
    const auto& infos = document.segments().segments;
    SessionFigures figures{{}, *document.facts()->measured, document.volume().geometry};
    for (const auto& statistics : studio::SegmentMeasures(document).all()) {
        const auto info = std::find_if(infos.begin(), infos.end(), [&](const studio::SegmentInfo& segment) {
            return segment.label == statistics.label;
        });
        VS_CHECK(info != infos.end());
        figures.segments.push_back(
            {info->label, info->name, glm::u8vec3(glm::round(info->colour * 255.0)), statistics});
    }
    context.requireNoErrors();
    if (figures.segments.empty() && figures.measurements.empty()) {
        throw Error("{}: leaves no voxel in a segment and no measurement; a session to measure seeds and "
                    "grows, or measures",
                    options.labels);
    }
    return figures;
}

void requireCsv(const char* option, const std::string& file) {
    if (!file.empty()) {
        if (!file.ends_with(".csv")) {
            throw UsageError("{} {}: give a name that ends in .csv", option, file);
        }
        outputFile(file);
    }
}

void run(const StatsOptions& options) {
    requireCsv("--csv", options.csv); // what can be wrong is said before anything is read
    requireCsv("--measurements", options.measurements);
    requireCsv("--vessels", options.vessels);
    const bool isSession = options.labels.ends_with(".json");
    for (const auto& [option, file] :
         {std::pair("--measurements", options.measurements), std::pair("--vessels", options.vessels)}) {
        if (!file.empty() && !isSession) {
            throw UsageError("{} {}: only sessions have measurements; give one (.json)", option, file);
        }
    }
    const SessionFigures figures =
        isSession ? measureSession(options) : SessionFigures{measureLabels(options), {}, {}};
    if (!options.csv.empty()) {
        writeFileAtomically(options.csv, csvOf(figures.segments));
    }
    if (!options.measurements.empty()) {
        writeFileAtomically(options.measurements, studio::csvOf(figures.measurements));
    }
    if (!options.vessels.empty()) {
        writeFileAtomically(options.vessels, studio::vesselsCsvOf(figures.measurements));
    }
    if (!figures.segments.empty()) {
        printTable(figures.segments);
    }
    printTable(figures.measurements, figures.geometry);
}

} // namespace

void addStatsCommand(CLI::App& app) {
    auto* command = app.add_subcommand("stats", "Measures what labels of a label map, or segments of a "
                                                "session, cover of a volume, and lists what was "
                                                "measured in a session");
    const auto options = std::make_shared<StatsOptions>();
    command
        ->add_option("LABELS", options->labels,
                     "Label map (whole numbers, 0 for none, in any format that volumes are read from), or a "
                     "session (.json), which is opened from its state or replayed without writing its files")
        ->required();
    command->add_option("--volume", options->volume.path,
                        "The volume that it lies on; of a session, to be used instead of its own");
    addReadOptions(*command, options->volume);
    command->add_option("--csv", options->csv, "Write the table with all digits too (CSV)");
    command->add_option("--measurements", options->measurements,
                        "Write the session's measurements with all digits too (CSV)");
    command->add_option("--vessels", options->vessels,
                        "Write the diameters along the session's vessels too (CSV)");
    command->callback([options] { run(*options); });
}

} // namespace vs::cli
