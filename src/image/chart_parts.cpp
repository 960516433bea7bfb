// SPDX-License-Identifier: Apache-2.0
#include "image/chart_parts.h"

#include <algorithm>
#include <cmath>

namespace vs::image {

namespace {

// A text without its middle, as long as fits.
std::string shortened(const std::string& text, double size, bool isBold, double width) {
    if (textWidth(text, size, isBold) <= width) {
        return text;
    }
    for (std::size_t keep = text.size(); keep > 2; --keep) {
        std::size_t head = keep / 2;
        std::size_t tail = text.size() - (keep - head);
        // Never through a character of several bytes.
        while (head > 0 && (std::uint8_t(text[head]) & 0xC0U) == 0x80U) {
            --head;
        }
        while (tail < text.size() && (std::uint8_t(text[tail]) & 0xC0U) == 0x80U) {
            ++tail;
        }
        std::string tried = text.substr(0, head) + "…" + text.substr(tail);
        if (textWidth(tried, size, isBold) <= width) {
            return tried;
        }
    }
    return "";
}

} // namespace

double widest(const std::vector<Tick>& ticks, double size) {
    double width = 0;
    for (const auto& tick : ticks) {
        width = std::max(width, textWidth(tick.label, size));
    }
    return width;
}

std::vector<Tick> linearTicks(const Range& range, double pixels, double perTick) {
    std::vector<Tick> ticks;
    for (const double value : roundTicks(range, std::clamp(int(pixels / perTick), 2, 12))) {
        ticks.push_back({(value - range.lo) / range.width(), tickLabel(value)});
    }
    return ticks;
}

Text centredOn(const std::string& text, glm::dvec2 middle, double size, Align align) {
    return {text, {middle.x, middle.y + 0.5 * kCapHeight * size}, size, align};
}

void drawHeading(Drawing& drawing, const Layout& layout, const std::string& title, std::string note,
                 double right) {
    const double y = layout.margin() + kCapHeight * layout.titleSize;
    const double titleWidth = textWidth(title, layout.titleSize, true);
    const auto room = [&] {
        return right - layout.lo.x - textWidth(note, layout.tickSize) - layout.margin();
    };
    while (room() < titleWidth && note.rfind(", ") != std::string::npos) {
        note.erase(note.rfind(", "));
    }
    const std::string shown = shortened(title, layout.titleSize, true, room());
    drawing.text({shown, {layout.lo.x, y}, layout.titleSize, Align::Left, true}, kText);
    drawing.text({note, {right, y}, layout.tickSize, Align::Right}, kQuiet);
}

void drawAcross(Drawing& drawing, const Layout& layout, const std::vector<Tick>& ticks,
                const std::string& label) {
    const double hair = layout.hairline();
    drawing.fillBox({layout.lo.x - hair, layout.hi.y}, {layout.hi.x, layout.hi.y + hair}, kText);
    for (const auto& tick : ticks) {
        const double x = std::round(layout.at({tick.part, 0}).x - 0.5 * hair);
        drawing.fillBox({x, layout.hi.y}, {x + hair, layout.hi.y + 7 * layout.scale}, kText);
        drawing.text(
            {tick.label,
             {x + 0.5 * hair, layout.hi.y + layout.gap() + 3 * layout.scale + kCapHeight * layout.tickSize},
             layout.tickSize,
             Align::Centre},
            kText);
    }
    const double baseline =
        layout.hi.y + 2 * layout.gap() + 6 * layout.scale + kCapHeight * (layout.tickSize + layout.labelSize);
    drawing.text({label, {0.5 * (layout.lo.x + layout.hi.x), baseline}, layout.labelSize, Align::Centre},
                 kText);
}

void drawUp(Drawing& drawing, const Layout& layout, const std::vector<Tick>& ticks,
            const std::string& label) {
    const double hair = layout.hairline();
    drawing.fillBox({layout.lo.x - hair, layout.lo.y}, {layout.lo.x, layout.hi.y + hair}, kText);
    for (const auto& tick : ticks) {
        const double y = std::round(layout.at({0, tick.part}).y - 0.5 * hair);
        drawing.fillBox({layout.lo.x - 7 * layout.scale, y}, {layout.lo.x, y + hair}, kText);
        drawing.text(centredOn(tick.label, {layout.lo.x - layout.gap() - 3 * layout.scale, y + 0.5 * hair},
                               layout.tickSize, Align::Right),
                     kText);
    }
    Text upward{label,
                {layout.margin() + kCapHeight * layout.labelSize, 0.5 * (layout.lo.y + layout.hi.y)},
                layout.labelSize,
                Align::Centre};
    upward.axes = glm::dmat2(glm::dvec2(0, -1), glm::dvec2(1, 0));
    drawing.text(upward, kText);
}

void placePlot(Layout& layout, glm::ivec2 size, double upLabels, double extraRight, double extraTop) {
    const double tickRoom = layout.gap() + 3 * layout.scale;
    layout.lo = {layout.margin() + kCapHeight * layout.labelSize + 1.4 * layout.gap() + upLabels + tickRoom,
                 layout.margin() + kCapHeight * layout.titleSize + 1.6 * layout.gap() + extraTop};
    layout.hi = {size.x - layout.margin() - extraRight,
                 size.y - layout.margin() - 2 * layout.gap() - 9 * layout.scale -
                     kCapHeight * (layout.tickSize + layout.labelSize)};
    layout.lo = glm::round(layout.lo);
    layout.hi = glm::round(layout.hi);
}

Image paper(glm::ivec2 size) {
    Image image(size.x, size.y);
    std::fill(image.rgba.begin(), image.rgba.end(), std::uint8_t(255));
    return image;
}

Image onPaper(const Drawing& drawing, Image image) {
    blend(image, drawing.picture());
    return image;
}

std::optional<Range> partsOf(const std::optional<Range>& shaded, const Range& across) {
    if (!shaded || shaded->hi < across.lo || shaded->lo > across.hi) {
        return std::nullopt;
    }
    const auto part = [&](double value) {
        return std::clamp((value - across.lo) / across.width(), 0.0, 1.0);
    };
    return Range{part(shaded->lo), part(shaded->hi)};
}

void drawRangeLabel(Drawing& drawing, const Layout& layout, const Range& parts, const std::string& label) {
    const double half = 0.5 * textWidth(label, layout.tickSize);
    const double middle = layout.at({0.5 * (parts.lo + parts.hi), 1}).x;
    const double x = std::clamp(middle, std::min(layout.lo.x + half, layout.hi.x - half), layout.hi.x - half);
    drawing.text({label, {x, layout.lo.y - 0.7 * layout.gap()}, layout.tickSize, Align::Centre}, kBar);
}

} // namespace vs::image
