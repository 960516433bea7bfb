// SPDX-License-Identifier: Apache-2.0
#include "model/keepers/rehearsal_keeper.h"

#include "base/error.h"
#include "base/log.h"
#include "model/document/document_host.h"
#include "studio/document/document.h"

#include <algorithm>

namespace vs::desktop {

RehearsalKeeper::RehearsalKeeper(DocumentHost& host) : host_(host) {
    constexpr int kWatchMs = 500;
    watch_.setInterval(kWatchMs);
    connect(&watch_, &QTimer::timeout, this, [this] {
        if (process_->hasEnded()) {
            watch_.stop();
        }
    });
    connect(&host_, &DocumentHost::ready, this, [this] { prepareFor(kindOf(host_.document()->field())); });
    prepareFor(ScanKind());
}

void RehearsalKeeper::prepareFor(const ScanKind& kind) {
    if (std::find(rehearsed_.begin(), rehearsed_.end(), kind) != rehearsed_.end()) {
        return;
    }
    rehearsed_.push_back(kind);
    try {
        process_ = ChildProcess::start(
            {"/proc/self/exe", kRehearse, host_.gl().device().renderer, toText(kind), kAside}, {});
        if (process_) {
            watch_.start();
        }
    } catch (const Error& error) { // then programs are compiled when they are needed
        logNotice(error.what());
    }
}

} // namespace vs::desktop
