// SPDX-License-Identifier: Apache-2.0
#include "studio/json/session.h"

#include "base/atomic_file.h"
#include "base/described_json.h"
#include "base/error.h"
#include "base/json_file.h"
#include "base/json_reader.h"
#include "phantom/phantom.h"
#include "studio/json/operation_json.h"
#include "studio/json/session_json.h"
#include "studio/operations/segment_list.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace vs::studio {

using Json = nlohmann::ordered_json;

namespace {

void checkRawLayout(const JsonReader& reader) {
    try {
        volume::parseRawLayout(reader.text());
    } catch (const UsageError& error) {
        reader.fail(error.what());
    }
}

Session::Block readBlock(const JsonReader& reader) {
    Session::Block block;
    const JsonReader dims = reader.member("block");
    dims.expectSize(3);
    for (int axis = 0; axis < 3; ++axis) {
        block.dims[axis] = int(dims.at(std::size_t(axis)).integerBetween(1, Session::Block::kMostVoxels));
    }
    reader.ifHas("spacing", [&](const JsonReader& r) {
        r.expectSize(3);
        for (int axis = 0; axis < 3; ++axis) {
            block.spacingMm[axis] =
                r.at(std::size_t(axis))
                    .numberBetween(Session::Block::kSpacingMm.lo, Session::Block::kSpacingMm.hi);
        }
    });
    return block;
}

// Relative when the volume lies in or below the session's folder, so that the two can move together.
std::filesystem::path storedPath(const std::filesystem::path& volume, const std::filesystem::path& session) {
    const auto absolute = std::filesystem::absolute(volume).lexically_normal();
    const auto folder = std::filesystem::absolute(session).lexically_normal().parent_path();
    const auto relative = absolute.lexically_relative(folder);
    return relative.empty() || *relative.begin() == ".." ? absolute : relative;
}

// A session that speaks of the first segment counts on its being there, whatever others are named before.
void keepFirstSegment(std::vector<Operation>& operations) {
    if (std::none_of(operations.begin(), operations.end(),
                     [](const Operation& operation) { return speaksOf(operation, kFirstSegment); })) {
        return;
    }
    for (Operation& operation : operations) {
        if (auto* use = std::get_if<UseSegment>(&operation); use != nullptr && !use->takesFirst) {
            use->takesFirst = false;
        }
    }
}

} // namespace

void readVolume(const JsonReader& reader, Session& session) {
    if (reader.has("block")) {
        reader.allow({"block", "spacing", "checksum"});
        session.block = readBlock(reader);
        reader.ifHas("checksum", [&](const JsonReader& r) { session.volumeChecksum = r.text(); });
        return;
    }
    if (reader.has("phantom")) {
        auto names = namesOfFields<phantom::Recipe>([](const auto&) { return true; });
        names.push_back("checksum");
        reader.allow(names);
        session.phantom.emplace();
        readFields(reader, *session.phantom, phantom::Recipe::fields(), Rule());
        reader.ifHas("checksum", [&](const JsonReader& r) { session.volumeChecksum = r.text(); });
        return;
    }
    reader.allow({"path", "checksum", "raw", "series", "frame"});
    session.volumePath = reader.member("path").fileName();
    reader.ifHas("checksum", [&](const JsonReader& r) { session.volumeChecksum = r.text(); });
    reader.ifHas("raw", [&](const JsonReader& r) {
        checkRawLayout(r);
        session.rawLayout = r.text();
    });
    reader.ifHas("series", [&](const JsonReader& r) { session.series = r.text(); });
    reader.ifHas("frame", [&](const JsonReader& r) { session.frame = int(r.integerBetween(0, 1 << 20)); });
}

sculpt::Precision readPrecision(const JsonReader& reader) {
    const long bits = reader.integerBetween(8, 32);
    if (bits != 8 && bits != 16 && bits != 32) {
        reader.fail("must be 8, 16 or 32 bits");
    }
    return sculpt::Precision(bits == 8 ? 0 : bits == 16 ? 1 : 2);
}

Json volumeToJson(const Session& session, const std::filesystem::path& path) {
    Json volume;
    if (session.block) {
        const auto list = [](const auto& v) { return Json::array({v.x, v.y, v.z}); };
        volume = {{"block", list(session.block->dims)}, {"spacing", list(session.block->spacingMm)}};
    } else if (session.phantom) {
        volume = write(*session.phantom, Rule());
    } else {
        volume = {{"path", path.string()}};
    }
    const auto addText = [&volume](const char* key, const std::string& value) {
        if (!value.empty()) {
            volume[key] = value;
        }
    };
    addText("checksum", session.volumeChecksum);
    addText("raw", session.rawLayout);
    addText("series", session.series);
    if (session.frame) {
        volume["frame"] = *session.frame;
    }
    return volume;
}

