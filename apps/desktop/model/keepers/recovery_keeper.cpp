// SPDX-License-Identifier: Apache-2.0
#include "model/keepers/recovery_keeper.h"

#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"

#include "base/error.h"
#include "base/log.h"

#include <QCoreApplication>
#include <QDateTime>

namespace vs::desktop {

namespace {

constexpr int kRetryMs = 3000;

// The process, the time and a number: no two are the same.
std::filesystem::path newJournal() {
    static int count = 0;
    const QString name = QString("%1-%2-%3.jsonl")
                             .arg(QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss"))
                             .arg(QCoreApplication::applicationPid())
                             .arg(++count);
    return studio::journalFolder() / name.toStdString();
}

} // namespace

RecoveryKeeper::RecoveryKeeper(StudioController& studio) : QObject(&studio), studio_(studio) {
    connect(&studio.host(), &DocumentHost::opened, this, &RecoveryKeeper::begin);
    connect(&studio.host(), &DocumentHost::changed, this, &RecoveryKeeper::follow);
    connect(&studio.files(), &DocumentFiles::saved, this, &RecoveryKeeper::write);
    connect(&studio.host(), &DocumentHost::closed, this, &RecoveryKeeper::finish);
    connect(&studio.host(), &DocumentHost::openFailed, this, [this] { endRecovery(false); });
    connect(&studio.host(), &DocumentHost::givenUp, this, [this] { endRecovery(false); });
    connect(&studio.files(), &DocumentFiles::volumeWanted, this, [this] { endRecovery(false); });
    retry_.setInterval(kRetryMs);
    connect(&retry_, &QTimer::timeout, this, &RecoveryKeeper::write);
}

// Without finish() the journal stays: the program ends by an error.
RecoveryKeeper::~RecoveryKeeper() = default;

bool RecoveryKeeper::recover(const OpenRequest& request) {
    auto held = studio::HeldJournal::hold(request.journal);
    if (!held || studio_.host().isLoading()) {
        return false;
    }
    recovered_ = std::move(held);
    isDamaged_ = !studio::describeJournal(request.journal).leftOut.empty();
    studio_.files().open(request);
    return true;
}

void RecoveryKeeper::begin() {
    finish();
    isReplaying_ = studio_.host().isReplaying();
    write();
    if (!isReplaying_) { // there was nothing to do again
        endRecovery(trouble_.isEmpty());
    }
}

void RecoveryKeeper::follow() {
    if (!journal_ && trouble_.isEmpty()) {
        return; // nothing is open
    }
    write();
    if (std::exchange(isReplaying_, studio_.host().isReplaying()) && !studio_.host().isReplaying()) {
        endRecovery(trouble_.isEmpty());
    }
}

// Brings the journal up to what the document is now, from wherever trouble has left it.
void RecoveryKeeper::write() {
    const auto* document = studio_.host().document();
    if (document == nullptr) {
        return;
    }
    const auto& files = studio_.files();
    try {
        if (!journal_ || !journal_->isThere()) {
            journal_.reset();
            notedAsSaved_.clear();
            journal_.emplace(newJournal(), files.provenance());
        }
        journal_->follow(document->log());
        // What was opened from its state, or replayed whole, is in its file; what was recovered is in none.
        const auto& session = files.source().session;
        const bool isSaved = !studio_.host().isReplaying() && !files.hasUnsavedEdits() && !session.empty();
        const auto holder = isSaved ? std::filesystem::absolute(session) : std::filesystem::path();
        if (isSaved && holder != notedAsSaved_) {
            journal_->noteSaved(holder);
        }
        notedAsSaved_ = holder;
        setTrouble({});
    } catch (const std::exception& e) {
        setTrouble(QString::fromUtf8(e.what()));
    }
}

// The old journal goes only when all of it is in the new one.
void RecoveryKeeper::endRecovery(bool isDone) {
    if (recovered_ && isDone && isDamaged_) {
        try {
            studio_.notices().add({"the damaged journal is kept as " + recovered_->setAside().string()});
        } catch (const std::exception& e) {
            studio_.notices().add({e.what()});
        }
    } else if (recovered_ && isDone) {
        recovered_->remove();
    }
    recovered_.reset();
}

void RecoveryKeeper::finish() {
    if (journal_) {
        std::error_code ignored;
        std::filesystem::remove(journal_->path(), ignored);
        journal_.reset();
    }
    notedAsSaved_.clear();
    setTrouble({});
}

// The work goes on meanwhile.
void RecoveryKeeper::setTrouble(const QString& trouble) {
    if (trouble == trouble_) {
        return;
    }
    const bool isOver = trouble.isEmpty() && studio_.host().document() != nullptr;
    trouble_ = trouble;
    trouble.isEmpty() ? retry_.stop() : retry_.start();
    if (!trouble.isEmpty() || isOver) {
        studio_.host().say(isOver ? tr("The crash journal goes on") : trouble);
    }
    emit troubleChanged();
}

} // namespace vs::desktop
