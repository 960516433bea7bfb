// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/child_process.h"
#include "engine/rehearsal.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <string>
#include <vector>

namespace vs::desktop {

class DocumentHost;

// Has what may be done next to the scan that is open rehearsed by a process of its own (engine/rehearsal.h),
// so that no hand waits for a compiler. It begins with the window, when no scan is known yet, for the kind
// that most are of, and anew for each kind that is opened.
class RehearsalKeeper : public QObject {
public:
    // The host must outlive it. The running program must be one that rehearses when it is asked to by
    // kRehearse.
    explicit RehearsalKeeper(DocumentHost& host);

    // The arguments that make a program rehearse(): the first, the renderer, the kind, and where it is to
    // standBack(), the second.
    static constexpr const char* kRehearse = "--rehearse";
    static constexpr const char* kAside = "aside";

private:
    void prepareFor(const ScanKind& kind);

    DocumentHost& host_;
    std::unique_ptr<ChildProcess> process_;
    std::vector<ScanKind> rehearsed_;
    QTimer watch_; // asks whether the process has ended
};

} // namespace vs::desktop
