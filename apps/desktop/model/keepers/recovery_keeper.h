// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/json/journal.h"

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace vs::desktop {

class StudioController;

// What a run of the program that did not end well has left behind.
struct LostWork {
    std::filesystem::path journal;
    QString name; // of the volume
    QDateTime when;
    int edits = 0;
    QString problem; // empty: it can be recovered
};

// Keeps the journal of the open document in the user's state folder, from opening to a clean close, and
// brings back what another run has left there. Every journal has a lock beside it, so that two windows keep
// off each other's.
class RecoveryKeeper : public QObject {
    Q_OBJECT

public:
    explicit RecoveryKeeper(StudioController& studio);
    ~RecoveryKeeper() override;

    // The newest first. Journals of running programs are left out, those without unsaved edits removed.
    [[nodiscard]] static std::vector<LostWork> lostWork();
    // Throws lost work away. False: another window has it in hand.
    static bool discard(const LostWork& lost);
    // Opens the lost document and does its edits again. Its journal stays until that is done. False: another
    // window has it in hand.
    bool recover(const LostWork& lost);
    // The document is left on purpose: nothing is to be recovered.
    void finish();

private:
    void begin();
    void follow();
    void noteSaved();
    void endRecovery(bool isDone);
    void complain(const char* problem);

    StudioController& studio_;
    std::unique_ptr<QLockFile> lock_;
    std::unique_ptr<studio::Journal> journal_;
    bool isReplaying_ = false;
    // The lock and the file of the document that is being recovered.
    std::unique_ptr<QLockFile> recoveredLock_;
    std::filesystem::path recovered_;
};

} // namespace vs::desktop
