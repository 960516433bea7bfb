// SPDX-License-Identifier: Apache-2.0
#include "panels/histogram_panel.h"

#include "model/studio/studio_controller.h"
#include "panels/range_page.h"
#include "parts/panel_parts.h"
#include "transfer/curve_page.h"
#include "transfer/function_bar.h"
#include "transfer/function_chart.h"
#include "transfer/shape_page.h"

#include <QVBoxLayout>

namespace vs::desktop {

namespace {

constexpr int kRetryMs = 60;   // while the picture is in motion
constexpr double kCountMs = 8; // counted at a time
constexpr int kGradientBins = 128;

} // namespace

HistogramPanel::HistogramPanel(StudioController& studio, QWidget* parent)
    : QWidget(parent), studio_(studio), editor_(studio.host(), studio.view()) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* card = nullptr;
    outer->addWidget(makeCard(tr("Histogram"), card));
    auto* tabs =
        new ChoiceRow({{"tabRange", tr("Range"), tr("The displayed range of intensities")},
                       {"tabIntensity", tr("Intensity"), tr("Colour and opacity over intensity")},
                       {"tabGradient", tr("Gradient"), tr("Colour and opacity over gradient magnitude")},
                       {"tabBoth", tr("Both"), tr("Colour and opacity over intensity and gradient")}},
                      0);
    card->addWidget(tabs);
    range_ = new RangePage(studio_);
    using enum render::FunctionKind;
    intensity_ = new CurvePage(studio_, editor_, Intensity, "intensityCurve", "intensity");
    gradient_ = new CurvePage(studio_, editor_, Gradient, "gradientCurve", "gradient");
    both_ = new ShapePage(studio_, editor_);
    pages_ = {range_, intensity_, gradient_, both_};
    for (QWidget* page : pages_) {
        card->addWidget(page);
    }
    card->addWidget(new FunctionBar(studio_, editor_));
    connect(tabs, &ChoiceRow::chosen, this, &HistogramPanel::showPage);
    connect(&studio_.host(), &DocumentHost::opened, this, &HistogramPanel::takeDocument);
    connect(&studio_.host(), &DocumentHost::corrected, this, &HistogramPanel::countAgain);
    connect(&editor_, &FunctionEditor::changed, this, &HistogramPanel::refreshStrip);
    countTimer_.setSingleShot(true);
    connect(&countTimer_, &QTimer::timeout, this, &HistogramPanel::countGradients);
    showPage(0);
    setEnabled(false);
}

HistogramPanel::~HistogramPanel() {
    studio_.host().gl().makeCurrent(); // what is being counted lies on the device
    counting_.reset();
}

// Hidden ones take no room: the panel is as high as the page that is shown.
void HistogramPanel::showPage(int page) {
    shown_ = page;
    for (int i = 0; i < int(pages_.size()); ++i) {
        pages_[std::size_t(i)]->setVisible(i == page);
    }
    const bool needsGradients = page >= 2;
    if (needsGradients && !isCounted_) {
        countTimer_.start(0);
    }
}

// Gradients are per mm.
void HistogramPanel::countAgain() {
    studio_.host().gl().makeCurrent();
    counting_.reset();
    isCounted_ = false;
    showPage(shown_);
}

void HistogramPanel::takeDocument() {
    studio_.host().gl().makeCurrent();
    counting_.reset();
    isCounted_ = false;
    range_->takeDocument();
    intensity_->takeDocument();
    gradient_->takeDocument();
    both_->takeDocument();
    setEnabled(true);
    refreshStrip();
    showPage(shown_);
}

void HistogramPanel::refreshStrip() {
    if (!editor_.isUsed(render::FunctionKind::Intensity)) {
        range_->setColourStrip({});
        return;
    }
    const auto sampler =
        std::make_shared<render::FunctionSampler>(editor_.function(render::FunctionKind::Intensity));
    range_->setColourStrip([sampler](double value) {
        return screenColour(render::colourFromLinear(glm::dvec3(sampler->at(value, 0))));
    });
}

void HistogramPanel::countGradients() {
    auto* document = studio_.host().document();
    if (document == nullptr || isCounted_) {
        return;
    }
    if (!studio_.isSettled()) {
        countTimer_.start(kRetryMs);
        return;
    }
    bool isDone = false;
    const bool isFine = studio_.host().workLong([&] {
        if (!counting_) {
            counting_.emplace(document->field(),
                              glm::ivec2(int(document->histogram().size()), kGradientBins));
        }
        isDone = counting_->advance(kCountMs);
    });
    if (isDone) {
        takeJoint();
    } else if (isFine) {
        countTimer_.start(0);
    }
}

void HistogramPanel::takeJoint() {
    const field::JointHistogram joint = counting_->joint();
    counting_.reset();
    isCounted_ = true;
    std::vector<std::uint32_t> byGradient(std::size_t(joint.bins.y));
    for (std::size_t i = 0; i < joint.counts.size(); ++i) {
        byGradient[i / std::size_t(joint.bins.x)] += joint.counts[i];
    }
    const QString unit = QString::fromStdString(studio_.host().document()->volume().unit);
    editor_.setGradientTop(joint.gradients.hi);
    gradient_->setCounts(byGradient, joint.gradients, unit + tr("/mm"));
    both_->setJoint(joint);
}

} // namespace vs::desktop
