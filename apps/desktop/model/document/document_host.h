// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/gl_host.h"
#include "engine/long_work.h"

#include "base/timer.h"
#include "volume/grid/geometry.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

namespace vs::studio {
class Document;
struct DocumentFacts;
} // namespace vs::studio
namespace vs::volume {
struct Volume;
} // namespace vs::volume

namespace vs::desktop {

// Has the open document and the engine's context, and runs all work on them: everything in the window that
// reads or changes the document does it through here. Says what became of it, to whoever shows messages.
//
// Work that may last goes through workLong(): the document is away meanwhile, on a thread of its own, and the
// window paints. Work that is over at once goes through guard(). Both turn what is thrown into the message.
class DocumentHost : public QObject {
    Q_OBJECT

public:
    // Needs a QApplication. Throws GlError if there is no OpenGL 4.5.
    DocumentHost();
    ~DocumentHost() override;

    [[nodiscard]] GlHost& gl() { return gl_; }
    // The open document, with the engine's context current; null before something was opened. Waits while the
    // document is away.
    [[nodiscard]] studio::Document* document();
    // The volume that is open, where its voxels lie, and where they do by its file; null before something was
    // opened. Also while the document is away, which may correct the geometry in `volume` meanwhile: ask here
    // for it.
    [[nodiscard]] const volume::Volume* volume() const;
    [[nodiscard]] const volume::GridGeometry* geometry() const;
    [[nodiscard]] const volume::GridGeometry* geometryInFile() const;
    // What is known of the document, as it was when it was last here: what panels show, also while it is
    // away. Never null; before something was opened, those of nothing.
    [[nodiscard]] std::shared_ptr<const studio::DocumentFacts> facts() const;
    // Another document, or none. What looks into the former one lets go of it first (leaving()).
    void replace(std::unique_ptr<studio::Document> document);

    // Whether long work has the document: nothing else can be done with it.
    [[nodiscard]] bool isAway() const { return longWork_.isRunning(); }
    // Whether work is under way that lasts, so that all that a person can do is to give it up.
    [[nodiscard]] bool isLasting() const { return longWork_.isShown(); }
    // What is being opened: first the file is read, then a session's operations are done again.
    enum class Opening { Nothing, Reading, Replaying };
    [[nodiscard]] bool isLoading() const { return opening_ != Opening::Nothing; }
    [[nodiscard]] bool isReplaying() const { return opening_ == Opening::Replaying; }
    void setOpening(Opening opening) { opening_ = opening; }

    // The graphics driver was reset: nothing can be done with the document any more.
    [[nodiscard]] bool isDeviceLost() const { return isDeviceLost_; }

    // Does something with the document at once. False: it failed, and the message says why.
    bool guard(const std::function<void()>& work);
    // Does something with the document that may take long while the window goes on painting and input waits
    // (LongWork). False: it failed, and the message says why.
    bool workLong(const std::function<void()>& work, LongWork::Input input = LongWork::Input::Waits);
    // Does something with the document that may take long, as workLong() does, but throws what it throws.
    void runLong(const std::function<void()>& work, LongWork::Input input = LongWork::Input::Waits);
    // Does something now, or once the document is back: for what ends on other threads.
    void whenHere(std::function<void()> work);
    // Does what waited for the document. Called by the scheduler when it is here.
    void doWaiting();
    // Ends what takes long, if it can be ended: as if it had not been begun.
    void giveUp();

    void say(const QString& message);
    [[nodiscard]] const QString& message() const { return message_; }
    // Says that a person did something: it is answered soon, by a draft.
    void wake();
    // Whether a person did something within the last moment: that is answered first, and what goes on by
    // itself gives way.
    [[nodiscard]] bool isHandAtWork() const;
    // Says that something beside the picture waits to be done.
    void workSoon() { emit workWaits(); }
    // Emits changed() with the next picture: painting a label alone costs the window as much as painting all
    // of it.
    void tellSoon();
    [[nodiscard]] bool isToldSoon() const { return isToldSoon_; }
    void tell(); // what tellSoon() left

signals:
    void leaving(); // the document is about to go: what looks into it lets go
    void ready();   // there is a document that can be shown
    void opened();
    void closing(); // a person closes the document: what is in hand is dropped
    void closed();
    void emptied(); // after a document was closed, when all have heard of it: nothing is shown any more
    void openFailed(const QString& message);
    void changed(); // document, view, tool or playback: panels and actions look again
    // Where the voxels lie was corrected, or that was taken back: they lay there `before`.
    void corrected(const volume::GridGeometry& before);
    void messageChanged();
    void progress(int done, int total); // total 0: unknown; done == total > 0: finished
    void givenUp();                     // what goes on by itself ends
    void deviceLost();                  // told once; the journal has all that was done
    void woken();
    void workWaits();

private:
    void publish() const; // the facts; the document must be here
    void noticeCorrection();

    GlHost gl_;
    LongWork longWork_{gl_};
    std::unique_ptr<studio::Document> document_;
    mutable std::shared_ptr<const studio::DocumentFacts> facts_; // as they were last published
    mutable volume::GridGeometry geometry_; // of those who ask for it: stays where it is in memory
    volume::GridGeometry toldGeometry_;     // that all have heard of
    Opening opening_ = Opening::Nothing;
    std::vector<std::function<void()>> waiting_; // for the document to be back
    QString message_;
    bool isToldSoon_ = false;
    bool isDeviceLost_ = false;
    Timer sinceWoken_;
};

} // namespace vs::desktop
