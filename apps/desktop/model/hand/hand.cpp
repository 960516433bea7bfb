// SPDX-License-Identifier: Apache-2.0
#include "model/hand/hand.h"

#include "model/document/document_host.h"
#include "model/hand/tool.h"

#include "image/image.h"
#include "sculpt/mask/outline_image.h"
#include "volume/reading/read_picture.h"

#include <utility>

namespace vs::desktop {

namespace {

// In hand before there are tools.
class NoTool : public Tool {
public:
    using Tool::Tool;
    [[nodiscard]] QString name() const override { return {}; }
    [[nodiscard]] QString hint() const override { return {}; }
    void press(const Pen&) override {}
    void move(const Pen&) override {}
    void release(const Pen&) override {}
};

} // namespace

Hand::Hand(DocumentHost& host) : host_(host), tool_(new NoTool(this)) {}

void Hand::take(Tool& tool) {
    if (tool_ != &tool) {
        tool_->clear(); // leaving a tool changes nothing: a stroke in hand is dropped
        tool_->putDown();
        tool_ = &tool;
        tool_->taken();
        host_.wake();
        emit overlayChanged();
        emit host_.changed();
    }
}

void Hand::listenTo(Tool& tool) {
    connect(&tool, &Tool::settingsChanged, &host_, &DocumentHost::changed);
    connect(&tool, &Tool::overlayChanged, this, &Hand::overlayChanged);
}

void Hand::setShape(studio::Shape shape) {
    if (tool_->isSketching()) { // a polyline that was under way
        tool_->clear();
    }
    shape_ = shape;
    emit overlayChanged(); // the hint
    emit host_.changed();
}

bool Hand::setStencil(const std::filesystem::path& picture) {
    std::vector<glm::dvec2> outline;
    const bool isRead = host_.guard([&] {
        for (const glm::dvec2 point : sculpt::outlineFromImage(volume::readPicture(picture), 1)) {
            outline.emplace_back(point.x, -point.y);
        }
    });
    if (isRead) {
        stencil_ = std::move(outline);
        setShape(studio::Shape::Stencil);
        host_.say(
            tr("Drag a box for the shape of %1").arg(QString::fromStdString(picture.filename().string())));
    }
    return isRead;
}

void Hand::setTarget(Target target) {
    target_ = target;
    emit overlayChanged(); // the hint
    emit host_.changed();
}

void Hand::setMaterial(int number) {
    material_ = number;
    emit host_.changed();
}

void Hand::setPicksValue(bool on) {
    if (on != picksValue_) {
        picksValue_ = on;
        emit overlayChanged(); // the hint
        emit host_.changed();
    }
}

} // namespace vs::desktop
