// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/cut_tool.h"

#include "studio/operations/operation.h"

#include <QTimer>

#include <optional>

namespace vs::desktop {

class CameraTool;

// Cuts what lies outside a box along the grid, and what lies before a plane. Set in the tool panel and shown
// at once; one operation when the slider is let go. As long as nothing else was done since, a further change
// takes the place of the one before: it is taken back first. In the picture the left button turns the volume.
class ClipTool : public CutTool {
    Q_OBJECT

public:
    ClipTool(StudioController& studio, CameraTool& camera);

    [[nodiscard]] QString name() const override { return "clip"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Overlays overlays() const override;
    [[nodiscard]] Qt::CursorShape cursor() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void clear() override;
    void finishPending() override;
    void advance() override;
    [[nodiscard]] bool isBusy() const override { return isOpen_; }

    // The box of the whole grid, voxel borders included, and the one that is set, within it.
    [[nodiscard]] studio::Clip::Box wholeBox() const;
    [[nodiscard]] studio::Clip::Box box() const;
    [[nodiscard]] bool hasPlane() const { return !clip_.planes.empty(); }
    // How far before the grid's centre the plane is, in mm, against the way that the viewer looks; it cannot
    // be farther than this.
    [[nodiscard]] double planeOffset() const;
    [[nodiscard]] double greatestOffset() const;
    [[nodiscard]] bool cutsInside() const { return clip_.cutsInside; }

    // The patient's direction that a face of the box looks in: "left", "superior" ...
    static QString directionOf(const volume::GridGeometry& geometry, int axis, bool isHi);

    // `isDragged`: more of it will come until finish(). Else it ends by itself when nothing comes any more.
    void setBox(const studio::Clip::Box& box, bool isDragged);
    void setPlaneOffset(double mm, bool isDragged);
    void setCutsInside(bool inside);
    // Turned to the viewer, through the grid's centre if there was none; or none.
    void facePlane();
    void dropPlane();
    void reset();
    void finish();

signals:
    void clipChanged();

private:
    CameraTool& camera_;
    void show(const studio::Clip& clip, bool isDragged);
    bool open();
    void drop();
    [[nodiscard]] const studio::Clip* standing() const;
    void takeStanding();
    [[nodiscard]] studio::Clip operation() const;

    studio::Clip clip_;  // what is set
    studio::Clip begun_; // what the stroke in hand began as: restoring or not stays
    bool isOpen_ = false;
    bool isStale_ = false;     // the document does not show it yet
    bool replaces_ = false;    // the stroke in hand, an earlier clip
    bool isReplacing_ = false; // right now
    QTimer calm_;
};

} // namespace vs::desktop
