// SPDX-License-Identifier: Apache-2.0
#include "panels/segment_numbers_panel.h"

#include "model/segments/segment_controller.h"
#include "model/segments/segment_measurer.h"
#include "model/studio/studio_controller.h"
#include "model/texts/quantities.h"
#include "parts/fold_card.h"
#include "parts/panel_parts.h"

#include <QApplication>
#include <QClipboard>
#include <QGridLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace vs::desktop {

namespace {

QLabel* addFigure(QGridLayout* grid, const QString& text, const char* objectName) {
    const int row = grid->rowCount();
    grid->addWidget(makeQuietLabel(text), row, 0);
    auto* value = named(new QLabel, objectName, text);
    value->setAlignment(Qt::AlignRight);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(value, row, 1);
    return value;
}

QString number(double value) { return QString::number(value, 'g', 5); }

} // namespace

SegmentNumbersPanel::SegmentNumbersPanel(StudioController& studio, QWidget* parent)
    : QWidget(parent), studio_(studio), card_(new FoldCard(tr("Numbers"), "numbersFold")) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(card_);
    auto* grid = new QGridLayout;
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    voxels_ = addFigure(grid, tr("Voxels"), "voxels");
    millilitres_ = addFigure(grid, tr("Volume"), "millilitres");
    mean_ = addFigure(grid, tr("Mean, spread"), "meanValue");
    extremes_ = addFigure(grid, tr("Least, median, most"), "extremeValues");
    box_ = addFigure(grid, tr("Box"), "segmentBox");
    surface_ = addFigure(grid, tr("Surface"), "segmentSurface");
    sphericity_ = addFigure(grid, tr("Sphericity"), "segmentSphericity");
    sphericity_->setToolTip(tr("The surface of a ball of the same volume by this one: 1 for a ball"));
    axes_ = addFigure(grid, tr("Axes"), "segmentAxes");
    axes_->setToolTip(tr("Of the ellipsoid with the same moments, the longest first"));
    topology_ = addFigure(grid, tr("Parts, tunnels, cavities"), "segmentTopology");
    topology_->setToolTip(tr("Pieces that do not touch, ways through as in a ring, hollows that are closed"));
    euler_ = addFigure(grid, tr("Euler number"), "segmentEuler");
    euler_->setToolTip(tr("Parts less tunnels and more cavities"));
    card_->content()->addLayout(grid);
    copy_ = named(new QPushButton(tr("Copy all as CSV")), "copyNumbers", tr("Copy the numbers as CSV"));
    copy_->setToolTip(tr("The numbers of all segments, for a table, as `vstudio stats --csv` writes them"));
    copy_->setFocusPolicy(Qt::TabFocus);
    connect(copy_, &QPushButton::clicked, this, &SegmentNumbersPanel::copy);
    card_->content()->addWidget(copy_);
    connect(card_, &FoldCard::toggled, this, [this](bool isOpen) {
        studio_.measurer().want(this, isOpen);
        refreshLive();
        refreshMeasured();
    });
    connect(&studio_.host(), &DocumentHost::changed, this, &SegmentNumbersPanel::refreshLive);
    connect(&studio_.measurer(), &SegmentMeasurer::changed, this, &SegmentNumbersPanel::refreshMeasured);
}

void SegmentNumbersPanel::refreshLive() {
    if (card_->isOpen()) {
        const auto& segments = studio_.segments();
        const std::uint8_t label = segments.list().atWork;
        voxels_->setText(grouped(segments.voxels(label)));
        const double millilitres = segments.millilitres(label);
        constexpr double kFew = 0.01; // below which other units say more
        millilitres_->setText(millilitres >= kFew ? tr("%1 ml").arg(millilitres, 0, 'f', 3)
                                                  : volumeText(millilitres));
    }
}

void SegmentNumbersPanel::refreshMeasured() {
    const auto& measurer = studio_.measurer();
    const auto* found = measurer.working();
    copy_->setEnabled(!measurer.segments().empty());
    if (found == nullptr) {
        const QString text = measurer.isMeasuring() ? tr("measuring\u2026") : tr("\u2013");
        for (QLabel* label : {mean_, extremes_, box_, surface_, sphericity_, axes_, topology_, euler_}) {
            label->setText(text);
        }
        return;
    }
    const auto& s = found->statistics;
    mean_->setText(tr("%1 \u00b1 %2").arg(number(s.intensities.mean), number(s.intensities.deviation)));
    extremes_->setText(tr("%1, %2, %3")
                           .arg(number(s.intensities.smallest), number(s.intensities.median),
                                number(s.intensities.largest)));
    box_->setText(
        tr("%1 \u00d7 %2 \u00d7 %3 mm").arg(number(s.boxMm.x), number(s.boxMm.y), number(s.boxMm.z)));
    surface_->setText(tr("%1 cm\u00b2").arg(s.surfaceMm2 / 100, 0, 'f', 2));
    sphericity_->setText(QString::number(s.sphericity, 'f', 3));
    axes_->setText(
        tr("%1 \u00d7 %2 \u00d7 %3 mm")
            .arg(number(s.axes[0].lengthMm), number(s.axes[1].lengthMm), number(s.axes[2].lengthMm)));
    const auto& topology = s.topology;
    topology_->setText(tr("%1, %2, %3").arg(topology.parts).arg(topology.tunnels()).arg(topology.cavities));
    euler_->setText(QString::number(topology.euler));
}

void SegmentNumbersPanel::copy() {
    auto segments = studio_.measurer().segments();
    for (auto& measured : segments) { // renamed since, perhaps
        for (const auto& info : studio_.segments().list().segments) {
            if (info.label == measured.label) {
                measured.name = info.name;
                measured.colour = glm::u8vec3(glm::round(info.colour * 255.0));
            }
        }
    }
    QApplication::clipboard()->setText(QString::fromStdString(segment::csvOf(segments)));
    studio_.host().say(segments.size() == 1 ? tr("Copied the numbers of one segment")
                                            : tr("Copied the numbers of %1 segments").arg(segments.size()));
}

} // namespace vs::desktop
