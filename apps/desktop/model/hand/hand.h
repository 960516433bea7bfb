// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

#include <QObject>

#include <glm/glm.hpp>

#include <filesystem>
#include <vector>

namespace vs::desktop {

class DocumentHost;
class Tool;

// What a person has in hand: the current tool, and what all tools share: the shape that is sketched, how hard
// the pen presses, and whether they work on the scan, on the segment at work or on material.
class Hand : public QObject {
    Q_OBJECT

public:
    explicit Hand(DocumentHost& host);

    // The tool in hand: at first one that does nothing.
    [[nodiscard]] Tool& tool() const { return *tool_; }
    void take(Tool& tool);
    // Hears of what changes in a tool; each that can be taken.
    void listenTo(Tool& tool);

    [[nodiscard]] studio::Shape shape() const { return shape_; }
    // Shape::Stencil once there is a stencil.
    void setShape(studio::Shape shape);
    // What that sketches: an outline (y down) fitted into the box that is dragged.
    [[nodiscard]] const std::vector<glm::dvec2>& stencil() const { return stencil_; }
    // A picture's bright or opaque part as the stencil. False: it has none, and the message says why.
    bool setStencil(const std::filesystem::path& picture);

    // For a mouse; a tablet's own pressure overrides it.
    [[nodiscard]] double mousePressure() const { return mousePressure_; }
    void setMousePressure(double pressure) { mousePressure_ = pressure; }
    // Press and hold: a mouse that is held down presses harder and harder.
    [[nodiscard]] bool rampsPressure() const { return rampsPressure_; }
    void setRampsPressure(bool on) { rampsPressure_ = on; }
    void setTabletPressure(double pressure) { emit tabletPressureChanged(pressure); }

    // What tools act on that can act on it; others act on the scan.
    enum class Target { Scan, Segment, Material };
    [[nodiscard]] Target target() const { return target_; }
    void setTarget(Target target);
    // The number of the material that is filled with, counted from 1; of the one that comes next, if there is
    // none of that number yet.
    [[nodiscard]] int material() const { return material_; }
    void setMaterial(int number);
    // The next click takes the scan's value for that material.
    [[nodiscard]] bool picksValue() const { return picksValue_; }
    void setPicksValue(bool on);

signals:
    void overlayChanged(); // what is painted over the picture, and the hint and the cursor with it
    void tabletPressureChanged(double pressure);

private:
    DocumentHost& host_;
    Tool* tool_;
    studio::Shape shape_ = studio::Shape::FreeForm;
    std::vector<glm::dvec2> stencil_;
    double mousePressure_ = 1;
    bool rampsPressure_ = false;
    Target target_ = Target::Scan;
    int material_ = 1;
    bool picksValue_ = false;
};

} // namespace vs::desktop
