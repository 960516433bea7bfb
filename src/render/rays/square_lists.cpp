// SPDX-License-Identifier: Apache-2.0
#include "render/rays/square_lists.h"

#include "gl/pass.h"
#include "render/shaders/bindings.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace vs::render {

namespace {

constexpr int kSquare = 8; // pixels; a work group's

} // namespace

SquareLists::SquareLists()
    : mark_("render/shaders/mark_squares.comp"), list_("render/shaders/list_squares.comp"),
      marks_(4, "marks of squares"), squares_(4, "squares"), places_(4, "places of squares"),
      counts_(2 * sizeof(std::uint32_t), "square counts"), contrasts_(4, "contrasts of squares"),
      unsettled_(4, "unsettled squares") {}

std::size_t SquareLists::bytes() const { return std::size_t(all()) * sizeof(std::uint32_t); }

void SquareLists::resize(glm::ivec2 pictureSize) {
    count_ = (pictureSize + kSquare - 1) / kSquare;
    for (gl::Buffer* buffer : {&marks_, &squares_, &places_, &contrasts_, &unsettled_}) {
        buffer->reserve(bytes());
    }
}

void SquareLists::forget() {
    marks_.clear();
    contrasts_.clear();
}

void SquareLists::mark(const gl::Texture& beams, int beamPixels) {
    const gl::Pass pass("mark squares");
    beams.bindTexture(kBeamsTexture);
    marks_.bindStorage(kMarksStorage);
    mark_.set("squareCount", count_).set("beamPixels", beamPixels);
    // The beams, which this reads as a texture, are an image when a picture begins anew.
    mark_.dispatchOver({count_, 1}, gl::Barrier::All);
}

void SquareLists::list(const Box2& window) {
    const gl::Pass pass("list squares");
    marks_.bindStorage(kMarksStorage);
    squares_.bindStorage(kSquaresStorage);
    places_.bindStorage(kPlacesStorage);
    counts_.clear();
    counts_.bindStorage(kSquareCountsStorage);
    list_.set("squareCount", count_).set("window", glm::vec4(window.lo, window.hi));
    list_.dispatchOver({count_, 1}, gl::Barrier::Storage);
    const auto counts = counts_.read<std::uint32_t>(2);
    occupied_ = active_ = int(counts[0]);
    empty_ = int(counts[1]);
}

void SquareLists::setSettledAside() {
    const gl::Pass pass("set settled squares aside");
    squares_.bindStorage(kSquaresStorage);
    places_.bindStorage(kPlacesStorage);
    contrasts_.bindStorage(kContrastsStorage);
    unsettled_.bindStorage(kOrderedStorage);
    counts_.clear();
    counts_.bindStorage(kSquareCountsStorage);
    gl::Program& setAside = setAside_.with({});
    setAside.set("squareCount", count_).set("occupied", occupied_);
    setAside.dispatchOverList(std::size_t(all()), gl::Barrier::Storage);
    active_ = int(counts_.readValue<std::uint32_t>());
    std::swap(squares_, unsettled_);
}

void SquareLists::listPart(const gl::Texture& beams, int beamPixels, PartSquares& part) {
    const gl::Pass pass("list squares of a part");
    if (part.list.size() < bytes()) {
        part.list = gl::Buffer(bytes(), "squares of a part");
    }
    beams.bindTexture(kBeamsTexture);
    part.list.bindStorage(kSquaresStorage);
    places_.bindStorage(kPlacesStorage);
    counts_.clear();
    counts_.bindStorage(kSquareCountsStorage);
    gl::Program& listPart = listPart_.with({});
    listPart.set("squareCount", count_).set("beamPixels", beamPixels).set("activeSquares", active_);
    listPart.dispatchOver({count_, 1}, gl::Barrier::All); // beams, as in mark()
    part.count = int(counts_.readValue<std::uint32_t>());
}

void SquareLists::bind() const {
    squares_.bindStorage(kSquaresStorage);
    contrasts_.bindStorage(kContrastsStorage);
}

void SquareLists::bind(const PartSquares& part) const {
    part.list.bindStorage(kSquaresStorage);
    contrasts_.bindStorage(kContrastsStorage);
}

void SquareLists::bindPlaces() const { places_.bindStorage(kPlacesStorage); }

glm::ivec3 SquareLists::groupsFor(int squares) {
    const int rows = std::clamp(int(std::thread::hardware_concurrency()), 1, 64);
    return {(squares + rows - 1) / rows, rows, 1};
}

} // namespace vs::render
