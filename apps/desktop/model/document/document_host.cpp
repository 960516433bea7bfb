// SPDX-License-Identifier: Apache-2.0
#include "model/document/document_host.h"

#include "base/error.h"
#include "base/progress.h"
#include "studio/document/document.h"
#include "studio/document/document_facts.h"

#include <new>
#include <utility>

namespace vs::desktop {

namespace {
constexpr double kHandMs = 300; // after the last input
} // namespace

DocumentHost::DocumentHost() : facts_(std::make_shared<const studio::DocumentFacts>()) {
    connect(this, &DocumentHost::changed, this, &DocumentHost::noticeCorrection);
    connect(&longWork_, &LongWork::lasts, this, [this](int thousandths) {
        if (!isReplaying()) { // which counts its operations
            thousandths < 0 ? emit progress(0, 0) : emit progress(thousandths, 1000);
        }
    });
}

DocumentHost::~DocumentHost() = default;

void DocumentHost::noticeCorrection() {
    const volume::GridGeometry now = facts()->geometry;
    if (!(now == toldGeometry_)) {
        emit corrected(std::exchange(toldGeometry_, now));
    }
}

studio::Document* DocumentHost::document() {
    gl_.makeCurrent();
    return document_.get();
}

const volume::Volume* DocumentHost::volume() const { return document_ ? &document_->volume() : nullptr; }

const volume::GridGeometry* DocumentHost::geometry() const {
    if (!document_) {
        return nullptr;
    }
    const auto facts = this->facts();
    if (!(facts->geometry == geometry_)) { // never while the document is away
        geometry_ = facts->geometry;
    }
    return &geometry_;
}

const volume::GridGeometry* DocumentHost::geometryInFile() const {
    return document_ ? &document_->geometryInFile() : nullptr;
}

void DocumentHost::publish() const {
    static const auto nothing = std::make_shared<const studio::DocumentFacts>();
    facts_ = document_ ? document_->facts() : nothing;
}

std::shared_ptr<const studio::DocumentFacts> DocumentHost::facts() const {
    if (!isAway()) {
        publish();
    }
    return facts_;
}

void DocumentHost::replace(std::unique_ptr<studio::Document> document) {
    gl_.makeCurrent();
    emit leaving();
    document_ = std::move(document);
    publish();
    toldGeometry_ = facts_->geometry;
}

bool DocumentHost::guard(const std::function<void()>& work) {
    gl_.makeCurrent();
    try {
        work();
        gl::Context::requireDevice();
        return true;
    } catch (const GivenUp&) {
        say(tr("Given up: nothing was changed"));
        return false;
    } catch (const std::bad_alloc&) {
        say(tr(
            "There is no memory for that: nothing was changed; end other programs, or use a smaller volume"));
        return false;
    } catch (const ContextLost& e) {
        say(QString::fromUtf8(e.what()));
        if (!std::exchange(isDeviceLost_, true)) {
            emit deviceLost();
        }
        return false;
    } catch (const std::exception& e) {
        say(QString::fromUtf8(e.what()));
        return false;
    }
}

void DocumentHost::runLong(const std::function<void()>& work, LongWork::Input input) {
    if (!isAway()) {
        publish(); // the facts that hold until it is back
    }
    longWork_.run(work, input);
}

bool DocumentHost::workLong(const std::function<void()>& work, LongWork::Input input) {
    return guard([&] { runLong(work, input); });
}

void DocumentHost::whenHere(std::function<void()> work) {
    if (isAway()) {
        waiting_.push_back(std::move(work));
        workSoon();
    } else {
        work();
    }
}

void DocumentHost::doWaiting() {
    gl_.makeCurrent();
    for (const auto& work : std::exchange(waiting_, {})) {
        work();
    }
}

void DocumentHost::giveUp() {
    longWork_.giveUp();
    emit givenUp();
}

void DocumentHost::say(const QString& message) {
    message_ = message;
    emit messageChanged();
}

void DocumentHost::wake() {
    sinceWoken_ = Timer();
    emit woken();
}

bool DocumentHost::isHandAtWork() const { return sinceWoken_.milliseconds() < kHandMs; }

void DocumentHost::tellSoon() {
    isToldSoon_ = true;
    workSoon();
}

void DocumentHost::tell() {
    if (std::exchange(isToldSoon_, false)) {
        emit changed();
    }
}

} // namespace vs::desktop
