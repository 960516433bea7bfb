// SPDX-License-Identifier: Apache-2.0
#include "experiments/page.h"

#include "base/atomic_file.h"
#include "base/check.h"

#include <fmt/format.h>

#include <map>

namespace vs::cli {

namespace {

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += c == '&'   ? "&amp;"
                  : c == '<' ? "&lt;"
                  : c == '>' ? "&gt;"
                  : c == '"' ? "&quot;"
                             : std::string(1, c);
    }
    return result;
}

// Three digits that mean something, and none that do not.
std::string rounded(double value) {
    return value >= 100  ? fmt::format("{:.0f}", value)
           : value >= 10 ? fmt::format("{:.1f}", value)
                         : fmt::format("{:.2f}", value);
}
std::string roundedOrNothing(const std::optional<double>& value) { return value ? rounded(*value) : ""; }

std::string sizeText(glm::ivec3 dims) { return fmt::format("{} × {} × {}", dims.x, dims.y, dims.z); }

std::string scanText(const PlayedCase& played) {
    return played.scan != nullptr ? played.scan->file : played.volume;
}

std::string diceText(const CaseFigures& figures) {
    std::string text;
    for (const auto& [segment, dice] : figures.dice) {
        text += fmt::format("{}{} {:.3f}", text.empty() ? "" : ", ", segment, dice);
    }
    return text;
}

std::string row(const std::string& attributes, const std::vector<std::string>& cells) {
    std::string text = fmt::format("<tr{}>", attributes);
    for (const std::string& cell : cells) {
        text += fmt::format("<td>{}</td>", cell);
    }
    return text + "</tr>\n";
}

std::string rowOf(const PlayedExperiment& experiment, const PlayedCase& played, bool isFirst) {
    const CaseFigures& f = played.figures;
    const std::string name = fmt::format("<a href=\"#{}\">{}</a>, {}", experiment.which->name,
                                         escaped(experiment.which->title), escaped(scanText(played)));
    const std::string growth = f.voxelsPerSecond ? rounded(*f.voxelsPerSecond / 1e6) : std::string();
    return row(isFirst ? " class=\"first\"" : "",
               {name, sizeText(f.dims), rounded(f.loadSeconds), rounded(f.mip), rounded(f.xray),
                rounded(f.surface), roundedOrNothing(f.drill), roundedOrNothing(f.laser),
                roundedOrNothing(f.peel), roundedOrNothing(f.paste), growth, rounded(f.seconds),
                escaped(diceText(f))});
}

std::string rowOf(const studio::ThesisFigures& f) {
    const auto number = [](const std::optional<double>& value) {
        return value ? fmt::format("{:g}", *value) : std::string();
    };
    return row(" class=\"thesis\"", {"in the thesis", escaped(f.size), number(f.load), number(f.mip),
                                     number(f.xray), number(f.surface), number(f.drill), number(f.laser),
                                     number(f.peel), number(f.paste), "", "", ""});
}

std::string rows(const std::vector<PlayedExperiment>& experiments) {
    std::string text;
    for (const PlayedExperiment& experiment : experiments) {
        bool isFirst = true;
        for (const PlayedCase& played : experiment.cases) {
            if (played.isDone()) {
                text += rowOf(experiment, played, isFirst);
                isFirst = false;
            }
        }
        if (!isFirst && experiment.which->thesis) {
            text += rowOf(*experiment.which->thesis);
        }
    }
    return text;
}

std::string stagesOf(const PlayedCase& played) {
    std::string text = "<div class=\"stages\">\n";
    for (const PlayedCase::Stage& stage : played.stages) {
        // The text stands under the last of its pictures, which shows what came of it.
        for (std::size_t i = 0; i < stage.pictures.size(); ++i) {
            const bool isLast = i + 1 == stage.pictures.size();
            text += fmt::format("<figure><img src=\"{}/{}\" alt=\"{}\" loading=\"lazy\"><figcaption>{}"
                                "</figcaption></figure>\n",
                                played.which->session, escaped(stage.pictures[i]), escaped(stage.text),
                                isLast ? escaped(stage.text) : std::string());
        }
    }
    return text + "</div>\n";
}

