// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/document.h"

#include <QObject>

#include <filesystem>
#include <functional>
#include <string>

namespace vs::desktop {

class DocumentHost;
class FreeRoom;
class Hand;
class ViewModel;

// Changes the document: everything that a person does to it ends in one of these calls. Each tells what came
// of it; false: it failed, and the message says why.
//
// apply() and change() first let what is under way come to its end (interrupting()), so that their edit is an
// operation of its own. perform() does not: it is for what is under way itself.
class Editor : public QObject {
    Q_OBJECT

public:
    Editor(DocumentHost& host, ViewModel& view, Hand& hand);

    bool apply(const studio::Operation& operation, const std::filesystem::path& outputFolder = ".");
    bool change(const std::function<studio::Outcome()>& edit);
    // Performs an edit on the thread for long work; when it takes long, it can be given up.
    bool perform(const std::function<studio::Outcome()>& edit);
    // Plays the region backward; one undo step with the rewinding before it.
    bool rewind(int generations);
    // What goes on by itself or waits for a moment of calm is done first.
    void interrupt() { emit interrupting(); }

    // Runs `begin`, which opens a live stroke on the view's canvas.
    bool beginStroke(const std::function<void(studio::Document&, const studio::Canvas&)>& begin);
    // Whether it ended so: what takes long can be given up, and then the stroke is gone.
    bool endStroke(bool keep);
    // Does a whole stroke, to the scan or, if the tool acts on it, to the segment at work or to material.
    bool cut(const studio::Operation& stroke);
    // A stroke as the operation that it is when the tool acts on material: the scissors' outline fills a
    // hole. Else itself.
    [[nodiscard]] studio::Operation aimed(const studio::Operation& stroke) const;
    // Makes the material in hand if the tool is to fill with it and there is none yet. False: that failed.
    bool prepareMaterial();
    // Pastes what tools cut since the last paste where there is room beside the object and the parts pasted
    // before; what Keep and Clip took away too, if that is wanted. The view steps back if it would not be
    // seen.
    bool paste(bool takesTrimmed = false);
    // Pulls a segment out to where there is room, likewise; one that is out already goes back.
    bool pullOut(const std::string& segment);

signals:
    void interrupting();
    void done(double milliseconds);             // a step of the history, which took so long
    void voxelsMoved();                         // an edit corrected where they lie, or took that back
    void pasted();                              // a part that is to be moved now
    void pulledOut(const std::string& segment); // a segment that is to be moved now

private:
    bool endMark(bool keep);
    void report(const studio::Outcome& outcome);
    // What a person can see at present: what remains, pasted parts and segments that are pulled out.
    [[nodiscard]] FreeRoom roomBesideAll();

    DocumentHost& host_;
    ViewModel& view_;
    Hand& hand_;
};

} // namespace vs::desktop
