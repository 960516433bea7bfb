// SPDX-License-Identifier: Apache-2.0
#include "studio/cases/cases.h"

#include "base/described_json.h"
#include "base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace vs::studio {

namespace {

constexpr std::string_view kIndex = "index";

std::string_view textNamed(std::string_view name) {
    const auto texts = embeddedCases();
    const auto found =
        std::find_if(texts.begin(), texts.end(), [&](const EmbeddedText& text) { return text.name == name; });
    if (found == texts.end()) {
        throw SessionError("examples/experiments/{}.json is not among the files compiled in", name);
    }
    return found->text;
}

CaseIndex readIndex() {
    const Json json = Json::parse(textNamed(kIndex));
    CaseIndex index;
    read(JsonReader(json, "examples/experiments/index.json"), index, Rule());
    return index;
}

} // namespace

const CaseIndex& caseIndex() {
    static const CaseIndex index = readIndex();
    return index;
}

Session sessionOf(const Case& which) {
    return sessionFromText(textNamed(which.session), which.session + ".json");
}

const CaseScan* scanOf(const Session& session) {
    const auto& scans = caseIndex().scans;
    const auto found = std::find_if(scans.begin(), scans.end(), [&](const CaseScan& scan) {
        return scan.file == session.volumePath.filename();
    });
    return session.isMade() || found == scans.end() ? nullptr : &*found;
}

std::optional<std::filesystem::path> findFile(const std::filesystem::path& named,
                                              std::span<const std::filesystem::path> folders) {
    std::error_code ignored;
    if (named.is_absolute() && std::filesystem::exists(named, ignored)) {
        return named;
    }
    for (const std::filesystem::path& folder : folders) {
        if (std::filesystem::exists(folder / named.filename(), ignored)) {
            return folder / named.filename();
        }
    }
    return {};
}

} // namespace vs::studio
