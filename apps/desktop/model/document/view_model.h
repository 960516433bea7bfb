// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/document.h"

#include <QObject>
#include <QPointF>
#include <QSizeF>

#include <optional>
#include <utility>

namespace vs::desktop {

class DocumentHost;

// The view as the person sees it, and the viewport that it is seen in. What is changed here reaches the
// document before the next picture.
class ViewModel : public QObject {
    Q_OBJECT

public:
    explicit ViewModel(DocumentHost& host);

    [[nodiscard]] const studio::View& shown() const { return view_; }
    void showView(const studio::View& view);
    void setMode(render::Mode mode);
    // Colours every mode; nothing: the modes' own colours.
    void setTransferFunction(const std::optional<render::TransferFunction>& function);
    // Takes one that a person chose, with the mode, the light and the sampling that suit it.
    void chooseTransferFunction(const std::optional<render::TransferFunction>& function);
    void suit(const render::SuitedView& wanted);
    void setSculptureView(field::SculptureView view);
    // Ambient occlusion and soft shadows.
    void setShadows(bool shadows);
    void setRange(Range range);
    // Values above the displayed range: hidden in MIP, X-ray and overlay, or shown as its upper end.
    void setHidesAbove(bool hidesAbove);
    // Sigma in steps; 0: surfaces as they are in the data.
    void setSurfaceSmoothing(double sigma);
    // Segments in their colours in MIP and X-ray too.
    void setTintsSegments(bool tintsSegments);
    // MIP and X-ray dark on light.
    void setInverted(bool isInverted);
    void setSampling(field::Sampling sampling);
    // Segments smooth, or voxel by voxel.
    void setSmoothsSegments(bool smooths);
    // How far parts are moved apart: an exploded view.
    void setSpread(double spread);
    // The values that slices show from black to white; nothing: those that suit the scan.
    void setSliceWindow(std::optional<Range> window);
    [[nodiscard]] Range sliceWindow() const;
    // What the 3D picture shows, in colour on slices.
    void setTintsSlices(bool tintsSlices);
    // What of the volume's values the view shows (View::visibleRange). There must be a volume.
    [[nodiscard]] Range visibleRange() const;

    // Gives the document the view, unless a stroke is open on another.
    void flush();
    // Whether the document does not have the view yet.
    [[nodiscard]] bool isPending() const { return isPending_; }
    // Takes the view over from the document, which an operation or another document changed.
    void adopt();
    // Back to how it was before anything was opened.
    void forget();
    // What a sketch is drawn on now; with the engine's context current.
    studio::Canvas canvas();

    // Sets the viewport's size in logical and in device pixels. While the document is away, the change waits.
    void setViewport(QSizeF logical, glm::ivec2 device);
    void takeWaitingViewport();
    [[nodiscard]] bool isViewportWaiting() const { return waiting_.has_value(); }
    [[nodiscard]] glm::ivec2 viewport() const { return viewport_; } // device pixels
    [[nodiscard]] glm::dvec2 devicePerLogical() const;
    [[nodiscard]] QPointF centre() const; // logical pixels
    // The rays of the view as the person sees it, on the viewport. There must be a volume.
    [[nodiscard]] render::ViewRays rays() const;
    // Where a place in the world appears, in logical pixels of the view.
    [[nodiscard]] QPointF seenAt(glm::dvec3 world) const;
    // How much one logical pixel covers, in the middle of what is looked at.
    [[nodiscard]] double millimetresPerPixel() const;

signals:
    void resized(); // places in the viewport mean something else

private:
    DocumentHost& host_;
    studio::View view_;
    bool isPending_ = false;
    QSizeF logical_{1, 1};
    glm::ivec2 viewport_{0};
    std::optional<std::pair<QSizeF, glm::ivec2>> waiting_; // a viewport set while the document was away
};

} // namespace vs::desktop
