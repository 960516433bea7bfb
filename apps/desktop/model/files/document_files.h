// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/volume_loader.h"

#include "studio/json/session.h"

#include <QObject>

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vs::desktop {

class CameraMotion;
class DocumentHost;
class Editor;
class GrowthController;
class Hand;
class Notices;
class SegmentController;
class ViewModel;

// Opens volumes and sessions, saves sessions and label maps, and knows where the open document comes from.
class DocumentFiles : public QObject {
    Q_OBJECT

public:
    // What of the model it asks and tells.
    struct Model {
        DocumentHost& host;
        Notices& notices;
        ViewModel& view;
        CameraMotion& camera;
        Hand& hand;
        Editor& editor;
        GrowthController& growth;
        SegmentController& segments;
    };
    explicit DocumentFiles(const Model& model);

    // Asks where to look for volumes of sessions that are not where the sessions say.
    void searchIn(std::function<std::vector<std::filesystem::path>()> folders) {
        folders_ = std::move(folders);
    }
    // What volumes and edits may take from now on; and what they may where that says nothing.
    void limitMemory(const studio::MemoryBudgets& budgets) { budgets_ = budgets; }
    void preferMemory(const studio::MemoryBudgets& budgets) { preferred_ = budgets; }
    // Returns at once; DocumentHost::opened() or openFailed() tells how it ended.
    void open(const OpenRequest& request);
    [[nodiscard]] const OpenRequest& source() const { return source_; }
    // Where the volume comes from, as a session without operations. There must be a volume.
    [[nodiscard]] studio::Session provenance() const;
    bool saveSession(const std::filesystem::path& path);
    bool exportLabels(const std::filesystem::path& path);
    // Back to how it was before anything was opened; what was not saved is gone.
    void close();
    // Whether there are edits that no session file holds.
    [[nodiscard]] bool hasUnsavedEdits() const;
    // Does the next operation of the session that is being opened. Called by the scheduler.
    void replayOne();
    // What has been done so far is in a file, or comes with the program: nobody need save it.
    void takeAsSaved() { savedEdits_ = countEdits(); }

signals:
    // A session was opened to be played: its volume is there, and nothing was done yet.
    void playable(const std::vector<vs::studio::Operation>& operations);
    void saved(); // a session file holds all edits; source() names it
    // Nothing was opened: the person must choose one of the series first.
    void seriesWanted(const vs::desktop::OpenRequest& request,
                      const std::vector<vs::volume::SeriesChoice>& choices);

    // Nothing was opened: the session's volume is not where the session says, and the person must say where.
    void volumeWanted(const vs::desktop::OpenRequest& request, const std::filesystem::path& wanted);

private:
    void connectLoader();
    [[nodiscard]] static QString begun(const OpenRequest& request);
    void finishOpening(const std::shared_ptr<Loaded>& loaded);
    void takeSource(const studio::Session& session, bool isOfAnotherLevel);
    void takeOperations(const studio::Session& session);
    void finishReplay(const QString& error, bool isGivenUp);
    void endReading();
    [[nodiscard]] std::size_t countEdits() const;

    std::function<std::vector<std::filesystem::path>()> folders_;
    Model model_;
    DocumentHost& host_;
    VolumeLoader loader_;
    studio::MemoryBudgets budgets_;
    studio::MemoryBudgets preferred_;
    OpenRequest source_;
    std::string checksum_;                 // of the volume
    std::size_t savedEdits_ = 0;           // edits in the log when it was last saved or opened
    std::deque<studio::Operation> replay_; // of the session being opened
    int replayTotal_ = 0;
    bool isReplayGivenUp_ = false;
};

} // namespace vs::desktop
