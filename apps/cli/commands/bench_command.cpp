// SPDX-License-Identifier: Apache-2.0
// vstudio bench: how long reading, preparing, rendering and editing take on this device.
#include "arguments/parse.h"
#include "arguments/volume_argument.h"
#include "bench/bench_scenarios.h"
#include "bench/bench_strokes.h"
#include "commands/commands.h"
#include "reports/progress.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/lines.h"
#include "base/log.h"
#include "field/histogram.h"
#include "gl/context.h"
#include "phantom/phantom.h"
#include "render/colours/transfer_function_json.h"
#include "volume/reading/read_volume.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace vs::cli {

namespace {

using Json = nlohmann::json;

constexpr int kPhantomSide = 256;

struct BenchOptions {
    std::vector<std::string> volumes;
    VolumeArgument reading; // all but the path
    std::string json;
    int frames = BenchSettings().frames;
    std::string size = "1230x870";
    std::string range;
    std::string function;
    std::string modes;
    std::string parts = "data,modes,edits";
    std::string orbit;
};

// Everything on the command line, understood before anything is read.
struct BenchRequest {
    BenchSettings settings;
    std::optional<Range> range;
    std::optional<render::TransferFunction> function;
    std::vector<render::Mode> modes;
    std::vector<std::string> parts;

