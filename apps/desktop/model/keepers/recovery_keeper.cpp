// SPDX-License-Identifier: Apache-2.0
#include "model/keepers/recovery_keeper.h"

#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"

#include "base/error.h"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>

#include <algorithm>

namespace vs::desktop {

namespace {

// The XDG state folder, which Qt knows of only from 6.7 on.
QString journalFolder() {
    const QString state = qEnvironmentVariable("XDG_STATE_HOME", QDir::homePath() + "/.local/state");
    return state + "/volume-studio/journals";
}

// Held by nobody else, or null. A lock of a process that has died does not count.
std::unique_ptr<QLockFile> lockOf(const std::filesystem::path& journal) {
    auto lock = std::make_unique<QLockFile>(QString::fromStdString(journal.string()) + ".lock");
    lock->setStaleLockTime(0); // however long it has been held
    return lock->tryLock(0) ? std::move(lock) : nullptr;
}

void removeJournal(const std::filesystem::path& journal) {
    std::error_code ignored;
    std::filesystem::remove(journal, ignored);
}

LostWork describe(const QFileInfo& file) {
    LostWork lost;
    lost.journal = file.filePath().toStdString();
    lost.when = file.lastModified();
    try {
        const auto content = studio::readJournal(lost.journal);
        lost.edits = int(content.unsavedEdits());
        lost.name = content.session.isMade()
                        ? tr("Made from nothing")
                        : QString::fromStdString(content.session.volumePath.filename().string());
        if (!content.session.isMade() && !std::filesystem::exists(content.session.volumePath)) {
            lost.problem = tr("its volume %1 is not there")
                               .arg(QString::fromStdString(content.session.volumePath.string()));
        }
    } catch (const std::exception& e) {
        lost.name = file.fileName();
        lost.problem = QString::fromUtf8(e.what());
    }
    return lost;
}

} // namespace

RecoveryKeeper::RecoveryKeeper(StudioController& studio) : QObject(&studio), studio_(studio) {
    connect(&studio.host(), &DocumentHost::opened, this, &RecoveryKeeper::begin);
    connect(&studio.host(), &DocumentHost::changed, this, &RecoveryKeeper::follow);
    connect(&studio.files(), &DocumentFiles::saved, this, &RecoveryKeeper::noteSaved);
    connect(&studio.host(), &DocumentHost::closed, this, &RecoveryKeeper::finish);
    connect(&studio.host(), &DocumentHost::openFailed, this, [this] { endRecovery(false); });
    connect(&studio.host(), &DocumentHost::givenUp, this, [this] { endRecovery(false); });
}

// Without finish() the journal stays: the program ends by an error.
RecoveryKeeper::~RecoveryKeeper() = default;

std::vector<LostWork> RecoveryKeeper::lostWork() {
    std::vector<LostWork> all;
    for (QDirIterator it(journalFolder(), {"*.jsonl"}, QDir::Files); it.hasNext();) {
        const QFileInfo file(it.next());
        const std::filesystem::path path = file.filePath().toStdString();
        if (const auto lock = lockOf(path)) {
            const LostWork lost = describe(file);
            if (lost.edits > 0 || !lost.problem.isEmpty()) {
                all.push_back(lost);
            } else {
                removeJournal(path);
            }
        }
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.when > b.when; });
    return all;
}

bool RecoveryKeeper::discard(const LostWork& lost) {
    const auto lock = lockOf(lost.journal);
    if (lock) {
        removeJournal(lost.journal);
    }
    return lock != nullptr;
}

bool RecoveryKeeper::recover(const LostWork& lost) {
    auto lock = lockOf(lost.journal);
    if (!lock || studio_.host().isLoading()) {
        return false;
    }
    recoveredLock_ = std::move(lock);
    recovered_ = lost.journal;
    OpenRequest request;
    request.journal = lost.journal;
    studio_.files().open(request);
    return true;
}

void RecoveryKeeper::begin() {
    finish();
    isReplaying_ = studio_.host().isReplaying();
    // The process, the time and a number: no two are the same.
    static int count = 0;
    const QString name = QString("%1-%2-%3.jsonl")
                             .arg(QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss"))
                             .arg(QCoreApplication::applicationPid())
                             .arg(++count);
    const std::filesystem::path path = (journalFolder() + "/" + name).toStdString();
    QDir().mkpath(journalFolder());
    lock_ = lockOf(path);
    try {
        journal_ = std::make_unique<studio::Journal>(path, studio_.files().provenance());
    } catch (const std::exception& e) {
        complain(e.what());
    }
    follow();
    // What was opened from its state is in its file.
    if (!isReplaying_ && !studio_.files().source().session.empty() && !studio_.files().hasUnsavedEdits()) {
        noteSaved();
    }
}

void RecoveryKeeper::follow() {
    if (journal_ == nullptr || studio_.host().document() == nullptr) {
        return;
    }
    try {
        journal_->follow(studio_.host().document()->log());
    } catch (const std::exception& e) {
        complain(e.what());
        return;
    }
    // A session that has been replayed whole is in its file; what was recovered is in none.
    if (std::exchange(isReplaying_, studio_.host().isReplaying()) && !studio_.host().isReplaying()) {
        if (!studio_.files().hasUnsavedEdits() && !studio_.files().source().session.empty()) {
            noteSaved();
        }
        endRecovery(true);
    }
}

void RecoveryKeeper::noteSaved() {
    if (journal_ != nullptr) {
        try {
            journal_->follow(studio_.host().document()->log());
            journal_->noteSaved(std::filesystem::absolute(studio_.files().source().session));
        } catch (const std::exception& e) {
            complain(e.what());
        }
    }
}

// The old journal goes only when all of it is in the new one.
void RecoveryKeeper::endRecovery(bool isDone) {
    if (recoveredLock_ && isDone && studio_.files().hasUnsavedEdits()) {
        removeJournal(recovered_);
    }
    recoveredLock_.reset();
}

void RecoveryKeeper::finish() {
    if (journal_ != nullptr) {
        removeJournal(journal_->path());
        journal_.reset();
    }
    lock_.reset(); // which also removes its file
}

// Once: without a journal the work goes on.
void RecoveryKeeper::complain(const char* problem) {
    journal_.reset();
    studio_.host().say(QString::fromUtf8(problem));
}

} // namespace vs::desktop
