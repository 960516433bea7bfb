// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace vs::studio {

// Collects what a check has compared: how many values, how many of them differ by more than is allowed, and
// where the error is largest beside what is allowed.
class Tally {
public:
    // The first values found wrong, or those that are farthest from what is allowed.
    struct Worst {
        std::string what; // the values that this one belongs to
        double error = 0; // in the unit of `what`; infinite for a value that is no number
        double allowed = 0;
        double share = -1; // of what is allowed
    };

    // Says what the values compared from now on are, with their unit: "hits, voxels".
    void about(std::string what) { what_ = std::move(what); }
    // A value that the device found, and the one that it should be.
    void compare(double found, double expected, double allowed = 0);
    // Values in the same order. Counts another number of them as one that is wrong.
    template <typename Found, typename Expected>
    void compareAll(std::span<const Found> found, std::span<const Expected> expected, double allowed = 0) {
        compare(double(found.size()), double(expected.size()));
        for (std::size_t i = 0; i < found.size() && i < expected.size(); ++i) {
            compare(double(found[i]), double(expected[i]), allowed);
        }
    }
    // Something that must be so.
    void require(bool isSo) { compare(isSo ? 1 : 0, 1); }
    // A note for the report: what of the stage this device does not do.
    void note(std::string text) { note_ = std::move(text); }

    [[nodiscard]] std::uint64_t values() const { return values_; }
    [[nodiscard]] std::uint64_t wrong() const { return wrong_; }
    [[nodiscard]] const Worst& worst() const { return worst_; }
    [[nodiscard]] const std::string& noted() const { return note_; }

private:
    std::string what_;
    std::uint64_t values_ = 0;
    std::uint64_t wrong_ = 0;
    Worst worst_;
    std::string note_;
};

} // namespace vs::studio
