// SPDX-License-Identifier: Apache-2.0
#include "view/play_strip.h"

#include "model/texts/texts.h"
#include "parts/icons.h"
#include "parts/panel_parts.h"
#include "tools/play_tool.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>

namespace vs::desktop {

namespace {

constexpr std::array kSpeeds{0.5, 1.0, 2.0, 4.0};

// The part of a figure that a step's text begins with, "(b) The peel ...", or its number.
QString labelOf(const studio::Step& step, std::size_t number) {
    static const QRegularExpression letter(R"(^\((\w{1,3})\))");
    const auto match = letter.match(QString::fromStdString(step.text));
    return match.hasMatch() ? match.captured(1) : QString::number(number + 1);
}

// Notes of cases that come with the program are translated; others are their authors' own.
QString textOf(const studio::Step& step) {
    return step.text.empty() ? QString() : QCoreApplication::translate("cases", step.text.c_str());
}

} // namespace

PlayStrip::PlayStrip(PlayTool& tool, QWidget* parent)
    : QWidget(parent), tool_(tool), text_(named(new QLabel, "playText", tr("What is done in this step"))),
      row_(new QWidget), play_(makeIconButton("play", "playSession", tr("Play"), tr("Play on (Space)"))),
      next_(makeIconButton("step", "playStep", tr("One step"), tr("Play one step, then pause"))),
      back_(makeIconButton("back", "playBack", tr("Back"),
                           tr("Back to where this step began, or the one before"))),
      speed_(named(new QComboBox, "playSpeed", tr("How fast"))) {
    setObjectName("playStrip");
    setAccessibleName(tr("Steps of the session"));
    text_->setWordWrap(true);
    text_->setMinimumHeight(2 * text_->fontMetrics().lineSpacing());
    for (const double speed : kSpeeds) {
        speed_->addItem(tr("%1 ×").arg(speed), speed);
    }
    speed_->setCurrentIndex(1);
    auto* byHand = named(new QPushButton(tr("Go on by hand")), "goOnByHand", tr("Go on by hand"));
    byHand->setToolTip(tr("End playing: what was done so far stays, and is yours"));
    auto* controls = new QHBoxLayout;
    controls->setSpacing(6);
    for (QWidget* widget : {static_cast<QWidget*>(back_), static_cast<QWidget*>(play_),
                            static_cast<QWidget*>(next_), static_cast<QWidget*>(speed_)}) {
        controls->addWidget(widget);
    }
    controls->addSpacing(8);
    controls->addWidget(row_, 1);
    controls->addWidget(byHand);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 10, 6);
    column->setSpacing(4);
    column->addLayout(controls);
    column->addWidget(text_);
    auto* steps = new QHBoxLayout(row_);
    steps->setContentsMargins(0, 0, 0, 0);
    steps->setSpacing(3);
    connect(play_, &QToolButton::clicked, this, &PlayStrip::toggle);
    connect(next_, &QToolButton::clicked, &tool_, &PlayTool::playStep);
    connect(back_, &QToolButton::clicked, this, [this] {
        const std::size_t step = tool_.step();
        tool_.goTo(tool_.isWithinStep() || step == 0 ? step : step - 1);
    });
    connect(speed_, &QComboBox::activated, this,
            [this](int index) { tool_.setSpeed(kSpeeds.at(std::size_t(index))); });
    connect(byHand, &QPushButton::clicked, &tool_, &PlayTool::goOnByHand);
    connect(&tool_, &PlayTool::changed, this, &PlayStrip::refresh);
    refresh();
}

void PlayStrip::toggle() { tool_.isRunning() ? tool_.pause() : tool_.play(); }

void PlayStrip::makeSteps() {
    for (QToolButton* step : steps_) {
        step->deleteLater();
    }
    steps_.clear();
    auto* layout = static_cast<QHBoxLayout*>(row_->layout());
    while (layout->count() > 0) {
        delete layout->takeAt(0);
    }
    for (std::size_t i = 0; i < tool_.steps().size(); ++i) {
        const studio::Step& step = tool_.steps()[i];
        auto* button = named(new QToolButton, "", tr("Step %1").arg(i + 1));
        button->setObjectName(QString("playStep%1").arg(i));
        button->setText(labelOf(step, i));
        button->setToolTip(textOf(step));
        button->setCheckable(true);
        button->setAutoRaise(true);
        connect(button, &QToolButton::clicked, this, [this, i] { tool_.goTo(i); });
        layout->addWidget(button);
        steps_.push_back(button);
    }
    layout->addStretch(1);
}

void PlayStrip::refresh() {
    setVisible(tool_.hasSession());
    if (!tool_.hasSession()) {
        return;
    }
    if (steps_.size() != tool_.steps().size()) {
        makeSteps();
    }
    const std::size_t step = tool_.step();
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        steps_[i]->setChecked(i == step);
    }
    text_->setText(step < tool_.steps().size() ? textOf(tool_.steps()[step]) : tr("That was all."));
    play_->setIcon(icon(tool_.isRunning() ? "pause" : "play"));
    play_->setToolTip(tool_.isRunning() ? tr("Pause (Space)") : tr("Play on (Space)"));
    play_->setEnabled(!tool_.isAtEnd());
    next_->setEnabled(!tool_.isAtEnd());
    back_->setEnabled(tool_.isWithinStep() || step > 0);
}

} // namespace vs::desktop
