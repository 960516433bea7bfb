// SPDX-License-Identifier: Apache-2.0
#include "testing/latency_recorder.h"

#include "model/studio/studio_controller.h"
#include "view/view_widget.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/log.h"

#include <nlohmann/json.hpp>

#include <QApplication>
#include <QInputEvent>
#include <QTimer>

#include <cmath>

namespace vs::desktop {

namespace {

constexpr double kLongMs = 40;

const char* kindOf(const QEvent& event) {
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::TabletPress:
        return "press";
    case QEvent::MouseMove:
    case QEvent::TabletMove:
        return "move";
    case QEvent::MouseButtonRelease:
    case QEvent::TabletRelease:
        return "release";
    case QEvent::Wheel:
        return "wheel";
    case QEvent::KeyPress:
        return "key";
    default:
        return nullptr;
    }
}

// X servers stamp input with the low 32 bits of the steady clock's milliseconds.
double arrival(const QInputEvent& event, double nowMs) {
    constexpr double kWrap = 4294967296.0;
    const double arrived = std::floor(nowMs / kWrap) * kWrap + double(event.timestamp() & 0xffffffffu);
    return arrived > nowMs + 0.5 * kWrap ? arrived - kWrap : arrived;
}

} // namespace

LatencyRecorder::LatencyRecorder(WatchedApplication& application, StudioController& studio,
                                 const ViewWidget& view, std::filesystem::path path)
    : QObject(&studio), application_(application), studio_(studio), path_(std::move(path)) {
    application.installEventFilter(this);
    application.watch([this](const WatchedApplication::Busy& busy) {
        if (busy.milliseconds > kLongMs) {
            blocks_.push_back(busy);
        }
    });
    connect(&view, &ViewWidget::painted, this, &LatencyRecorder::notePainted);
    connect(qApp, &QCoreApplication::aboutToQuit, this, &LatencyRecorder::write);
}

LatencyRecorder::~LatencyRecorder() { application_.watch({}); }

bool LatencyRecorder::eventFilter(QObject* watched, QEvent* event) {
    const char* kind = kindOf(*event);
    if (kind != nullptr && event->spontaneous() && watched->isWindowType()) { // not again for each widget
        const double now = Timer::now();
        inputs_.push_back({kind, arrival(static_cast<QInputEvent&>(*event), now), now, 0});
    }
    return QObject::eventFilter(watched, event);
}

// The window system has the picture only once the event that painted it is done with.
void LatencyRecorder::notePainted() {
    const auto& loop = studio_.picture();
    const Frame frame{0, loop.pictures(), loop.shown().width(), loop.isComplete()};
    QTimer::singleShot(0, this, [this, frame, answeredMs = studio_.answeredMs()] {
        frames_.push_back(frame);
        frames_.back().shownMs = Timer::now();
        while (unanswered_ < inputs_.size() && inputs_[unanswered_].handledMs <= answeredMs) {
            inputs_[unanswered_++].shownMs = frames_.back().shownMs;
        }
    });
}

void LatencyRecorder::write() const {
    nlohmann::json inputs = nlohmann::json::array();
    for (const Input& input : inputs_) {
        inputs.push_back({{"kind", input.kind},
                          {"arrived", input.arrivedMs},
                          {"handled", input.handledMs},
                          {"shown", input.shownMs > 0 ? nlohmann::json(input.shownMs) : nlohmann::json()}});
    }
    nlohmann::json frames = nlohmann::json::array();
    for (const Frame& frame : frames_) {
        frames.push_back({{"shown", frame.shownMs},
                          {"picture", frame.picture},
                          {"width", frame.width},
                          {"isComplete", frame.isComplete}});
    }
    nlohmann::json blocks = nlohmann::json::array();
    for (const auto& block : blocks_) {
        blocks.push_back({{"began", block.beganMs},
                          {"ms", block.milliseconds},
                          {"threadMs", block.threadMs},
                          {"programMs", block.programMs},
                          {"receiver", block.receiver.toStdString()},
                          {"event", block.type}});
    }
    try {
        writeFileAtomically(
            path_, nlohmann::json{{"inputs", inputs}, {"frames", frames}, {"blocks", blocks}}.dump());
    } catch (const Error& e) {
        logNotice(e.what());
    }
}

} // namespace vs::desktop