namespace {

Session sessionFromJson(const Json& json, const std::filesystem::path& path) {
    const JsonReader root(json, path.string());
    root.allow({"volumeStudioSession", "volume", "precision", "operations"});
    const long version = root.member("volumeStudioSession").integerBetween(1, 1 << 20);
    if (version > Session::kVersion) {
        throw SessionError(
            "{}: made by a newer Volume Studio (session version {}, this program knows {}); update it",
            path.string(), version, Session::kVersion);
    }
    Session session;
    readVolume(root.member("volume"), session);
    root.ifHas("precision", [&](const JsonReader& r) { session.precision = readPrecision(r); });
    const JsonReader operations = root.member("operations");
    for (std::size_t i = 0; i < operations.size(); ++i) {
        session.operations.push_back(operationFromJson(
            json.at("operations").at(i), fmt::format("{}: operation {}", path.string(), i + 1)));
        if (auto* labels = std::get_if<LoadLabels>(&session.operations.back())) {
            labels->path = path.parent_path() / labels->path; // an absolute one stays
        }
    }
    keepFirstSegment(session.operations);
    return session;
}

} // namespace

Session loadSession(const std::filesystem::path& path) {
    return sessionFromJson(readJsonFile(path, "a session file", "doc/session.md"), path);
}

Session sessionFromText(std::string_view text, const std::filesystem::path& path) {
    try {
        return sessionFromJson(Json::parse(text), path);
    } catch (const Json::parse_error& error) {
        throw SessionError("{}: is not JSON ({}); see doc/session.md", path.string(), error.what());
    }
}

namespace {

std::string textOf(const std::filesystem::path& path, const Session& session) {
    const Json volume = volumeToJson(session, session.isMade() ? std::filesystem::path()
                                                               : storedPath(session.volumePath, path));
    // One operation a line: sessions are read and compared by people too.
    std::string text = fmt::format(
        "{{\n  \"volumeStudioSession\": {},\n  \"volume\": {},\n  \"precision\": {},\n  \"operations\": [",
        Session::kVersion, volume.dump(), sculpt::kPrecisions[std::size_t(session.precision)]);
    for (std::size_t i = 0; i < session.operations.size(); ++i) {
        Operation operation = session.operations[i];
        if (auto* labels = std::get_if<LoadLabels>(&operation)) {
            labels->path = storedPath(labels->path, path);
        }
        text += fmt::format("{}\n    {}", i == 0 ? "" : ",", toJson(operation).dump());
    }
    return text + "\n  ]\n}\n";
}

} // namespace

void saveSession(const std::filesystem::path& path, const Session& session) {
    std::string text;
    try {
        text = textOf(path, session);
    } catch (const Json::exception&) {
        throw WriteError(
            "{}: cannot be saved: a session is UTF-8 text, and the name of the volume {} or of a "
            "file that the session writes is not; rename it",
            path.string(), session.volumePath.string());
    }
    writeFileAtomically(path, text);
}

Session sessionOf(const Document& document, const Session& source) {
    Session session = source;
    if (source.volumePath.empty() && !source.isMade()) {
        const volume::GridGeometry& geometry = document.geometryInFile();
        session.block = Session::Block{geometry.dims, geometry.spacing()};
    }
    session.volumeChecksum = volume::checksum(document.volume());
    session.precision = document.sculpture().precision();
    session.operations = document.log();
    const View& view = document.view();
    session.operations.emplace_back(setViewTo(view));
    return session;
}

namespace {

// Reads another volume than the session's. What the session says about choosing from its own helps where it
// fits, and is left out of `options` where it does not.
volume::ReadResult readInstead(const std::filesystem::path& path, volume::ReadOptions& options,
                               const volume::ReadOptions& overrides) {
    const bool tellsMore = options.series != overrides.series || options.frame != overrides.frame;
    if (tellsMore) {
        try {
            return volume::readVolume(path, options);
        } catch (const ReadError&) {
            // Whatever else is wrong is told below.
        }
    }
    options.series = overrides.series;
    options.frame = overrides.frame;
    auto result = volume::readVolume(path, options);
    if (tellsMore) {
        result.notices.push_back(
            fmt::format("{}: the session's series or frame does not fit it and is left out", path.string()));
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
    if (!options.frame) {
        options.frame = session.frame;
    }
    return options;
}

// Also false where nobody may look, or a network is gone.
bool isThere(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::exists(path, error) && !error;
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

volume::Volume openVolume(const Session& session, const std::filesystem::path& sessionPath,
                          const std::optional<std::filesystem::path>& replacement,
                          std::vector<std::string>& notices, const volume::ReadOptions& overrides,
                          const std::vector<std::filesystem::path>& folders, volume::ReadOptions* used) {
    const std::filesystem::path path =
        replacement ? *replacement
                    : (session.volumePath.is_absolute() ? session.volumePath
                                                        : sessionPath.parent_path() / session.volumePath);
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
        if (!replacement && !overrides.raw && !overrides.series && !overrides.frame) {
            throw SessionError(
                "{}: its volume {} is not the one the session was made with (checksum {}, not {}); give "
                "the right file with --volume",
                sessionPath.string(), path.string(), volume::checksum(result.volume), session.volumeChecksum);
        }
        notices.push_back(fmt::format("{} is not the volume that {} was made with; the result will differ",
                                      path.string(), sessionPath.string()));
    }
    return std::move(result.volume);
}

} // namespace vs::studio
