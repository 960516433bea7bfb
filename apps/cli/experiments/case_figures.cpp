// SPDX-License-Identifier: Apache-2.0
#include "experiments/case_figures.h"

#include "base/error.h"
#include "base/timer.h"
#include "field/gradient.h"
#include "field/histogram.h"
#include "render/rays/ray_caster.h"
#include "segment/edits/islands.h"
#include "segment/edits/set_algebra.h"
#include "segment/measures/agreement.h"
#include "studio/state/region.h"

#include <algorithm>

namespace vs::cli {

namespace {

constexpr glm::ivec2 kWindow{1230, 870}; // as in the thesis, section 6
constexpr int kTimedPictures = 2;        // after one that does not count

double picturesPerSecond(studio::Document& document) {
    render::RayCaster caster;
    const auto draw = [&] {
        caster.render(document.frame(kWindow));
        gl::Context::finish();
    };
    draw();
    const Timer timer;
    for (int i = 0; i < kTimedPictures; ++i) {
        draw();
    }
    return 1000 * kTimedPictures / timer.milliseconds();
}

// The connected piece of a set that shares most voxels with another.
segment::VoxelSet pieceOf(const segment::VoxelSet& truth, const segment::VoxelSet& found) {
    segment::VoxelSet best;
    std::size_t most = 0;
    for (const segment::Island& island : segment::islands(truth)) {
        segment::VoxelSet piece = segment::keepIsland(truth, island.first);
        const std::size_t shared = segment::intersect(piece, found).count();
        if (shared > most) {
            most = shared;
            best = std::move(piece);
        }
    }
    return best;
}

double placesOf(const studio::PenCut& cut) { return std::max(1.0, double(cut.stroke.size())); }

} // namespace

void FigureTaker::countAll(const studio::Document& document) {
    const field::Field& field = document.field();
    field::intensityHistogram(field);
    const Range gradients = field::gradientRange(field);
    field::gradientHistogram(field, gradients);
    field::jointHistogram(field, gradients);
    gl::Context::finish();
}

void FigureTaker::timeModes(studio::Document& document) {
    const studio::View shown = document.view();
    const auto time = [&](render::Mode mode) {
        studio::View view = shown;
        view.mode = mode;
        document.showView(view);
        return picturesPerSecond(document);
    };
    figures.mip = time(render::Mode::Mip);
    figures.xray = time(render::Mode::XRay);
    figures.surface = time(render::Mode::Surface);
    document.showView(shown);
}

void FigureTaker::add(const studio::Operation& operation, const studio::Outcome& outcome) {
    const auto count = [&](Tally& tally, double amount) {
        tally.milliseconds += outcome.milliseconds;
        tally.amount += amount;
    };
    if (const auto* drill = std::get_if<studio::Drill>(&operation)) {
        count(drill_, placesOf(*drill));
    } else if (const auto* laser = std::get_if<studio::Laser>(&operation)) {
        count(laser_, placesOf(*laser));
    } else if (const auto* peel = std::get_if<studio::Peel>(&operation)) {
        count(peel_, std::max(1.0, peel->layers));
    } else if (std::holds_alternative<studio::Grow>(operation)) {
        count(growth_, double(outcome.voxelsTouched));
    }
    figures.seconds += outcome.milliseconds / 1000;
}

std::optional<double> FigureTaker::updatesPerSecond(const Tally& tool) const {
    if (tool.amount == 0) {
        return {};
    }
    return 1000 / (tool.milliseconds / tool.amount + 1000 / figures.surface);
}

void FigureTaker::finish(studio::Document& document) {
    figures.drill = updatesPerSecond(drill_);
    figures.laser = updatesPerSecond(laser_);
    figures.peel = updatesPerSecond(peel_);
    if (growth_.milliseconds > 0) {
        figures.voxelsPerSecond = 1000 * growth_.amount / growth_.milliseconds;
    }
    const auto& segments = document.segments().segments;
    const bool hasPulledOut = std::any_of(segments.begin(), segments.end(),
                                          [](const auto& segment) { return segment.pulledOut.has_value(); });
    if (hasPulledOut || !document.view().pasted.empty()) {
        figures.paste = picturesPerSecond(document);
    }
}

std::vector<std::pair<std::string, double>> diceOf(const studio::Document& document,
                                                   const std::vector<studio::TrueLabels>& wanted,
                                                   const std::vector<std::int64_t>& truth) {
    const auto map = document.region().labelMap();
    std::vector<std::pair<std::string, double>> result;
    for (const studio::TrueLabels& one : wanted) {
        const studio::SegmentInfo* segment = document.segments().find(one.segment);
        if (segment == nullptr) {
            throw Error("there is no segment '{}' to be compared with what is true", one.segment);
        }
        const glm::ivec3 dims = document.volume().geometry.dims;
        segment::VoxelSet found = segment::emptySet({glm::ivec3(0), dims});
        segment::VoxelSet wantedSet = found;
        for (std::size_t i = 0; i < map.size(); ++i) {
            found.inside[i] = std::uint8_t(map[i] == segment->label);
            wantedSet.inside[i] = std::uint8_t(
                std::find(one.labels.begin(), one.labels.end(), int(truth[i])) != one.labels.end());
        }
        if (one.isOnePiece) {
            wantedSet = pieceOf(wantedSet, found).within(found.box);
        }
        result.emplace_back(one.segment, segment::dice(dims, found.inside, wantedSet.inside));
    }
    return result;
}

} // namespace vs::cli
