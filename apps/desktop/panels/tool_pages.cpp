// SPDX-License-Identifier: Apache-2.0
#include "panels/tool_pages.h"

#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "panels/cut_rows.h"
#include "parts/panel_parts.h"
#include "tools/drill_tool.h"
#include "tools/keep_tool.h"
#include "tools/laser_tool.h"
#include "tools/peel_tool.h"
#include "tools/scissors_tool.h"
#include "tools/tool_box.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QProgressBar>
#include <QPushButton>

#include <cmath>

namespace vs::desktop {

namespace {

QLabel* addNote(QFormLayout* form, const QString& text) {
    auto* note = makeQuietLabel(text);
    note->setWordWrap(true);
    form->addRow(note);
    return note;
}

// Drill and laser.
QFormLayout* addPenRows(QWidget* page, PenTool& tool, StudioController& studio, const QString& prefix) {
    auto* form = makeForm(page);
    addCutOrRestore(form, tool, studio, prefix);
    constexpr int kPerStep = 2; // half steps
    const QByteArray depthName = (prefix + "Depth").toLatin1();
    auto* depth = makeSlider(depthName.constData(), tr("Depth at full pressure, in steps"),
                             int(kPerStep * tool.depths().least), int(kPerStep * tool.depths().most),
                             int(std::lround(kPerStep * tool.depth())));
    QObject::connect(depth, &QSlider::valueChanged, &tool,
                     [&tool](int v) { tool.setDepth(double(v) / kPerStep); });
    form->addRow(tr("Depth (steps)"), withSteps(depth, kPerStep, studio));
    addRadius(form, tool, prefix);
    const QByteArray digName = (prefix + "KeepsDigging").toLatin1();
    auto* dig = makeCheckBox(digName.constData(), tr("Keep digging"),
                             tr("Goes deeper as long as the pen moves, instead of down to the depth"),
                             tool.keepsDigging());
    QObject::connect(dig, &QCheckBox::toggled, &tool, &PenTool::setKeepsDigging);
    form->addRow(dig);
    return form;
}

} // namespace

QWidget* makePeelPage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    PeelTool& tool = tools.get<PeelTool>();
    addCutOrRestore(form, tool, studio, "peel");
    addRadius(form, tool, "peel");
    auto* layers = named(new QLabel, "peelLayers", tr("Layers peeled"));
    layers->setAlignment(Qt::AlignRight);
    form->addRow(tr("Layers"), layers);
    addNote(form, tr("10 pixels of dragging are one layer; a layer is the smallest voxel spacing."));
    const auto show = [layers, &tool, &studio] { layers->setText(stepsAndMm(tool.layers(), studio)); };
    QObject::connect(&tool, &PeelTool::layersChanged, layers, show);
    QObject::connect(&studio.host(), &DocumentHost::opened, layers, show);
    QObject::connect(&studio.host(), &DocumentHost::corrected, layers, show);
    show();
    return page;
}

QWidget* makeDrillPage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    DrillTool& tool = tools.get<DrillTool>();
    auto* form = addPenRows(page, tool, studio, "drill");
    auto* through = makeCheckBox("drillThrough", tr("Through all"),
                                 tr("Drills through all of the volume, instead of down to the depth"),
                                 tool.goesThrough());
    QObject::connect(through, &QCheckBox::toggled, &tool, &DrillTool::setGoesThrough);
    QObject::connect(through, &QCheckBox::toggled, page->findChild<QSlider*>("drillDepth"),
                     &QSlider::setDisabled);
    form->addRow(through);
    auto* tilt = makeCheckBox("drillFollowsTilt", tr("Follow the pen's tilt"),
                              tr("Drills the way that the tablet's pen points, instead of along the view"),
                              tool.followsTilt());
    QObject::connect(tilt, &QCheckBox::toggled, &tool, &DrillTool::setFollowsTilt);
    form->addRow(tilt);
    return page;
}

