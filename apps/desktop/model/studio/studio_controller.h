// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/picture_loop.h"
#include "model/document/camera_motion.h"
#include "model/document/document_host.h"
#include "model/document/notices.h"
#include "model/document/view_model.h"
#include "model/edits/editor.h"
#include "model/files/document_files.h"
#include "model/hand/hand.h"
#include "model/settings/preferences.h"
#include "studio/document/surface_queries.h"

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <optional>

namespace vs::desktop {

class GrowthController;
class SegmentController;
class SegmentMeasurer;
class SliceController;

// The model of the window: has its parts, and the one timer that does all work in short slices, so that input
// is handled between. No widgets. Everything runs on the window's thread but reading files and long work.
class StudioController : public QObject {
    Q_OBJECT

public:
    // Needs a QApplication. Throws GlError if there is no OpenGL 4.5.
    StudioController();
    ~StudioController() override;

    // --- parts, each of which knows only those before it
    [[nodiscard]] DocumentHost& host() { return host_; }
    [[nodiscard]] ViewModel& view() { return view_; }
    [[nodiscard]] Notices& notices() { return notices_; }
    [[nodiscard]] CameraMotion& camera() { return camera_; }
    [[nodiscard]] Hand& hand() { return hand_; }
    [[nodiscard]] Editor& editor() { return editor_; }
    [[nodiscard]] GrowthController& growth() { return *growth_; }
    [[nodiscard]] SegmentController& segments() { return *segments_; }
    [[nodiscard]] SegmentMeasurer& measurer() { return *measurer_; }
    [[nodiscard]] SliceController& slices() { return *slices_; }
    [[nodiscard]] DocumentFiles& files() { return *files_; }
    [[nodiscard]] PictureLoop& picture() { return *picture_; }

    // Undo's memory counts for the open document too, quality and shadows of the view that is shown as well.
    [[nodiscard]] const Preferences& preferences() const { return preferences_; }
    void setPreferences(const Preferences& preferences);
    // Remembered as preferred (CameraMotion::isTurntable()).
    void setTurntable(bool isTurntable);
    // Remembered as preferred (GrowthLimit).
    void setFirstStrokePercent(int percent);

    // Written as soon as the picture is at full quality.
    void takeScreenshot(const std::filesystem::path& path);
    // What lies under a place of the view. Nothing while things move.
    std::optional<studio::Probe> probe(QPointF position);

    // The picture shows the document, though perhaps as a draft, and nothing is changing it: the time to look
    // at what is under the pen.
    [[nodiscard]] bool isSettled();
    // The time (Timer::now()) up to which all input has been reckoned into what is shown.
    [[nodiscard]] double answeredMs() const;
    // The next picture is being made or about to be.
    [[nodiscard]] bool isPictureComing() const;
    // Whether nothing is under way and nothing is waiting; the picture is at full quality then.
    [[nodiscard]] bool isIdle();

signals:
    void pictureChanged(); // a new picture to show

private:
    void connectParts();
    void tick();
    bool takeUpWaiting();
    bool takeInput();
    void show();
    bool grow();
    void scheduleNext(PictureLoop::State state, bool slicesWait);
    void schedule(int milliseconds);
    void showDocument();
    void letGo();
    void preferTo(const Preferences& before);
    [[nodiscard]] std::optional<Range> preferredWindow() const;
    void writeScreenshot();

    DocumentHost host_;
    ViewModel view_{host_};
    Notices notices_;
    CameraMotion camera_{host_, view_};
    Hand hand_{host_};
    Editor editor_{host_, view_, hand_};
    std::unique_ptr<PictureLoop> picture_;
    Preferences preferences_ = Preferences::load();
    std::unique_ptr<SegmentController> segments_;
    std::unique_ptr<SegmentMeasurer> measurer_;
    std::unique_ptr<GrowthController> growth_;
    std::unique_ptr<SliceController> slices_;
    std::unique_ptr<DocumentFiles> files_;
    std::filesystem::path screenshot_; // waiting for the picture
    QTimer timer_;
    int picturesSeen_ = 0;
    double caughtUpMs_ = 0; // answeredMs() once the picture that is being made is shown
    double answeredMs_ = 0;
    double growthMs_ = 0; // grown for since the last picture
};

} // namespace vs::desktop