std::string sectionOf(const PlayedExperiment& experiment) {
    std::string text = fmt::format("<h2 id=\"{}\"><span class=\"figure\">{}</span>{}</h2>\n<p>{}</p>\n",
                                   experiment.which->name, escaped("figure " + experiment.which->figure),
                                   escaped(experiment.which->title), escaped(experiment.which->about));
    for (const PlayedCase& played : experiment.cases) {
        if (!played.error.empty()) {
            text += fmt::format("<h3>{}</h3>\n<p class=\"failed\">{}</p>\n", escaped(played.which->session),
                                escaped(played.error));
        } else if (!played.isMissing) {
            const std::string origin =
                played.scan == nullptr
                    ? played.volume + ", made by the program"
                    : fmt::format("{}: {}. From {}; licence: {}", played.scan->file, played.scan->meaning,
                                  played.scan->from, played.scan->licence);
            text += fmt::format("<h3>{}</h3>\n{}", escaped(origin), stagesOf(played));
        }
    }
    return text;
}

std::string missingScans(const std::vector<PlayedExperiment>& experiments) {
    std::string list;
    for (const PlayedExperiment& experiment : experiments) {
        for (const PlayedCase& played : experiment.cases) {
            if (played.isMissing && played.scan != nullptr) {
                list += fmt::format("<li>{}: {} ({}), from {}</li>\n", escaped(played.which->session),
                                    escaped(played.scan->file), escaped(played.scan->meaning),
                                    escaped(played.scan->from));
            }
        }
    }
    return list.empty() ? ""
                        : "<h2>Not played</h2>\n<p>Their scans do not come with the program. With a folder "
                          "that has them, <code>--data FOLDER</code>, they are.</p>\n<ul class=\"quiet\">\n" +
                              list + "</ul>\n";
}

std::string filledIn(std::string page, const std::map<std::string, std::string>& texts) {
    for (const auto& [name, text] : texts) {
        const std::string place = "{{" + name + "}}";
        const auto at = page.find(place);
        VS_CHECK(at != std::string::npos);
        page.replace(at, place.size(), text);
    }
    return page;
}

} // namespace

void writePage(const std::filesystem::path& file, const std::vector<PlayedExperiment>& experiments,
               const std::string& device) {
    const std::map<std::string, std::string> texts{
        {"introduction",
         "The ten experiments of the thesis “Interactive Volume Manipulation”, chapter 6, and some of its "
         "figures, done again: each is a session of strokes on the rendered picture, replayed into these "
         "pictures by <code>vstudio experiments</code>. Green is what is about to be drawn, red what has "
         "been."},
        {"device", escaped("Measured on: " + device +
                           ". The thesis measured on: " + studio::ThesisFigures::kDevice + ".")},
        {"rows", rows(experiments)},
        {"notes",
         "Pictures are of 1230 × 870 pixels with one ray a pixel, in the view of the first picture. Load: "
         "reading the file (a phantom is not read), upload, and the histograms of intensity, gradient "
         "magnitude and both. An update is a place of the pen or a layer of a peel, with a picture in "
         "surface "
         "mode after each. All: every operation of the session with its pictures."},
        {"experiments",
         [&] {
             std::string all;
             for (const PlayedExperiment& experiment : experiments) {
                 all += sectionOf(experiment);
             }
             return all;
         }()},
        {"missing", missingScans(experiments)}};
    writeFileAtomically(file, filledIn(std::string(embeddedPages().front().text), texts));
}

void writeFigures(const std::filesystem::path& file, const std::vector<PlayedExperiment>& experiments) {
    std::string csv =
        "experiment,session,voxels_x,voxels_y,voxels_z,load_s,mip_per_s,xray_per_s,surface_per_s,"
        "drill_updates_per_s,laser_updates_per_s,peel_updates_per_s,cut_and_paste_per_s,"
        "growth_voxels_per_s,all_s,dice\n";
    const auto number = [](const std::optional<double>& value) {
        return value ? fmt::format("{:.6g}", *value) : std::string();
    };
    for (const PlayedExperiment& experiment : experiments) {
        for (const PlayedCase& played : experiment.cases) {
            if (!played.isDone()) {
                continue;
            }
            const CaseFigures& f = played.figures;
            csv += fmt::format("{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{},{},{},{},{},{:.6g},\"{}\"\n",
                               experiment.which->name, played.which->session, f.dims.x, f.dims.y, f.dims.z,
                               f.loadSeconds, f.mip, f.xray, f.surface, number(f.drill), number(f.laser),
                               number(f.peel), number(f.paste), number(f.voxelsPerSecond), f.seconds,
                               diceText(f));
        }
    }
    writeFileAtomically(file, csv);
}

} // namespace vs::cli
