// SPDX-License-Identifier: Apache-2.0
#include "studio/exports/store_export.h"

#include "base/error.h"
#include "base/progress.h"
#include "volume/grid/known_ranges.h"
#include "volume/store/write_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>

namespace vs::studio {

namespace {

// What is written is gone on with by nobody: it may be cut further before the same is asked for again.
std::string onceOnly() {
    return fmt::format("made at {}", std::chrono::system_clock::now().time_since_epoch().count());
}

std::string described(const std::filesystem::path& path, const volume::GridGeometry& grid,
                      const std::string& what) {
    return fmt::format("{}: {} x {} x {} {}", path.string(), grid.dims.x, grid.dims.y, grid.dims.z, what);
}

} // namespace

std::string writeSculptedStore(const std::filesystem::path& path, const ExportSource& source,
                               const std::optional<double>& fill) {
    const double filled = fill.value_or(source.volume->range.lo);
    const auto said = [&](const volume::GridGeometry& grid, volume::ScalarType type) {
        return described(path, grid, fmt::format("{} values, cut ones {:g}", volume::name(type), filled));
    };
    if (!source.finest) {
        const volume::Volume left = sculptedVolume(source, fill);
        volume::StoreSource store = volume::sourceOf(left);
        store.identity = onceOnly();
        volume::writeStore(path, store);
        return said(left.geometry, left.type);
    }
    const ExportSource::Finest& finest = *source.finest;
    volume::StoreSource store;
    store.facts = {finest.geometry, source.volume->unit, source.volume->name};
    store.type = finest.levels->type();
    store.identity = onceOnly();
    store.read = [&](const Box3& box) {
        auto values = finest.levels->read(0, box);
        if (source.view != field::SculptureView::Whole) {
            takeCutAway(values, finest.levels->type(), finest.cut(box), source.view, filled);
        }
        return values;
    };
    const volume::KnownRanges known(*finest.levels, 0);
    store.isZero = [&](const Box3& box) {
        const bool isFilled = source.view != field::SculptureView::Whole && filled != 0;
        const bool staysAsItIs =
            !isFilled || (source.view == field::SculptureView::Cut && finest.isUncut(box));
        const auto range = known.in(box);
        return staysAsItIs && range && range->lo == 0 && range->hi == 0;
    };
    volume::writeStore(path, store);
    return said(finest.geometry, store.type);
}

std::string writeLabelStore(const std::filesystem::path& path, const ExportSource& source) {
    const bool isSmall = std::all_of(source.segments.begin(), source.segments.end(), [](const auto& segment) {
        return std::in_range<std::uint8_t>(segment.value);
    });
    std::array<std::uint32_t, 256> values{};
    volume::StoreSource store;
    for (const ExportedSegment& segment : source.segments) {
        if (!std::in_range<std::uint32_t>(segment.value)) {
            throw WriteError("{}: label {} is too large for a store; 4294967295 is the most", path.string(),
                             segment.value);
        }
        values[segment.label] = std::uint32_t(segment.value);
        const glm::u8vec3 colour(glm::round(segment.colour * 255.0));
        store.facts.labels.push_back(
            {segment.value,
             segment.name,
             {colour.x, colour.y, colour.z, std::uint8_t(std::round(segment.opacity * 255))}});
    }
    if (source.finestLabels) {
        store.isZero = source.finestLabels->isEmpty;
    }
    store.facts.geometry = source.finestLabels ? source.finestLabels->geometry : source.geometry;
    store.facts.name = path.stem().string();
    store.type = isSmall ? volume::ScalarType::UInt8 : volume::ScalarType::UInt32;
    store.identity = onceOnly();
    store.read = [&](const Box3& box) {
        const std::size_t bytes = volume::sizeOf(store.type);
        std::vector<std::byte> written(box.volume() * bytes);
        const auto write = [&](std::size_t n, std::uint8_t label) { // little-endian, as every device here
            std::memcpy(&written[n * bytes], &values[label], bytes);
        };
        if (source.finestLabels) {
            const auto labels = source.finestLabels->labels(box);
            for (std::size_t n = 0; n < labels.size(); ++n) {
                write(n, labels[n]);
            }
            return written;
        }
        const glm::ivec3 dims = source.geometry.dims;
        forEachVoxel(box, [&](glm::ivec3 v, std::size_t n) {
            write(n, source.labels[(std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) *
                                       std::size_t(dims.x) +
                                   std::size_t(v.x)]);
        });
        return written;
    };
    volume::StoreLayout layout;
    layout.reducing = volume::Reducing::Commonest;
    volume::writeStore(path, store, layout);
    return fmt::format("{}: {} labels", path.string(), source.segments.size());
}

} // namespace vs::studio
