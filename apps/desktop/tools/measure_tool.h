// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/studio_tool.h"

#include "studio/state/measured.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace vs::desktop {

class CameraTool;

// Measures between places that are clicked, on the surface seen or on slices; a drag from one to the next
// does as well. Paths are drawn there, and outlines of areas on slices. Where there is no surface, it turns
// the volume. What is measured is an operation of the document: it stands in sessions, and is undone.
class MeasureTool : public StudioTool {
    Q_OBJECT

public:
    MeasureTool(StudioController& studio, CameraTool& camera);

    [[nodiscard]] QString name() const override { return "measure"; }
    [[nodiscard]] QString hint() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void hover(const Pen& pen) override;
    void clear() override; // what is in hand, else nothing

    using Kind = studio::Measure::Kind;
    [[nodiscard]] Kind kind() const { return kind_; }
    void setKind(Kind kind);
    // How much is cut away.
    void measureCut();

    // A place was pressed, the last one goes to where the pen is now (a path goes on to there), and it was
    // let go there after a drag or not.
    void begin(glm::dvec3 world);
    void lead(glm::dvec3 world);
    void end(bool isDrag);

    [[nodiscard]] const std::vector<studio::Measured>& measurements() const;
    // The measurement in hand, with the place under the pen as its last. An area comes to nothing before it
    // is closed.
    [[nodiscard]] std::optional<studio::Measured> inHand() const;
    // What a measurement comes to, with the values of an area.
    [[nodiscard]] QString labelOf(const studio::Measured& measured) const;
    // What a vessel's narrowest place is like beside its neighbours.
    [[nodiscard]] QString narrowestOf(const studio::Measured& measured) const;
    void removeLast();
    void removeAll();

signals:
    void changed();

private:
    [[nodiscard]] std::optional<glm::dvec3> surfaceAt(QPointF position);
    void fix();
    void tell();
    void drop();
    [[nodiscard]] bool isDrawn() const { return kind_ == Kind::Path || kind_ == Kind::Area; }
    void finish();

    CameraTool& camera_;
    std::vector<glm::dvec3> places_; // of the measurement in hand: world, mm; none: there is none
    Kind kind_ = Kind::Distance;
    bool isHeld_ = false;
    bool isFirst_ = false; // the press that is held began the measurement
    bool isTurning_ = false;
    QPointF pressed_;
};

} // namespace vs::desktop
