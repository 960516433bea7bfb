// SPDX-License-Identifier: Apache-2.0
#include "render/marks/background.h"

#include "base/error.h"
#include "render/colours/colour.h"

#include <charconv>
#include <optional>

namespace vs::render {

namespace {

constexpr Background kWhite{glm::vec3(1), glm::vec3(1), false};
constexpr Background kBlack{glm::vec3(0), glm::vec3(0), false};
constexpr Background kTransparent{glm::vec3(0), glm::vec3(0), true};

// "#RRGGBB"
std::optional<glm::vec3> colourFrom(std::string_view text) {
    if (text.size() != 7 || text.front() != '#') {
        return std::nullopt;
    }
    unsigned value = 0;
    const auto result = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
    if (result.ec != std::errc() || result.ptr != text.data() + 7) {
        return std::nullopt;
    }
    return glm::vec3(float(value >> 16), float(value >> 8 & 255U), float(value & 255U)) / 255.0F;
}

std::string hex(glm::vec3 colour) {
    const glm::ivec3 bytes(glm::round(glm::clamp(colour, 0.0F, 1.0F) * 255.0F));
    return fmt::format("#{:02X}{:02X}{:02X}", bytes.x, bytes.y, bytes.z);
}

} // namespace

glm::vec3 linearTop(const Background& background) { return linearFromDisplay(background.top); }
glm::vec3 linearBottom(const Background& background) { return linearFromDisplay(background.bottom); }

Background forInverted(const Background& background) {
    return background == Background{} ? complement(background) : background;
}

Background complement(const Background& background) {
    return background.isTransparent ? background
                                    : Background{1.0F - background.top, 1.0F - background.bottom, false};
}

std::string name(const Background& background) {
    if (background.isTransparent) {
        return "transparent";
    }
    if (background == Background{}) {
        return "studio";
    }
    if (background == kWhite || background == kBlack) {
        return background == kWhite ? "white" : "black";
    }
    const std::string top = hex(background.top);
    const std::string bottom = hex(background.bottom);
    return top == bottom ? top : top + ":" + bottom;
}

Background backgroundFromName(const std::string& name) {
    if (name == "studio") {
        return {};
    }
    if (name == "white") {
        return kWhite;
    }
    if (name == "black") {
        return kBlack;
    }
    if (name == "transparent") {
        return kTransparent;
    }
    const std::string_view text = name;
    const std::size_t colon = std::min(text.find(':'), text.size());
    const auto top = colourFrom(text.substr(0, colon));
    const auto bottom = colon < text.size() ? colourFrom(text.substr(colon + 1)) : top;
    if (!top || !bottom) {
        throw UsageError("background '{}' is not known; use studio, white, black, transparent, #RRGGBB or "
                         "#RRGGBB:#RRGGBB (top and bottom)",
                         name);
    }
    return {*top, *bottom, false};
}

} // namespace vs::render
