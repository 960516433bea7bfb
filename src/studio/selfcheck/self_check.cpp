// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/self_check.h"

#include "base/timer.h"
#include "studio/selfcheck/checks.h"

#include <exception>
#include <regex>

namespace vs::studio {

namespace {

constexpr StageCheck kStageChecks[] = {
    {"upload and read-back", checkUpload},
    {"order of work", checkOrder},
    {"sampling between voxels", checkSampling},
    {"intensity histogram", checkHistograms},
    {"gradient magnitudes", checkGradients},
    {"ranges of macrocells", checkCellRanges},
    {"distances of macrocells", checkDistances},
    {"smoothed values", checkSmoothing},
    {"transfer function tables", checkTables},
    {"point radiation", checkRadiation},
    {"drill and undo", checkDrill},
    {"peel", checkPeel},
    {"clip and outline cut", checkSolids},
    {"islands and solids", checkIslands},
    {"growth", checkGrowth},
    {"seeds on surfaces", checkSeeds},
    {"memberships of segments", checkMembership},
    {"surfaces", checkSurfaces},
    {"faces of cuts", checkCutFaces},
    {"surfaces of segments", checkSegmentSurfaces},
    {"brightest places", checkBrightest},
    {"MIP pictures", checkMaximum},
    {"X-ray pictures", checkXRay},
    {"volume pictures", checkCompositing},
    {"skipping of empty space", checkSkipping},
    {"pasted parts", checkParts},
    {"light", checkLight},
    {"slices", checkSlices},
    {"bricks", checkBricks},
    {"marks", checkMarks},
    {"fill", checkFill},
};

} // namespace

std::span<const StageCheck> stageChecks() { return kStageChecks; }

std::string withoutPaths(const std::string& message) {
    static const std::regex absolute(R"((^|[\s"'(=:])/[^\s:,;'")]+)");
    static const std::regex relative(R"([\w.+~@-]*(?:/[\w.+~@-]*)*/([\w+~@-]+)(?:\.[\w.]*\w)?)");
    std::string line = std::regex_replace(message, absolute, "$1a path");
    line = std::regex_replace(line, relative, "$1");
    for (char& c : line) {
        c = c == '\n' || c == '\r' ? ' ' : c;
    }
    return line;
}

StageResult runCheck(const StageCheck& check, const gl::Context& context) {
    StageResult result;
    result.name = check.name;
    const int errorsBefore = context.errorCount();
    const Timer timer;
    try {
        check.run(result.tally);
        gl::Context::finish();
    } catch (const std::exception& fault) {
        result.failure = withoutPaths(fault.what());
    }
    result.milliseconds = timer.milliseconds();
    result.errors = context.errorCount() - errorsBefore;
    return result;
}

} // namespace vs::studio
