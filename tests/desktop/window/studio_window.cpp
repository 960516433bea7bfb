// SPDX-License-Identifier: Apache-2.0
#include "studio_window.h"

#include "tools/camera_tool.h"
#include "view/view_widget.h"

#include "base/error.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QTabletEvent>
#include <QTest>

namespace vs::desktop {

namespace {

using Device = QInputDevice::DeviceType;
using Pointer = QPointingDevice::PointerType;
constexpr QInputDevice::Capabilities kPenCan =
    QInputDevice::Capability::Position | QInputDevice::Capability::Pressure |
    QInputDevice::Capability::XTilt | QInputDevice::Capability::YTilt | QInputDevice::Capability::Hover;

} // namespace

std::filesystem::path StudioWindow::folder;
std::filesystem::path StudioWindow::volume;

StudioWindow& StudioWindow::instance() {
    static auto* window = new StudioWindow; // closed by main, before the QApplication goes
    return *window;
}

StudioWindow::StudioWindow()
    : tip_("tablet tip", 1001, Device::Stylus, Pointer::Pen, kPenCan, 1, 3),
      eraser_("tablet eraser", 1002, Device::Stylus, Pointer::Eraser, kPenCan, 1, 3),
      screen_(QTest::createTouchDevice()) {
    studio_ = std::make_unique<StudioController>();
    tools_ = new ToolBox(*studio_);
    window_ = std::make_unique<MainWindow>(*studio_, *tools_);
    window_->resize(1100, 760);
    window_->show();
}

void StudioWindow::close() {
    studio_->files().close();
    window_.reset();
    studio_.reset();
}

QWidget& StudioWindow::part(const char* name) {
    auto* found = window_->findChild<QWidget*>(name);
    if (found == nullptr) {
        throw Error("the window has no widget {}", name);
    }
    return *found;
}

void StudioWindow::wait(const char* what, const std::function<bool()>& condition) {
    constexpr int kLongMs = 90000;
    if (!QTest::qWaitFor(condition, kLongMs)) {
        throw Error("waited {} ms for {}", kLongMs, what);
    }
}

// A hint of another length may give the view another size.
void StudioWindow::settle() {
    const double done = Timer::now();
    studio_->host().workSoon();
    const auto isSettled = [&] { return studio_->isSettled() && studio_->answeredMs() >= done; };
    wait("the document to be shown", isSettled);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    wait("the document to be shown again", isSettled);
}

void StudioWindow::rest() {
    wait("the program to be idle", [this] { return studio_->isIdle(); });
}

void StudioWindow::open() {
    leaveTablet();
    studio_->files().close();
    OpenRequest request;
    request.volume = volume;
    studio_->files().open(request);
    wait("the volume",
         [this] { return studio_->host().document() != nullptr && !studio_->host().isLoading(); });
    studio_->hand().take(tools_->get<CameraTool>());
    settle();
}

void StudioWindow::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(window_.get(), key, modifiers);
}

void StudioWindow::trigger(const char* action) {
    auto* found = window_->findChild<QAction*>(action);
    if (found == nullptr || !found->isEnabled()) {
        throw Error("the action {} is {}", action, found == nullptr ? "not there" : "disabled");
    }
    found->trigger();
}

void StudioWindow::photograph(QWidget& widget, const std::string& name) {
    widget.grab().save(QString::fromStdString((folder / (name + ".png")).string()));
}

void StudioWindow::pen(QEvent::Type type, QWidget& widget, const Touch& touch, End end) {
    const QPointF place(touch.place.x() * widget.width(), touch.place.y() * widget.height());
    const QPointF inWindow = QPointF(widget.mapTo(window_.get(), QPoint(0, 0))) + place;
    const QPointF onScreen = QPointF(window_->mapToGlobal(QPoint(0, 0))) + inWindow;
    const bool isDown = touch.pressure > 0 && type != QEvent::TabletRelease;
    const auto button = type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton;
    QTabletEvent event(type, end == End::Tip ? &tip_ : &eraser_, inWindow, onScreen, touch.pressure,
                       float(touch.tilt.x()), float(touch.tilt.y()), 0, 0, 0, Qt::NoModifier, button,
                       isDown ? Qt::LeftButton : Qt::NoButton);
    QApplication::sendEvent(window_->windowHandle(), &event); // Qt's own way from there to the widget
}

void StudioWindow::stroke(QWidget& widget, const std::vector<Touch>& way, End end) {
    settle();                                                  // a tool was perhaps chosen just now
    pen(QEvent::TabletMove, widget, {way.front().place}, end); // hovering
    pen(QEvent::TabletPress, widget, way.front(), end);
    for (std::size_t n = 1; n < way.size(); ++n) {
        QCoreApplication::processEvents(); // the program works between two reports
        pen(QEvent::TabletMove, widget, way[n], end);
    }
    pen(QEvent::TabletRelease, widget, {way.back().place}, end);
}

void StudioWindow::leaveTablet(End end) {
    QTabletEvent event(QEvent::TabletLeaveProximity, end == End::Tip ? &tip_ : &eraser_, {}, {}, 0, 0, 0, 0,
                       0, 0, Qt::NoModifier, Qt::NoButton, Qt::NoButton);
    QApplication::sendEvent(qApp, &event);
}

void StudioWindow::drawMask(double halfWidth) {
    const double w = halfWidth;
    stroke(view(), {{{0.5 - w, 0.5 - w}, 0.5},
                    {{0.5 + w, 0.5 - w}, 0.5},
                    {{0.5 + w, 0.5 + w}, 0.5},
                    {{0.5 - w, 0.5 + w}, 0.5}});
}

void StudioWindow::fingers(QWidget& widget, const std::vector<QPointF>& places) {
    auto sequence = QTest::touchEvent(window_->windowHandle(), screen_, false);
    const auto inWindow = [&](QPointF place) { return widget.mapTo(window_.get(), place.toPoint()); };
    for (std::size_t id = 0; id < std::max(places.size(), down_.size()); ++id) {
        if (id >= places.size()) {
            sequence.release(int(id), inWindow(down_[id]));
        } else if (id >= down_.size()) {
            sequence.press(int(id), inWindow(places[id]));
        } else {
            sequence.move(int(id), inWindow(places[id]));
        }
    }
    sequence.commit(true);
    down_ = places;
}

} // namespace vs::desktop
