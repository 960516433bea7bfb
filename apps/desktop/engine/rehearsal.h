// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/picture_loop.h"
#include "studio/document/document.h"
#include "studio/operations/operation.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vs::studio {
class LiveStroke;
} // namespace vs::studio

namespace vs::desktop {

// What decides into which machine code a driver compiles the programs that a scan is worked on with.
struct ScanKind {
    volume::ScalarType type = volume::ScalarType::Int16; // one whose texels are of the same format
    glm::bvec3 isPowerOfTwo{false};                      // each of its dimensions
    bool isLarge = true;                                 // has no quads (field/quads.h)

    bool operator==(const ScanKind&) const = default;
};

ScanKind kindOf(const field::Field& field);
// A few words without spaces, such as "int16:001:large"; and back: nothing where a text is no such kind.
std::string toText(const ScanKind& kind);
std::optional<ScanKind> kindFromText(const std::string& text);

// What a person may do to a scan, done to a small made-up one of its kind, with the window's own picture
// loop: afterwards the driver has compiled whatever that needs and keeps it (doc/decisions/0033). In steps of
// some tenths of a second at most where nothing was compiled before, what is likely to be done first coming
// first. Needs a current context for its whole life.
class Rehearsal {
public:
    explicit Rehearsal(const ScanKind& kind);

    // Does the next step; false when there was none left.
    bool doNext();

private:
    using Leading = std::function<void(studio::LiveStroke&)>;

    void planStrokes();
    void planGrowth();
    void planMarks();
    void planCutsAndParts();
    void planSegments();
    void planModes();
    void add(std::function<void()> step) { steps_.push_back(std::move(step)); }
    void addSeed();
    void addOperation(const studio::Operation& operation);
    void addStroke(const studio::Operation& operation, const Leading& lead);
    void addView(const std::function<void(studio::View&)>& change);

    void showDraft();
    void showFull();
    void showSlice();
    [[nodiscard]] studio::Canvas canvas() const;

    studio::Document document_;
    PictureLoop pictures_;
    std::vector<std::function<void()>> steps_;
    std::size_t done_ = 0;
};

// Does all that, in a context of its own, where that is one of the renderer named. Returns the exit status of
// a program that does nothing else.
int rehearse(const std::string& renderer, const std::string& kind);

// For a process that rehearses beside a window: takes the processor only where nothing else wants it, and
// ends with whoever started it.
void standBack();

} // namespace vs::desktop
