// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "studio/document/document.h"
#include "studio/editing/film_plan.h"

#include <optional>
#include <vector>

namespace vs::studio {

// Brings a document where a film's frames show it, and back: to generations, and through undo and redo to the
// steps of a session. Private to the document's own files.
class FilmPlayer {
public:
    // Throws Error when a shot shows what is not there.
    FilmPlayer(Document::Impl& impl, const SaveMovie& film);
    ~FilmPlayer(); // the document is as it was
    FilmPlayer(const FilmPlayer&) = delete;
    FilmPlayer& operator=(const FilmPlayer&) = delete;

    [[nodiscard]] int frameCount() const { return plan_.frameCount(); }
    [[nodiscard]] int frameAt(double seconds) const { return plan_.frameAt(seconds); }
    image::Image picture(int frame, glm::ivec2 size, int samples);
    // The document is as it was. Without this the end of the player sees to it, as well as it can.
    void goBack();

private:
    void show(const FilmFrame& frame);
    void travelTo(std::size_t steps);
    void showGeneration(int generation);
    [[nodiscard]] int generationNow() const;

    Document::Impl& impl_;
    const SaveMovie& film_;
    std::size_t steps_; // that were done when it began
    int generation_;    // that the segment at work has after the steps that are done now
    View view_;         // that was shown when it began
    FilmPlan plan_;
    std::vector<std::optional<int>> generationsBefore_; // what each step found, once it was taken back
};

} // namespace vs::studio
