// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/volume_loader.h"

#include "base/timer.h"
#include "render/slices/slice_view.h"

#include <QMainWindow>
#include <QPointer>
#include <QTimer>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QDockWidget;
class QFileDialog;
class QLabel;
class QProgressBar;
class QStackedWidget;
class QToolBar;
class QToolButton;

namespace vs::studio {
struct LostWork;
}

namespace vs::desktop {

class ActionTable;
class FilmDialog;
class HintLine;
class HistoryPanel;
class RecoveryKeeper;
class StudioController;
class ThumbnailKeeper;
class PictureExport;
class Tool;
class ToolBox;
class ViewGrid;
class ViewWidget;
class WelcomePage;

// The window: tool bars and menus around the view, panels on the left, the line of hints below the picture
// and the status bar. What it shows and changes is the controller's. It owns the keepers of recent documents'
// pictures and of lost work, and remembers only what is its own business: which panels the start screen has
// hidden, whether it asks if it may close, when the tool's sign was last reversed, and a copy to the
// clipboard that is under way.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    MainWindow(StudioController& studio, ToolBox& tools, QWidget* parent = nullptr);

    // With this code the program ends that is to be started again: the graphics driver was reset.
    static constexpr int kStartsAgain = 75;

    [[nodiscard]] const ViewWidget& view() const { return *view_; }
    // Opens a path given by a person: a session if it ends in .json, else a volume. Asks for the layout of
    // raw files.
    void openPath(const QString& path);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    // main_window_actions.cpp
    [[nodiscard]] bool isOpen();
    [[nodiscard]] bool hasVoxels();
    void makeFileActions();
    void makeEditActions();
    void makeViewActions();
    void makeModeActions();
    void makeLookActions();
    void makeGrowthActions();
    void showExport();
    void askForNote();

    // main_window_tools.cpp
    void makeToolActions();
    void makeShapeActions();
    void chooseStencil();
    void reverseSign();

    // main_window_camera.cpp
    void makeCameraActions();
    void makeDragActions();
    void makeCameraMenu();

    // main_window_slices.cpp
    void makeSliceActions();
    void makeSliceWindowActions();
    void makeSliceMenu();
    void refreshSliceActions();
    void showSliceProbe(render::SliceKind kind, std::optional<glm::dvec2> place);

    // main_window_colours.cpp
    void makeColourMenu();
    void openTransferFunction();

    // main_window_bars.cpp
    void makeMenus();
    std::vector<std::string> toolNames();
    void makeToolBars();
    void fitToolBar(int width);
    void makeToolColumn();

    // main_window_files.cpp
    void openFile();
    void playFile();
    void playAgain();
    void openFolder();
    void openLabels();
    void dropOn(const QString& path);
    void saveSession();
    void saveSessionAs();
    void exportLabels();
    void screenshot();
    QFileDialog* makeFileDialog(const char* objectName, const QString& title, bool isSave,
                                const QString& filter, const QString& suggestion);
    void choose(const char* objectName, const QString& title, bool isSave, const QString& filter,
                const QString& suggestion, const std::function<void(const QString&)>& take);
    [[nodiscard]] QString suggestedName(const QString& suffix) const;
    [[nodiscard]] QString suggestedSession() const;

    // main_window_properties.cpp
    void makePropertiesAction();
    void addNoticesBadge();
    void addJournalBadge();
    void showProperties();

    // main_window_help.cpp
    void makeHelpActions();
    void showPreferences();
    void about();

    // main_window_developer.cpp
    void makeDeveloperActions();
    void reloadShaders();
    void tellShaderFault();

    // main_window_start.cpp
    bool mayLeave();
    bool closeDialogs();
    bool agreesToLeave();
    bool saveBeforeLeaving();
    void open(const OpenRequest& request);
    void showStartScreen();
    void leaveForStartScreen();
    void recover(const OpenRequest& request);
    void recoverLost(const studio::LostWork& lost);
    void askForBlock();
    void askForVolume(const OpenRequest& request, const std::filesystem::path& wanted);
    void chooseSeries(const OpenRequest& request, const std::vector<volume::SeriesChoice>& choices);
    void showView();
    void startAgain();

    // main_window_pictures.cpp
    void makePictureActions();
    void copyPicture();

    void makeCentre();
    void makeDock();
    void makeStatusBar();
    void showLevels();
    void tellUnreadBricks();
    void refresh();
    void refreshHint();
    void refreshProbe();
    void showDuration(double milliseconds);
    void showProbe(double value, glm::dvec3 voxel, glm::dvec3 world);
    void showProgress(int done, int total);

    StudioController& studio_;
    ToolBox& tools_;
    ActionTable* actions_ = nullptr;
    QToolBar* bar_ = nullptr;
    QStackedWidget* centre_ = nullptr;
    WelcomePage* welcome_ = nullptr;
    ThumbnailKeeper* thumbnails_ = nullptr;
    RecoveryKeeper* recovery_ = nullptr;
    HistoryPanel* history_ = nullptr;
    std::vector<QDockWidget*> hiddenDocks_; // while the start screen is shown
    ViewWidget* view_ = nullptr;
    ViewGrid* grid_ = nullptr; // the 3D view and the slices
    QList<QAction*> sliceWindows_;
    HintLine* hint_ = nullptr;
    QLabel* message_ = nullptr;
    QLabel* probe_ = nullptr;
    QLabel* duration_ = nullptr;
    QLabel* volume_ = nullptr;
    QLabel* rate_ = nullptr;
    QLabel* device_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QToolButton* giveUp_ = nullptr; // beside the progress bar
    QTimer probeTimer_;
    QTimer rateTimer_;
    std::size_t toldFailures_ = 0;     // of Detail::failures()
    PictureExport* copying_ = nullptr; // to the clipboard
    QPointer<FilmDialog> film_;        // while it is open
    bool isBusyCursor_ = false;
    bool isLeaving_ = false; // asks whether to
    Timer sinceReversed_;    // the tool's sign: cut or restore
};

} // namespace vs::desktop
