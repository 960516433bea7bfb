// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "phantom/phantom.h"
#include "studio/json/session.h"
#include "studio/operations/other_grid.h"
#include "volume/reading/read_volume.h"
#include "volume/reading/store_bricks.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace vs::studio {

namespace {

// Reads another volume than the session's. What the session says about choosing from its own helps where it
// fits, and is left out of `options` where it does not.
volume::ReadResult readInstead(const std::filesystem::path& path, volume::ReadOptions& options,
                               const volume::ReadOptions& overrides) {
    const bool tellsMore = options.series != overrides.series || options.frame != overrides.frame ||
                           options.level != overrides.level || options.channel != overrides.channel;
    if (tellsMore) {
        try {
            return volume::readVolume(path, options);
        } catch (const ReadError&) {
            // Whatever else is wrong is told below.
        }
    }
    options.series = overrides.series;
    options.frame = overrides.frame;
    options.level = overrides.level;
    options.channel = overrides.channel;
    auto result = volume::readVolume(path, options);
    if (tellsMore) {
        result.notices.push_back(
            fmt::format("{}: the session's series, frame, level or channel does not fit it and is left out",
                        path.string()));
    }
    return result;
}

volume::Volume blockOf(const Session::Block& block) {
    auto volume = phantom::makePhantom(
        block.dims, volume::ScalarType::UInt8, [](glm::dvec3) { return 1.0; }, block.spacingMm);
    volume.name = fmt::format("block of {} x {} x {}", block.dims.x, block.dims.y, block.dims.z);
    return volume;
}

// The volume of a session that has no file, if it is one.
std::optional<volume::ReadResult> madeVolume(const Session& session) {
    if (session.block) {
        return volume::ReadResult{blockOf(*session.block), {}};
    }
    if (session.phantom) {
        return volume::ReadResult{phantom::make(*session.phantom).volume, {}};
    }
    return {};
}

bool isTheOne(const Session& session, const volume::Volume& volume) {
    return session.volumeChecksum.empty() || volume::checksum(volume) == session.volumeChecksum;
}

volume::ReadOptions optionsFor(const Session& session, const volume::ReadOptions& overrides,
                               const std::filesystem::path& path, bool isReplacement) {
    volume::ReadOptions options = overrides;
    if (!options.raw && !session.rawLayout.empty() && (!isReplacement || volume::isHeaderless(path))) {
        options.raw = volume::parseRawLayout(session.rawLayout);
    }
    if (!options.series && !session.series.empty()) {
        options.series = session.series;
    }
    const auto takeIfNone = [](std::optional<int>& chosen, std::optional<int> said) {
        chosen = chosen ? chosen : said;
    };
    takeIfNone(options.frame, session.frame);
    takeIfNone(options.level, session.level);
    takeIfNone(options.channel, session.channel);
    return options;
}

// Also false where nobody may look, or a network is gone.
bool isThere(const std::filesystem::path& path) {
    std::error_code error;
    return volume::isWebAddress(path) || (std::filesystem::exists(path, error) && !error);
}

// What lies in a folder under the name of the session's volume, if it is that.
std::optional<volume::ReadResult> readIfTheOne(const Session& session, const std::filesystem::path& path,
                                               const volume::ReadOptions& options) {
    if (!isThere(path)) {
        return {};
    }
    try {
        auto result = volume::readVolume(path, options);
        return isTheOne(session, result.volume) ? std::optional(std::move(result)) : std::nullopt;
    } catch (const ReadError&) {
        return {}; // something else of that name
    }
}

volume::Volume findMoved(const Session& session, const std::filesystem::path& sessionPath,
                         const std::filesystem::path& wanted, const volume::ReadOptions& options,
                         std::vector<std::string>& notices,
                         const std::vector<std::filesystem::path>& folders) {
    const std::filesystem::path clean = wanted.lexically_normal();
    const auto name = clean.has_filename() ? clean.filename() : clean.parent_path().filename();
    std::vector<std::filesystem::path> places{sessionPath.parent_path()};
    if (!session.volumeChecksum.empty()) { // or anything might be taken for it
        places.insert(places.end(), folders.begin(), folders.end());
    }
    for (const std::filesystem::path& place : places) {
        if (auto found = readIfTheOne(session, place / name, options)) {
            notices.push_back(
                fmt::format("{} is not there any more; opened {}", wanted.string(), (place / name).string()));
            notices.insert(notices.end(), found->notices.begin(), found->notices.end());
            return std::move(found->volume);
        }
    }
    throw MovedVolume(fmt::format("{}: its volume {} is not there, and is not beside the session; say with "
                                  "--volume where it is",
                                  sessionPath.string(), wanted.string()),
                      wanted);
}

} // namespace

