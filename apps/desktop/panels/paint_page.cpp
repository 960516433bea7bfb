// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "panels/tool_pages.h"
#include "parts/panel_parts.h"
#include "tools/paint_tool.h"
#include "tools/tool_box.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QSignalBlocker>

#include <cmath>

namespace vs::desktop {

namespace {

// The slider goes by equal factors, so that small brushes are as easy to set as large ones.
constexpr int kSteps = 200;

int stepOf(double mm) {
    const double part =
        std::log(mm / PaintTool::kLeastMm) / std::log(PaintTool::kMostMm / PaintTool::kLeastMm);
    return int(std::lround(kSteps * part));
}

double radiusAt(int step) {
    return PaintTool::kLeastMm * std::pow(PaintTool::kMostMm / PaintTool::kLeastMm, double(step) / kSteps);
}

QString label(double mm) { return tr("%1 mm").arg(mm, 0, 'f', mm < 9.95 ? 1 : 0); }

} // namespace

QWidget* makePaintPage(StudioController&, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    PaintTool& tool = tools.get<PaintTool>();
    auto* sign = new ChoiceRow({{"paintAdds", tr("Add"), tr("What is painted joins the segment at work")},
                                {"paintRemoves", tr("Remove"), tr("What is painted leaves it")}},
                               tool.isToAdd() ? 0 : 1);
    QObject::connect(sign, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setToAdd(n == 0); });
    form->addRow(tr("Brush"), sign);
    auto* shape = new ChoiceRow(
        {{"paintDisc", tr("Disc"), tr("Paints on the slice that is drawn on alone")},
         {"paintBall", tr("Ball"), tr("Reaches into the slices around it, as far as it is wide")}},
        tool.isBall() ? 1 : 0);
    QObject::connect(shape, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setBall(n == 1); });
    form->addRow(tr("Shape"), shape);
    auto* radius =
        makeSlider("paintRadius", tr("Radius of the brush, in mm"), 0, kSteps, stepOf(tool.radiusMm()));
    QObject::connect(radius, &QSlider::valueChanged, &tool,
                     [&tool](int v) { tool.setRadiusMm(radiusAt(v)); });
    form->addRow(tr("Radius"), withValue(radius, [](int v) { return label(radiusAt(v)); }));
    QObject::connect(&tool, &PaintTool::settingsChanged, radius, [radius, &tool] {
        if (std::abs(radiusAt(radius->value()) / tool.radiusMm() - 1) > 0.03) { // not by this slider
            radius->setValue(stepOf(tool.radiusMm()));
        }
    });
    auto* inRange =
        makeCheckBox("paintInRange", tr("Only in range"),
                     tr("Leaves voxels alone whose intensity growth would refuse"), tool.isInRangeOnly());
    QObject::connect(inRange, &QCheckBox::toggled, &tool, &PaintTool::setInRangeOnly);
    form->addRow(inRange);
    return page;
}

} // namespace vs::desktop
