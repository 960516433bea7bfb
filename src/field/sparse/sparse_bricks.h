// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace vs::field {

// Bricks of a grid that exist only where there is something, by their places in it. Once made they stay as
// they are: edits make others, which share the bricks that they leave alone, so that undo holds what has
// changed and no more. A brick says isEmpty() where it might as well not be there.
template <typename B>
class SparseBricks {
public:
    using Brick = std::shared_ptr<const B>;
    using Entry = std::pair<std::uint32_t, Brick>;

    SparseBricks() = default;
    // In the order of their places, none of them null or empty.
    explicit SparseBricks(std::vector<Entry> entries) : entries_(std::move(entries)) {}

    [[nodiscard]] bool isEmpty() const { return entries_.empty(); }
    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
    // Null: nothing is there.
    [[nodiscard]] Brick at(std::uint32_t place) const {
        const auto found =
            std::lower_bound(entries_.begin(), entries_.end(), place,
                             [](const Entry& entry, std::uint32_t p) { return entry.first < p; });
        return found != entries_.end() && found->first == place ? found->second : nullptr;
    }
    // These with other bricks in the places named (in order; null or empty ones are taken away).
    [[nodiscard]] SparseBricks with(std::vector<Entry> changed) const {
        std::vector<Entry> all;
        all.reserve(entries_.size() + changed.size());
        auto old = entries_.begin();
        for (Entry& entry : changed) {
            const auto next = std::lower_bound(old, entries_.end(), entry.first,
                                               [](const Entry& e, std::uint32_t p) { return e.first < p; });
            all.insert(all.end(), old, next);
            old = next != entries_.end() && next->first == entry.first ? next + 1 : next;
            if (entry.second && !entry.second->isEmpty()) {
                all.push_back(std::move(entry));
            }
        }
        all.insert(all.end(), old, entries_.end());
        return SparseBricks(std::move(all));
    }
    bool operator==(const SparseBricks& other) const {
        return std::equal(entries_.begin(), entries_.end(), other.entries_.begin(), other.entries_.end(),
                          [](const Entry& one, const Entry& two) {
                              return one.first == two.first &&
                                     (one.second == two.second || *one.second == *two.second);
                          });
    }

private:
    std::vector<Entry> entries_;
};

// The places of bricks that differ, in order; bricks are compared by where they lie in memory.
template <typename B>
std::vector<std::uint32_t> changedPlaces(const SparseBricks<B>& before, const SparseBricks<B>& now) {
    std::vector<std::uint32_t> places;
    auto a = before.entries().begin();
    auto b = now.entries().begin();
    while (a != before.entries().end() || b != now.entries().end()) {
        const bool isOnlyBefore =
            b == now.entries().end() || (a != before.entries().end() && a->first < b->first);
        const bool isOnlyNow =
            a == before.entries().end() || (b != now.entries().end() && b->first < a->first);
        if (isOnlyBefore || isOnlyNow || a->second != b->second) {
            places.push_back(isOnlyNow ? b->first : a->first);
        }
        a += isOnlyNow ? 0 : 1;
        b += isOnlyBefore ? 0 : 1;
    }
    return places;
}

} // namespace vs::field