std::filesystem::path volumePathOf(const Session& session, const std::filesystem::path& sessionPath,
                                   const std::optional<std::filesystem::path>& replacement) {
    if (replacement) {
        return *replacement;
    }
    const bool isWhole = session.volumePath.is_absolute() || volume::isWebAddress(session.volumePath);
    return isWhole ? session.volumePath : sessionPath.parent_path() / session.volumePath;
}

bool goToLevel(Session& session, const std::filesystem::path& sessionPath,
               const std::optional<std::filesystem::path>& replacement, const volume::ReadOptions& used,
               bool growsFinest, std::vector<std::string>& notices) {
    const auto madeOn = std::size_t(session.level.value_or(0));
    const auto wanted = std::size_t(used.level.value_or(0));
    const std::filesystem::path path = volumePathOf(session, sessionPath, replacement);
    const auto forgetFinest = [&](const OtherGrid& sceneFromFinest) {
        for (Operation& operation : session.operations) {
            operation = withoutFinest(std::move(operation), sceneFromFinest);
        }
    };
    const bool isOther = madeOn != wanted;
    if (wanted == 0 && !isOther) {
        forgetFinest({});
    }
    const bool isAsItIs =
        !isOther && (growsFinest || wanted == 0 ||
                     std::none_of(session.operations.begin(), session.operations.end(), namesFinest));
    if (session.isMade() || !volume::hasLevels(path) || isAsItIs) {
        return false;
    }
    const volume::StoreBricks store(path, used);
    const auto& levels = store.levels();
    if (madeOn >= levels.size() || wanted >= levels.size()) {
        return false;
    }
    const OtherGrid sceneFromFinest = otherGrid(levels.front(), levels[wanted]);
    if (!isOther) {
        forgetFinest(sceneFromFinest);
        return false;
    }
    OtherGrid grid = otherGrid(levels[madeOn], levels[wanted]);
    grid.isFromFinest = madeOn == 0;
    grid.isToFinest = wanted == 0;
    grid.generations =
        growsFinest ? 1 : levels.front().stepMm() / levels[wanted].stepMm(); // it was made so, too
    for (Operation& operation : session.operations) {
        operation = onGrid(std::move(operation), grid);
    }
    if (!growsFinest) {
        forgetFinest(sceneFromFinest);
    }
    session.level = used.level;
    session.volumeChecksum.clear();
    session.stateChecksum.clear(); // the state is that of the other level
    notices.push_back(fmt::format(
        "{}: it was made on level {} and is replayed on level {}: places and depths are those of that "
        "level",
        sessionPath.string(), madeOn, wanted));
    return true;
}

volume::Volume openVolume(const Session& session, const std::filesystem::path& sessionPath,
                          const std::optional<std::filesystem::path>& replacement,
                          std::vector<std::string>& notices, const volume::ReadOptions& overrides,
                          const std::vector<std::filesystem::path>& folders, volume::ReadOptions* used) {
    const std::filesystem::path path = volumePathOf(session, sessionPath, replacement);
    volume::ReadOptions options = optionsFor(session, overrides, path, replacement.has_value());
    const auto tell = [&] {
        if (used != nullptr) {
            *used = options;
        }
    };
    tell();
    if (!replacement && !session.isMade() && !isThere(path)) {
        return findMoved(session, sessionPath, path, options, notices, folders);
    }
    auto result = [&] {
        if (replacement) {
            auto read = readInstead(path, options, overrides);
            tell();
            return read;
        }
        auto made = madeVolume(session);
        return made ? std::move(*made) : volume::readVolume(path, options);
    }();
    notices.insert(notices.end(), result.notices.begin(), result.notices.end());
    if (!isTheOne(session, result.volume)) {
        if (!replacement && !overrides.raw && !overrides.series && !overrides.frame && !overrides.level &&
            !overrides.channel) {
            throw SessionError(
                "{}: its volume {} is not the one the session was made with (checksum {}, not {}); give "
                "the right file with --volume",
                sessionPath.string(), path.string(), volume::checksum(result.volume), session.volumeChecksum);
        }
        const bool isOtherLevel =
            !replacement && options.level.value_or(0) != session.level.value_or(0); // goToLevel() tells
        if (!isOtherLevel) {
            notices.push_back(
                fmt::format("{} is not the volume that {} was made with; the result will differ",
                            path.string(), sessionPath.string()));
        }
    }
    return std::move(result.volume);
}

} // namespace vs::studio
