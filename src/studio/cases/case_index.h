// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/description.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vs::studio {

// The cases that come with the program: the experiments of the thesis, section 6, and some of its figures, as
// sessions that can be replayed into pictures or played before one's eyes. What is said of them stands in
// examples/experiments/index.json, which these structs describe; the sessions lie beside it.

// A scan that some of them work on, which does not come with the program.
struct CaseScan {
    static constexpr const char* kName = "scan";

    std::string file;    // its name, in whatever folder it lies
    std::string meaning; // "T1-weighted MR of a head, the mean of 27 scans of one man"
    std::string from;    // where it can be had
    std::string licence;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("file", &CaseScan::file), required("what", &CaseScan::meaning),
                          required("from", &CaseScan::from), required("licence", &CaseScan::licence)};
    }
};

// Which true labels a segment is to cover.
struct TrueLabels {
    static constexpr const char* kName = "true labels";

    std::string segment;
    std::vector<int> labels;
    bool isOnePiece =
        false; // only the connected piece of them that it shares most with: one of two ventricles

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("segment", &TrueLabels::segment),
                          required("labels", &TrueLabels::labels, {.least = 1, .most = 255}),
                          sparse("onePiece", &TrueLabels::isOnePiece)};
    }
};

// One session of an experiment, on one scan.
struct Case {
    static constexpr const char* kName = "case";

    std::string session;             // the name of its file, without extension
    std::string truth;               // a label map's file; of a phantom, its own labels, if empty
    std::vector<TrueLabels> compare; // none: nothing is known to be true

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("session", &Case::session), sparse("truth", &Case::truth),
                          sparse("compare", &Case::compare)};
    }
};

// What was measured in the thesis, section 6, table 6.1: frames a second, loading in seconds. Not set: not
// measured.
struct ThesisFigures {
    static constexpr const char* kName = "figures of the thesis";
    static constexpr const char* kDevice =
        "GeForce 8800 GTX (768 MB), AMD Athlon 64 X2 3800, 1230 x 870 pixels, 2009";

    std::string size; // "256 x 256 x 256"
    std::optional<double> load, mip, xray, surface, drill, laser, peel, paste;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("size", &ThesisFigures::size),      sparse("load", &ThesisFigures::load),
                          sparse("mip", &ThesisFigures::mip),          sparse("xray", &ThesisFigures::xray),
                          sparse("surface", &ThesisFigures::surface),  sparse("drill", &ThesisFigures::drill),
                          sparse("laser", &ThesisFigures::laser),      sparse("peel", &ThesisFigures::peel),
                          sparse("cutAndPaste", &ThesisFigures::paste)};
    }
};

struct Experiment {
    static constexpr const char* kName = "experiment";

    std::string name;   // as it is asked for on the command line: "head"
    std::string title;  // "Exploring a head"
    std::string figure; // "6.1": of the thesis, section 6 or another
    std::string about;  // one or two sentences
    std::optional<ThesisFigures> thesis;
    std::vector<Case> cases; // those whose scan anyone has first

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("name", &Experiment::name),     required("title", &Experiment::title),
                          required("figure", &Experiment::figure), required("about", &Experiment::about),
                          sparse("thesis", &Experiment::thesis),   required("cases", &Experiment::cases)};
    }
};

struct CaseIndex {
    static constexpr const char* kName = "case index";

    std::vector<CaseScan> scans;
    std::vector<Experiment> experiments; // in the order of their figures

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{required("scans", &CaseIndex::scans),
                          required("experiments", &CaseIndex::experiments)};
    }
};

} // namespace vs::studio
