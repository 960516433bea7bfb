// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/sketch_tool.h"

#include "sculpt/surface/stroke.h"
#include "studio/operations/marking.h"

#include <QColor>

#include <deque>

namespace vs::desktop {

// A marking pen: lays colour on the surface seen, which stays on the material. Free-form lines are seen while
// they are drawn; other shapes, areas and arrows when the sketch ends; letters where one clicks. With the
// sign reversed it takes colour away.
class MarkTool : public SketchTool<StudioTool> {
    Q_OBJECT

public:
    static constexpr double kLeastMm = 0.2;
    static constexpr double kMostMm = 50;

    explicit MarkTool(StudioController& studio);

    [[nodiscard]] QString name() const override { return "mark"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Overlays overlays() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void clear() override;
    void viewResized() override;
    void advance() override;
    [[nodiscard]] bool isBehind() const override { return isDrawing_ && !waiting_.empty(); }
    [[nodiscard]] bool isBusy() const override { return isDrawing_ || SketchTool::isBusy(); }

    // The sign reversed: it erases.
    [[nodiscard]] bool hasSign() const override { return true; }
    [[nodiscard]] bool isReversed() const override { return erases_; }
    void setReversed(bool reversed) override;

    using Kind = studio::Mark::Kind;
    [[nodiscard]] Kind kind() const { return kind_; }
    void setKind(Kind kind);
    // The pen of the next mark: colour, width and all else that does not come from the drawing.
    [[nodiscard]] const studio::Mark& pen() const { return mark_; }
    void setColour(const QColor& colour);
    [[nodiscard]] QColor colour() const;
    void setOpacity(double part);
    void setWidthMm(double mm);
    // How much of half the line's width is a rim that grows from nothing, 0 to 1.
    [[nodiscard]] double softness() const { return softness_; }
    void setSoftness(double part);
    void setDashed(bool on);
    [[nodiscard]] bool isDashed() const { return isDashed_; }
    void setPressureSets(studio::Mark::Pressure what);
    void setText(const QString& text);
    void setSizeMm(double mm);
    // Takes all marks away.
    void removeAll();

protected:
    void takeSketch() override;

private:
    [[nodiscard]] bool isLive() const;
    [[nodiscard]] studio::Mark markOf(const studio::Sketch& sketch) const;
    void lead(const Pen& pen);
    void draw(double budgetMs);
    void endLine(bool keep);
    void write(const Pen& pen);
    void tell();

    Kind kind_ = Kind::Line;
    studio::Mark mark_;
    double softness_ = 0;
    bool isDashed_ = false;
    bool erases_ = false;
    bool isDrawing_ = false;               // a line that is seen meanwhile
    sculpt::PenPoint last_;                // of the line, as far as it was told
    std::deque<sculpt::PenPoint> waiting_; // pen points that the document has not seen yet
};

} // namespace vs::desktop
