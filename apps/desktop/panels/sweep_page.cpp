// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "panels/cut_rows.h"
#include "panels/tool_pages.h"
#include "parts/panel_parts.h"
#include "tools/sweep_tool.h"
#include "tools/tool_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QPushButton>

#include <array>
#include <cmath>
#include <functional>

namespace vs::desktop {

namespace {

enum class Unit { Steps, None };

// A row with a slider for one of the numbers; `perUnit` positions of it are one.
QWidget* addNumber(QFormLayout* form, SweepTool& tool, StudioController& studio, const char* objectName,
                   const QString& text, const QString& tip, double SweepTool::Settings::*number, Range range,
                   int perUnit, Unit unit) {
    auto* slider = makeSlider(objectName, tip, int(perUnit * range.lo), int(perUnit * range.hi),
                              int(std::lround(perUnit * tool.settings().*number)));
    slider->setToolTip(tip);
    QObject::connect(slider, &QSlider::valueChanged, &tool, [&tool, number, perUnit](int v) {
        auto settings = tool.settings();
        settings.*number = double(v) / perUnit;
        tool.set(settings);
    });
    auto* row =
        unit == Unit::Steps ? withSteps(slider, perUnit, studio) : withValue(slider, [perUnit](int v) {
            return QString::number(double(v) / perUnit, 'f', perUnit > 1 ? 1 : 0);
        });
    form->addRow(text, row);
    return row;
}

QWidget* addLine(QFormLayout* form, SweepTool& tool) {
    auto* line = new ChoiceRow({{"sweepByHand", tr("By hand"), tr("The way is drawn along the pen")},
                                {"sweepPolyline", tr("Polyline"),
                                 tr("Straight from corner to corner; Enter or a double click ends it")},
                                {"sweepSpline", tr("Spline"),
                                 tr("A smooth curve through corners; Enter or a double click ends it")}},
                               int(tool.settings().line), 3);
    QObject::connect(line, &ChoiceRow::chosen, &tool, [&tool](int n) {
        auto settings = tool.settings();
        settings.line = SweepTool::Line(n);
        tool.set(settings);
    });
    form->addRow(line);
    return line;
}

// A choice of one of `names`; `take` gets its number.
template <std::size_t N>
QComboBox* addNames(QFormLayout* form, const QString& text, const char* objectName, const QString& tip,
                    const std::array<const char*, N>& names, int chosen,
                    const std::function<void(int)>& take) {
    auto* box = named(new QComboBox, objectName, text);
    box->setToolTip(tip);
    for (const char* name : names) {
        box->addItem(name); // as sessions and papers call it
    }
    box->setCurrentIndex(chosen);
    QObject::connect(box, &QComboBox::currentIndexChanged, box, take);
    form->addRow(text, box);
    return box;
}

// For experiments on how cuts are made.
void addAdvanced(QFormLayout* form, SweepTool& tool) {
    auto* advanced = makeCheckBox("sweepAdvanced", tr("Advanced"),
                                  tr("Raw energy, and the filter of the mask's edge"), false);
    form->addRow(advanced);
    auto* raw =
        makeCheckBox("sweepRaw", tr("Raw energy"),
                     tr("0.1 for each element of the mask instead of its volume: the cut's size follows the "
                        "way's length in pixels"),
                     tool.settings().isRaw);
    QObject::connect(raw, &QCheckBox::toggled, &tool, [&tool](bool on) {
        auto settings = tool.settings();
        settings.isRaw = on;
        tool.set(settings);
    });
    form->addRow(raw);
    auto* sampling = addNames(form, tr("Sampling"), "sweepSampling", tr("How the mask's edge is sampled"),
                              sculpt::kMaskSamplings, int(tool.settings().filter.sampling), [&tool](int n) {
                                  auto settings = tool.settings();
                                  settings.filter.sampling = sculpt::Sampling(n);
                                  tool.set(settings);
                              });
    auto* reconstruction =
        addNames(form, tr("Filter"), "sweepFilter", tr("What the samples are weighted by"),
                 sculpt::kReconstructions, int(tool.settings().filter.reconstruction), [&tool](int n) {
                     auto settings = tool.settings();
                     settings.filter.reconstruction = sculpt::Reconstruction(n);
                     settings.filter.width = sculpt::naturalWidth(settings.filter.reconstruction);
                     tool.set(settings);
                 });
    const auto show = [form, raw, sampling, reconstruction](bool on) {
        for (QWidget* row : {static_cast<QWidget*>(raw), static_cast<QWidget*>(sampling),
                             static_cast<QWidget*>(reconstruction)}) {
            form->setRowVisible(row, on);
        }
    };
    QObject::connect(advanced, &QCheckBox::toggled, form, show);
    show(false);
}

} // namespace

QWidget* makeSweepPage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    SweepTool& tool = tools.get<SweepTool>();
    addCutOrRestore(form, tool, studio, "sweep");
    auto* way =
        new ChoiceRow({{"sweepSurface", tr("On the surface"), tr("Draw the way on the surface")},
                       {"sweepPlane", tr("Across the view"), tr("Draw the way in the plane across the view")},
                       {"sweepLine", tr("Line inward"), tr("Straight along the view, through the shape")},
                       {"sweepHelix", tr("Helix inward"), tr("A helix along the view, about the shape")}},
                      int(tool.settings().way), 2);
    QObject::connect(way, &ChoiceRow::chosen, &tool, [&tool](int n) {
        auto settings = tool.settings();
        settings.way = SweepTool::Way(n);
        tool.set(settings);
    });
    form->addRow(way);
    auto* line = addLine(form, tool);
    using Settings = SweepTool::Settings;
    auto* length = addNumber(form, tool, studio, "sweepLength", tr("Length (steps)"),
                             tr("How far inward, in steps"), &Settings::length, {5, 200}, 1, Unit::Steps);
    auto* radius = addNumber(form, tool, studio, "sweepHelixRadius", tr("Helix radius (steps)"),
                             tr("In steps"), &Settings::helixRadius, {2, 60}, 1, Unit::Steps);
    auto* turns = addNumber(form, tool, studio, "sweepTurns", tr("Turns"), tr("From end to end"),
                            &Settings::turns, {0.5, 10}, 2, Unit::None);
    auto* frame = new ChoiceRow(
        {{"sweepParallel", tr("Parallel"), tr("The shape turns as little as it can along its way")},
         {"sweepFrenet", tr("Frenet"), tr("The shape turns with the way's bends")}},
        int(tool.settings().frame));
    QObject::connect(frame, &ChoiceRow::chosen, &tool, [&tool](int n) {
        auto settings = tool.settings();
        settings.frame = sculpt::FrameKind(n);
        tool.set(settings);
    });
    form->addRow(tr("Turning"), frame);
    addRadius(form, tool, "sweep");
    auto* atOnce = makeCheckBox("sweepAtPenUp", tr("At once when the pen is lifted"),
                                tr("Instead of showing the way first"), tool.settings().cutsAtPenUp);
    QObject::connect(atOnce, &QCheckBox::toggled, &tool, [&tool](bool on) {
        auto settings = tool.settings();
        settings.cutsAtPenUp = on;
        tool.set(settings);
    });
    form->addRow(atOnce);
    auto* apply = named(new QPushButton, "sweepApply", tr("Sweep what is shown"));
    apply->setFocusPolicy(Qt::TabFocus);
    QObject::connect(apply, &QPushButton::clicked, &tool, &SweepTool::accept);
    form->addRow(apply);
    addAdvanced(form, tool);
    const auto show = [&tool, form, line, length, radius, turns, apply] {
        const auto now = tool.settings().way;
        const bool isHelix = now == SweepTool::Way::Helix;
        form->setRowVisible(line, now == SweepTool::Way::Surface || now == SweepTool::Way::ViewPlane);
        form->setRowVisible(length, isHelix || now == SweepTool::Way::Line);
        form->setRowVisible(radius, isHelix);
        form->setRowVisible(turns, isHelix);
        apply->setText(tool.actsOnMaterial() ? (tool.isReversed() ? tr("Take away what is shown (Enter)")
                                                                  : tr("Fill what is shown (Enter)"))
                       : tool.restores()     ? tr("Restore what is shown (Enter)")
                                             : tr("Cut what is shown (Enter)"));
        apply->setEnabled(tool.canAccept());
    };
    QObject::connect(&tool, &Tool::overlayChanged, apply, show);
    show();
    return page;
}

} // namespace vs::desktop
