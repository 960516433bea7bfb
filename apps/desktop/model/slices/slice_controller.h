// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/tool.h"

#include "render/slices/slice_renderer.h"
#include "studio/document/document.h"
#include "studio/document/surface_queries.h"

#include <QImage>
#include <QObject>

#include <array>
#include <memory>
#include <optional>

namespace vs::desktop {

class DocumentHost;
class ViewModel;

// The model of the three slices: the crosshair that links them, what part of each is looked at, and their
// pictures, which follow the document after the 3D one. No widgets.
class SliceController : public QObject {
    Q_OBJECT

public:
    using Kind = render::SliceKind;

    SliceController(DocumentHost& host, ViewModel& view);

    // Begins with another document: the crosshair goes to its middle, and all of each slice is looked at.
    void reset();

    // Slices that nobody looks at are not drawn. Any: there is a crosshair to be seen.
    void setShown(Kind kind, bool isShown);
    [[nodiscard]] bool isShown(Kind kind) const { return pane(kind).isShown; }
    [[nodiscard]] bool isAnyShown() const;
    // Interpolated between voxels, or voxels as plain areas.
    void setSmooth(bool isSmooth);
    [[nodiscard]] bool isSmooth() const { return isSmooth_; }

    [[nodiscard]] bool hasVolume() const;
    // The voxel in which the three slices meet.
    [[nodiscard]] glm::ivec3 crosshair() const { return crosshair_; }
    // Puts the crosshair on the voxel of the grid nearest to a place. There must be a volume.
    void setCrosshair(glm::dvec3 voxel);
    // Moves the crosshair by so many slices towards the head, the face or the patient's right.
    void scroll(Kind kind, int slices);
    // Puts the crosshair on the surface seen under a place of the 3D view. False: nothing is there.
    bool centreOnSurface(QPointF place);

    // There must be a volume for all of these.
    [[nodiscard]] glm::dvec3 voxelAt(glm::dvec3 world) const;
    [[nodiscard]] render::SliceGeometry geometry(Kind kind) const;
    [[nodiscard]] render::SliceView view(Kind kind) const;
    // Sets the size of a slice's picture in device pixels, and how many of them a logical one has.
    void setViewport(Kind kind, glm::ivec2 pixels, double perLogical);
    [[nodiscard]] double pixelsPerLogical(Kind kind) const { return pane(kind).perLogical; }
    // Zooms a slice by a factor; the place (mm, see SliceGeometry) under `anchor` stays there.
    void zoom(Kind kind, double factor, glm::dvec2 anchor);
    void pan(Kind kind, glm::dvec2 mm);
    void showAll(Kind kind);

    // Slices along the third voxel axis that no file holds, in order.
    [[nodiscard]] const std::vector<int>& interpolated() const;

    // The values that all slices show from black to white.
    [[nodiscard]] Range window() const;
    // Leads the window away from one, by a pen that was moved so far (logical pixels, to the right and down):
    // to the right it becomes wider, up brighter.
    void leadWindow(const Range& from, glm::dvec2 moved);

    // Value and place under a place of a slice; nothing outside the grid.
    [[nodiscard]] std::optional<studio::Probe> probe(Kind kind, glm::dvec2 place);

    // The latest picture; empty before the first.
    [[nodiscard]] const QImage& picture(Kind kind) const { return pane(kind).picture; }
    // Draws the slice that has waited longest, if any is stale. True: others are stale still.
    bool step();
    // Draws all that are shown once more: not the document has changed, but what draws them.
    void drawAnew();
    // Whether all pictures show the document as it is.
    [[nodiscard]] bool isComplete();
    // The crosshair in the 3D view.
    [[nodiscard]] Overlays overlays() const;

signals:
    void changed(); // crosshair, zoom, document: positions and lines look again
    void crosshairMoved();
    void pictureChanged(render::SliceKind kind);

private:
    // What a picture was drawn from.
    struct Key {
        render::SliceView view;
        std::uint64_t version = 0;
        bool isSmooth = true;
        bool operator==(const Key&) const = default;
    };
    struct Pane {
        bool isShown = false;
        glm::ivec2 pixels{0};
        double perLogical = 1;
        double zoom = 1; // 1: all of the slice
        glm::dvec2 centreMm{0};
        QImage picture;
        std::optional<Key> drawn;
        int turn = 0; // when it was drawn
    };

    [[nodiscard]] Pane& pane(Kind kind) { return panes_[std::size_t(kind)]; }
    [[nodiscard]] const Pane& pane(Kind kind) const { return panes_[std::size_t(kind)]; }
    [[nodiscard]] Key wanted(Kind kind) const;
    [[nodiscard]] bool isStale(Kind kind) const;
    void draw(Kind kind);
    void touch();

    DocumentHost& host_;
    ViewModel& view_;
    std::unique_ptr<render::SliceRenderer> renderer_; // made when first needed
    std::array<Pane, 3> panes_;
    glm::ivec3 crosshair_{0};
    bool isSmooth_ = true;
    int turns_ = 0;
};

} // namespace vs::desktop