    [[nodiscard]] bool wants(const std::string& part) const {
        return std::find(parts.begin(), parts.end(), part) != parts.end();
    }
};

// "AZIMUTH,AZIMUTH,...:ELEVATION", degrees.
Orbit parseOrbit(const std::string& text) {
    const std::string example = "0,90,180,270:15";
    const auto halves = split(text, ':');
    if (halves.size() != 2) {
        throw UsageError("--orbit '{}' is not understood; write azimuths and one elevation like {}", text,
                         example);
    }
    const auto count = std::size_t(std::count(halves[0].begin(), halves[0].end(), ',')) + 1;
    return {parseNumbers(halves[0], ',', count, "--orbit", example),
            parseNumbers(halves[1], ',', 1, "--orbit", example)[0]};
}

std::vector<render::Mode> parseModes(const std::string& text) {
    std::vector<render::Mode> modes;
    if (text.empty()) {
        modes.assign(std::begin(render::kModes), std::end(render::kModes));
        return modes;
    }
    for (const auto& name : split(text, ',')) {
        modes.push_back(render::modeFromName(name));
    }
    return modes;
}

std::vector<std::string> parseParts(const std::string& text) {
    auto parts = split(text, ',');
    for (const auto& part : parts) {
        if (part != "data" && part != "modes" && part != "edits" && part != "strokes") {
            throw UsageError("--parts: there is no part '{}'; choose among data, modes, edits and strokes",
                             part);
        }
    }
    return parts;
}

BenchRequest understand(const BenchOptions& options) {
    BenchRequest request;
    request.settings.size = parseSize(options.size);
    request.settings.frames = options.frames;
    if (!options.orbit.empty()) {
        request.settings.orbit = parseOrbit(options.orbit);
    }
    if (!options.range.empty()) {
        request.range = parseRange(options.range);
    }
    if (!options.function.empty()) {
        request.function = render::transferFunctionFromArgument(options.function);
    }
    request.modes = parseModes(options.modes);
    request.parts = parseParts(options.parts);
    readOptions(options.reading);
    if (!options.json.empty()) {
        outputFile(options.json);
    }
    return request;
}

// A ball with a spherical cave that opens to the front: surfaces before and behind others.
volume::Volume makePhantom() {
    constexpr double side = kPhantomSide;
    const auto edge = [](double depth) { return 200 * std::clamp(depth / 4 + 0.5, 0.0, 1.0); };
    auto volume =
        phantom::makePhantom(glm::ivec3(kPhantomSide), volume::ScalarType::UInt8, [&](glm::dvec3 p) {
            const double inBall = 0.42 * side - glm::distance(p, glm::dvec3(0.5 * side));
            const double outsideCave = glm::distance(p, glm::dvec3(0.5, 0.2, 0.6) * side) - 0.18 * side;
            return edge(std::min(inBall, outsideCave));
        });
    volume.name = fmt::format("phantom {}", kPhantomSide);
    return volume;
}

VolumeArgument argumentFor(const BenchOptions& options, const std::string& path) {
    VolumeArgument argument = options.reading;
    argument.path = path;
    return argument;
}

void printTable(const volume::Volume& volume, const BenchRequest& request, const std::string& device,
                const std::vector<Measurement>& results) {
    const auto d = volume.geometry.dims;
    fmt::print("{}: {} x {} x {} {}, pictures of {} x {}, on {}\n", volume.name, d.x, d.y, d.z,
               name(volume.type), request.settings.size.x, request.settings.size.y, device);
    fmt::print("  {:<20} {:>4} {:>11} {:>11} {:>11}   passes by the device's clock (ms)\n", "milliseconds",
               "runs", "median", "least", "device");
    for (const auto& result : results) {
        std::vector<std::string> passes;
        for (const auto& [pass, times] : result.passes) {
            passes.push_back(fmt::format("{} {:.2f}", pass, times.deviceMilliseconds));
        }
        fmt::print("  {:<20} {:>4} {:>11.2f} {:>11.2f} {:>11.2f}   {}\n", result.name,
                   result.milliseconds.size(), result.medianMilliseconds(),
                   *std::min_element(result.milliseconds.begin(), result.milliseconds.end()),
                   result.deviceMilliseconds(), fmt::join(passes, ", "));
    }
}

Json toJson(const Measurement& result) {
    Json passes = Json::object();
    for (const auto& [pass, times] : result.passes) {
        passes[pass] = {{"count", times.count},
                        {"milliseconds", times.milliseconds},
                        {"deviceMilliseconds", times.deviceMilliseconds}};
    }
    return {{"kind", result.kind},
            {"name", result.name},
            {"medianMilliseconds", result.medianMilliseconds()},
            {"deviceMilliseconds", result.deviceMilliseconds()},
            {"milliseconds", result.milliseconds},
            {"passes", passes}};
}

Json toJson(const volume::Volume& volume, const Range& range, const std::vector<Measurement>& results) {
    const auto d = volume.geometry.dims;
    Json entries = Json::array();
    for (const auto& result : results) {
        entries.push_back(toJson(result));
    }
    return {{"path", volume.path.string()}, {"name", volume.name},           {"dims", {d.x, d.y, d.z}},
            {"type", name(volume.type)},    {"range", {range.lo, range.hi}}, {"entries", entries}};
}

// Measures what is asked for, prints a table and returns it as JSON.
Json benchVolume(const BenchOptions& options, const BenchRequest& request, const std::string& path,
                 volume::Volume volume, const gl::Context& context) {
    std::vector<Measurement> results;
    if (request.wants("data") && !path.empty()) {
        const auto read = [&] { volume::readVolume(path, readOptions(options.reading)); };
        benchReading(request.settings, read, results);
    }
    if (request.wants("data")) {
        benchData(request.settings, volume, request.range.value_or(volume.range), results);
    }
    studio::Document document(std::move(volume));
    studio::View view = document.view();
    view.range = request.range.value_or(view.range);
    view.transferFunction = request.function;
    document.showView(view);
    for (const render::Mode mode : request.modes) {
        if (request.wants("modes")) {
            benchMode(request.settings, document, mode, results);
        }
    }
    if (request.wants("edits") && !benchEdits(request.settings, document, results)) {
        logNotice(fmt::format("{}: no surface is met, so nothing was edited", document.volume().name));
    }
    if (request.wants("strokes") && !benchStrokes(request.settings, document, results)) {
        logNotice(fmt::format("{}: no surface is met, so no stroke was made", document.volume().name));
    }
    context.requireNoErrors();
    printTable(document.volume(), request, context.device().renderer, results);
    return toJson(document.volume(), view.range, results);
}

void runBench(const BenchOptions& options) {
    const BenchRequest request = understand(options);
    const auto context = gl::Context::createHeadless();
    Json volumes = Json::array();
    for (const auto& path : options.volumes) {
        auto volume = loadVolume(argumentFor(options, path)).volume;
        volumes.push_back(benchVolume(options, request, path, std::move(volume), context));
    }
    if (options.volumes.empty() && request.parts == std::vector<std::string>{"strokes"}) {
        for (const int side : {128, 256, 512}) {
            volumes.push_back(benchVolume(options, request, "", ballIn(side), context));
        }
    } else if (options.volumes.empty()) {
        volumes.push_back(benchVolume(options, request, "", makePhantom(), context));
    }
    if (!options.json.empty()) {
        const auto& settings = request.settings;
        const auto& device = context.device();
        const Json report{{"program", "vstudio " VOLUME_STUDIO_VERSION},
                          {"device",
                           {{"renderer", device.renderer},
                            {"vendor", device.vendor},
                            {"version", device.version},
                            {"isSoftware", device.isSoftware}}},
                          {"size", {settings.size.x, settings.size.y}},
                          {"frames", settings.frames},
                          {"azimuths", settings.orbit.azimuths},
                          {"elevation", settings.orbit.elevation},
                          {"volumes", volumes}};
        writeFileAtomically(options.json, report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    }
}

} // namespace

void addBenchCommand(CLI::App& app) {
    auto* command = app.add_subcommand("bench", "Time reading, preparing, rendering and editing");
    auto options = std::make_shared<BenchOptions>();
    command->add_option(
        "VOLUME", options->volumes,
        "Volumes as other commands take them; a phantom of 256 x 256 x 256 voxels if none is given");
    addReadOptions(*command, options->reading);
    command->add_option("--json", options->json, "Write everything measured to this file");
    command->add_option("--frames", options->frames, "Frames per mode, stamps per tool")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    command->add_option("--size", options->size, "Pixels, WIDTHxHEIGHT")->capture_default_str();
    command->add_option("--range", options->range,
                        "Displayed range LO:HI; suggested from the histogram if not given");
    command->add_option("--tf", options->function,
                        "Transfer function that colours every mode: a preset's name or a JSON file");
    command->add_option("--modes", options->modes, "Render modes, separated by commas; all if not given");
    command
        ->add_option("--parts", options->parts,
                     "Which of data, modes, edits and strokes to time; strokes without a "
                     "VOLUME are timed in balls of one size in volumes of 128, 256 and 512")
        ->capture_default_str();
    command->add_option("--orbit", options->orbit,
                        "Cameras AZIMUTH,AZIMUTH,...:ELEVATION in degrees; eight around at 15 if not given");
    command->callback([options] { runBench(*options); });
}

} // namespace vs::cli
