// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/studio_tool.h"

#include "volume/grid/geometry.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace vs::desktop {

class CameraTool;

// A distance between two places, or the angle at the second of three. In mm of the world.
struct Measurement {
    std::vector<glm::dvec3> places;

    [[nodiscard]] bool isAngle() const { return places.size() > 2; }
};
// What a measurement gives, in mm or in degrees; 0 while there is nothing to measure.
double valueOf(const Measurement& measurement);
// A measurement's value as people read it: "12.3 mm", "90.5°".
QString labelOf(const Measurement& measurement);

// Measures between places that are clicked, on the surface seen or on slices; a drag from one to the next
// does as well. Where there is no surface, it turns the volume.
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

    [[nodiscard]] bool measuresAngles() const { return measuresAngles_; }
    void setMeasuresAngles(bool angles);

    // A place was pressed, the last one goes to where the pen is now, and it was let go there after a drag or
    // not.
    void begin(glm::dvec3 world);
    void lead(glm::dvec3 world);
    void end(bool isDrag);

    [[nodiscard]] const std::vector<Measurement>& measurements() const { return measurements_; }
    // The measurement in hand, with the place under the pen as its last.
    [[nodiscard]] const std::optional<Measurement>& inHand() const { return inHand_; }
    void removeLast();
    void removeAll();

signals:
    void changed();

private:
    [[nodiscard]] std::optional<glm::dvec3> surfaceAt(QPointF position);
    void fix();
    void tell();
    void followVoxels(const volume::GridGeometry& before);

    CameraTool& camera_;
    std::vector<Measurement> measurements_;
    std::optional<Measurement> inHand_;
    bool measuresAngles_ = false;
    bool isHeld_ = false;
    bool isFirst_ = false; // the press that is held began the measurement
    bool isTurning_ = false;
    QPointF pressed_;
};

} // namespace vs::desktop
