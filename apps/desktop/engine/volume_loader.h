// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/finer_levels.h"
#include "studio/json/session_state.h"

#include <QObject>

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace vs::desktop {

// Sculpting from nothing: what is there at first.
struct NewBlock {
    studio::Session::Block block;
    sculpt::Precision precision = sculpt::Precision::Bits16;
    bool isBuiltUp = false; // what is cut is what is seen
};

// What to open: a volume, a session (which names its volume), the journal of a document that was not closed,
// or a new block.
struct OpenRequest {
    std::filesystem::path volume;
    std::filesystem::path session;
    std::string rawLayout;
    std::string series;
    std::optional<int> frame;
    std::optional<int> level = {};   // of a store of OME-Zarr
    std::optional<int> channel = {}; // of a store or a stack
    std::filesystem::path journal = {};
    std::optional<NewBlock> block = {};
    std::optional<phantom::Recipe> phantom = {}; // what a session's volume was made by
    // A session that no file has, instead of one that is named: a case that comes with the program.
    std::shared_ptr<const studio::Session> given = {};
    // Where a session's volume is looked for that is not where the session says.
    std::vector<std::filesystem::path> folders = {};
    bool isPlayed = false; // a session's operations are not done at once, but before one's eyes
    studio::MemoryBudgets budgets = {};
    std::string stateTrouble = {}; // why a session's operations are done again although it has a state
};

struct Loaded {
    OpenRequest request;
    volume::Volume volume;
    std::optional<studio::Session> session;
    std::optional<studio::DocumentState> state; // what the session's operations led to, if it was saved
    std::vector<std::string> notices;
    std::string checksum; // of the volume
    // The session was told to another level than its file speaks of.
    bool isOfAnotherLevel = false;
    std::optional<studio::FinerLevels> finer; // than the level that was read, where a store has them
};

// Reads volumes on a thread of its own, so that the window answers meanwhile. No OpenGL here: a volume is
// uploaded by the document, on the window's thread.
class VolumeLoader : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    // Begins to read. Must not be called while isLoading(): one volume is read at a time.
    void start(const OpenRequest& request);
    [[nodiscard]] bool isLoading() const { return isLoading_; }
    // Asks for reading to stop: it ends with givenUp() the next time that it reports how far it is.
    void giveUp() { isGivenUp_ = true; }

signals:
    void loaded(const std::shared_ptr<vs::desktop::Loaded>& result);
    void failed(const QString& message);
    void givenUp();
    // The volume of the request is one of several; a request that names its series would do.
    void severalSeries(const vs::desktop::OpenRequest& request,
                       const std::vector<vs::volume::SeriesChoice>& choices);

    // The session's volume is neither where the session says nor where else it was looked for.
    void volumeMissing(const vs::desktop::OpenRequest& request, const std::filesystem::path& wanted);

private:
    struct Ending {
        QString error;                             // none: it was read
        std::vector<volume::SeriesChoice> choices; // of which one has to be chosen
        std::filesystem::path missing;             // the session's volume, where it was
    };
    void finish(const std::shared_ptr<Loaded>& result, const Ending& ending);

    bool isLoading_ = false;
    std::atomic<bool> isGivenUp_ = false;
    std::jthread worker_;
};

} // namespace vs::desktop
