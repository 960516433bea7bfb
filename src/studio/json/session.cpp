// SPDX-License-Identifier: Apache-2.0
#include "studio/json/session.h"

#include "base/atomic_file.h"
#include "base/described_json.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/json_file.h"
#include "base/json_reader.h"
#include "phantom/phantom.h"
#include "studio/json/operation_json.h"
#include "studio/json/session_json.h"
#include "studio/operations/segment_list.h"
#include "volume/reading/read_volume.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>
#include <utility>

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

void checkMade(const JsonReader& dims, const glm::ivec3& made) {
    const std::int64_t voxels = std::int64_t(made.x) * made.y * made.z;
    if (voxels > Session::kMostMadeVoxels) {
        dims.fail(fmt::format("makes {} voxels; a session makes at most {} (512 x 512 x 512)", voxels,
                              Session::kMostMadeVoxels));
    }
}

Session::Block readBlock(const JsonReader& reader) {
    Session::Block block;
    const JsonReader dims = reader.member("block");
    dims.expectSize(3);
    for (int axis = 0; axis < 3; ++axis) {
        block.dims[axis] = int(dims.at(std::size_t(axis)).integerBetween(1, Session::Block::kMostVoxels));
    }
    checkMade(dims, block.dims);
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
std::filesystem::path storedPath(const std::filesystem::path& scan, const std::filesystem::path& session) {
    if (volume::isWebAddress(scan)) {
        return scan;
    }
    const auto absolute = std::filesystem::absolute(scan).lexically_normal();
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
        reader.ifHas("dims", [&](const JsonReader& r) { checkMade(r, *session.phantom->dims); });
        reader.ifHas("checksum", [&](const JsonReader& r) { session.volumeChecksum = r.text(); });
        return;
    }
    reader.allow({"path", "checksum", "raw", "series", "frame", "level", "channel"});
    session.volumePath = reader.member("path").fileName();
    reader.ifHas("checksum", [&](const JsonReader& r) { session.volumeChecksum = r.text(); });
    reader.ifHas("raw", [&](const JsonReader& r) {
        checkRawLayout(r);
        session.rawLayout = r.text();
    });
    reader.ifHas("series", [&](const JsonReader& r) { session.series = r.text(); });
    const auto readCount = [&](const char* key, std::optional<int>& count) {
        reader.ifHas(key, [&](const JsonReader& r) { count = int(r.integerBetween(0, 1 << 20)); });
    };
    readCount("frame", session.frame);
    readCount("level", session.level);
    readCount("channel", session.channel);
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
    const auto addCount = [&volume](const char* key, std::optional<int> count) {
        if (count) {
            volume[key] = *count;
        }
    };
    addCount("frame", session.frame);
    addCount("level", session.level);
    addCount("channel", session.channel);
    return volume;
}

namespace {

std::string checksumOf(const Json& operations) {
    Hash64 hash;
    for (const Json& operation : operations) {
        const std::string text = operation.dump() + "\n";
        hash.add(std::as_bytes(std::span(text)));
    }
    return hash.text();
}

Session sessionFromJson(const Json& json, const std::filesystem::path& path) {
    const JsonReader root(json, path.string());
    root.allow({"volumeStudioSession", "volume", "precision", "state", "operations"});
    const long version = root.member("volumeStudioSession").integerBetween(1, 1 << 20);
    if (version > Session::kVersion) {
        throw SessionError(
            "{}: made by a newer Volume Studio (session version {}, this program knows {}); update it",
            path.string(), version, Session::kVersion);
    }
    Session session;
    session.version = int(version);
    readVolume(root.member("volume"), session);
    root.ifHas("precision", [&](const JsonReader& r) { session.precision = readPrecision(r); });
    root.ifHas("state", [&](const JsonReader& r) { session.stateChecksum = r.text(); });
    const JsonReader operations = root.member("operations");
    session.operationsChecksum = checksumOf(operations.json());
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

// As they stand in a file at `path`.
Json operationsOf(const std::filesystem::path& path, const Session& session) {
    Json list = Json::array();
    for (Operation operation : session.operations) {
        if (auto* labels = std::get_if<LoadLabels>(&operation)) {
            labels->path = storedPath(labels->path, path);
        }
        list.push_back(toJson(operation));
    }
    return list;
}

std::string textOf(const std::filesystem::path& path, const Session& session) {
    const Json volume = volumeToJson(session, session.isMade() ? std::filesystem::path()
                                                               : storedPath(session.volumePath, path));
    const std::string state =
        session.stateChecksum.empty() ? "" : fmt::format("\n  \"state\": \"{}\",", session.stateChecksum);
    // One operation a line: sessions are read and compared by people too.
    std::string text = fmt::format(
        "{{\n  \"volumeStudioSession\": {},\n  \"volume\": {},\n  \"precision\": {},{}\n  "
        "\"operations\": [",
        Session::kVersion, volume.dump(), sculpt::kPrecisions[std::size_t(session.precision)], state);
    const char* separator = "";
    for (const Json& operation : operationsOf(path, session)) {
        text += fmt::format("{}\n    {}", std::exchange(separator, ","), operation.dump());
    }
    return text + "\n  ]\n}\n";
}

WriteError notUtf8(const std::filesystem::path& path, const Session& session) {
    return WriteError("{}: cannot be saved: a session is UTF-8 text, and the name of the volume {} or of a "
                      "file that the session writes is not; rename it",
                      path.string(), session.volumePath.string());
}

} // namespace

std::string operationsChecksum(const std::filesystem::path& path, const Session& session) {
    try {
        return checksumOf(operationsOf(path, session));
    } catch (const Json::exception&) {
        throw notUtf8(path, session);
    }
}

void saveSession(const std::filesystem::path& path, const Session& session) {
    std::string text;
    try {
        text = textOf(path, session);
    } catch (const Json::exception&) {
        throw notUtf8(path, session);
    }
    writeFileAtomically(path, text);
}

Session sessionOf(const Document& document, const Session& source) {
    Session session = source;
    session.stateChecksum.clear();
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

} // namespace vs::studio
