// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "render/camera/camera.h"

#include <QObject>
#include <QPointF>
#include <QString>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace vs::desktop {

class DocumentHost;
class ViewModel;

// A view that books know: from straight in front of one side of the patient.
struct StandardView {
    std::string name; // in names of actions
    QString text;
    QString tip;
    const char* key;
    glm::dvec3 direction{0}; // from which it is looked at; world
};

// How the person looks around the volume, whatever leads it: mouse, wheel, keys, fingers, the cube. Places
// and movements are in logical pixels of the view.
class CameraMotion : public QObject {
    Q_OBJECT

public:
    CameraMotion(DocumentHost& host, ViewModel& view);

    // All six, opposite ones after each other.
    static std::vector<StandardView> standardViews();

    // A turntable keeps the head up and stops at the poles; else what is seen rolls under the hand as a ball
    // does, past the poles too.
    [[nodiscard]] bool isTurntable() const { return isTurntable_; }
    void setTurntable(bool isTurntable) { isTurntable_ = isTurntable; }

    // Turns what is seen by a movement of the hand.
    void turn(QPointF delta);
    void pan(QPointF delta);
    // Zooms by a factor; the place under `anchor` stays there.
    void zoom(double factor, QPointF anchor);
    // The factor of a drag by so many pixels down: up comes nearer.
    [[nodiscard]] static double zoomBy(double pixelsDown) { return std::exp(-0.008 * pixelsDown); }
    // Rolls about the line of sight, clockwise; the place under `anchor` stays there.
    void roll(double degrees, QPointF anchor);
    // Looks straight from a direction (world), upright. All that was in the picture when it was fitted is in
    // it again, unless the person has moved or zoomed it since.
    void lookFrom(glm::dvec3 direction);
    // Without perspective. What was fitted is fitted anew.
    [[nodiscard]] bool isOrthographic() const;
    void setOrthographic(bool isOrthographic);
    // Shows all that can be seen as large as the view has room for. What is turned later turns about its
    // middle.
    void fit();
    // Whether that has been done, and nobody has looked from elsewhere since.
    [[nodiscard]] bool isFitted() const;
    // Fits after an edit that moved the voxels, if all was fitted before it.
    void fitAfterCorrection();
    // Looks at the face, all of what can be seen.
    void reset();

private:
    [[nodiscard]] render::Camera fittedOn(const render::Camera& camera) const;
    [[nodiscard]] glm::dvec3 pivot() const;
    [[nodiscard]] bool isFramed() const;
    // How far a place of the view is from its centre to the right and up, at the depth that is looked at.
    [[nodiscard]] glm::dvec2 millimetresFromCentre(QPointF place) const;
    void show(const render::Camera& camera);
    void turnTo(const render::Camera& turned);
    void fitAgain();
    void forget();
    void noteCorrection();

    DocumentHost& host_;
    ViewModel& view_;
    bool isTurntable_ = false;
    bool wasFitted_ = false;               // before the voxels were moved
    std::vector<glm::dvec3> seen_;         // around what could be seen when it was fitted; world
    std::optional<render::Camera> fitted_; // the camera that was fitted on them
    std::optional<render::Camera> framed_; // that, or as it was turned since
};

} // namespace vs::desktop