QWidget* makeLaserPage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    addPenRows(page, tools.get<LaserTool>(), studio, "laser");
    return page;
}

QWidget* makePressureRows(StudioController& studio) {
    auto* rows = new QWidget;
    auto* form = makeForm(rows);
    auto* mouse = makeSlider("mousePressure", tr("Pressure of the mouse, in percent"), 5, 100, 100);
    mouse->setToolTip(tr("How hard the mouse presses; a tablet's pen reports its own pressure"));
    QObject::connect(mouse, &QSlider::valueChanged, &studio,
                     [&studio](int v) { studio.hand().setMousePressure(v / 100.0); });
    form->addRow(tr("Mouse pressure"), withValue(mouse, [](int v) { return tr("%1 %").arg(v); }));
    auto* ramp =
        makeCheckBox("rampsPressure", tr("Press and hold presses harder"),
                     tr("A mouse that is held down goes from a light touch to full pressure in a second"),
                     studio.hand().rampsPressure());
    QObject::connect(ramp, &QCheckBox::toggled, &studio.hand(), &Hand::setRampsPressure);
    QObject::connect(ramp, &QCheckBox::toggled, mouse, &QSlider::setDisabled);
    form->addRow(ramp);

    auto* pressure = named(new QProgressBar, "penPressure", tr("Pressure of the tablet's pen"));
    pressure->setRange(0, 100);
    pressure->setValue(0); // or its text is not shown
    pressure->setFormat(tr("no tablet pen yet"));
    QObject::connect(&studio.hand(), &Hand::tabletPressureChanged, pressure, [pressure](double p) {
        pressure->setFormat("%p %");
        pressure->setValue(int(std::lround(100 * p)));
    });
    form->addRow(tr("Pen pressure"), pressure);
    return rows;
}

QWidget* makeScissorsPage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    ScissorsTool& tool = tools.get<ScissorsTool>();
    addCutOrRestore(form, tool, studio, "scissors");
    auto* side = new ChoiceRow({{"scissorsInside", tr("Inside"), tr("What is inside the stroke goes")},
                                {"scissorsOutside", tr("Outside"), tr("What is outside the stroke goes")}},
                               tool.cutsOutside() ? 1 : 0);
    QObject::connect(side, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setCutsOutside(n == 1); });
    form->addRow(tr("Of the stroke"), side);
    constexpr int kUsualDepth = 20;
    auto* limit = makeCheckBox("scissorsHasDepth", tr("Only down to a depth"),
                               tr("Not through everything, but so many steps below the surface"), false);
    auto* depth = makeSlider("scissorsDepth", tr("Depth below the surface, in steps"), 1, 100, kUsualDepth);
    depth->setEnabled(false);
    const auto take = [&tool, limit, depth] {
        depth->setEnabled(limit->isChecked());
        tool.setDepth(limit->isChecked() ? std::optional<double>(depth->value()) : std::nullopt);
    };
    QObject::connect(limit, &QCheckBox::toggled, &tool, take);
    QObject::connect(depth, &QSlider::valueChanged, &tool, take);
    form->addRow(limit);
    form->addRow(tr("Depth (steps)"), withSteps(depth, 1, studio));
    addRadius(form, tool, "scissors");
    return page;
}

QWidget* makeKeepPage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    KeepTool& tool = tools.get<KeepTool>();
    auto* joined = new ChoiceRow(
        {{"keepCorners", tr("Corners too"), tr("Voxels that touch at an edge or a corner are connected")},
         {"keepFaces", tr("Faces only"), tr("Only voxels that share a face are connected: keeps less")}},
        tool.joinsCorners() ? 0 : 1);
    QObject::connect(joined, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setJoinsCorners(n == 0); });
    form->addRow(tr("Connected by"), joined);
    addLimits(form, tool, studio, "keep");
    addNote(form,
            tr("What is visible follows the displayed range: raise its lower end where a table touches the "
               "patient."));
    return page;
}

} // namespace vs::desktop
