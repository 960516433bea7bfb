// SPDX-License-Identifier: Apache-2.0
#include "model/exports/sliced_export.h"

#include "model/studio/studio_controller.h"

namespace vs::desktop {

SlicedExport::SlicedExport(StudioController& studio) : studio_(studio) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, [this] {
        if (isRunning_) {
            tick();
        }
    });
}

void SlicedExport::start() {
    isRunning_ = true;
    goOn();
}

void SlicedExport::end(bool isDone, const QString& message) {
    timer_.stop();
    isRunning_ = false;
    letGo();
    emit finished(isDone, message);
}

void SlicedExport::keepVersion() { version_ = studio_.host().document()->version(); }

bool SlicedExport::hasChanged() const {
    const auto* document = studio_.host().document();
    return document == nullptr || document->version() != version_;
}

} // namespace vs::desktop
