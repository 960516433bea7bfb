// SPDX-License-Identifier: Apache-2.0
// The page of the camera tool: from where the volume is looked at, and how it turns.
#include "model/document/camera_motion.h"
#include "model/studio/studio_controller.h"
#include "panels/tool_pages.h"
#include "parts/panel_parts.h"
#include "tools/camera_tool.h"
#include "tools/tool_box.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QPushButton>
#include <QSignalBlocker>

namespace vs::desktop {

namespace {

constexpr int kPerRow = 2; // opposite sides stand beside each other

QWidget* makeViewButtons(StudioController& studio) {
    auto* row = new QWidget;
    auto* grid = new QGridLayout(row);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    int n = 0;
    for (const StandardView& view : CameraMotion::standardViews()) {
        auto* button = named(new QPushButton(view.text), ("look." + view.name).c_str(), view.tip);
        button->setToolTip(view.tip);
        QObject::connect(button, &QPushButton::clicked, button,
                         [&studio, view] { studio.camera().lookFrom(view.direction); });
        grid->addWidget(button, n / kPerRow, n % kPerRow);
        ++n;
    }
    auto* fit = named(new QPushButton(CameraMotion::tr("Fit")), "fitCamera",
                      CameraMotion::tr("Show all that can be seen as large as there is room for"));
    fit->setToolTip(fit->accessibleName());
    QObject::connect(fit, &QPushButton::clicked, fit, [&studio] { studio.camera().fit(); });
    grid->addWidget(fit, n / kPerRow, 0, 1, kPerRow);
    return row;
}

QWidget* makeUses(StudioController& studio, CameraTool& tool) {
    auto* uses = new ChoiceRow(
        {{"dragTurns", CameraMotion::tr("Turn"), CameraMotion::tr("Dragging turns the volume")},
         {"dragMoves", CameraMotion::tr("Move"), CameraMotion::tr("Dragging moves the picture")},
         {"dragZooms", CameraMotion::tr("Zoom"),
          CameraMotion::tr("Dragging up comes nearer, down steps back")}},
        int(tool.use()), 3);
    QObject::connect(uses, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setUse(CameraTool::Use(n)); });
    QObject::connect(&studio.host(), &DocumentHost::changed, uses,
                     [&tool, uses] { uses->choose(int(tool.use())); });
    return uses;
}

} // namespace

QWidget* makeCameraPage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    form->addRow(makeUses(studio, tools.get<CameraTool>()));
    form->addRow(makeViewButtons(studio));
    auto* orthographic =
        makeCheckBox("cameraOrthographic", CameraMotion::tr("Orthographic"),
                     CameraMotion::tr("Without perspective: what is farther off is as large"), false);
    auto* turntable = makeCheckBox(
        "cameraTurntable", CameraMotion::tr("Turntable"),
        CameraMotion::tr("The head stays up while the volume is turned, instead of rolling under the hand"),
        studio.camera().isTurntable());
    QObject::connect(orthographic, &QCheckBox::toggled, &studio.camera(), &CameraMotion::setOrthographic);
    QObject::connect(turntable, &QCheckBox::toggled, &studio, &StudioController::setTurntable);
    const auto show = [&studio, orthographic, turntable] {
        const QSignalBlocker noProjection(orthographic);
        const QSignalBlocker noTurning(turntable);
        orthographic->setChecked(studio.camera().isOrthographic());
        turntable->setChecked(studio.camera().isTurntable());
    };
    QObject::connect(&studio.host(), &DocumentHost::changed, orthographic, show);
    form->addRow(orthographic);
    form->addRow(turntable);
    return page;
}

} // namespace vs::desktop
