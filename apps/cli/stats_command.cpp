// SPDX-License-Identifier: Apache-2.0
// vstudio stats: what the labels of a label map cover of a volume, as a table.
#include "commands.h"
#include "label_map.h"
#include "measurements.h"
#include "volume_argument.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "segment/statistics.h"

#include <memory>
#include <string>

namespace vs::cli {
namespace {

struct StatsOptions {
    std::string labels;
    VolumeArgument volume;
    std::string csv;
};

void run(const StatsOptions& options) {
    if (!options.csv.empty()) { // what can be wrong is said before anything is read
        if (!options.csv.ends_with(".csv")) {
            throw UsageError("--csv {}: give a name that ends in .csv", options.csv);
        }
        outputFile(options.csv);
    }
    const LabelMap map = readLabelMap(options.labels);
    const volume::Volume volume = loadVolume(options.volume).volume;
    requireSameGrid(map, volume.geometry, volume.path);
    std::vector<MeasuredSegment> segments;
    for (const auto& statistics : segment::measure(volume, map.labels)) {
        segments.push_back({map.values[statistics.label], "", {}, statistics});
    }
    if (segments.empty()) {
        throw Error("{}: holds no label; a label map has voxels other than 0", options.labels);
    }
    if (!options.csv.empty()) {
        writeFileAtomically(options.csv, csvOf(segments));
    }
    printTable(segments);
}

} // namespace

void addStatsCommand(CLI::App& app) {
    auto* command = app.add_subcommand("stats", "Measures what the labels of a label map cover of a volume");
    const auto options = std::make_shared<StatsOptions>();
    command
        ->add_option("LABELS", options->labels,
                     "Label map: whole numbers, 0 for none, in any format that volumes are read from")
        ->required();
    command->add_option("--volume", options->volume.path, "The volume that it lies on")->required();
    addReadOptions(*command, options->volume);
    command->add_option("--csv", options->csv, "Write the table with all digits too (CSV)");
    command->callback([options] { run(*options); });
}

} // namespace vs::cli
