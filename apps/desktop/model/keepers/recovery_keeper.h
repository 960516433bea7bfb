// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/volume_loader.h"

#include "studio/json/journal.h"
#include "studio/json/lost_work.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <optional>

namespace vs::desktop {

class StudioController;

// Keeps the journal of the open document in the user's state folder, from opening to a clean close, and
// brings back what another run has left there. While the journal cannot be written it says so, and tries
// again.
class RecoveryKeeper : public QObject {
    Q_OBJECT

public:
    explicit RecoveryKeeper(StudioController& studio);
    ~RecoveryKeeper() override;

    // Opens the lost document of the request's journal and does its edits again. Its journal stays until that
    // is done. False: another window has it in hand.
    bool recover(const OpenRequest& request);
    // The document is left on purpose: nothing is to be recovered.
    void finish();
    // Why what is done now would be lost in a crash; empty: it would not.
    [[nodiscard]] const QString& trouble() const { return trouble_; }

signals:
    void troubleChanged();

private:
    void begin();
    void follow();
    void write();
    void endRecovery(bool isDone);
    void setTrouble(const QString& trouble);

    StudioController& studio_;
    std::optional<studio::Journal> journal_;
    std::filesystem::path notedAsSaved_; // by the journal; empty: it has edits that no session file holds
    QString trouble_;
    QTimer retry_;
    bool isReplaying_ = false;
    std::optional<studio::HeldJournal> recovered_; // of the document that is being recovered
    bool isDamaged_ = false;                       // and not all of it could be read
};

} // namespace vs::desktop
