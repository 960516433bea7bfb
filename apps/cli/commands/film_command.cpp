// SPDX-License-Identifier: Apache-2.0
#include "arguments/parse.h"
#include "arguments/storage_argument.h"
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/long_work.h"
#include "sessions/replay.h"

#include "base/error.h"
#include "base/json_file.h"
#include "base/timer.h"
#include "gl/context.h"
#include "studio/document/document.h"
#include "studio/json/operation_json.h"
#include "studio/json/session.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vs::cli {

namespace {

struct FilmOptions {
    std::string input; // a session, or a volume
    std::string output;
    std::vector<std::string> shots;
    std::string shotsFile;
    std::string size = "1280x720";
    double rate = 25;
    int samples = 4;
    std::string background = "studio";
    bool annotations = false;
    std::string range;
    std::string mode;
    VolumeArgument volume;
    StorageArgument storage;
};

using Json = nlohmann::ordered_json;

// "growth:6:turntable:360" as it stands in sessions; what is left out is as there.
Json shotOf(const std::string& text) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        c == ':' ? parts.emplace_back() : parts.back() += c;
    }
    const auto number = [&](std::size_t n) {
        try {
            std::size_t used = 0;
            const double value = std::stod(parts[n], &used);
            if (used == parts[n].size()) {
                return value;
            }
        } catch (const std::exception&) { // told below
        }
        throw UsageError("--shot {}: '{}' is not a number; give KIND:SECONDS:ORBIT:AMOUNT", text, parts[n]);
    };
    if (parts.size() > 4) {
        throw UsageError("--shot {}: give KIND, or KIND:SECONDS:ORBIT:AMOUNT", text);
    }
    Json shot{{"shot", parts[0]}};
    if (parts[0] == "shrinking") { // growth, from its end to its seeds
        shot["shot"] = "growth";
        shot["backward"] = true;
    }
    if (parts.size() > 1) {
        shot["seconds"] = number(1);
    }
    if (parts.size() > 2) {
        shot["orbit"] = parts[2];
    }
    if (parts.size() > 3) {
        shot["amount"] = number(3);
    }
    return shot;
}

Json shotsOf(const FilmOptions& options) {
    Json shots = Json::array();
    if (!options.shotsFile.empty()) {
        const Json file = readJsonFile(options.shotsFile, "a list of shots", "doc/session.md");
        for (const Json& shot : file.is_array() ? file : Json::array({file})) {
            shots.push_back(shot);
        }
    }
    for (const std::string& shot : options.shots) {
        shots.push_back(shotOf(shot));
    }
    if (shots.empty()) {
        shots.push_back({{"shot", "still"}, {"seconds", 8}, {"orbit", "turntable"}});
    }
    return shots;
}

// A folder for pictures may end in a slash.
std::filesystem::path fileOf(const FilmOptions& options) {
    const std::filesystem::path file(options.output);
    return file.has_filename() ? file : file.parent_path();
}

// The film as sessions have it, so that one place says what may be given.
studio::SaveMovie filmOf(const FilmOptions& options) {
    const glm::ivec2 size = parseSize(options.size);
    const std::filesystem::path file = fileOf(options);
    const Json json{{"op", "movie"},
                    {"file", file.filename().string()},
                    {"size", {size.x, size.y}},
                    {"rate", options.rate},
                    {"samples", options.samples},
                    {"background", options.background},
                    {"annotations", options.annotations},
                    {"shots", shotsOf(options)}};
    return std::get<studio::SaveMovie>(studio::operationFromJson(json, options.output));
}

std::unique_ptr<studio::Document> openInput(const FilmOptions& options, const gl::Context& context) {
    if (options.input.ends_with(".json")) {
        studio::Session session = studio::loadSession(options.input);
        return openDocument(session, options.input,
                            loadSessionScan(session, options.input, options.volume, options.storage),
                            context);
    }
    VolumeArgument argument = options.volume;
    argument.path = options.input;
    return documentOf(loadScan(argument, options.storage));
}

void look(const FilmOptions& options, studio::Document& document) {
    studio::View view = document.view();
    if (!options.range.empty()) {
        view.range = parseRange(options.range);
    }
    if (!options.mode.empty()) {
        view.mode = render::modeFromName(options.mode);
    }
    document.showView(view);
}

void makeFilm(const FilmOptions& options) {
    const studio::SaveMovie film = filmOf(options);
    const Timer timer;
    const auto context = gl::Context::createHeadless();
    const auto document = openInput(options, context);
    look(options, *document);
    {
        const LongWork work("filming");
        document->apply(film, fileOf(options).parent_path());
    }
    context.requireNoErrors();
    fmt::print("{}: {:.1f} s\n", options.output, timer.milliseconds() / 1000);
}

} // namespace

void addFilmCommand(CLI::App& app) {
    auto* command =
        app.add_subcommand("film", "Make a film of a session or a volume: a turntable, growth, what "
                                   "was done with its strokes, or a way from view to view");
    auto options = std::make_shared<FilmOptions>();
    command->add_option("input", options->input, "Session (.json) or volume")->required();
    command
        ->add_option("-o,--output", options->output,
                     "File to write: .webm (VP9), .mp4 (H.264), or a name without an ending for a folder of "
                     "numbered PNGs; the first two need the program ffmpeg")
        ->required();
    command->add_option(
        "--shot", options->shots,
        "KIND:SECONDS:ORBIT:AMOUNT, again for each shot. KIND: still, growth, shrinking, session; "
        "ORBIT: none, turntable, rock, tilt, spiral, approach; AMOUNT: degrees, or how much "
        "nearer. Without: still:8:turntable:360");
    command->add_option("--shots", options->shotsFile,
                        "JSON file with shots as sessions have them (doc/session.md), with key frames");
    command->add_option("--size", options->size, "Size, WxH")->capture_default_str();
    command->add_option("--rate", options->rate, "Frames a second")->capture_default_str();
    command->add_option("--samples", options->samples, "Samples a pixel")->capture_default_str();
    command
        ->add_option("--background", options->background, "studio, white, black, #RRGGBB or #RRGGBB:#RRGGBB")
        ->capture_default_str();
    command->add_flag("--annotations", options->annotations, "Scale bar, orientation marker, measurements");
    command->add_option("--range", options->range,
                        "Displayed range, LO:HI, instead of the session's or usual one");
    command->add_option("--mode", options->mode, "Mode, instead of the session's");
    command->add_option("--volume", options->volume.path, "Use this volume instead of the session's own");
    addReadOptions(*command, options->volume);
    addStorageOptions(*command, options->storage);
    command->callback([options] { makeFilm(*options); });
}

} // namespace vs::cli
