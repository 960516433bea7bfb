// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/document.h"

#include <QColor>
#include <QObject>
#include <QString>

#include <array>
#include <filesystem>
#include <optional>
#include <thread>

namespace vs::desktop {

class DocumentHost;
class Editor;
class GrowthController;
class Notices;
class ViewModel;

// The list of segments and what is done to finished ones. Every call is one operation; growing goes on after
// those that only change how a segment looks.
class SegmentController : public QObject {
    Q_OBJECT

public:
    SegmentController(DocumentHost& host, ViewModel& view, Editor& editor, GrowthController& growth,
                      Notices& notices);

    // One segment without voxels before something was opened. While the document is away, as they were
    // before. Valid until it is asked for again.
    [[nodiscard]] const studio::SegmentList& list() const;
    [[nodiscard]] std::size_t voxels(std::uint8_t label) const; // shown
    [[nodiscard]] double millilitres(std::uint8_t label) const;
    [[nodiscard]] bool hasVoxels() const; // any of them
    // Not the only one left with nothing in it.
    [[nodiscard]] bool canRemove() const;

    // Goes to work on a segment: strokes and edits are its. Going on to another at once leaves one operation.
    void workOn(const std::string& name);
    void add(); // a fresh one, with a name that is free, and goes to work on it
    void removeWorking();
    // Gives a segment another name. False: the name is empty or taken, and the message says so.
    bool rename(const std::string& name, const QString& to);
    void setColour(const std::string& name, const QColor& colour);
    void setVisible(const std::string& name, bool isVisible);
    // Hides all others, or shows all.
    void showOnly(const std::string& name);
    void showAll();
    void setLocked(const std::string& name, bool isLocked);
    // Draws it once more beside the object; no more, if that is done already.
    void pullOut(const std::string& name);
    // Pulls out all that have voxels, each in its own place; if all are out, puts them back.
    void pullAllOut();
    [[nodiscard]] bool areAllOut() const; // those that have voxels, of which there are some
    // Hides what is pulled out of a segment, or shows it again.
    void showPulledOut(const std::string& name, bool isVisible);
    // What tools that cut do with it.
    void setTreatment(const std::string& name, studio::SegmentInfo::Treatment treatment);
    // How opaque the segment at work is; `continues`: takes the place of the change before (a slider that is
    // dragged).
    void setOpacity(double opacity, bool continues);

    // Edits of the segment at work, and cuts by it.
    void perform(const studio::Operation& operation);

    // Reads a label map on a thread of its own and makes its labels segments of the volume that is open.
    void openLabels(const std::filesystem::path& path);
    // Waits for what is being read; before the program ends.
    void stop() { reader_ = {}; }

private:
    void takeLabels(const studio::LoadLabels& labels);
    void apply(studio::UseSegment change);

    DocumentHost& host_;
    ViewModel& view_;
    Editor& editor_;
    GrowthController& growth_;
    Notices& notices_;
    mutable std::shared_ptr<const studio::DocumentFacts> listed_; // whose list was last asked for
    bool isReading_ = false;
    int documents_ = 0; // counts those opened and closed
    std::jthread reader_;
};

} // namespace vs::desktop
