// SPDX-License-Identifier: Apache-2.0
// What there is to say of operations besides their names.
#include "studio/operations/operation.h"

#include <fmt/format.h>

namespace vs::studio {

namespace {

constexpr const char* kRestore = VS_TEXT("library", "restore");

template <typename Cut>
std::vector<Phrase> withRestore(const Cut& cut, std::vector<Phrase> said = {}) {
    if (cut.restores) {
        said.push_back({kRestore});
    }
    return said;
}

Phrase inQuotes(const std::string& segment) { return {VS_TEXT("library", "“%1”"), {segment}}; }

Phrase generationsSaid(int count) {
    return count == 1 ? Phrase{VS_TEXT("library", "one generation")}
                      : Phrase{VS_TEXT("library", "%1 generations"), {std::to_string(count)}};
}

Phrase oneOrAll(const std::optional<std::string>& segment) {
    return segment ? inQuotes(*segment) : say(VS_TEXT("library", "all"));
}

} // namespace

std::vector<Phrase> Peel::details() const {
    return withRestore(*this, {{VS_TEXT("library", "%1 layers"), {fmt::format("{:.3g}", layers)}}});
}

std::vector<Phrase> Drill::details() const { return withRestore(*this); }
std::vector<Phrase> Laser::details() const { return withRestore(*this); }
std::vector<Phrase> Sweep::details() const { return withRestore(*this); }
std::vector<Phrase> Clip::details() const { return withRestore(*this); }

std::vector<Phrase> SetMaterial::details() const {
    return {name ? inQuotes(*name) : say(VS_TEXT("library", "number %1"), number)};
}

namespace {
template <typename Stroke>
Phrase strokeSaid(const Stroke& stroke) {
    return std::visit([](const auto& op) { return Phrase{std::decay_t<decltype(op)>::kAbout.name}; }, stroke);
}
} // namespace

std::vector<Phrase> Fill::details() const {
    return {strokeSaid(stroke), say(VS_TEXT("library", "material %1"), material)};
}
std::vector<Phrase> FillHole::details() const { return {say(VS_TEXT("library", "material %1"), material)}; }
std::vector<Phrase> SegmentFill::details() const {
    return {say(VS_TEXT("library", "material %1"), material)};
}
std::vector<Phrase> Unfill::details() const { return {strokeSaid(stroke)}; }

std::vector<Phrase> Mark::details() const {
    std::vector<Phrase> said;
    if (erases) {
        said.push_back({VS_TEXT("library", "erase")});
    }
    if (kind == Kind::Text) {
        said.push_back(inQuotes(text));
    } else if (kind == Kind::Area) {
        said.push_back({VS_TEXT("library", "area")});
    } else {
        said.push_back({VS_TEXT("library", "%1 mm wide"), {fmt::format("{:.3g}", widthMm)}});
    }
    return said;
}

std::vector<Phrase> Scissors::details() const {
    return withRestore(*this, {{cutsOutside ? VS_TEXT("library", "outside") : VS_TEXT("library", "inside")}});
}

std::vector<Phrase> MovePart::details() const {
    return {{VS_TEXT("library", "part %1"), {std::to_string(part + 1)}}};
}

std::vector<Phrase> ChangePart::details() const {
    return {name ? inQuotes(*name) : Phrase{VS_TEXT("library", "part %1"), {std::to_string(part + 1)}}};
}

std::vector<Phrase> DiscardPart::details() const {
    return {{VS_TEXT("library", "part %1"), {std::to_string(part + 1)}}};
}

std::vector<Phrase> Grow::details() const {
    return {generations ? generationsSaid(*generations) : Phrase{VS_TEXT("library", "to the end")}};
}

std::vector<Phrase> Rewind::details() const { return {generationsSaid(generations)}; }

std::vector<Phrase> ShowGeneration::details() const { return {{"%1", {std::to_string(generation)}}}; }

std::vector<Phrase> UseSegment::details() const { return {inQuotes(name.value_or(segment))}; }

std::vector<Phrase> RemoveSegment::details() const { return {inQuotes(segment)}; }
std::vector<Phrase> PullOut::details() const { return {oneOrAll(segment)}; }
std::vector<Phrase> PutBack::details() const { return {oneOrAll(segment)}; }
std::vector<Phrase> ShowSegments::details() const { return {oneOrAll(only)}; }

std::vector<Phrase> EditSegment::details() const { return {{nameOf(kind)}}; }

std::vector<Phrase> Measure::details() const { return {{nameOf(kind)}}; }

std::vector<Phrase> RemoveMeasurement::details() const {
    return {measurement ? say("%1", *measurement + 1) : say(VS_TEXT("library", "all"))};
}

std::vector<Phrase> BrushSegment::details() const {
    return {{isToAdd ? VS_TEXT("library", "add") : VS_TEXT("library", "remove")}};
}

std::vector<Phrase> CutSegment::details() const {
    return {{keeps ? VS_TEXT("library", "all but it") : VS_TEXT("library", "away")}};
}

} // namespace vs::studio
