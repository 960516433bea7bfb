// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/gl_host.h"
#include "engine/long_work.h"
#include "engine/picture_loop.h"
#include "engine/volume_loader.h"
#include "model/keepers/preferences.h"

#include "studio/document/document.h"

#include <QObject>
#include <QSizeF>
#include <QTimer>

#include <deque>
#include <functional>
#include <memory>

namespace vs::desktop {

class GrowthController;
class SegmentController;
class SegmentMeasurer;
class SliceController;
class Tool;

// The model of the window: the document, its picture, the current tool, and the one timer that does all work
// in short slices, so that input is handled between. No widgets. Everything runs on the window's thread but
// reading files.
class StudioController : public QObject {
    Q_OBJECT

public:
    // Needs a QApplication. Throws GlError if there is no OpenGL 4.5.
    StudioController();
    ~StudioController() override;

    GlHost& host() { return host_; }
    PictureLoop& picture() { return *picture_; }
    GrowthController& growth() { return *growth_; }
    SegmentController& segments() { return *segments_; }
    SegmentMeasurer& measurer() { return *measurer_; }
    SliceController& slices() { return *slices_; }
    // Null before something was opened. With the engine's context current; waits while the document is away.
    studio::Document* document();
    // Long work has the document: nothing else can be done with it.
    [[nodiscard]] bool isAway() const { return longWork_.isRunning(); }
    // It lasts, and all that a person can do meanwhile is to give it up.
    [[nodiscard]] bool isLasting() const { return longWork_.isShown(); }
    // Does something with the document that may take long while the window goes on painting and input waits
    // (LongWork). False: it failed, and the message says why.
    bool workLong(const std::function<void()>& work);
    // The same, but what it throws is thrown.
    void runLong(const std::function<void()>& work) { longWork_.run(work); }
    // Does it now, or once the document is back: for what ends on other threads.
    void whenHere(std::function<void()> work);
    // Ends what takes long, if it can be ended: as if it had not been begun, but for a session, of which so
    // much stays as was replayed.
    void giveUp();

    // Files. open() returns at once; opened() or openFailed() tells how it ended.
    void open(const OpenRequest& request);
    [[nodiscard]] const OpenRequest& source() const { return source_; }
    // Where the volume comes from, as a session without operations. There must be a volume.
    [[nodiscard]] studio::Session provenance() const;
    bool saveSession(const std::filesystem::path& path);
    // Back to how it was before anything was opened; what was not saved is gone.
    void close();
    bool exportLabels(const std::filesystem::path& path);
    // Written as soon as the picture is at full quality.
    void takeScreenshot(const std::filesystem::path& path);

    // Undo's memory counts for the open document too, quality and shadows of the view that is shown as well.
    [[nodiscard]] const Preferences& preferences() const { return preferences_; }
    void setPreferences(const Preferences& preferences);

    // The view as the person sees it; look() reaches the document before the next picture.
    [[nodiscard]] const studio::View& view() const { return view_; }
    void look(const studio::View& view);
    void setMode(render::Mode mode);
    // Colours every mode; nothing: the modes' own colours.
    void setTransferFunction(const std::optional<render::TransferFunction>& function);
    void setSculptureView(field::SculptureView view);
    // Ambient occlusion and soft shadows.
    void setShadows(bool shadows);
    void setRange(Range range);
    // Values above the displayed range: hidden in MIP, X-ray and overlay, or shown as its upper end.
    void setHidesAbove(bool hidesAbove);
    // Sigma in steps; 0: surfaces as they are in the data.
    void setSurfaceSmoothing(double sigma);
    // Segments in their colours in MIP and X-ray too.
    void setTintsSegments(bool tintsSegments);
    // What of the volume's values the view shows (View::visibleRange). There must be a volume.
    [[nodiscard]] Range visibleRange() const;
    void setSampling(field::Sampling sampling);
    void setViewport(QSizeF logical, glm::ivec2 device);
    [[nodiscard]] glm::dvec2 devicePerLogical() const;
    [[nodiscard]] QPointF viewCentre() const;
    // Of the volume that is shown; null before something was opened.
    [[nodiscard]] const volume::GridGeometry* geometry() const {
        return document_ ? &document_->volume().geometry : nullptr;
    }
    // Document::version(); 0 before something was opened.
    [[nodiscard]] std::uint64_t documentVersion() const;
    // Of the view as the person sees it, on the viewport. There must be a volume.
    [[nodiscard]] render::ViewRays rays() const;
    // Where a place in the world appears, in logical pixels of the view.
    [[nodiscard]] QPointF seenAt(glm::dvec3 world) const;
    // Of one logical pixel, in the middle of what is looked at.
    [[nodiscard]] double millimetresPerPixel();
    // What a sketch is drawn on now.
    studio::Canvas canvas();

    // Edits. False: it failed, and the message says why.
    bool apply(const studio::Operation& operation, const std::filesystem::path& outputFolder = ".");
    // Plays the region backward; one undo step with the rewinding before it.
    bool rewind(int generations);
    // Pastes what was cut since the last paste where there is room beside the object and the parts pasted
    // before. The view steps back if it would not be seen.
    bool paste();
    // Whether there are edits that no session file holds.
    [[nodiscard]] bool hasUnsavedEdits() const;
    // Runs `begin`, which opens a live stroke on canvas(); what is growing is paused first.
    bool beginStroke(const std::function<void(studio::Document&, const studio::Canvas&)>& begin);
    void endStroke(bool keep);
    // Does a whole stroke, to the scan or, if the tool acts on it, to the segment at work.
    bool cut(const studio::Operation& stroke);
    // Whether tools that can act on the segment at work do so.
    [[nodiscard]] bool brushesSegment() const { return brushesSegment_; }
    void setBrushesSegment(bool on);
    bool change(const std::function<studio::Outcome()>& edit);
    bool guard(const std::function<void()>& work);
    // Does it as workLong() does and reports what it did; when it takes long, it can be given up.
    bool perform(const std::function<studio::Outcome()>& edit);
    void report(const studio::Outcome& outcome);

