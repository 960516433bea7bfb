// SPDX-License-Identifier: Apache-2.0
#include "studio/cases/cases.h"

#include "base/error.h"
#include "studio/cases/steps.h"
#include "studio/operations/drawn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace vs::studio {
namespace {

template <typename F>
void forEachCase(F f) {
    for (const Experiment& experiment : caseIndex().experiments) {
        for (const Case& one : experiment.cases) {
            SCOPED_TRACE(one.session);
            f(one, sessionOf(one));
        }
    }
}

std::vector<std::string> picturesOf(const Session& session) {
    std::vector<std::string> files;
    for (const Operation& operation : session.operations) {
        if (const auto* picture = std::get_if<SavePicture>(&operation)) {
            files.push_back(picture->file);
        }
    }
    return files;
}

TEST(Cases, AreSessionsOfScansThatAreMadeOrSaidWhereToBeHad) {
    std::set<std::string> sessions;
    forEachCase([&](const Case& one, const Session& session) {
        EXPECT_TRUE(sessions.insert(one.session).second) << "is in the index twice";
        EXPECT_TRUE(session.isMade() || scanOf(session) != nullptr) << session.volumePath;
        EXPECT_TRUE(session.volumeChecksum.empty());
    });
    EXPECT_EQ(sessions.size() + 1, embeddedCases().size()) << "a session that the index does not name";
}

TEST(Cases, OfTheThesisAreTenOnScansThatAnyoneCanMake) {
    std::size_t ten = 0;
    for (const Experiment& experiment : caseIndex().experiments) {
        if (experiment.thesis) {
            ++ten;
            EXPECT_TRUE(sessionOf(experiment.cases.front()).isMade()) << experiment.name;
        }
    }
    EXPECT_EQ(ten, 10U);
}

TEST(Cases, MakeFiftyPicturesWithoutAnyScan) {
    std::size_t pictures = 0;
    forEachCase([&](const Case&, const Session& session) {
        const auto files = picturesOf(session);
        pictures += session.isMade() ? files.size() : 0;
        EXPECT_GE(files.size(), 3U);
        EXPECT_EQ(std::set<std::string>(files.begin(), files.end()).size(), files.size());
        for (const std::string& file : files) {
            EXPECT_EQ(file.find('/'), std::string::npos) << file;
        }
    });
    EXPECT_GE(pictures, 50U);
}

TEST(Cases, AreToldStepByStep) {
    forEachCase([](const Case&, const Session& session) {
        const auto steps = stepsOf(session.operations);
        EXPECT_GE(std::count_if(steps.begin(), steps.end(), [](const Step& s) { return !s.text.empty(); }),
                  2);
    });
}

TEST(Cases, CompareSegmentsThatTheirSessionsMake) {
    forEachCase([](const Case& one, const Session& session) {
        for (const TrueLabels& truth : one.compare) {
            EXPECT_TRUE(std::any_of(session.operations.begin(), session.operations.end(),
                                    [&](const Operation& operation) {
                                        const auto* use = std::get_if<UseSegment>(&operation);
                                        return use != nullptr &&
                                               (use->segment == truth.segment || use->name == truth.segment);
                                    }))
                << truth.segment;
        }
    });
}

TEST(Steps, CoverEveryOperationOnceInTheirOrder) {
    const std::vector<Operation> operations{SetView{}, Note{"(a) one"}, Undo{}, Redo{}, Note{"two"}, UnCut{}};
    const auto steps = stepsOf(operations);
    ASSERT_EQ(steps.size(), 3U);
    std::size_t next = 0;
    for (const Step& step : steps) {
        EXPECT_EQ(step.first, next);
        next += step.count;
    }
    EXPECT_EQ(next, operations.size());
    EXPECT_EQ(steps[0].text, "");
    EXPECT_EQ(steps[1].text, "(a) one");
    EXPECT_EQ(steps[2].count, 2U);
    EXPECT_TRUE(stepsOf({}).empty());
}

TEST(Drawn, IsWhatThePenDrew) {
    Laser laser;
    laser.mask = {Shape::Circle, {{100, 50}, {110, 50}}};
    laser.stroke = {{{10, 20}, 1, {}}, {{30, 40}, 0.5, {}}};
    const Drawn pen = drawnFor(laser);
    ASSERT_EQ(pen.areas.size(), 1U);
    EXPECT_EQ(pen.way, (Drawn::Line{{10, 20}, {30, 40}}));
    const Drawn::Line moved = pen.areaAt(pen.areas[0], {30, 40});
    for (const glm::dvec2 corner : moved) {
        EXPECT_NEAR(glm::distance(corner, glm::dvec2(30, 40)), 10, 0.1);
    }
    Seed seed;
    seed.widthPixels = 7;
    seed.strokes = {{Shape::FreeForm, {{1, 1}, {5, 5}}}, {Shape::Rectangle, {{0, 0}, {4, 4}}}};
    const Drawn seeds = drawnFor(seed);
    EXPECT_EQ(seeds.lines.size(), 1U);
    EXPECT_EQ(seeds.areas.size(), 1U);
    EXPECT_EQ(seeds.lineWidth, 7);
    EXPECT_TRUE(drawnFor(Undo{}).isEmpty());
}

TEST(FindFile, LooksWhereTheSessionSaysAndThenByName) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "find_file";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "scan.nrrd") << "x";
    const std::vector<std::filesystem::path> folders{folder};
    EXPECT_EQ(findFile(folder / "scan.nrrd", {}), folder / "scan.nrrd");
    EXPECT_EQ(findFile("scan.nrrd", folders), folder / "scan.nrrd");
    EXPECT_EQ(findFile("/not/there/scan.nrrd", folders), folder / "scan.nrrd");
    EXPECT_FALSE(findFile("other.nrrd", folders));
    EXPECT_FALSE(findFile("scan.nrrd", {}));
}

TEST(SessionFromText, SaysWhatIsNotJson) {
    EXPECT_THROW(sessionFromText("{", "mine.json"), SessionError);
    const Session session = sessionFromText(
        R"({"volumeStudioSession": 1, "volume": {"phantom": "skull", "noise": 2, "seed": 3}, "operations": []})",
        "mine.json");
    ASSERT_TRUE(session.phantom);
    EXPECT_EQ(session.phantom->kind, phantom::Kind::Skull);
    EXPECT_EQ(session.phantom->noisePercent, 2);
    const auto file = std::filesystem::path(testing::TempDir()) / "phantom_session.json";
    saveSession(file, session);
    EXPECT_EQ(loadSession(file).phantom, session.phantom);
    for (const char* wrong :
         {R"({"phantom": "foot"})", R"({"phantom": "head", "noise": -1})",
          R"({"phantom": "head", "colour": "red"})", R"({"phantom": "head", "dims": [1, 1, 1]})"}) {
        EXPECT_THROW(sessionFromText(std::string(R"({"volumeStudioSession": 1, "volume": )") + wrong +
                                         R"(, "operations": []})",
                                     "mine.json"),
                     SessionError)
            << wrong;
    }
}

} // namespace
} // namespace vs::studio
