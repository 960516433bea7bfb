// SPDX-License-Identifier: Apache-2.0
#include "model/segments/segment_controller.h"

#include "base/progress.h"
#include "model/document/document_host.h"
#include "model/document/notices.h"
#include "model/document/view_model.h"
#include "model/edits/editor.h"
#include "model/segments/growth_controller.h"
#include "studio/document/document_facts.h"

#include <algorithm>
#include <optional>
#include <stop_token>

namespace vs::desktop {

SegmentController::SegmentController(DocumentHost& host, ViewModel& view, Editor& editor,
                                     GrowthController& growth, Notices& notices)
    : host_(host), view_(view), editor_(editor), growth_(growth), notices_(notices) {
    for (const auto signal : {&DocumentHost::opened, &DocumentHost::closed}) {
        connect(&host_, signal, this, [this] { ++documents_; });
    }
}

const studio::SegmentList& SegmentController::list() const {
    listed_ = host_.facts();
    return listed_->segments;
}

std::size_t SegmentController::voxels(std::uint8_t label) const { return host_.facts()->voxels[label]; }

double SegmentController::millilitres(std::uint8_t label) const {
    return double(voxels(label)) * host_.facts()->segmentVoxelMm3 / 1000;
}

bool SegmentController::hasVoxels() const {
    const auto& all = list().segments;
    return std::any_of(all.begin(), all.end(),
                       [this](const studio::SegmentInfo& segment) { return voxels(segment.label) > 0; });
}

bool SegmentController::canRemove() const {
    return !list().working().isLocked && (list().segments.size() > 1 || voxels(list().atWork) > 0);
}

void SegmentController::workOn(const std::string& name) {
    if (name == list().working().name || host_.document() == nullptr) {
        return;
    }
    const auto* last = host_.facts()->lastEdit();
    const auto* use = last != nullptr ? std::get_if<studio::UseSegment>(last) : nullptr;
    const bool isOnlyGoing = use != nullptr && use->goesToWork && !use->name && !use->colour &&
                             !use->opacity && !use->isVisible && !use->isLocked && !use->treatment;
    // One that was only looked at on the way, if the way there did not make it.
    const bool wasThere = isOnlyGoing && use->segment == list().working().name && voxels(list().atWork) > 0;
    const studio::UseSegment going{name};
    editor_.change(
        [&] { return wasThere ? host_.document()->replaceLast(going) : host_.document()->apply(going); });
}

void SegmentController::add() {
    for (int number = int(list().segments.size()) + 1;; ++number) {
        const std::string name = tr("Segment %1").arg(number).toStdString();
        if (list().find(name) == nullptr) {
            studio::UseSegment another{name};
            another.takesFirst = false;
            editor_.apply(another);
            return;
        }
    }
}

void SegmentController::removeWorking() {
    if (canRemove()) {
        editor_.apply(studio::RemoveSegment{list().working().name});
    }
}

// Looks are no business of what grows.
void SegmentController::apply(studio::UseSegment change) {
    change.goesToWork = false;
    growth_.whilePaused([&] { editor_.apply(change); });
}

bool SegmentController::rename(const std::string& name, const QString& to) {
    const QString trimmed = to.trimmed();
    if (trimmed.toStdString() == name) {
        return true;
    }
    constexpr std::size_t kLongest = 200; // bytes, as in session files
    if (trimmed.toStdString().size() > kLongest) {
        host_.say(tr("A segment's name has at most %1 characters").arg(kLongest));
        return false;
    }
    if (trimmed.isEmpty() || list().find(trimmed.toStdString()) != nullptr) {
        host_.say(trimmed.isEmpty()
                      ? tr("A segment needs a name")
                      : tr("There is a segment '%1' already; choose another name").arg(trimmed));
        return false;
    }
    studio::UseSegment change{name};
    change.name = trimmed.toStdString();
    apply(change);
    return true;
}

void SegmentController::setColour(const std::string& name, const QColor& colour) {
    studio::UseSegment change{name};
    change.colour = glm::dvec3(colour.red(), colour.green(), colour.blue()) / 255.0;
    apply(change);
}

void SegmentController::setVisible(const std::string& name, bool isVisible) {
    studio::UseSegment change{name};
    change.isVisible = isVisible;
    apply(change);
}

void SegmentController::showOnly(const std::string& name) {
    growth_.whilePaused([&] { editor_.apply(studio::ShowSegments{name}); });
}

void SegmentController::showAll() {
    growth_.whilePaused([&] { editor_.apply(studio::ShowSegments{}); });
}

void SegmentController::pullOut(const std::string& name) {
    growth_.whilePaused([&] { editor_.pullOut(name); });
}

void SegmentController::pullAllOut() {
    growth_.whilePaused([&] {
        if (areAllOut()) {
            editor_.apply(studio::PutBack{});
        } else {
            editor_.apply(studio::PullOut{});
        }
    });
}

bool SegmentController::areAllOut() const {
    const auto& segments = list().segments;
    return hasVoxels() && std::all_of(segments.begin(), segments.end(), [this](const auto& segment) {
               return segment.pulledOut || voxels(segment.label) == 0;
           });
}

void SegmentController::showPulledOut(const std::string& name, bool isVisible) {
    const studio::SegmentInfo* info = list().find(name);
    if (info != nullptr && info->pulledOut) {
        const studio::PullOut change{name, info->pulledOut->place, isVisible};
        growth_.whilePaused([&] { editor_.apply(change); });
    }
}

void SegmentController::setLocked(const std::string& name, bool isLocked) {
    studio::UseSegment change{name};
    change.isLocked = isLocked;
    apply(change);
}

void SegmentController::setTreatment(const std::string& name, studio::SegmentInfo::Treatment treatment) {
    studio::UseSegment change{name};
    change.treatment = treatment;
    apply(change);
}

void SegmentController::setOpacity(double opacity, bool continues) {
    studio::UseSegment change{list().working().name};
    change.opacity = opacity;
    change.goesToWork = false;
    growth_.whilePaused([&] {
        editor_.change([&] {
            return continues ? host_.document()->replaceLast(change) : host_.document()->apply(change);
        });
    });
}

void SegmentController::perform(const studio::Operation& operation) {
    if (host_.document() == nullptr || host_.isLoading()) {
        return;
    }
    host_.say(tr("Working\u2026"));
    editor_.apply(operation);
}

void SegmentController::openLabels(const std::filesystem::path& path) {
    if (host_.document() == nullptr || host_.isLoading() || isReading_) {
        return;
    }
    isReading_ = true;
    host_.say(tr("Reading %1").arg(QString::fromStdString(path.filename().string())));
    emit host_.progress(0, 0);
    reader_ = std::jthread([this, path = std::filesystem::absolute(path), document = documents_,
                            grids = host_.document()->labelGrids()](const std::stop_token& stop) {
        const ProgressListener listener([&stop](std::optional<double>) { return !stop.stop_requested(); });
        studio::LoadLabels labels{path};
        std::vector<std::string> notices;
        QString error;
        try {
            studio::readLabels(labels, grids, notices);
        } catch (const std::exception& e) {
            error = QString::fromUtf8(e.what());
        }
        const auto finish = [this, labels, notices, error, document] {
            isReading_ = false;
            if (document != documents_ || host_.isLoading()) {
                host_.say(tr("The label map was dropped: its volume is no longer open"));
                if (!host_.isLoading()) { // else the bar is that of the next volume
                    emit host_.progress(1, 1);
                }
                return;
            }
            if (error.isEmpty()) {
                takeLabels(labels);
                notices_.add(notices);
            } else {
                host_.say(error);
                emit host_.openFailed(error);
            }
            emit host_.progress(1, 1);
        };
        QMetaObject::invokeMethod(
            this, [this, finish] { host_.whenHere(finish); }, Qt::QueuedConnection);
    });
}

void SegmentController::takeLabels(const studio::LoadLabels& labels) {
    if (editor_.apply(labels)) {
        if (view_.shown().mode == render::Mode::Surface) {
            view_.setMode(render::Mode::Overlay); // they may lie deep inside
        }
    } else {
        emit host_.openFailed(host_.message());
    }
}

} // namespace vs::desktop