    // Tools.
    [[nodiscard]] Tool& tool() const { return *tool_; }
    void setTool(Tool& tool);
    // Hears of what changes in a tool; each that can be taken in hand.
    void listenTo(Tool& tool);
    [[nodiscard]] studio::Shape shape() const { return shape_; }
    // Shape::Stencil once there is a stencil.
    void setShape(studio::Shape shape);
    // What that sketches: an outline (y down) fitted into the box that is dragged.
    [[nodiscard]] const std::vector<glm::dvec2>& stencil() const { return stencil_; }
    // A picture's bright or opaque part as the stencil. False: it has none, and the message says why.
    bool setStencil(const std::filesystem::path& picture);
    // For a mouse; a tablet's own pressure overrides it.
    [[nodiscard]] double mousePressure() const { return mousePressure_; }
    void setMousePressure(double pressure) { mousePressure_ = pressure; }
    // Press and hold: a mouse that is held down presses harder and harder.
    [[nodiscard]] bool rampsPressure() const { return rampsPressure_; }
    void setRampsPressure(bool on) { rampsPressure_ = on; }
    void setTabletPressure(double pressure);

    // What lies under a place of the view. Nothing while things move.
    std::optional<studio::Document::Probe> probe(QPointF position);

    void say(const QString& message);
    [[nodiscard]] const QString& message() const { return message_; }
    // Something happened: the next slice comes soon. Input also sends the picture back to drafts.
    void wake();
    // Something beside the picture waits to be drawn.
    void workSoon() { schedule(0); }
    [[nodiscard]] bool isLoading() const { return loader_.isLoading() || isReplaying(); }
    [[nodiscard]] bool isReplaying() const { return !replay_.empty(); }
    // The picture shows the document, though perhaps as a draft, and nothing is changing it: the time to look
    // at what is under the pen.
    [[nodiscard]] bool isSettled();
    // The time (Timer::now()) up to which all input has been reckoned into what is shown.
    [[nodiscard]] double answeredMs() const;
    // Something was done just now: it is answered first, and what goes on by itself gives way.
    [[nodiscard]] bool isHandAtWork() const;
    // The next picture is being made or about to be.
    [[nodiscard]] bool isPictureComing() const;
    // Nothing is under way and nothing is waiting; the picture is at full quality.
    [[nodiscard]] bool isIdle();

signals:
    void givenUp(); // what goes on by itself ends
    void opened();
    void closing(); // what is in hand is dropped
    void closed();
    void pasted(); // a part that is to be moved now
    void saved();  // a session file holds all edits; source() names it
    void openFailed(const QString& message);
    // Nothing was opened: the person must choose one of the series first.
    void seriesWanted(const vs::desktop::OpenRequest& request,
                      const std::vector<vs::volume::SeriesChoice>& choices);
    void changed();        // document, view, tool or playback: panels and actions look again
    void pictureChanged(); // a new picture to show
    void overlayChanged();
    void messageChanged();
    void tabletPressureChanged(double pressure);
    void progress(int done, int total); // total 0: unknown; done == total > 0: finished

private:
    void tick();
    bool grow(); // true: more of it before the next picture
    void schedule(int milliseconds);
    void tellSoon();
    void tell();
    void flushView();
    void connectLoader();
    void prefer();
    void finishOpening(const std::shared_ptr<Loaded>& loaded);
    void replayOne();
    void writeScreenshot();

    GlHost host_;
    LongWork longWork_{host_};
    std::unique_ptr<PictureLoop> picture_;
    std::unique_ptr<studio::Document> document_;
    VolumeLoader loader_;
    OpenRequest source_;
    mutable std::uint64_t versionSeen_ = 0; // of the document, when it was last here
    std::string checksum_;                  // of the volume
    std::size_t savedEdits_ = 0;            // edits in the log when it was last saved or opened
    std::deque<studio::Operation> replay_;  // of the session being opened
    int replayTotal_ = 0;
    bool isReplayGivenUp_ = false;
    std::vector<std::function<void()>> waiting_;               // for the document to be back
    std::optional<std::pair<QSizeF, glm::ivec2>> newViewport_; // since it went
    std::filesystem::path screenshot_;                         // waiting for the picture
    SegmentController* segments_;
    SegmentMeasurer* measurer_;
    GrowthController* growth_;
    Tool* tool_;
    std::unique_ptr<SliceController> slices_;
    studio::View view_;
    Preferences preferences_ = Preferences::load();
    bool isViewPending_ = false;
    bool isToldSoon_ = false;
    studio::Shape shape_ = studio::Shape::FreeForm;
    std::vector<glm::dvec2> stencil_;
    double mousePressure_ = 1;
    bool rampsPressure_ = false;
    bool brushesSegment_ = false;
    QSizeF logical_{1, 1};
    QString message_;
    QTimer timer_;
    int picturesSeen_ = 0;
    double caughtUpMs_ = 0; // answeredMs() once the picture that is being made is shown
    double answeredMs_ = 0;
    Timer sinceWoken_;
    double growthMs_ = 0; // grown for since the last picture
};

} // namespace vs::desktop
