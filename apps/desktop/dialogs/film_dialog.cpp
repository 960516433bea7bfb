// SPDX-License-Identifier: Apache-2.0
#include "dialogs/film_dialog.h"

#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "parts/panel_parts.h"

#include "studio/document/document.h"
#include "studio/document/document_facts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include <cmath>

namespace vs::desktop {

namespace {

using studio::Shot;

constexpr QSize kPreview{384, 216};
constexpr int kTimeSteps = 1000;    // of the slider
constexpr int kPreviewAfterMs = 60; // what is chosen on the way is not shown
constexpr int kPreviewEachMs = 120; // while it plays

// What a person can choose: kinds of shots and orbits, with what their amount is at first.
struct Choice {
    Shot::Kind kind;
    Shot::Orbit orbit;
    bool isBackward;
    double amount;
};
constexpr Choice kChoices[] = {{Shot::Kind::Still, Shot::Orbit::Turntable, false, 360},
                               {Shot::Kind::Still, Shot::Orbit::Rock, false, 25},
                               {Shot::Kind::Still, Shot::Orbit::Tilt, false, 360},
                               {Shot::Kind::Still, Shot::Orbit::Spiral, false, 360},
                               {Shot::Kind::Still, Shot::Orbit::Approach, false, 2},
                               {Shot::Kind::Growth, Shot::Orbit::None, false, 360},
                               {Shot::Kind::Growth, Shot::Orbit::None, true, 360},
                               {Shot::Kind::Session, Shot::Orbit::None, false, 0},
                               {Shot::Kind::Keys, Shot::Orbit::None, false, 360}};

QImage toQImage(const image::Image& picture) {
    return QImage(picture.rgba.data(), picture.width, picture.height, qsizetype(4) * picture.width,
                  QImage::Format_RGBA8888)
        .copy();
}

} // namespace

FilmDialog::FilmDialog(StudioController& studio, const QString& name, QWidget* parent)
    : QDialog(parent), studio_(studio), name_(name) {
    setObjectName("filmDialog");
    setWindowTitle(tr("Film"));
    auto* column = new QVBoxLayout(this);
    makePreview(column);
    auto* fields = new QWidget;
    form_ = makeForm(fields);
    makeFields(form_);
    makeKeys(form_);
    column->addWidget(fields);
    column->addStretch(1); // rows that are hidden leave their room here, and the others stay where they are
    makeButtons(column);
    previewing_.setSingleShot(true);
    connect(&previewing_, &QTimer::timeout, this, &FilmDialog::preview);
    connect(&playing_, &QTimer::timeout, this, [this] {
        const double step = double(kPreviewEachMs) / 1000 / seconds_->value() * kTimeSteps;
        time_->setValue(int(time_->value() + step) % (kTimeSteps + 1));
    });
    connect(&studio_.host(), &DocumentHost::closing, this, &QDialog::close);
    connect(&studio_.host(), &DocumentHost::opened, this, &QDialog::close);
    follow();
}

void FilmDialog::makePreview(QVBoxLayout* column) {
    picture_ = named(new QLabel, "filmPreview", tr("Preview"));
    picture_->setFixedSize(kPreview);
    picture_->setAlignment(Qt::AlignCenter);
    column->addWidget(picture_, 0, Qt::AlignCenter);
    auto* row = new QHBoxLayout;
    play_ = named(new QPushButton(tr("Play")), "filmPlay", tr("Play the preview"));
    play_->setCheckable(true);
    time_ = named(new QSlider(Qt::Horizontal), "filmTime", tr("Moment of the film"));
    time_->setRange(0, kTimeSteps);
    timeText_ = makeQuietLabel({});
    timeText_->setMinimumWidth(timeText_->fontMetrics().horizontalAdvance("000.0 s"));
    row->addWidget(play_);
    row->addWidget(time_, 1);
    row->addWidget(timeText_);
    column->addLayout(row);
    connect(time_, &QSlider::valueChanged, this, &FilmDialog::previewSoon);
    connect(play_, &QPushButton::toggled, this,
            [this](bool isOn) { isOn ? playing_.start(kPreviewEachMs) : playing_.stop(); });
}

void FilmDialog::makeFields(QFormLayout* form) {
    what_ = named(new QComboBox, "filmWhat", tr("What the film shows"));
    for (const QString& text :
         {tr("Around the patient's axis"), tr("To and fro"), tr("Over the head"), tr("Around and up"),
          tr("Coming nearer"), tr("The segment growing"), tr("The segment going back to its seeds"),
          tr("All that was done, with its strokes"), tr("From view to view")}) {
        what_->addItem(text);
    }
    form->addRow(tr("Shows"), what_);
    seconds_ = named(new QDoubleSpinBox, "filmSeconds", tr("Duration"));
    seconds_->setRange(0.5, 600);
    seconds_->setDecimals(1);
    seconds_->setValue(8);
    seconds_->setSuffix(tr(" s"));
    form->addRow(tr("Duration"), seconds_);
    degrees_ = named(new QSpinBox, "filmDegrees", tr("How far it turns"));
    degrees_->setRange(-3600, 3600);
    degrees_->setSuffix(tr("°"));
    form->addRow(tr("Turns by"), degrees_);
    factor_ = named(new QDoubleSpinBox, "filmFactor", tr("How much nearer it comes"));
    factor_->setRange(0.1, 20);
    form->addRow(tr("Nearer by"), factor_);
    turns_ =
        makeCheckBox("filmTurns", tr("Turn once meanwhile"), tr("Goes around the patient's axis too"), false);
    form->addRow(QString(), turns_);
    size_ = named(new QComboBox, "filmSize", tr("Size"));
    for (const QSize size : {QSize(1280, 720), QSize(1920, 1080), QSize(854, 480), QSize(1080, 1080)}) {
        size_->addItem(tr("%1 × %2").arg(size.width()).arg(size.height()), size);
    }
    form->addRow(tr("Size"), size_);
    rate_ = named(new QComboBox, "filmRate", tr("Frames a second"));
    for (const int rate : {25, 30, 50, 60}) {
        rate_->addItem(tr("%1 a second").arg(rate), rate);
    }
    form->addRow(tr("Frames"), rate_);
    background_ = named(new QComboBox, "filmBackground", tr("Background"));
    for (const auto& [text, value] : {std::pair(tr("As in the window"), "studio"),
                                      std::pair(tr("White"), "white"), std::pair(tr("Black"), "black")}) {
        background_->addItem(text, value);
    }
    form->addRow(tr("Background"), background_);
    annotations_ = makeCheckBox("filmAnnotations", tr("Scale bar and orientation marker"),
                                tr("Draws both into the picture"), false);
    form->addRow(QString(), annotations_);
    connect(what_, &QComboBox::currentIndexChanged, this, &FilmDialog::follow);
    connect(seconds_, &QDoubleSpinBox::valueChanged, this, &FilmDialog::previewSoon);
    connect(degrees_, &QSpinBox::valueChanged, this, &FilmDialog::previewSoon);
    connect(factor_, &QDoubleSpinBox::valueChanged, this, &FilmDialog::previewSoon);
    connect(turns_, &QCheckBox::toggled, this, &FilmDialog::previewSoon);
    connect(size_, &QComboBox::currentIndexChanged, this, &FilmDialog::previewSoon);
    connect(background_, &QComboBox::currentIndexChanged, this, &FilmDialog::previewSoon);
    connect(annotations_, &QCheckBox::toggled, this, &FilmDialog::previewSoon);
}

void FilmDialog::makeKeys(QFormLayout* form) {
    keyRow_ = new QWidget;
    auto* column = new QVBoxLayout(keyRow_);
    column->setContentsMargins(0, 0, 0, 0);
    keyList_ = named(new QListWidget, "filmKeys", tr("Views of the film"));
    keyList_->setMaximumHeight(90);
    column->addWidget(keyList_);
    auto* row = new QHBoxLayout;
    addKey_ = named(new QPushButton(tr("Add this view")), "filmAddKey",
                    tr("Add what the window shows now: view, displayed range, parts, generation"));
    removeKey_ = named(new QPushButton(tr("Remove")), "filmRemoveKey", tr("Remove the view that is chosen"));
    row->addWidget(addKey_);
    row->addWidget(removeKey_);
    column->addLayout(row);
    form->addRow(tr("Views"), keyRow_);
    connect(addKey_, &QPushButton::clicked, this, &FilmDialog::addKey);
    connect(removeKey_, &QPushButton::clicked, this, &FilmDialog::removeKey);
}

void FilmDialog::makeButtons(QVBoxLayout* column) {
    message_ = named(makeQuietLabel({}), "filmMessage", tr("Message"));
    message_->setWordWrap(true);
    message_->setMinimumHeight(2 * message_->fontMetrics().lineSpacing()); // so that nothing moves
    column->addWidget(message_);
    auto* row = new QHBoxLayout;
    auto* close = named(new QPushButton(tr("Close")), "filmClose", tr("Close"));
    save_ = named(new QPushButton(tr("Save…")), "filmSave", tr("Save"));
    row->addStretch(1);
    row->addWidget(close);
    row->addWidget(save_);
    column->addLayout(row);
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    connect(save_, &QPushButton::clicked, this, &FilmDialog::askWhere);
}

// --- what is chosen

void FilmDialog::follow() {
    const Choice& chosen = kChoices[std::size_t(what_->currentIndex())];
    const bool isOrbit = chosen.kind == Shot::Kind::Still;
    const bool comesNearer = chosen.orbit == Shot::Orbit::Approach;
    if (isOrbit) {
        comesNearer ? factor_->setValue(chosen.amount) : degrees_->setValue(int(chosen.amount));
    }
    form_->setRowVisible(degrees_, isOrbit && !comesNearer);
    form_->setRowVisible(factor_, comesNearer);
    form_->setRowVisible(turns_, chosen.kind == Shot::Kind::Growth || chosen.kind == Shot::Kind::Keys);
    form_->setRowVisible(keyRow_, chosen.kind == Shot::Kind::Keys);
    listKeys();
    previewSoon();
}

void FilmDialog::addKey() {
    studio::FilmKey key;
    key.view = studio::setViewTo(studio_.view().shown());
    const auto& growth = studio_.host().facts()->growth;
    if (growth.hasSeeds) {
        key.generation = growth.generation;
    }
    keys_.push_back(key);
    listKeys();
    keyList_->setCurrentRow(int(keys_.size()) - 1);
    previewSoon();
}

void FilmDialog::removeKey() {
    const int row = keyList_->currentRow();
    if (row >= 0) {
        keys_.erase(keys_.begin() + row);
        listKeys();
        previewSoon();
    }
}

void FilmDialog::listKeys() {
    keyList_->clear();
    for (std::size_t n = 0; n < keys_.size(); ++n) {
        const auto& camera = *keys_[n].view.camera;
        keyList_->addItem(tr("View %1: %2° around, %3° up, zoom %4")
                              .arg(n + 1)
                              .arg(std::lround(camera.azimuthDegrees))
                              .arg(std::lround(camera.elevationDegrees))
                              .arg(camera.zoom, 0, 'f', 2));
    }
    removeKey_->setEnabled(!keys_.empty());
}

Shot FilmDialog::shot() const {
    const Choice& chosen = kChoices[std::size_t(what_->currentIndex())];
    Shot shot;
    shot.kind = chosen.kind;
    shot.orbit = chosen.orbit;
    shot.isBackward = chosen.isBackward;
    shot.seconds = seconds_->value();
    shot.amount = chosen.orbit == Shot::Orbit::Approach ? factor_->value() : degrees_->value();
    if (chosen.kind != Shot::Kind::Still && chosen.kind != Shot::Kind::Session && turns_->isChecked()) {
        shot.orbit = Shot::Orbit::Turntable;
        shot.amount = 360;
    }
    if (chosen.kind == Shot::Kind::Keys) {
        shot.keys = keys_;
        for (std::size_t n = 0; n < keys_.size(); ++n) {
            shot.keys[n].seconds = keys_.size() < 2 ? 0 : shot.seconds * double(n) / double(keys_.size() - 1);
        }
    }
    return shot;
}

studio::SaveMovie FilmDialog::film() const {
    const QSize size = size_->currentData().toSize();
    studio::SaveMovie film;
    film.size = {size.width(), size.height()};
    film.framesPerSecond = rate_->currentData().toInt();
    film.background = render::backgroundFromName(background_->currentData().toString().toStdString());
    film.annotations = annotations_->isChecked();
    film.shots.push_back(shot());
    return film;
}

// --- the preview

void FilmDialog::previewSoon() {
    const double seconds = seconds_->value() * time_->value() / kTimeSteps;
    timeText_->setText(tr("%1 s").arg(seconds, 0, 'f', 1));
    previewing_.start(kPreviewAfterMs);
}

void FilmDialog::preview() {
    const studio::SaveMovie wanted = film();
    const bool needsKeys = wanted.shots[0].kind == Shot::Kind::Keys && keys_.empty();
    save_->setEnabled(!needsKeys);
    if (needsKeys) {
        picture_->setText(tr("Turn to a view, and add it"));
        return;
    }
    if (studio_.host().isAway() || studio_.host().facts()->isStrokeOpen()) {
        previewing_.start(kPreviewEachMs);
        return;
    }
    studio_.editor().interrupt(); // what grows by itself ends
    const double seconds = seconds_->value() * time_->value() / kTimeSteps;
    const QSize room = size_->currentData().toSize().scaled(kPreview, Qt::KeepAspectRatio);
    image::Image picture;
    QString trouble;
    try {
        studio_.host().runLong(
            [&] {
                picture =
                    studio_.host().document()->filmFrame(wanted, seconds, {room.width(), room.height()});
            },
            wanted.shots[0].kind == Shot::Kind::Session ? LongWork::Input::GivesUp : LongWork::Input::Waits);
    } catch (const std::exception& error) {
        trouble = QString::fromUtf8(error.what());
    }
    save_->setEnabled(trouble.isEmpty());
    if (trouble.isEmpty()) {
        picture_->setPixmap(QPixmap::fromImage(toQImage(picture)));
    } else {
        picture_->clear();
    }
    if (!trouble.isEmpty() || isTroubled_) {
        tell(trouble);
    }
    isTroubled_ = !trouble.isEmpty();
    studio_.host().wake();
}

void FilmDialog::tell(const QString& message) { message_->setText(message); }

// --- the film

void FilmDialog::askWhere() {
    play_->setChecked(false);
    auto* dialog = new QFileDialog(this, tr("Save the film"), {},
                                   tr("Films (*.webm *.mp4);;Folders of numbered pictures (*)"));
    dialog->setObjectName("filmFileDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->selectFile(name_ + ".webm");
    connect(dialog, &QFileDialog::fileSelected, this, &FilmDialog::save, Qt::QueuedConnection);
    dialog->open();
}

void FilmDialog::save(const QString& path) {
    const std::filesystem::path file(path.toStdString());
    studio::SaveMovie wanted = film();
    wanted.file = file.filename().string();
    const bool isDone = studio_.editor().apply(wanted, file.parent_path());
    tell(isDone ? tr("Saved %1").arg(QString::fromStdString(wanted.file)) : studio_.host().message());
    if (isDone) {
        studio_.host().say(tr("Saved %1").arg(path));
    }
}

} // namespace vs::desktop
