// SPDX-License-Identifier: Apache-2.0
#include "window_states.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QTest>
#include <QToolButton>

namespace vs::desktop {

namespace {

QList<QWidget*> visible(QWidget& within) {
    QList<QWidget*> found;
    for (QWidget* widget : within.findChildren<QWidget*>()) {
        if (widget->isVisible() && !widget->objectName().startsWith("qt_")) {
            found << widget;
        }
    }
    return found;
}

void letSettle() {
    for (int n = 0; n < 3; ++n) { // layouts ask for one another
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
    }
}

} // namespace

std::string described(const QWidget& widget) {
    QString text;
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        text = label->text();
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        text = button->text();
    }
    return QString("%1 '%2' (%3) in '%4'")
        .arg(widget.metaObject()->className(), widget.objectName(), text,
             widget.parentWidget() != nullptr ? widget.parentWidget()->objectName() : QString())
        .toStdString();
}

void forEachState(StudioWindow& w,
                  const std::function<void(const std::string&, const QList<QWidget*>&)>& look) {
    const auto lookAt = [&](const std::string& name) {
        letSettle();
        look(name, visible(w.window()));
    };
    w.window().resize(1440, 900);
    w.open();
    for (auto* fold : w.window().findChildren<QToolButton*>()) {
        if (fold->property("fold").toBool() && !fold->isChecked()) {
            fold->click();
        }
    }
    for (const char* tool :
         {"cameraTool", "peelTool", "drillTool", "laserTool", "sweepTool", "scissorsTool", "clipTool",
          "keepTool", "seedTool", "islandTool", "paintTool", "measureTool", "moveTool", "markTool"}) {
        w.trigger(tool);
        lookAt(tool);
    }
    w.trigger("cameraTool");
    for (const char* page : {"tabIntensity", "tabGradient", "tabBoth", "tabRange"}) {
        if (auto* button = w.window().findChild<QAbstractButton*>(page)) {
            button->click();
            lookAt(page);
        }
    }
    w.trigger("slices");
    w.trigger("showHistory");
    lookAt("slices and history");
    w.trigger("showHistory");
    w.trigger("only3D");
    for (const char* dialog : {"preferences", "shortcuts", "exportPicture", "about"}) {
        w.trigger(dialog);
        StudioWindow::wait(dialog, [] { return QApplication::activeModalWidget() != nullptr; });
        QWidget* shown = QApplication::activeModalWidget();
        letSettle();
        look(dialog, visible(*shown));
        shown->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    w.window().resize(1100, 760);
    letSettle();
}

} // namespace vs::desktop
