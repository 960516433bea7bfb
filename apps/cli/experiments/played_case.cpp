// SPDX-License-Identifier: Apache-2.0
#include "experiments/played_case.h"

#include "sessions/replay.h"

#include "base/error.h"
#include "base/timer.h"
#include "phantom/recipe.h"
#include "studio/cases/steps.h"
#include "volume/reading/label_map.h"

#include <algorithm>
#include <cmath>

namespace vs::cli {

namespace {

// A scan and what is true of it, a label a voxel; none where nothing is known.
struct Subject {
    volume::Volume volume;
    std::vector<std::int64_t> truth;
};

std::vector<std::int64_t> readTruth(const std::filesystem::path& path, const volume::Volume& volume) {
    std::vector<std::string> notices;
    const volume::LabelMap map = volume::readLabelMap(path, notices);
    volume::requireSameGrid(map, volume.geometry, volume.path);
    std::vector<std::int64_t> truth(map.labels.size());
    std::transform(map.labels.begin(), map.labels.end(), truth.begin(),
                   [&](std::uint8_t label) { return map.values[label]; });
    return truth;
}

// One session and where it is played.
class Player {
public:
    Player(PlayedCase& played, const PlayOptions& options, const gl::Context& context)
        : played_(played), options_(options), context_(context), session_(sessionOf(*played.which)),
          folder_(options.output / played.which->session) {
        played.scan = scanOf(session_);
    }

    void play() {
        if (!findScan()) {
            played_.isMissing = true;
            return;
        }
        Subject subject = open();
        const Timer loading;
        studio::Document document(std::move(subject.volume), session_.precision);
        FigureTaker::countAll(document);
        taker_.figures.loadSeconds = (readMs_ + loading.milliseconds()) / 1000;
        taker_.figures.dims = document.volume().geometry.dims;
        played_.volume = document.volume().name;
        fitPictures();
        std::filesystem::create_directories(folder_);
        replay(document);
        taker_.finish(document);
        if (!subject.truth.empty()) {
            taker_.figures.dice = diceOf(document, played_.which->compare, subject.truth);
        }
        context_.requireNoErrors();
        played_.figures = taker_.figures;
        takeStages();
    }

private:
    bool findScan() {
        if (session_.isMade()) {
            return true;
        }
        const auto found = studio::findFile(session_.volumePath, options_.data);
        session_.volumePath = found ? std::filesystem::absolute(*found) : session_.volumePath;
        return found.has_value();
    }

    Subject open() {
        Subject subject;
        if (session_.phantom) {
            auto made = phantom::make(*session_.phantom);
            subject.volume = std::move(made.volume);
            subject.truth.assign(made.labels.begin(), made.labels.end());
            return subject;
        }
        const Timer reading;
        std::vector<std::string> notices;
        subject.volume = studio::openVolume(session_, folder_, std::nullopt, notices);
        readMs_ = reading.milliseconds();
        if (const auto& truth = played_.which->truth; !truth.empty()) {
            if (const auto found = studio::findFile(truth, options_.data)) {
                subject.truth = readTruth(*found, subject.volume);
            }
        }
        return subject;
    }

    void fitPictures() {
        if (!options_.width) {
            return;
        }
        for (studio::Operation& operation : session_.operations) {
            if (auto* picture = std::get_if<studio::SavePicture>(&operation)) {
                const double scale = double(*options_.width) / picture->size.x;
                picture->size = glm::max(glm::ivec2(glm::round(scale * glm::dvec2(picture->size))), 1);
            }
        }
    }

    void replay(studio::Document& document) {
        const std::string name = played_.which->session + ".json";
        bool hasTimedModes = false;
        for (std::size_t i = 0; i < session_.operations.size(); ++i) {
            const studio::Operation& operation = session_.operations[i];
            if (!hasTimedModes && studio::isOutput(operation)) { // the view is set up, and nothing done
                taker_.timeModes(document);
                hasTimedModes = true;
            }
            taker_.add(operation, replayOperation(session_, name, i, document, context_, folder_));
        }
    }

    void takeStages() {
        for (const studio::Step& step : studio::stepsOf(session_.operations)) {
            PlayedCase::Stage stage{step.text, {}};
            for (std::size_t i = step.first; i < step.first + step.count; ++i) {
                if (const auto* picture = std::get_if<studio::SavePicture>(&session_.operations[i])) {
                    stage.pictures.push_back(picture->file);
                }
            }
            if (!stage.text.empty() || !stage.pictures.empty()) {
                played_.stages.push_back(std::move(stage));
            }
        }
    }

    PlayedCase& played_;
    const PlayOptions& options_;
    const gl::Context& context_;
    studio::Session session_;
    std::filesystem::path folder_;
    FigureTaker taker_;
    double readMs_ = 0;
};

} // namespace

std::size_t PlayedCase::pictureCount() const {
    std::size_t count = 0;
    for (const Stage& stage : stages) {
        count += stage.pictures.size();
    }
    return count;
}

PlayedCase playCase(const studio::Case& which, const PlayOptions& options, const gl::Context& context) {
    PlayedCase played;
    played.which = &which;
    try {
        Player(played, options, context).play();
    } catch (const std::exception& error) {
        played.error = error.what();
    }
    return played;
}

} // namespace vs::cli
