// SPDX-License-Identifier: Apache-2.0
#include "testing/layout_reporter.h"

#include "model/hand/tool.h"
#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "model/slices/slice_controller.h"
#include "model/studio/studio_controller.h"
#include "parts/theme.h"
#include "tools/measure_tool.h"
#include "tools/move_tool.h"
#include "tools/tool_box.h"
#include "view/view_widget.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/log.h"
#include "studio/document/document_facts.h"

#include <nlohmann/json.hpp>

#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QListWidget>
#include <QWidget>

#include <cmath>

namespace vs::desktop {

namespace {

constexpr int kReportMs = 40;

// Scripts point in the screen's own pixels, Qt thinks in scaled ones.
nlohmann::json onScreen(const QWidget& view, QPointF place) {
    const QPointF pixel = (QPointF(view.mapToGlobal(QPoint(0, 0))) + place) * view.devicePixelRatioF();
    return {std::lround(pixel.x()), std::lround(pixel.y())};
}

// Where the handles of pasted parts are on the screen.
nlohmann::json handlesOnScreen(const QWidget& view, const MoveTool& tool) {
    nlohmann::json places = nlohmann::json::array();
    for (const QPointF place : tool.handles()) {
        places.push_back(onScreen(view, place));
    }
    return places;
}

// In mm, degrees, mm^2 and ml.
nlohmann::json measured(const MeasureTool& tool) {
    nlohmann::json values = nlohmann::json::array();
    for (const studio::Measured& measured : tool.measurements()) {
        values.push_back(measured.value);
    }
    return values;
}

// Height of a row of the history on the screen; 0: it is not shown.
int historyRowHeight() {
    for (const QWidget* widget : QApplication::allWidgets()) {
        const auto* list = qobject_cast<const QListWidget*>(widget);
        if (list != nullptr && list->isVisible() && list->objectName() == "historyList") {
            return int(std::lround(list->sizeHintForRow(0) * list->devicePixelRatioF()));
        }
    }
    return 0;
}

// In its property "report"; of lists of choices, what is chosen.
QString reportOf(const QWidget& widget) {
    const QString said = widget.property("report").toString();
    const auto* choices = qobject_cast<const QComboBox*>(&widget);
    return said.isEmpty() && choices != nullptr ? choices->currentText() : said;
}

nlohmann::json screenRect(const QWidget& widget) {
    const double scale = widget.devicePixelRatioF();
    const QPointF corner = QPointF(widget.mapToGlobal(QPoint(0, 0))) * scale;
    return {std::lround(corner.x()), std::lround(corner.y()), std::lround(widget.width() * scale),
            std::lround(widget.height() * scale)};
}

nlohmann::json listOf(const SegmentController& segments) {
    nlohmann::json list = nlohmann::json::array();
    for (const studio::SegmentInfo& info : segments.list().segments) {
        list.push_back({{"name", info.name},
                        {"voxels", segments.voxels(info.label)},
                        {"visible", info.isVisible},
                        {"locked", info.isLocked},
                        {"tools", nameOf(info.treatment)},
                        {"opacity", info.opacity},
                        {"working", info.label == segments.list().atWork}});
    }
    return list;
}

} // namespace

LayoutReporter::LayoutReporter(StudioController& studio, ToolBox& tools, QWidget& window,
                               const ViewWidget& view, std::filesystem::path path)
    : QObject(&window), studio_(studio), tools_(tools), window_(window), view_(view), path_(std::move(path)),
      fence_(studio) {
    connect(&fence_, &InputFence::isPassed, this, &LayoutReporter::write);
    connect(&timer_, &QTimer::timeout, this, &LayoutReporter::write);
    timer_.setProperty(LongWork::kRunsMeanwhile, true);
    timer_.start(kReportMs);
}

nlohmann::json LayoutReporter::documentReport() const {
    const auto facts = studio_.host().facts();
    const auto status = studio_.growth().status();
    return {{"generation", status.generation},
            {"extent", status.extent},
            {"voxels", status.voxels},
            {"segments", listOf(studio_.segments())},
            {"operations", facts->logged},
            {"steps", facts->edits->operations.size()},
            {"stepsDone", facts->edits->done},
            {"canUndo", facts->canUndo()},
            {"canRedo", facts->canRedo()},
            {"unsaved", studio_.files().hasUnsavedEdits()},
            {"pictures", studio_.picture().pictures()},
            {"pictureComplete", studio_.picture().isComplete()},
            {"handles", handlesOnScreen(view_, tools_.get<MoveTool>())},
            {"glErrors", studio_.host().gl().errorCount()}};
}

// Where the zones of the orientation cube that face the viewer are on the screen, by the signs of their
// direction towards left, posterior and superior: "+00" is the left face, "0-+" the edge above the face.
nlohmann::json LayoutReporter::zonesOnScreen() const {
    nlohmann::json places = nlohmann::json::object();
    const glm::dvec3 toViewer = -studio_.view().rays().forward;
    for (int n = 0; n < 27; ++n) {
        const glm::ivec3 signs(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        const glm::dvec3 zone(signs);
        constexpr double facing = 0.3; // cosine
        if (signs == glm::ivec3(0) || glm::dot(glm::normalize(zone), toViewer) < facing) {
            continue;
        }
        std::string name;
        for (int axis = 0; axis < 3; ++axis) {
            name += signs[axis] < 0 ? '-' : signs[axis] > 0 ? '+' : '0';
        }
        places[name] = onScreen(view_, view_.cube().placeOf(zone));
    }
    return places;
}

void LayoutReporter::write() {
    // Without the document, what is said of it would not go with what the window says.
    if (studio_.host().isAway() && (ofDocument_.is_null() || !studio_.host().isLasting())) {
        return;
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    if (!studio_.host().isAway()) {
        ofDocument_ = documentReport();
    }
    nlohmann::json widgets = nlohmann::json::object();
    nlohmann::json windows = nlohmann::json::object(); // the X server's names of those that are shown
    nlohmann::json disabled = nlohmann::json::array();
    nlohmann::json reports = nlohmann::json::object(); // what widgets say of themselves
    for (const QWidget* widget : QApplication::allWidgets()) {
        const QString name = widget->objectName();
        if (widget->isVisible() && !name.isEmpty() && !name.startsWith("qt_")) {
            widgets[name.toStdString()] = screenRect(*widget);
            if (widget->isWindow()) {
                windows[name.toStdString()] = widget->winId();
            }
            if (!widget->isEnabled()) {
                disabled.push_back(name.toStdString());
            }
            if (const QString said = reportOf(*widget); !said.isEmpty()) {
                reports[name.toStdString()] = said.toStdString();
            }
        }
    }
    const QWidget* focused = QApplication::focusWidget();
    const auto& view = studio_.view().shown();
    const Range sliceWindow = studio_.view().sliceWindow();
    nlohmann::json report{
        {"idle", studio_.isIdle()},
        {"loading", studio_.host().isLoading()},
        {"away", studio_.host().isAway()},
        {"lasting", studio_.host().isLasting()},
        {"tool", studio_.hand().tool().name().toStdString()},
        {"hint", studio_.hand().tool().hint().toStdString()},
        {"mode", render::name(view.mode)},
        {"camera",
         {{"azimuth", view.camera.azimuthDegrees},
          {"elevation", view.camera.elevationDegrees},
          {"roll", view.camera.rollDegrees},
          {"zoom", view.camera.zoom},
          {"projection", render::kProjections.at(std::size_t(view.camera.projection))},
          {"pan", {view.camera.panMm.x, view.camera.panMm.y}}}},
        {"cube", studio_.host().geometry() != nullptr ? zonesOnScreen() : nlohmann::json::object()},
        {"range", {view.range.lo, view.range.hi}},
        {"sliceWindow", {sliceWindow.lo, sliceWindow.hi}},
        {"tintsSlices", view.tintsSlices},
        {"playing", studio_.growth().isPlaying()},
        {"smooth", view.sampling == field::Sampling::Tricubic},
        {"historyRow", historyRowHeight()},
        {"message", studio_.host().message().toStdString()},
        {"desktopLight", isDesktopLight()},
        {"focus", focused != nullptr ? focused->objectName().toStdString() : std::string()},
        {"title", window_.windowTitle().toStdString()},
        {"viewRect", view_.isVisible() ? screenRect(view_) : nlohmann::json::array()},
        {"viewport", {studio_.picture().viewport().x, studio_.picture().viewport().y}},
        {"crosshair",
         {studio_.slices().crosshair().x, studio_.slices().crosshair().y, studio_.slices().crosshair().z}},
        {"measurements", measured(tools_.get<MeasureTool>())},
        {"fence", fence_.window()},
        {"passed", fence_.passed()},
        {"windows", windows},
        {"disabled", disabled},
        {"reports", reports},
        {"widgets", widgets}};
    report.update(ofDocument_);
    const std::string text = report.dump(1);
    if (text == written_) {
        return;
    }
    try {
        writeFileAtomically(path_, text);
        written_ = text;
    } catch (const Error& e) {
        logNotice(e.what());
        timer_.stop(); // once is enough to be told
    }
}

} // namespace vs::desktop
