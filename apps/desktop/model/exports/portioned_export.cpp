// SPDX-License-Identifier: Apache-2.0
#include "model/exports/portioned_export.h"

#include "model/studio/studio_controller.h"

namespace vs::desktop {

PortionedExport::PortionedExport(StudioController& studio) : studio_(studio) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, [this] {
        if (isRunning_) {
            tick();
        }
    });
}

void PortionedExport::start() {
    isRunning_ = true;
    goOn();
}

void PortionedExport::end(bool isDone, const QString& message) {
    timer_.stop();
    isRunning_ = false;
    letGo();
    emit finished(isDone, message);
}

void PortionedExport::keepVersion() { version_ = studio_.host().document()->version(); }

bool PortionedExport::hasChanged() const {
    const auto* document = studio_.host().document();
    return document == nullptr || document->version() != version_;
}

} // namespace vs::desktop
